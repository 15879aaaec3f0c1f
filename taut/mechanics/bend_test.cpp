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
      EXPECT_NEAR(bend(node, end, at_angle(0.4), at_angle(0.4 + side * angle)).wrap.value, angle, 1e-12);
      EXPECT_NEAR(bend(node, end, at_angle(0.4), at_angle(0.4 - side * 0.3)).wrap.value, -0.3, 1e-12)
          << "through the air";
    }
  }
  node.turns = 2;
  const BranchEnd end{.centre = Vector3::Zero(), .axis = Vector3::UnitY(), .radius = 0.3};
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(1)).wrap.value, 1 + 4 * pi, 1e-12);
}

TEST(Bend, AtAPointIsTheAngleBetweenWithTheSupportsSign) {
  machine::Node node;
  const BranchEnd end;
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(0.7)).wrap.value, 0.7, 1e-12);
  EXPECT_NEAR(bend(node, end, at_angle(0.7), at_angle(0)).wrap.value, 0.7, 1e-12) << "no side without a support";
  node.support = Vector3::UnitZ();
  // a turn about +y leads downwards: the rope lies on what is below it
  EXPECT_NEAR(bend(node, end, at_angle(0), at_angle(0.7)).wrap.value, 0.7, 1e-12);
  EXPECT_NEAR(bend(node, end, at_angle(0.7), at_angle(0)).wrap.value, -0.7, 1e-12) << "it pulls away upwards";
  EXPECT_EQ(bend(node, end, at_angle(0.2), at_angle(0.2)).wrap.value, 0);
}

TEST(Bend, ItsDerivativesAreThoseOfDifferences) {
  taut_test::Dice dice{std::mt19937(3)};
  int out_of_plane = 0;
  for (int i = 0; i < 300; ++i) {
    machine::Node node;
    node.radius = i % 3 < 2 ? 0.4 : 0;
    const BranchEnd end{.centre = Vector3::Zero(),
                        .axis = Vector3(dice.in(-0.2, 0.2), 1, dice.in(-0.2, 0.2)).normalized(),
                        .radius = node.radius * (i % 4 == 0 ? 1 : -1)};
    const double aside = i % 3 == 0 ? 0.8 : 0.1;
    const Vector3 in(1, dice.in(-aside, aside), dice.in(-0.5, 0.5)),
        out(1, dice.in(-aside, aside), i % 3 == 0 ? dice.in(-0.5, 0.5) : dice.in(0.6, 2));
    const Bend b = bend(node, end, in.normalized(), out.normalized());
    const auto compare = [&](Angle Bend::*of) {
      for (int k = 0; k < 3; ++k) {
        const double h = 1e-6;
        const Vector3 d = h * Vector3::Unit(k);
        // the directions stay unit vectors: only changes across them count
        const auto angle = [&](const Vector3& a, const Vector3& c) {
          return (bend(node, end, a.normalized(), c.normalized()).*of).value;
        };
        const Vector3 u = in.normalized(), v = out.normalized();
        const Vector3 du = Vector3::Unit(k) - u * u[k], dv = Vector3::Unit(k) - v * v[k];
        EXPECT_NEAR((angle(u + d, v) - angle(u - d, v)) / (2 * h), (b.*of).by_in.dot(du), 1e-6) << i;
        EXPECT_NEAR((angle(u, v + d) - angle(u, v - d)) / (2 * h), (b.*of).by_out.dot(dv), 1e-6) << i;
      }
    };
    compare(&Bend::wrap);
    compare(&Bend::turning);
    EXPECT_GE(b.turning.value, b.wrap.value);
    if (node.radius > 0 && b.wrap.value < 0) ++out_of_plane;
  }
  EXPECT_GT(out_of_plane, 30) << "a rope that is only pressed aside";
}

TEST(Bend, TurnsOutOfThePlaneOfItsRoundToo) {
  machine::Node node;
  node.radius = 0.3;
  const BranchEnd end{.centre = Vector3::Zero(), .axis = Vector3::UnitY(), .radius = 0.3};
  const auto directed = [](double plan, double down) {
    return Vector3(std::cos(plan) * std::cos(down), std::sin(plan) * std::cos(down), -std::sin(down));
  };
  // level: 40 degrees in plan, no wrap at all
  const Bend level = bend(node, end, directed(-0.35, 0), directed(0.35, 0));
  EXPECT_NEAR(level.wrap.value, 0, 1e-15);
  EXPECT_NEAR(level.turning.value, 0.7, 1e-12);
  // the law of cosines on the sphere, side by side
  const Bend both = bend(node, end, directed(-0.35, -0.1), directed(0.35, 0.1));
  EXPECT_NEAR(std::cos(both.turning.value),
              std::cos(0.7) * std::cos(0.1) * std::cos(0.1) - std::sin(0.1) * std::sin(0.1), 1e-12);
  EXPECT_NEAR(both.wrap.value, 2 * std::atan(std::tan(0.1) / std::cos(0.35)), 1e-12);
  // it has left the round upwards, its strap still holds it aside
  EXPECT_NEAR(bend(node, end, directed(0.35, 0.1), directed(-0.35, -0.1)).turning.value,
              2 * std::asin(std::sin(0.35) * std::cos(0.1)), 1e-12);
  // in its plane the turning is the wrap, beyond half a turn too
  for (const double angle : {0.5, 3.0, 4.5}) {
    EXPECT_NEAR(bend(node, end, at_angle(0.4), at_angle(0.4 + angle)).turning.value, angle, 1e-12);
  }
}

TEST(Loss, IsTheLesserOfGripAndBearing) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto bent = [](double wrap, double turning) {
    return Bend{.wrap = {.value = wrap}, .turning = {.value = turning}};
  };
  EXPECT_NEAR(loss({inf, 0.95}, bent(1, 1)).log, -std::log(0.95), 1e-15) << "cannot slip";
  EXPECT_EQ(loss({inf, 0.95}, bent(1, 1)).by_turning, 0);
  EXPECT_NEAR(loss({0.1, 0}, bent(2.5, 2.5)).log, 0.25, 1e-15) << "cannot turn";
  EXPECT_EQ(loss({0.1, 0}, bent(2.5, 2.5)).by_turning, 0.1);
  EXPECT_NEAR(loss({0.1, 0.9}, bent(1, 1)).log, 0.1, 1e-15) << "slips before it turns";
  EXPECT_NEAR(loss({0.1, 0.9}, bent(2, 2)).log, -std::log(0.9), 1e-15) << "turns before it slips";
  EXPECT_EQ(loss({0.1, 0.9}, bent(-0.2, 0)).log, 0) << "does not touch";
  EXPECT_NEAR(loss({0.1, 0}, bent(0.2, 0.7)).log, 0.07, 1e-15) << "by all of the turning";
  EXPECT_NEAR(loss({0.1, 0.5}, bent(0.2, 0.7)).log, 0.07, 1e-15) << "of a sheave too";
}

}  // namespace taut::mechanics::bend_test
