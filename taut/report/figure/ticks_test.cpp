#include "taut/report/figure/ticks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "taut/base/expects.hpp"

namespace ticks_test {

using namespace taut::report;

TEST(Ticks, AreRound) {
  EXPECT_EQ(nice_ticks(0, 100, 5), (std::vector<double>{0, 20, 40, 60, 80, 100}));
  EXPECT_EQ(nice_ticks(-30, 30, 6), (std::vector<double>{-30, -20, -10, 0, 10, 20, 30}));
  EXPECT_EQ(tick_decimals({0, 0.05, 0.1}), 2);
  EXPECT_EQ(tick_decimals({0, 20}), 0);
}

TEST(Ticks, NiceBelow) {
  EXPECT_DOUBLE_EQ(nice_below(0.7), 0.5);
  EXPECT_DOUBLE_EQ(nice_below(100), 100);
  EXPECT_DOUBLE_EQ(nice_below(49), 20);
  EXPECT_THROW(nice_below(0), taut::ContractViolation);
}

RC_GTEST_PROP(Ticks, CoverTheRangeWithAFewSteps, ()) {
  const double low = *rc::gen::inRange(-1000000, 1000000) * 1e-3;
  const double size = *rc::gen::inRange(1, 1000000) * std::pow(10.0, *rc::gen::inRange(-6, 6));
  const auto ticks = nice_ticks(low, low + size, 6);
  const double step = ticks[1] - ticks[0];
  RC_ASSERT(ticks.front() <= low + 1e-6 * step);
  RC_ASSERT(ticks.back() >= low + size - 1e-6 * step);
  RC_ASSERT(ticks.size() >= 3U);
  RC_ASSERT(ticks.size() <= 13U);
}

}  // namespace ticks_test
