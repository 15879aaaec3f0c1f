#include "taut/design/constrained.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace taut::design::constrained_test {

using Point = std::optional<ConstrainedPoint>;
using X = std::vector<double>;

// Two bars and their load: the least volume 2 sqrt(2) x0 + x1 of the symmetric three-bar truss with its three stresses
// within limits (Rozvany; sigma = P = 20): x0 = 0.78868, x1 = 0.40825, volume 2.63896 for P/sigma = 1.
Point three_bars(const X& x) {
  const double r2 = std::numbers::sqrt2;
  const double d = r2 * x[0] * x[0] + 2 * x[0] * x[1];
  return ConstrainedPoint{.value = 2 * r2 * x[0] + x[1],
                          .over = {(r2 * x[0] + x[1]) / d - 1, x[1] / d - 1, 1 / (x[0] + r2 * x[1]) - 1}};
}

TEST(Constrained, three_bar_truss) {
  for (const X& start : {X{1, 1}, X{0.3, 0.2}, X{1.9, 0.1}}) {
    const auto a = least_within(three_bars, Sought::least_value,
                                {.start = start, .low = {0.05, 0.05}, .high = {2, 2}, .step = {0.3, 0.3}});
    EXPECT_TRUE(a.feasible);
    EXPECT_NEAR(a.at.value, 2.63896, 2e-4);
    EXPECT_LE(*std::max_element(a.at.over.begin(), a.at.over.end()), 0);  // not within a tolerance: kept
    const auto again = least_within(three_bars, Sought::least_value,
                                    {.start = start, .low = {0.05, 0.05}, .high = {2, 2}, .step = {0.3, 0.3}});
    EXPECT_EQ(a.x, again.x);
    EXPECT_EQ(a.evaluations, again.evaluations);
  }
}

// A range of another unit changes nothing but the unit.
TEST(Constrained, scaled_alike) {
  const auto scaled = [](const X& x) { return three_bars({x[0] / 1e5, x[1] * 1e3}); };
  const auto a = least_within(three_bars, Sought::least_value,
                              {.start = {1, 1}, .low = {0.05, 0.05}, .high = {2, 2}, .step = {0.3, 0.3}});
  const auto b = least_within(scaled, Sought::least_value,
                              {.start = {1e5, 1e-3}, .low = {5e3, 5e-5}, .high = {2e5, 2e-3}, .step = {3e4, 3e-4}});
  EXPECT_NEAR(b.at.value, a.at.value, 1e-6);
}

// The worst of three: |x - 1|, |x + y|, |y - 2|, each less 1, is least where all are alike. max(|x-1|, |x+y|, |y-2|):
// x - 1 = -t, x + y = t, y - 2 = -t -> x = 1 - t, y = 2 - t, 3 - 2t = t, t = 1.
TEST(Constrained, most_reserve) {
  const auto f = [](const X& x) -> Point {
    return ConstrainedPoint{.value = 7,
                            .over = {std::abs(x[0] - 1) - 3, std::abs(x[0] + x[1]) - 3, std::abs(x[1] - 2) - 3}};
  };
  const auto a =
      least_within(f, Sought::most_reserve, {.start = {4, 4}, .low = {-5, -5}, .high = {5, 5}, .step = {1, 1}});
  EXPECT_TRUE(a.feasible);
  EXPECT_NEAR(*std::max_element(a.at.over.begin(), a.at.over.end()), -2, 1e-3);
  EXPECT_NEAR(a.x[0], 0, 5e-3);
  EXPECT_NEAR(a.x[1], 1, 5e-3);
}

TEST(Constrained, tells_what_comes_nearest) {
  const auto f = [](const X& x) -> Point { return ConstrainedPoint{.value = x[0], .over = {1 + x[0] * x[0]}}; };
  const auto a = least_within(f, Sought::least_value, {.start = {1.7}, .low = {-2}, .high = {2}, .step = {0.5}});
  EXPECT_FALSE(a.feasible);
  EXPECT_NEAR(a.x[0], 0, 0.02);
}

// Where there is no value (no equilibrium) the search turns back; an unknown without a width stays; without constraints
// the bound is the answer.
TEST(Constrained, holes_and_bounds) {
  const auto f = [](const X& x) -> Point {
    if (x[0] < 0.5) return ConstrainedPoint{.value = std::nan(""), .over = {0}};
    return ConstrainedPoint{.value = x[0], .over = {x[1] - 3}};
  };
  const auto a =
      least_within(f, Sought::least_value, {.start = {1.5, 3}, .low = {0, 3}, .high = {2, 3}, .step = {0.5, 1}});
  EXPECT_TRUE(a.feasible);
  EXPECT_NEAR(a.x[0], 0.5, 0.05);
  EXPECT_EQ(a.x[1], 3);
  const auto free = [](const X& x) -> Point { return ConstrainedPoint{.value = -x[0], .over = {}}; };
  EXPECT_EQ(least_within(free, Sought::least_value, {{1}, {0}, {2}, {0.5}}).x[0], 2);
}

TEST(Constrained, ends_when_asked) {
  int calls = 0;
  const auto f = [&](const X& x) -> Point {
    if (++calls > 5) return {};
    return three_bars(x);
  };
  const auto a =
      least_within(f, Sought::least_value, {.start = {1, 1}, .low = {0.05, 0.05}, .high = {2, 2}, .step = {0.3, 0.3}});
  EXPECT_TRUE(a.ended);
  EXPECT_EQ(a.evaluations, 5);
  EXPECT_TRUE(a.feasible);
}

}  // namespace taut::design::constrained_test
