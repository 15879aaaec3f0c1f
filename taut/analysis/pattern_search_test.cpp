#include "taut/analysis/pattern_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::analysis::pattern_search_test {

using Point = std::vector<double>;

TEST(PatternSearch, finds_a_minimum_within_bounds) {
  const auto f = [](const Point& x) { return (x[0] - 1) * (x[0] - 1) + 4 * (x[1] + 2) * (x[1] + 2); };
  const auto inside = pattern_search(f, {4, 4}, {-5, -5}, {5, 5}, {1, 1});
  EXPECT_NEAR(inside.x[0], 1, 0.02);
  EXPECT_NEAR(inside.x[1], -2, 0.02);
  const auto at_bound = pattern_search(f, {4, 4}, {2, -5}, {5, 5}, {1, 1});
  EXPECT_EQ(at_bound.x[0], 2);
}

// The worst of two checks has its least value where they are equal: x = 2 of max(x/4, 1/x).
TEST(PatternSearch, the_worst_of_several) {
  const auto f = [](const Point& x) { return std::max(x[0] / 4, 1 / x[0]); };
  EXPECT_NEAR(pattern_search(f, {5}, {0.1}, {10}, {2}).x[0], 2, 0.02);
}

TEST(PatternSearch, keeps_out_of_what_is_not_there) {
  const auto f = [](const Point& x) { return x[0] > 3 ? std::nan("") : -x[0]; };
  EXPECT_NEAR(pattern_search(f, {0}, {0}, {10}, {2}).x[0], 3, 0.02);
}

TEST(PatternSearch, is_bounded) {
  int calls = 0;
  const auto f = [&](const Point& x) { return ++calls, -x[0]; };
  PatternOptions options;
  options.most_evaluations = 10;
  const auto answer = pattern_search(f, {0}, {0}, {1e9}, {1}, options);
  EXPECT_LE(answer.evaluations, 12);
  EXPECT_EQ(answer.evaluations, calls);
}

}  // namespace taut::analysis::pattern_search_test
