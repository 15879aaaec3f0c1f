#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes::tensioning_test {

TEST(Tensioning, NoStepsNoRows) { EXPECT_TRUE(tensioning(1270, 0).empty()); }

TEST(Tensioning, TwoStepsAddTheFrictionAndTwiceIt) {
  const auto rows = tensioning(1270, 9);
  for (std::size_t i = 2; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].S10_extension_first - rows[i - 2].S10_extension_first, 1270, 1e-9);
    EXPECT_NEAR(rows[i].S20_retraction_first - rows[i - 2].S20_retraction_first, 2540, 1e-9);
  }
}

RC_GTEST_PROP(Tensioning, NeverPullsHarderThanThePadsHold, ()) {
  const double friction = *rc::gen::inRange(1, 100000);
  for (const TensioningStep& s : tensioning(friction, 40)) {
    RC_ASSERT(std::abs(2 * s.S10_extension_first - s.S20_extension_first) <= friction * (1 + 1e-12));
    RC_ASSERT(std::abs(2 * s.S10_retraction_first - s.S20_retraction_first) <= friction * (1 + 1e-12));
  }
}

}  // namespace taut::boom_ropes::tensioning_test
