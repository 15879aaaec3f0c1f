#include <gtest/gtest.h>

#include "test/support/machines.hpp"
#include "test/support/transient_slopes.hpp"

/// The derivatives of sagging branches against differences: the whole tangent of a step, for carriages, tackles, and a
/// boom with a skew sheave, with dampers and without.
namespace taut_test::transient_sag_slopes_test {
namespace {

double worst_sagging_slope(machine::Model m, double damping) {
  for (auto& rope : m.reevings) {
    rope.damping_time = damping;
    EXPECT_GT(rope.weight, 0);
  }
  return worst_slope(m, {.branches = taut::solve::Branches::catenary});
}

TEST(TransientSagSlopes, AgreeWithDifferences) {
  for (const double damping : {0.0, 0.01}) {
    EXPECT_LT(worst_sagging_slope(with_carriage(true, 0), damping), 1e-7);
    EXPECT_LT(worst_sagging_slope(tackle(4, 0.97, 3000, 8), damping), 1e-7);
    EXPECT_LT(worst_sagging_slope(rollers(2, 0.8, 0.5, 1500), damping), 1e-7);
    EXPECT_LT(worst_sagging_slope(boom(), damping), 1e-7);
  }
}

}  // namespace
}  // namespace taut_test::transient_sag_slopes_test
