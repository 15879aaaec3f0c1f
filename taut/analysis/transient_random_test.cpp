#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/analysis/random_machines_test.hpp"

namespace taut_test::transient_random {
namespace {

using taut::analysis::transient;
using taut::analysis::TransientFrame;
using taut::analysis::TransientOptions;
using taut::analysis::TransientResult;

bool finite(const TransientFrame& frame) {
  bool all = std::isfinite(frame.energy.residual) && std::isfinite(frame.energy.kinetic);
  for (const auto& body : frame.bodies) all = all && body.position.allFinite() && body.velocity.allFinite();
  for (const auto& branch : frame.branches) {
    all = all && std::isfinite(branch.T_from) && branch.T_from >= 0 && branch.T_to >= 0 && branch.unstretched > 0;
  }
  return all;
}

/// What a broken rope takes along that has run off a round is not counted well yet.
bool has_run_off(const TransientResult& r) {
  return std::any_of(r.events.begin(), r.events.end(), [](const auto& event) { return event.what == "run_off"; });
}

/// 500 machines by chance, 2 s each or 2000 steps: no number that is none, no rope that pushes or has no length, no
/// hang; those that can't go on say why, and when. Those that end create no energy: a tenth of what is turned over is
/// the most that kinks and breaks leave.
TEST(TransientRandom, MachinesByChance) {
  int ended = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    RandomMachine chance(seed);
    const model::Model m = chance.machine();
    TransientOptions options = chance.options();
    options.most_steps = 2000;
    const TransientResult r = transient(m, options);
    for (const TransientFrame& frame : r.frames) ASSERT_TRUE(finite(frame)) << frame.t;
    if (r.outcome.ok()) {
      EXPECT_NEAR(r.t_end, 2, 1e-12);
      const double allowed =
          has_run_off(r) ? std::numeric_limits<double>::infinity() : 0.1 * r.frames.back().energy.turnover + 1e-6;
      EXPECT_LT(r.frames.back().energy.residual, allowed);
      ++ended;
      continue;
    }
    EXPECT_FALSE(r.outcome.message.empty());
    EXPECT_TRUE(r.frames.empty() || r.outcome.message.find("t = ") != std::string::npos) << r.outcome.message;
  }
  EXPECT_GE(ended, 140);
}

}  // namespace
}  // namespace taut_test::transient_random
