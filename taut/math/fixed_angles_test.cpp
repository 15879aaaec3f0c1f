#include "taut/math/fixed_angles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace taut::fixed_angles_test {
namespace {

using std::numbers::pi;

Matrix3 turned(double by, int axis) { return Eigen::AngleAxisd(by, Vector3(Vector3::Unit(axis))).toRotationMatrix(); }

TEST(FixedAngles, AboutOneAxisTheWholeTurnCounts) {
  for (int axis = 0; axis < 3; ++axis) {
    for (double angle = -3.1; angle < pi; angle += 0.1) {
      const Vector3 found = fixed_angles(turned(angle, axis));
      EXPECT_NEAR(found[axis], angle, 1e-14);
      EXPECT_LT(std::abs(found.sum() - found[axis]), 1e-14);
    }
  }
}

TEST(FixedAngles, OneAfterTheOther) {
  for (const double y : {-1.5, -0.4, 0.0, 1.2}) {
    for (const double x : {-2.5, 0.3, 3.0}) {
      const Vector3 found = fixed_angles(turned(-0.7, 2) * turned(y, 1) * turned(x, 0));
      EXPECT_LT((found - Vector3(x, y, -0.7)).norm(), 1e-12);
      EXPECT_LT((by_fixed_angles({x, y, -0.7}) - turned(-0.7, 2) * turned(y, 1) * turned(x, 0)).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace taut::fixed_angles_test
