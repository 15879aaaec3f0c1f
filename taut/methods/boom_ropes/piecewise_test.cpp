#include "taut/methods/boom_ropes/piecewise.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::boom_ropes::piecewise_test {

TEST(Piecewise, FindsTheOneRisingRoot) {
  const Crossings c = crossings([](double x) { return 2 * x - 3 + std::abs(x); }, {0});
  EXPECT_EQ(c.count, 1);
  EXPECT_TRUE(c.rising);
  EXPECT_LT(c.low, 1);
  EXPECT_GT(c.high, 1);
}

TEST(Piecewise, FindsRootsFarOutside) {
  EXPECT_EQ(crossings([](double x) { return x + 1e7; }, {0, 1}).count, 1);
  EXPECT_EQ(crossings([](double x) { return x - 1e7; }, {0, 1}).count, 1);
}

TEST(Piecewise, CountsEveryRoot) {
  const auto zigzag = [](double x) { return std::abs(std::abs(x) - 2) - 1; };  // -3, -1, 1, 3
  EXPECT_EQ(crossings(zigzag, {-2, 0, 2}).count, 4);
  EXPECT_EQ(crossings([](double x) { return std::abs(x) + 1; }, {0}).count, 0);
  EXPECT_EQ(crossings([](double x) { return std::max(x, 0.0) + std::min(x + 1, 0.0); }, {0, -1}).count, 2);
}

TEST(Piecewise, CountsARootOnABreakOnce) {
  const Crossings c = crossings([](double x) { return x < 0 ? x : 3 * x; }, {0});
  EXPECT_EQ(c.count, 1);
  EXPECT_TRUE(c.rising);
}

TEST(Piecewise, SeesAFallingRoot) {
  EXPECT_FALSE(crossings([](double x) { return 1 - x; }, {0}).rising);
}

RC_GTEST_PROP(Piecewise, BracketsTheRootOfARisingFunction, ()) {
  const double bend = static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 100;
  const double shift = static_cast<double>(*rc::gen::inRange(-100000, 100000)) / 7;
  const auto f = [&](double x) { return 2 * x + std::abs(x - bend) + shift; };
  const Crossings c = crossings(f, {bend, 0});
  RC_ASSERT(c.count == 1);
  RC_ASSERT(f(c.low) <= 0);
  RC_ASSERT(f(c.high) >= 0);
}

}  // namespace taut::boom_ropes::piecewise_test
