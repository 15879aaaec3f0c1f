#include "taut/chance/reliability/design_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/limit_states.hpp"

namespace taut::chance::design_point_test {

using namespace taut_test;

using Search = Reached (*)(const LimitState&, const Point&, const SearchOptions&);
const Search searches[] = {improved_hlrf, slsqp};

/// g = 2.5 - (3 u_1 - 4 u_2)/5: the nearest point is 2.5 (3, -4)/5.
TEST(DesignPoint, of_a_plane) {
  const LimitState plane = state_of(normals(2), [](const Point& u) { return 2.5 - (3 * u[0] - 4 * u[1]) / 5; });
  for (const Search search : searches) {
    for (const Point& start : {Point{0, 0}, Point{-3, 1}, Point{4, 4}}) {
      const Reached r = search(plane, start, {});
      ASSERT_TRUE(r.converged) << r.reason;
      EXPECT_NEAR(r.u[0], 1.5, 1e-3);
      EXPECT_NEAR(r.u[1], -2, 1e-3);
      EXPECT_NEAR(r.at.margin, 0, 1e-3);
      EXPECT_NEAR(r.at.gradient[0], -0.6, 1e-6);
      EXPECT_NEAR(r.at.gradient[1], 0.8, 1e-6);
      EXPECT_NEAR(r.at.steepness, 1, 1e-6);
    }
  }
}

/// u_2 = 3 - 0.1 u_1^2: |u|^2 has its only least value at (0, 3).
TEST(DesignPoint, of_a_curved_limit) {
  const LimitState curve = state_of(normals(2), [](const Point& u) { return 3 - 0.1 * u[0] * u[0] - u[1]; });
  for (const Search search : searches) {
    const Reached r = search(curve, {2, 1}, {});
    ASSERT_TRUE(r.converged) << r.reason;
    // of u = (e, 3) the part 3 (e/3 - 0.2 e) lies across the gradient, at the end at most 3 x 2e-3
    EXPECT_NEAR(r.u[0], 0, 0.015);
    EXPECT_NEAR(r.u[1], 3, 1e-3);
  }
}

TEST(DesignPoint, nothing_is_sought_too_far_out) {
  const LimitState far = state_of(normals(1), [](const Point& u) { return 12 - u[0]; });
  for (const Search search : searches) {
    const Reached r = search(far, {0}, {});
    EXPECT_FALSE(r.converged);
    EXPECT_FALSE(r.reason.empty());
  }
}

/// Cases beyond u_1 = 2.2 have no value; the limit lies before them at 2.
TEST(DesignPoint, a_failed_case_is_no_step) {
  const LimitState edge =
      state_of(normals(2), [](const Point& u) { return u[0] > 2.2 ? std::nan("") : 4 - u[0] * u[0] + 0 * u[1]; });
  const Reached r = improved_hlrf(edge, {0.5, 0}, {});
  ASSERT_TRUE(r.converged) << r.reason;
  EXPECT_NEAR(r.u[0], 2, 1e-3);
}

}  // namespace taut::chance::design_point_test
