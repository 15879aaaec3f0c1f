#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "taut/analysis/machines_test.hpp"
#include "taut/analysis/transient_run.hpp"

/// The derivatives of sagging branches against differences: the whole tangent of a step, for carriages, tackles, and a
/// boom with a skew sheave, with dampers and without.
namespace taut_test::transient_sag_slopes_test {
namespace {

namespace dynamics = taut::analysis::dynamics;
using taut::analysis::Branches;
using taut::analysis::TransientOptions;

bool is_flow(const dynamics::Mechanism& m, int column) {
  return std::any_of(m.contacts.begin(), m.contacts.end(), [&](const auto& c) { return c.column == column; });
}

/// The largest difference between the tangent and what a step's residual does, as a share of its row's largest entry.
double worst_slope(model::Model m, double damping) {
  for (auto& rope : m.reevings) rope.damping_time = damping;
  TransientOptions options;
  options.duration = 1;
  options.branches = Branches::catenary;
  dynamics::Run run{.model = m, .options = options};
  if (!dynamics::open_run(run)) return INFINITY;
  dynamics::Mechanism& mechanism = run.m;
  EXPECT_EQ(mechanism.sagging, static_cast<int>(mechanism.lines.size()));
  for (auto& contact : mechanism.contacts) contact.mass = 0;  // the thrust's rate is left out of every tangent
  dynamics::Scheme s = run.scheme;
  s.h = s.reach = 0.02;
  s.slip_now = 1 / s.h;
  s.slip_before = 0;
  std::mt19937 dice(3);
  std::uniform_real_distribution<double> by(-1, 1);
  for (double& rate : run.before.nu) rate = 0.1 * by(dice);
  for (auto& contact : run.before.contacts) contact.winding = contact.lambda;
  dynamics::begin_step(mechanism, s, run.before, run.w);
  dynamics::Values now = run.before;
  for (double& rate : now.rate) rate = 2 * by(dice);
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const std::size_t c = static_cast<std::size_t>(mechanism.contacts[i].column);
    now.q[c] = run.before.q[c] + 1e-3 * by(dice);
    now.contacts[i].grip = dynamics::Grip::equal;
  }
  const auto residual = [&](int column, double change) {
    dynamics::Values v = now;
    const auto c = static_cast<std::size_t>(std::max(column, 0));
    (is_flow(mechanism, column) ? v.q : v.rate)[c] += column < 0 ? 0 : change;
    EXPECT_TRUE(dynamics::follow(mechanism, s, run.before, run.w, s.h, v));
    dynamics::assemble(mechanism, s, run.before, v, run.w);
    return run.w.residual;
  };
  residual(-1, 0);
  const std::vector<double> tangent = mechanism.solver.dense();
  const auto n = static_cast<std::size_t>(mechanism.size);
  double worst = 0;
  for (std::size_t c = 0; c < n; ++c) {
    const double step = is_flow(mechanism, static_cast<int>(c)) ? 1e-6 : 1e-3;
    const auto more = residual(static_cast<int>(c), step), less = residual(static_cast<int>(c), -step);
    for (std::size_t r = 0; r < n; ++r) {
      double largest = 0;
      for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(tangent[r * n + k]));
      worst = std::max(worst, std::abs((more[r] - less[r]) / (2 * step) - tangent[r * n + c]) / largest);
    }
  }
  return worst;
}

TEST(TransientSagSlopes, AgreeWithDifferences) {
  for (const double damping : {0.0, 0.01}) {
    EXPECT_LT(worst_slope(with_carriage(true, 0), damping), 1e-7);
    EXPECT_LT(worst_slope(tackle(4, 0.97, 3000, 8), damping), 1e-7);
    EXPECT_LT(worst_slope(rollers(2, 0.8, 0.5, 1500), damping), 1e-7);
    EXPECT_LT(worst_slope(boom(), damping), 1e-7);
  }
}

}  // namespace
}  // namespace taut_test::transient_sag_slopes_test
