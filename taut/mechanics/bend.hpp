#pragma once
#include "taut/machine/model.hpp"
#include "taut/mechanics/branch.hpp"

namespace taut::mechanics {

/// An angle between the directions of a rope before and after a node, and its derivatives by the unit vectors along the
/// path there.
struct Angle {
  double value = 0;  ///< rad
  Vector3 by_in = Vector3::Zero(), by_out = Vector3::Zero();
};

/// The turn of a rope at a node.
struct Bend {
  Angle wrap;     ///< negative where the rope would have to pass through the air above its support
  Angle turning;  ///< all of it, out of the plane of a round too: by this angle a groove is pressed, >= 0
};

/// On a round: about its axis (`end`), in [-pi/2, 3 pi/2) + 2 pi turns. At a point: the angle between the directions;
/// with a support, negative where the rope presses away from it.
Bend bend(const machine::Node& node, const BranchEnd& end, const Vector3& in, const Vector3& out);

/// The turning of a rope on a round with the axis n in the sense of its wrap. With the angles d of `in` and `out` out
/// of the plane of the round, cos = cos d_in cos d_out cos(wrap) + sin d_in sin d_out, and a rope that has left the
/// round upwards (wrap < 0) still presses it aside. Never less than the wrap.
Angle turning(const Vector3& n, const Vector3& in, const Vector3& out, const Angle& wrap);

/// ln(T_out/T_in) for a flow along the path.
struct Loss {
  double log = 0;
  double by_turning = 0;  ///< friction where the groove decides, 0 where the bearing does
};
Loss loss(const machine::ContactLaw& law, const Bend& bend);

/// The bearing of a driven sheave takes this share of T_in + T_out, both less m v^2, of its motor's pull while the rope
/// runs: (1 - eta)/(1 + eta). Without a pull the tensions are then those of a sheave that no motor drives, 1/eta.
double bearing_share(const machine::ContactLaw& law);

}  // namespace taut::mechanics
