#pragma once
#include <Eigen/Core>

namespace taut {

/// Vector and matrix in space, right-handed axes, on the stack.
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// The upward direction: gravity pulls along -z.
inline Vector3 up() { return Vector3::UnitZ(); }

/// The projection on the plane normal to the unit vector `d`: across(d) v is the part of v normal to d.
inline Matrix3 across(const Vector3& d) { return Matrix3::Identity() - d * d.transpose(); }

}  // namespace taut
