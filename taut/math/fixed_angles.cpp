#include "taut/math/fixed_angles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace taut {

Vector3 fixed_angles(const Matrix3& R) {
  constexpr double tilt = 1e-12;  // half the square of the angle by which an axis may lean and still be the same
  for (int k = 0; k < 3; ++k) {
    if (R(k, k) < 1 - tilt) continue;
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    Vector3 angles = Vector3::Zero();
    angles[k] = std::atan2(R(j, i), R(i, i));
    return angles;
  }
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)), std::atan2(R(1, 0), R(0, 0))};
}

Matrix3 by_fixed_angles(const Vector3& angles) {
  Matrix3 R = Matrix3::Identity();
  for (int k = 0; k < 3; ++k) R = Eigen::AngleAxisd(angles[k], Vector3::Unit(k)).toRotationMatrix() * R;
  return R;
}

}  // namespace taut
