#pragma once
#include "taut/math/vector.hpp"

namespace taut {

/// Rotations about the fixed axes x, then y, then z that make up R, rad: R = Rz Ry Rx. What turns about one of these
/// axes alone has its whole angle there, -pi to pi; of the others y is within a quarter turn, as R leaves it open.
Vector3 fixed_angles(const Matrix3& R);
/// R = Rz Ry Rx of these rotations, rad.
Matrix3 by_fixed_angles(const Vector3& angles);

}  // namespace taut
