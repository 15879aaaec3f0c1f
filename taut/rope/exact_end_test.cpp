#include "taut/rope/exact_end.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace taut::rope::exact_end_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The formulas of end_position with fifty digits.
TEST(ExactEnd, HasTwentyDigits) {
  using Exact = boost::multiprecision::cpp_bin_float_50;
  const auto check = [](const CatenaryRope& rope, const CatenaryForce& f) {
    const Exact half = Exact(rope.weight) * rope.length / 2, H = f.H, V0 = f.V - half, V1 = f.V + half;
    const Exact T0 = sqrt(H * H + V0 * V0), T1 = sqrt(H * H + V1 * V1);
    const Exact compliance = std::isinf(rope.stiffness) ? Exact(0) : Exact(Exact(rope.length) / rope.stiffness);
    const Exact x = H * (compliance + (asinh(V1 / H) - asinh(V0 / H)) / rope.weight);
    const Exact z = f.V * (compliance + 2 * Exact(rope.length) / (T0 + T1));
    const ExactEnd end = exact_end(rope, f);
    const Exact open_x = Exact(end.x.high) + end.x.low - x, open_z = Exact(end.z.high) + end.z.low - z;
    EXPECT_LT(static_cast<double>(abs(open_x) / x), 1e-21) << f.H << ' ' << f.V;
    EXPECT_LT(static_cast<double>(abs(open_z)), 1e-21 * std::abs(static_cast<double>(z))) << f.H << ' ' << f.V;
  };
  std::mt19937_64 source(3);
  const auto ten_to = [&](double low, double high) {
    return std::pow(10, std::uniform_real_distribution<>(low, high)(source));
  };
  for (int i = 0; i < 2000; ++i) {
    const CatenaryRope rope{
        .length = ten_to(-1, 3), .weight = ten_to(-3, 3), .stiffness = i % 7 ? ten_to(4, 12) : infinite};
    const double V = ten_to(-3, 7);
    check(rope, {.H = ten_to(-4, 8), .V = i % 2 ? V : -V});
    // level at one end but for the last digit
    check(rope, {.H = ten_to(-4, 8), .V = rope.weight * rope.length / 2});
  }
  // a vertical rope, and one that carries nothing
  const ExactEnd loop = exact_end({.length = 10, .weight = 5, .stiffness = 1e4}, {.H = 0, .V = 10});
  EXPECT_EQ(static_cast<double>(loop.x), 0);
  EXPECT_NEAR(static_cast<double>(loop.z), 10 * (1e-3 + 2 / 5.0), 1e-15);
  EXPECT_EQ(static_cast<double>(exact_end({.length = 10, .weight = 0, .stiffness = 1e4}, {}).z), 0);
}

// Squares that underflow or overflow, and what is no number, give no number: nothing is read beyond a table.
TEST(ExactEnd, BeyondTheRangeOfDoubles) {
  const CatenaryRope rope{.length = 10, .weight = 5, .stiffness = 1e4};
  EXPECT_FALSE(std::isfinite(static_cast<double>(exact_end(rope, {.H = 1e-200, .V = 10}).x)));
  EXPECT_FALSE(std::isfinite(static_cast<double>(exact_end(rope, {.H = std::nan(""), .V = 10}).x)));
  EXPECT_FALSE(std::isfinite(static_cast<double>(exact_end(rope, {.H = 1e200, .V = 10}).x)));
}

}  // namespace taut::rope::exact_end_test
