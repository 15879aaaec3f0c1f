#pragma once
#include "taut/machine/model.hpp"
#include "taut/mechanics/branch.hpp"

namespace taut::mechanics {

/// The turn of a rope at a node. Derivatives by the unit vectors along the path before and after it.
struct Bend {
  double wrap = 0;  ///< rad; negative where the rope would have to pass through the air above its support
  Vector3 by_in = Vector3::Zero(), by_out = Vector3::Zero();
};

/// On a round: about its axis (`end`), in [-pi/2, 3 pi/2) + 2 pi turns. At a point: the angle between the directions;
/// with a support, negative where the rope presses away from it.
Bend bend(const machine::Node& node, const BranchEnd& end, const Vector3& in, const Vector3& out);

/// ln(T_out/T_in) for a flow along the path, and its derivative by the wrap.
struct Loss {
  double log = 0, by_wrap = 0;
};
Loss loss(const machine::ContactLaw& law, double wrap);

/// The bearing of a driven sheave takes this share of T_in + T_out, both less m v^2, of its motor's pull while the rope
/// runs: (1 - eta)/(1 + eta). Without a pull the tensions are then those of a sheave that no motor drives, 1/eta.
double bearing_share(const machine::ContactLaw& law);

}  // namespace taut::mechanics
