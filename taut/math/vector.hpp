#pragma once
#include <Eigen/Core>

namespace taut {

/// A vector and a matrix of space, right-handed axes. Eigen keeps them on the stack.
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// The upward direction: gravity pulls along -z.
inline Vector3 up() { return Vector3::UnitZ(); }

/// What a projection leaves of a vector: the part across the unit vector `d`.
inline Matrix3 across(const Vector3& d) { return Matrix3::Identity() - d * d.transpose(); }

}  // namespace taut
