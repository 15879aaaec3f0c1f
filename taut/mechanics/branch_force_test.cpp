#include "taut/mechanics/branch_force.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/rope/exact_end.hpp"
#include "test/support/dice.hpp"

namespace taut::mechanics::branch_force_test {

BranchEnd round(const Vector3& centre, double radius, const Vector3& axis = Vector3::UnitY()) {
  return {.centre = centre, .axis = axis.normalized(), .radius = radius};
}

TEST(BranchForce, TheStraightLineTouchesBothRounds) {
  taut_test::Dice dice{std::mt19937(2)};
  for (int i = 0; i < 200; ++i) {
    const BranchEnd from = round({0, 0, 0}, dice.in(-1, 1));
    const BranchEnd to = round({dice.in(4, 30), 0, dice.in(-20, 20)}, dice.in(-1, 1));
    const BranchDirections d = straight_directions(from, to);
    EXPECT_LT((d.leaves - d.arrives).norm(), 1e-12);
    const Vector3 line = to.centre + tangent_offset(to, d.arrives) - from.centre - tangent_offset(from, d.leaves);
    EXPECT_NEAR(line.cross(d.leaves).norm(), 0, 1e-9) << "from tangent point to tangent point";
    EXPECT_NEAR(tangent_offset(from, d.leaves).norm(), std::abs(from.radius), 1e-12);
    EXPECT_NEAR(tangent_offset(from, d.leaves).dot(d.leaves), 0, 1e-12);
  }
}

TEST(BranchForce, RatesAreThoseOfDifferences) {
  taut_test::Dice dice{std::mt19937(4)};
  const double h = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const BranchEnd end = round({0, 0, 0}, dice.in(0.1, 1) * (i % 2 == 0 ? 1 : -1), {dice.in(-0.3, 0.3), 1, 0.1});
    const Vector3 d = Vector3(dice.in(-1, 1), dice.in(-0.2, 0.2), dice.in(0.2, 1)).normalized();
    const BranchEnd none = round({9, 0, 0}, 0);
    for (int k = 0; k < 3; ++k) {
      const Vector3 by = h * (Vector3::Unit(k) - d * d[k]);
      const Vector3 ahead = (d + by).normalized(), back = (d - by).normalized();
      const Vector3 change = (tangent_offset(end, ahead) - tangent_offset(end, back)) / (2 * h);
      EXPECT_LT((change - tangent_offset_rate(end, d) * by / h).norm(), 1e-7);
      const double leaves =
          arcs_between(end, none, {.leaves = back, .arrives = d}, {.leaves = ahead, .arrives = d}) / (2 * h);
      EXPECT_NEAR(leaves, arc_rate(end, d, true).dot(by) / h, 1e-7);
      const double arrives =
          arcs_between(none, end, {.leaves = d, .arrives = back}, {.leaves = d, .arrives = ahead}) / (2 * h);
      EXPECT_NEAR(arrives, arc_rate(end, d, false).dot(by) / h, 1e-7);
    }
  }
}

TEST(BranchForce, ItsForceEndsTheRopeAtTheTangentPoint) {
  taut_test::Dice dice{std::mt19937(6)};
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const BranchEnd from = round({0, 0, 0}, dice.in(-2, 2));
    const BranchEnd to = round({dice.in(10, 60), dice.in(-2, 2), dice.in(-30, 30)}, dice.in(-2, 2));
    const BranchDirections straight = straight_directions(from, to);
    const double chord = (to.centre - from.centre).norm();
    const rope::CatenaryRope rope{
        .length = chord * dice.in(0.999, 1.3), .weight = dice.ten_to(0, 2), .stiffness = dice.ten_to(6, 9)};
    const auto b = branch_force(rope, from, to, straight);
    if (!b) continue;
    ++found;
    // the weight of each half turns the force in the middle into those at the ends
    const Vector3 half = rope.weight * b->length / 2 * up();
    const Vector3 leaves = (b->force - half).normalized(), arrives = (b->force + half).normalized();
    const Vector3 between = to.centre + tangent_offset(to, arrives) - from.centre - tangent_offset(from, leaves);
    const double H = std::hypot(b->force.x(), b->force.y());
    rope::CatenaryRope free = rope;
    free.length = b->length;
    const rope::ExactEnd end = rope::exact_end(free, {.H = H, .V = b->force.z()});
    const Vector3 along = Vector3(b->force.x(), b->force.y(), 0) / H;
    const Vector3 reached = static_cast<double>(end.x) * along + static_cast<double>(end.z) * up();
    EXPECT_LT((reached - between).norm(), 1e-7 * chord) << i;
    EXPECT_NEAR(b->length + arcs_between(from, to, straight, {leaves, arrives}), rope.length, 1e-9 * chord) << i;
  }
  EXPECT_GT(found, 280);
}

}  // namespace taut::mechanics::branch_force_test
