#include "taut/math/roots.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace taut::roots_test {

TEST(FindRoot, HitsTheLastBits) {
  const auto r = find_root([](double x) { return x * x - 2; }, 0, 2);
  ASSERT_TRUE(r.has_value());
  EXPECT_NEAR(*r, std::sqrt(2.0), 3e-16);
}

TEST(FindRoot, TakesAnEndThatIsARoot) {
  EXPECT_EQ(find_root([](double x) { return x; }, 0, 1), 0.0);
  EXPECT_EQ(find_root([](double x) { return x - 1; }, 0, 1), 1.0);
}

TEST(FindRoot, IsEmptyWithoutASignChange) {
  EXPECT_FALSE(find_root([](double x) { return x * x + 1; }, -1, 1).has_value());
  EXPECT_FALSE(find_root([](double) { return std::nan(""); }, -1, 1).has_value());
  EXPECT_FALSE(find_root([](double x) { return x; }, 1, -1).has_value());
}

TEST(FindRootAbove, WidensUntilItFindsOne) {
  const auto r = find_root_above([](double x) { return x - 12345.6; }, 0, 1);
  ASSERT_TRUE(r.has_value());
  EXPECT_DOUBLE_EQ(*r, 12345.6);
  EXPECT_FALSE(find_root_above([](double) { return 1.0; }, 0, 1).has_value());
}

RC_GTEST_PROP(FindRoot, SolvesTheCubicsOfTheMast, ()) {
  const double n = *rc::gen::inRange(0, 1000000) * 1.0;
  const double m = *rc::gen::inRange(1, 10000000) * 1.0;
  const auto f = [&](double b) { return 160e6 * b * b * b - n * b - 6 * m; };
  const auto r = find_root_above(f, 0, 1);
  RC_ASSERT(r.has_value());
  RC_ASSERT(std::abs(f(*r)) <= 1e-13 * (160e6 * std::pow(*r, 3) + n * *r + 6 * m));
}

}  // namespace taut::roots_test
