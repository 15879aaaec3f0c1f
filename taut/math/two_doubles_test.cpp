#include "taut/math/two_doubles.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace taut::math::two_doubles_test {

using Exact = boost::multiprecision::cpp_bin_float_100;

Exact exact(const TwoDoubles& a) { return Exact(a.high) + Exact(a.low); }

double relative_error(const TwoDoubles& a, const Exact& b) {
  return static_cast<double>(b == 0 ? abs(exact(a)) : abs((exact(a) - b) / b));
}

constexpr double rounding = 0x1p-100;

struct Dice {
  std::mt19937_64 source{7};
  double in(double low, double high) { return std::uniform_real_distribution<>(low, high)(source); }
  /// Positive, of any size a length or a force has, with digits in both parts.
  TwoDoubles number() {
    const double high = std::pow(10, in(-12, 12));
    return {.high = high, .low = high * in(-1, 1) * 0x1p-53};
  }
};

TEST(TwoDoubles, SumAndProductOfDoublesAreExact) {
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const double a = dice.number().high, b = dice.in(-1, 1) * dice.number().high;
    EXPECT_EQ(exact(exact_sum(a, b)), Exact(a) + Exact(b));
    EXPECT_EQ(exact(exact_product(a, b)), Exact(a) * Exact(b));
  }
  EXPECT_EQ(exact(exact_sum(1e20, 1)), Exact(1e20) + 1);
}

TEST(TwoDoubles, ArithmeticKeepsAHundredBits) {
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const TwoDoubles a = dice.number(), b = dice.number();
    const double d = dice.number().high;
    const Exact x = exact(a), y = exact(b), z = d;
    EXPECT_LT(relative_error(a + b, x + y), rounding);
    EXPECT_LT(relative_error(d + a, z + x), rounding);
    EXPECT_LT(relative_error(a * b, x * y), rounding);
    EXPECT_LT(relative_error(d * a, z * x), rounding);
    EXPECT_LT(relative_error(a / b, x / y), rounding);
    EXPECT_LT(relative_error(a / d, x / z), rounding);
    EXPECT_LT(relative_error(d / a, z / x), rounding);
    EXPECT_LT(relative_error(sqrt(a), sqrt(x)), rounding);
    // a difference is good to the digits of what it is taken from
    EXPECT_LT(static_cast<double>(abs(exact(a - b) - (x - y)) / (x + y)), rounding);
    EXPECT_LT(static_cast<double>(abs(exact(a - d) - (x - z)) / (x + z)), rounding);
    EXPECT_LT(static_cast<double>(abs(exact(d - a) - (z - x)) / (x + z)), rounding);
  }
  EXPECT_EQ(static_cast<double>(sqrt(TwoDoubles{})), 0);
}

TEST(TwoDoubles, NearlyEqualNumbersAreNormalizedAfterTheirDifference) {
  const TwoDoubles third = 1 / TwoDoubles{.high = 3, .low = 0};
  const TwoDoubles left = normalized(third - third.high);
  EXPECT_EQ(left.high, third.low);
  EXPECT_EQ(left.low, 0);
}

TEST(TwoDoubles, SeriesOfAtanh) {
  for (double u = -most_of_atanh_ratio; u <= most_of_atanh_ratio; u += 0.001) {
    const TwoDoubles at{.high = u, .low = u * 0x1p-55};
    const Exact x = exact(at);
    EXPECT_LT(relative_error(atanh_ratio(at), log((1 + x) / (1 - x)) / (2 * x)), 1e-22) << u;
  }
  EXPECT_EQ(static_cast<double>(atanh_ratio({})), 1);
}

TEST(TwoDoubles, LogarithmOfAnySize) {
  Dice dice;
  const auto expect_log = [](const TwoDoubles& a) {
    const Exact wanted = log(exact(a));
    const Exact scale = abs(wanted) > 1 ? Exact(abs(wanted)) : Exact(1);
    EXPECT_LT(static_cast<double>(abs(exact(log(a)) - wanted) / scale), 1e-22) << a.high;
  };
  for (int i = 0; i < 3000; ++i) expect_log(dice.number());
  for (const double high : {1e-250, 0.5, 1 - 0x1p-53, 1.0, 1 + 0x1p-52, 1.5, 2 - 0x1p-52, 2.0, 1e250}) {
    expect_log({.high = high, .low = 0});
    expect_log({.high = high, .low = -high * 0x1p-55});
  }
  EXPECT_NEAR(static_cast<double>(log({.high = 1, .low = 0})), 0, 1e-29);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(static_cast<double>(log({.high = infinite, .low = 0})), infinite);
  EXPECT_EQ(static_cast<double>(log({})), -infinite);
  EXPECT_TRUE(std::isnan(static_cast<double>(log({.high = std::nan(""), .low = 0}))));
}

}  // namespace taut::math::two_doubles_test
