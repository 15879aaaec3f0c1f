#include <gtest/gtest.h>

#include <cmath>

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

/// 500 machines by chance, 2 s each or 1000 steps: no number that is none, no rope that pushes or has no length, no
/// hang; those that can't go on say why, and when.
TEST(TransientRandom, MachinesByChance) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    RandomMachine chance(seed);
    const model::Model m = chance.machine();
    TransientOptions options = chance.options();
    options.most_steps = 1000;
    const TransientResult r = transient(m, options);
    for (const TransientFrame& frame : r.frames) ASSERT_TRUE(finite(frame)) << frame.t;
    if (r.outcome.ok()) {
      EXPECT_NEAR(r.t_end, 2, 1e-12);
      continue;
    }
    EXPECT_FALSE(r.outcome.message.empty());
    EXPECT_TRUE(r.frames.empty() || r.outcome.message.find("t = ") != std::string::npos) << r.outcome.message;
  }
}

}  // namespace
}  // namespace taut_test::transient_random
