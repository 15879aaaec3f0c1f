#include <gtest/gtest.h>

#include "taut/math/index.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace {

using namespace taut_test;
using namespace taut::solve;

/// `n` bodies of together 500 kg on ropes between two places 100 m apart, all drawn from a parabola, or level.
machine::Model long_chain(int n, double rope = 103, double depth = 10) {
  machine::Model m;
  const double span = 100;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 1.0) / (n + 1);
    m.bodies.push_back(body("b" + std::to_string(i), {span * t, 0, -4 * depth * t * (1 - t)}, 500.0 / n, "xyz"));
  }
  for (int i = 0; i <= n; ++i) {
    const machine::Node from = i == 0 ? anchor("A", {0, 0, 0}) : anchor_on("from", i - 1, {0, 0, 0});
    const machine::Node to = i == n ? anchor("B", {span, 0, 0}) : anchor_on("to", i, {0, 0, 0});
    m.reevings.push_back(reeve("r" + std::to_string(i), {from, to}, rope / (n + 1), 2 * 9.80665, 20e6));
  }
  return m;
}

// Found by slack ropes: each is 0.3 % longer than its way at the start. The number of steps does not grow with the
// number of bodies.
TEST(LongChain, ComesToRestInAsManyStepsAsAShortOne) {
  for (const int n : {100, 1000}) {
    const machine::Model m = long_chain(n);
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_LE(r.closure.iterations, 60) << n;
    const double H = r.branches.front().H;
    double hangs = r.branches.front().V_from;
    for (int i = 0; i < n; ++i) {
      const BranchResult& before = r.branches[taut::as_size(i)];
      const BranchResult& after = r.branches[taut::as_size(i) + 1];
      EXPECT_NEAR(after.H, H, 1e-8 * H);
      EXPECT_NEAR(after.V_from - before.V_to, 500.0 / n * m.gravity, 1e-8 * H);
    }
    hangs -= r.branches.back().V_to;
    EXPECT_NEAR(-hangs, 500 * m.gravity + 2 * 9.80665 * 103, 1e-6 * H);
  }
}

// Let go level, its ropes get taut together: the drag is between neighbours.
TEST(LongChain, ComesToRestFromALevelStartInAsManySteps) {
  for (const int n : {100, 1000, 3000}) {
    const machine::Model m = long_chain(n, 120, 0);
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_LE(r.closure.iterations, 100) << n;
    EXPECT_NEAR(r.branches.front().V_from, -(500 * m.gravity + 2 * 9.80665 * 120) / 2, 1e-6 * 500 * m.gravity);
    EXPECT_LT(r.state.bodies[n / 2].position.z(), -25);
  }
}

}  // namespace
