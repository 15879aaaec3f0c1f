#pragma once
#include <optional>

#include "taut/mechanics/branch.hpp"

namespace taut::mechanics {

/// Directions of a rope at its ends, along the path.
struct BranchDirections {
  Vector3 leaves = Vector3::UnitX(), arrives = Vector3::UnitX();
};

/// Along the straight line tangent to both rounds.
BranchDirections straight_directions(const BranchEnd& from, const BranchEnd& to);

/// What the arcs on both rounds grow by when a rope that left and arrived as `then` does so as `now`, m.
double arcs_between(const BranchEnd& from, const BranchEnd& to, const BranchDirections& then,
                    const BranchDirections& now);

/// Its derivative by the direction in which the rope leaves or arrives at a round.
Vector3 arc_rate(const BranchEnd& end, const Vector3& direction, bool leaves);

/// The force in the middle (N, along the path) and the free length of a rope with weight between two rounds, from afar;
/// `free` as in solve_branch, with the rope's length. A damped Newton iteration for the force as a vector of space:
/// where the rope's end then lies is explicit, and so are the tangent points, while the chord of a nearly taut rope
/// tells its force only through a small difference. First from the straight line, then with the rounds growing from
/// points.
struct BranchForce {
  Vector3 force = Vector3::Zero();
  double length = 0;
};
std::optional<BranchForce> branch_force(const rope::CatenaryRope& rope, const BranchEnd& from, const BranchEnd& to,
                                        const BranchDirections& free);

/// The tangent point of a round seen from its centre, for a rope along `direction`, m.
Vector3 tangent_offset(const BranchEnd& end, const Vector3& direction);

/// Its derivative by the direction.
Matrix3 tangent_offset_rate(const BranchEnd& end, const Vector3& direction);

}  // namespace taut::mechanics
