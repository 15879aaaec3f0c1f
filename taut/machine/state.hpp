#pragma once
#include <optional>
#include <utility>
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

/// State of a branch: the free rope from one node to the next that it touches.
struct BranchState {
  /// Unstretched, at the temperature of the rope, m, for the directions below (unknown: straight); 0 where the rope
  /// does not touch the first node.
  double length = 0;
  Vector3 leaves = Vector3::Zero(), arrives = Vector3::Zero();  ///< unit vectors along the path at its ends; 0: unknown
  std::optional<rope::CatenaryForce> force;                     ///< in the middle of the branch; none: unknown
};

/// Configuration of a machine: a value that can be copied, kept and used as a start.
struct State {
  Array<Pose> bodies;                   ///< [body]
  Array<Array<BranchState>> branches;   ///< [reeving][branch]; branch k begins at node k
  Array<Array<bool>> touched;           ///< [reeving][node]: false where the rope has lifted off
  Array<Array<PieceState>> beams = {};  ///< [beam][piece]
  Array<Array<int>> sides = {};         ///< [reeving][node]: Node::side as found; empty: as in the model
};

/// A copy of the model with the sides of its sheaves as in `state`.
Model with_sides(Model model, const State& state);

/// The state as described, a first guess: bodies at their given places, each rope straight from node to node. A given
/// length, less the arcs, is distributed over the branches as if all had the same tension (a weightless rope: in
/// proportion to the straight lines). Branches of a rope of given tension have their `taut_length`.
State initial_state(const Model& model);

/// Length of the common tangent of two nodes, m; where there is none, the distance of their centres.
double straight_length(const State& state, const Node& from, const Node& to);

/// Ends of that tangent, m; where there is none, the centres.
std::pair<Vector3, Vector3> straight_ends(const State& state, const Node& from, const Node& to);

/// Unstretched length of a branch along its straight line at `tension`, N. The sag is neglected, so the branch is
/// tighter than this tension. For an inextensible rope: the straight line plus a quarter of the extra length that the
/// sag at this tension needs.
double taut_length(const State& state, const Reeving& reeving, const Node& from, const Node& to, double tension);

/// Whether a state is one of this model: as many bodies, ropes with their branches and nodes, beams with their pieces.
bool is_of(const Model& model, const State& state);

/// A place in the ground frame, m.
Vector3 in_ground(const State& state, const Place& place);

}  // namespace taut::machine
