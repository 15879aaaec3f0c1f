#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/math/vector.hpp"
#include "taut/rope/catenary.hpp"

namespace taut::machine {

struct Pose {
  Vector3 position = Vector3::Zero();         ///< of the body's origin, m
  Matrix3 orientation = Matrix3::Identity();  ///< body to ground
};

/// The free rope from one node to the next one that it touches.
struct BranchState {
  /// Unstretched, at the rope's temperature, m, with the directions below (unknown: straight); 0 where the node before
  /// is not touched.
  double length = 0;
  Vector3 leaves = Vector3::Zero(), arrives = Vector3::Zero();  ///< unit vectors along the path at its ends; 0: unknown
  std::optional<rope::CatenaryForce> force;                     ///< at its middle; none: unknown
};

/// Where a machine is: a value, to be copied, kept and started from.
struct State {
  Array<Pose> bodies;                   ///< as in the model
  Array<Array<BranchState>> branches;   ///< [reeving][branch], branch k from node k on
  Array<Array<bool>> touched;           ///< [reeving][node]: false where the rope has lifted off
  Array<Array<PieceState>> beams = {};  ///< [beam][piece]
  Array<Array<int>> sides = {};         ///< [reeving][node], Node::side as found; empty: as in the model
};

/// The model with the sides of its sheaves as they are in a state of it.
Model with_sides(Model model, const State& state);

/// As described: bodies where they are given, each rope straight from round to round; what its given length leaves
/// beside the arcs is shared out in proportion. A rope of given tension has its `taut_length`.
State initial_state(const Model& model);

/// The straight line from one node to the next, tangent to both, m. Of the centres where there is none.
double straight_length(const State& state, const Node& from, const Node& to);

/// Unstretched length of a branch on its straight line at a tension, N: less than it needs with its sag, so that it is
/// tighter than that. A rope that does not stretch gets a quarter of its sag's length more than the line.
double taut_length(const State& state, const Reeving& reeving, const Node& from, const Node& to, double tension);

/// A place in the ground frame, m.
Vector3 in_ground(const State& state, const Place& place);

}  // namespace taut::machine
