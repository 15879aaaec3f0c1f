#include "taut/mechanics/bend.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "test/support/dice.hpp"

namespace taut::mechanics::bend_test {

using std::numbers::pi;

/// A unit vector in the plane across y, turned by an angle from x about +y.
Vector3 at_angle(double angle) { return Eigen::AngleAxisd(angle, Vector3::UnitY()) * Vector3::UnitX(); }

TEST(Bend, OnARoundIsTheAngleTurnedAboutItsAxis) {
  machine::Node node;
  node.radius = 0.3;
  for (const double side : {1.0, -1.0}) {
    for (const double angle : {0.2, 1.5, 3.0, 4.5}) {
      const BranchEnd end{.centre = Vector3::Zero(), .axis = Vector3::UnitY(), .radius = side * node.radius};
      EXPECT_NEAR(bend(node, end, at_angle(0.4), at_angle(0.4 + side * angle)).wrap, angle, 1e-12);
      EXPECT_NEAR(bend(node, end, at_angle(0.4), at_angle(0.4 - side * 0.3)).wrap, -0.3, 1e-12) << "through the air";
    }
  }
  node.turns = 2;
  const BranchEnd end{.centre = Vector3::Zero(), .axis = Vector3::UnitY(), .radius = 0.3};
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(1)).wrap, 1 + 4 * pi, 1e-12);
}

TEST(Bend, AtAPointIsTheAngleBetweenWithTheSupportsSign) {
  machine::Node node;
  const BranchEnd end;
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(0.7)).wrap, 0.7, 1e-12);
  EXPECT_NEAR(bend(node, end, at_angle(0.7), at_angle(0)).wrap, 0.7, 1e-12) << "no side without a support";
  node.support = Vector3::UnitZ();
  // a turn about +y leads downwards: the rope lies on what is below it
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(0.7)).wrap, 0.7, 1e-12);
  EXPECT_NEAR(bend(node, end, at_angle(0.7), at_angle(0)).wrap, -0.7, 1e-12) << "it pulls away upwards";
  EXPECT_EQ(bend(node, end, at_angle(0.2), at_angle(0.2)).wrap, 0);
}

TEST(Bend, ItsDerivativesAreThoseOfDifferences) {
  taut_test::Dice dice{std::mt19937(3)};
  for (int i = 0; i < 200; ++i) {
    machine::Node node;
    node.radius = i % 2 == 0 ? 0.4 : 0;
    const BranchEnd end{.centre = Vector3::Zero(),
                        .axis = Vector3(dice.in(-0.2, 0.2), 1, dice.in(-0.2, 0.2)).normalized(),
                        .radius = node.radius * (i % 4 == 0 ? 1 : -1)};
    const Vector3 in(1, dice.in(-0.1, 0.1), dice.in(-0.5, 0.5)), out(1, dice.in(-0.1, 0.1), dice.in(0.6, 2));
    const Bend b = bend(node, end, in.normalized(), out.normalized());
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-6;
      const Vector3 d = h * Vector3::Unit(k);
      // the directions stay unit vectors: only changes across them count
      const auto wrap = [&](const Vector3& a, const Vector3& c) {
        return bend(node, end, a.normalized(), c.normalized()).wrap;
      };
      const Vector3 u = in.normalized(), v = out.normalized();
      const Vector3 du = Vector3::Unit(k) - u * u[k], dv = Vector3::Unit(k) - v * v[k];
      EXPECT_NEAR((wrap(u + d, v) - wrap(u - d, v)) / (2 * h), b.by_in.dot(du), 1e-7);
      EXPECT_NEAR((wrap(u, v + d) - wrap(u, v - d)) / (2 * h), b.by_out.dot(dv), 1e-7);
    }
  }
}

TEST(Loss, IsTheLesserOfGripAndBearing) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(loss({inf, 0.95}, 1).log, -std::log(0.95), 1e-15) << "cannot slip";
  EXPECT_EQ(loss({inf, 0.95}, 1).by_wrap, 0);
  EXPECT_NEAR(loss({0.1, 0}, 2.5).log, 0.25, 1e-15) << "cannot turn";
  EXPECT_EQ(loss({0.1, 0}, 2.5).by_wrap, 0.1);
  EXPECT_NEAR(loss({0.1, 0.9}, 1).log, 0.1, 1e-15) << "slips before it turns";
  EXPECT_NEAR(loss({0.1, 0.9}, 2).log, -std::log(0.9), 1e-15) << "turns before it slips";
  EXPECT_EQ(loss({0.1, 0.9}, -0.2).log, 0) << "does not touch";
}

}  // namespace taut::mechanics::bend_test
