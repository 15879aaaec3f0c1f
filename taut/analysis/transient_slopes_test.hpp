#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "taut/analysis/transient_run.hpp"

/// The derivatives of a step of motion against differences, for the tests of all that adds to them.
namespace taut_test {

struct SlopesAt {
  taut::analysis::Branches branches = taut::analysis::Branches::straight;
  /// Of every contact between two lines; what ends on a drum is stuck.
  taut::analysis::dynamics::Grip grip = taut::analysis::dynamics::Grip::equal;
  int turns = 0;       ///< of every bearing, the sense in which it slides; 0: it sticks
  double speed = 0.1;  ///< of every freedom, up to this, m/s, 1/s
  bool still = false;  ///< nothing moves nor slips
  int dice = 3;
};

/// The largest difference between the tangent and what a step's residual does, as a share of its row's largest entry,
/// somewhere in a motion from the settled state.
inline double worst_slope(const taut::model::Model& m, const SlopesAt& at = {}) {
  namespace dynamics = taut::analysis::dynamics;
  taut::analysis::TransientOptions options;
  options.duration = 1;
  options.branches = at.branches;
  dynamics::Run run{.model = m, .options = options};
  if (!dynamics::open_run(run)) return INFINITY;
  dynamics::Mechanism& mechanism = run.m;
  for (auto& contact : mechanism.contacts) contact.mass = 0;  // the thrust's rate is left out of every tangent
  dynamics::Scheme s = run.scheme;
  s.h = s.reach = 0.02;
  s.slip_now = 1 / s.h;
  s.slip_before = 0;
  std::mt19937 dice(static_cast<unsigned>(at.dice));
  std::uniform_real_distribution<double> by(-1, 1);
  for (double& rate : run.before.nu) rate = at.still ? 0 : at.speed * by(dice);
  for (auto& contact : run.before.contacts) contact.winding = contact.lambda;
  dynamics::begin_step(mechanism, s, run.before, run.w);
  dynamics::Values now = run.before;
  for (double& rate : now.rate) rate = at.still ? 0 : 2 * by(dice);
  std::vector<char> is_flow(now.q.size(), 0);
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const auto c = static_cast<std::size_t>(mechanism.contacts[i].column);
    const bool passes = mechanism.contacts[i].in >= 0 && mechanism.contacts[i].out >= 0;
    is_flow[c] = 1;
    now.q[c] = run.before.q[c] + (at.still ? 0 : 1e-3 * by(dice));
    now.contacts[i].grip = passes ? at.grip : dynamics::Grip::stuck;
  }
  for (const auto& body : mechanism.bodies) {  // at no rotation in the step its vector is the turn itself
    for (int f = 0; f < body.count; ++f) {
      const auto c = static_cast<std::size_t>(body.first + f);
      if (body.turns) run.w.q_star[c] = run.before.q[c] - s.reach * (run.w.nu_star[c] + s.reach * now.rate[c]);
    }
  }
  // what sticks goes with its rim: its row has a scale of its own, which changes
  for (int once = 0; once < 3; ++once) {
    EXPECT_TRUE(dynamics::follow(mechanism, s, run.before, run.w, s.h, now));
    for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
      if (now.contacts[i].grip != dynamics::Grip::stuck) continue;
      const auto c = static_cast<std::size_t>(mechanism.contacts[i].column);
      now.q[c] = run.before.contacts[i].slipped + run.w.q_star[c] + s.reach * now.contacts[i].roll_rate;
    }
  }
  const std::size_t n = now.q.size();
  const auto residual = [&](std::size_t column, double change) {
    dynamics::Values v = now;
    if (change != 0) (is_flow[column] ? v.q : v.rate)[column] += change;
    EXPECT_TRUE(dynamics::follow(mechanism, s, run.before, run.w, s.h, v));
    for (std::size_t i = 0; i < v.spins.size(); ++i) {
      v.spins[i].turns = static_cast<std::int8_t>(at.turns);
      v.spins[i].capacity = 0;
      for (const auto& [contact, sense] : mechanism.spins[i].contacts) {
        const auto& of = mechanism.contacts[static_cast<std::size_t>(contact)];
        v.spins[i].capacity += dynamics::bearing_slope(mechanism, of, run.before, v).capacity;
      }
    }
    dynamics::assemble(mechanism, s, run.before, v, run.w);
    return run.w.residual;
  };
  residual(0, 0);
  const std::vector<double> tangent = mechanism.solver.dense();
  double worst = 0;
  for (std::size_t c = 0; c < n; ++c) {
    const double step = is_flow[c] ? 1e-6 : 1e-3;
    const auto more = residual(c, step), less = residual(c, -step);
    for (std::size_t r = 0; r < n; ++r) {
      double largest = 0;
      for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(tangent[r * n + k]));
      worst = std::max(worst, std::abs((more[r] - less[r]) / (2 * step) - tangent[r * n + c]) / largest);
    }
  }
  return worst;
}

}  // namespace taut_test
