#include "taut/chance/reliability/sorm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/chance/standard_laws.hpp"
#include "test/support/limit_states.hpp"

namespace taut::chance::sorm_test {

using namespace taut_test;

// g = 3 - u_0 + (k u_1^2 + l u_2^2)/2, in axes that are turned in the plane of the first two scores: at its nearest
// point, 3 along the first axis, the limit bends with k and l.
TEST(Sorm, curvatures_of_a_turned_paraboloid) {
  const double k = 0.4, l = -0.2, turn = 0.7;
  const auto axis = [&](const Point& u) {
    return Point{std::cos(turn) * u[0] + std::sin(turn) * u[1], -std::sin(turn) * u[0] + std::cos(turn) * u[1], u[2]};
  };
  const LimitState s = state_of(normals(3), [&](const Point& u) {
    const Point a = axis(u);
    return 2 * (3 - a[0] + (k * a[1] * a[1] + l * a[2] * a[2]) / 2);
  });
  const Point nearest_point{3 * std::cos(turn), 3 * std::sin(turn), 0};
  const auto shape = curved(s, nearest_point, slope(s, nearest_point, 0.01), 0.05);
  ASSERT_TRUE(shape);
  ASSERT_EQ(shape->curvatures.size(), 2u);
  EXPECT_NEAR(shape->curvatures[0], k, 1e-9) << "falling";
  EXPECT_NEAR(shape->curvatures[1], l, 1e-9);
  EXPECT_NEAR(std::abs(shape->least[2]), 1, 1e-9) << "the direction of the least curvature";
  EXPECT_TRUE(nearest(3, *shape));
  EXPECT_FALSE(nearest(5.01, *shape)) << "1 - 0.2 beta < 0: a saddle of the distance";
  EXPECT_TRUE(std::isnan(breitung(5.01, *shape)));
  EXPECT_NEAR(breitung(3, *shape), normal_above(3) / std::sqrt((1 + 3 * k) * (1 + 3 * l)), 1e-15);
}

// A plane has no curvature: Phi(-beta), on either side of the median.
TEST(Sorm, a_plane_is_exact) {
  const Curved plane{.curvatures = {0, 0}, .least = {0, 1, 0}};
  EXPECT_DOUBLE_EQ(breitung(2, plane), normal_above(2));
  EXPECT_DOUBLE_EQ(breitung(-2, plane), normal_below(2));
  EXPECT_DOUBLE_EQ(breitung(0, plane), 0.5);
}

// Where the median fails the answer is that of the turned question: P(g < 0) = 1 - P(-g < 0), with -beta and -k.
TEST(Sorm, the_turned_question) {
  const Curved shape{.curvatures = {0.3, -0.1}, .least = {0, 0, 1}};
  const Curved turned{.curvatures = {0.1, -0.3}, .least = {0, 1, 0}};
  EXPECT_NEAR(breitung(-1.5, shape), 1 - breitung(1.5, turned), 1e-15);
}

TEST(Sorm, one_input_has_no_curvature_and_a_failed_case_no_shape) {
  const LimitState line = state_of(normals(1), [](const Point& u) { return 2 - u[0]; });
  const auto shape = curved(line, {2}, slope(line, {2}, 0.01), 0.05);
  ASSERT_TRUE(shape);
  EXPECT_TRUE(shape->curvatures.empty());
  const LimitState torn = state_of(
      normals(2), [](const Point& u) { return u[1] > 0 ? std::numeric_limits<double>::quiet_NaN() : 2 - u[0]; });
  EXPECT_FALSE(curved(torn, {2, 0}, slope(torn, {2, 0}, 0.01), 0.05));
}

}  // namespace taut::chance::sorm_test
