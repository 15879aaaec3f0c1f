#include "taut/chance/reliability/limit_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "test/support/limit_states.hpp"

namespace taut::chance::limit_state_test {

using namespace taut_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The margin is positive on the kept side of either bound, in the unit of the output.
TEST(LimitState, margin_of_either_bound) {
  const Inputs in{.of = {{.law = Normal{.mean = 10, .sd = 2}}}};
  const OutputOf f = [](const Point& x) { return x[0]; };
  const LimitState least = state_of(in, f, {.bound = Bound::at_least, .value = 7});
  const LimitState most = state_of(in, f, {.bound = Bound::at_most, .value = 7});
  const double on_limit = 7e-9;  // a value on its limit keeps it
  EXPECT_NEAR(least.margins({{1}})[0], 5 + on_limit, 1e-12);
  EXPECT_NEAR(most.margins({{1}})[0], -5 + on_limit, 1e-12);
  EXPECT_EQ(least.margins({{0}, {1}, {-1}}).size(), 3u);
  EXPECT_EQ(least.evaluations(), 4u);
  EXPECT_EQ(most.evaluations(), 1u);
}

// Central differences of a quadratic are exact: d/du (u_0^2 + 3 u_1) at (2, 1) is (4, 3).
TEST(LimitState, slope) {
  const LimitState s = state_of(normals(2), [](const Point& u) { return u[0] * u[0] + 3 * u[1]; });
  const Slope at = slope(s, {2, 1}, 0.1);
  EXPECT_NEAR(at.margin, 7, 1e-12);
  EXPECT_NEAR(at.gradient[0], 4, 1e-12);
  EXPECT_NEAR(at.gradient[1], 3, 1e-12);
  EXPECT_NEAR(at.steepness, 5, 1e-12);
  EXPECT_EQ(s.evaluations(), 5u);
}

// Where one side has no value the other one gives the slope; where neither has, there is none.
TEST(LimitState, slope_beside_cases_without_a_value) {
  const LimitState ends = state_of(normals(1), [](const Point& u) { return u[0] > 1 ? nan : 2 * u[0]; });
  EXPECT_NEAR(slope(ends, {1}, 0.1).gradient[0], 2, 1e-12);
  const LimitState begins = state_of(normals(1), [](const Point& u) { return u[0] < 1 ? nan : 2 * u[0]; });
  EXPECT_NEAR(slope(begins, {1}, 0.1).gradient[0], 2, 1e-12);
  const LimitState alone = state_of(normals(1), [](const Point& u) { return u[0] == 1 ? 2. : nan; });
  EXPECT_TRUE(std::isnan(slope(alone, {1}, 0.1).gradient[0]));
  EXPECT_TRUE(std::isnan(slope(alone, {1}, 0.1).steepness));
}

// A smooth margin has none, one that jumps between two values has half their distance, at any level and slope.
TEST(LimitState, noise) {
  const LimitState smooth = state_of(normals(2), [](const Point& u) { return std::exp(u[0]) + 5 * u[1]; });
  EXPECT_LT(noise(smooth, {0.3, -0.2}), 1e-12);
  int turn = 0;
  const LimitState rough = state_of(normals(2), [&](const Point& u) { return 1e3 + u[0] + (++turn % 2) * 2e-3; });
  const double found = noise(rough, {0.3, -0.2});
  EXPECT_GT(found, 0.5e-3);
  EXPECT_LT(found, 4e-3);
  EXPECT_EQ(noise(state_of(normals(1), [](const Point&) { return nan; }), {0}), 0);
}

}  // namespace taut::chance::limit_state_test
