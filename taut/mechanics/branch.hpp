#pragma once
#include <optional>

#include "taut/machine/state.hpp"
#include "taut/math/vector.hpp"
#include "taut/rope/span.hpp"

namespace taut::mechanics {

/// What a branch runs from or to: the circle of a round in the ground frame, or a point.
struct BranchEnd {
  Vector3 centre = Vector3::Zero();  ///< m
  Vector3 axis = Vector3::UnitY();   ///< unit vector
  double radius = 0;                 ///< m; negative where the rope turns left-handed about the axis
};

/// The free rope between two ends. A weightless rope is a straight spring that may push (its negative tension says how
/// slack it is, and shares slack out along a rope); `slack` says that nothing of it reaches the machine.
struct Branch {
  Vector3 chord = Vector3::Zero();                                     ///< between the tangent points, m
  Vector3 offset_from = Vector3::Zero(), offset_to = Vector3::Zero();  ///< centre to tangent point, m
  Vector3 pull_from = Vector3::Zero(), pull_to = Vector3::Zero();      ///< tension at the ends, along the path, N
  Vector3 leaves = Vector3::UnitX(), arrives = Vector3::UnitX();       ///< unit vectors along the path there
  double T_from = 0, T_to = 0;                                         ///< N
  double length = 0;                                                   ///< unstretched, m
  bool slack = false;
  double closure = 0;  ///< m
  rope::Span span;     ///< of a rope with weight
  /// Of a rope with weight: derivatives in its plane at the force where its last Newton step began; none: exact.
  std::optional<rope::CatenaryStiffness> stiffness;
};

/// Derivatives of a branch, by X, the vector from centre to centre (axes kept), and by the rope that is fed into it, u:
/// what its free length and the arcs up to a fixed direction on each round take up together. The pulls differ by the
/// rope's weight.
struct BranchRates {
  Matrix3 pull_from_X = Matrix3::Zero(), pull_to_X = Matrix3::Zero();
  Matrix3 leaves_X = Matrix3::Zero(), arrives_X = Matrix3::Zero();
  Matrix3 offset_from_X = Matrix3::Zero(), offset_to_X = Matrix3::Zero();
  Vector3 pull_from_u = Vector3::Zero(), pull_to_u = Vector3::Zero();
  Vector3 leaves_u = Vector3::Zero(), arrives_u = Vector3::Zero();
  Vector3 offset_from_u = Vector3::Zero(), offset_to_u = Vector3::Zero();
  Vector3 length_X = Vector3::Zero();  ///< a row
  double length_u = 1;
};

/// The branch of `rope` between two ends. Where an end has a radius, the tangent point follows the direction of the
/// sagging rope itself, r (d x a)/|d x a| from the centre: a Newton iteration around the span's. `rope.length` is what
/// is free while the rope leaves and arrives as `start` says (unknown: along the straight tangent line); what lies on
/// the rounds beyond those directions is taken from it. (With the free length itself given, a rope that sags over large
/// rounds has two shapes or none: sag draws rope onto the rounds about as fast as it needs more of it.) A
/// span that its start's force closes to 2 % of the chord gets one Newton step, and what was open counts as closure:
/// an iteration that asks again closes it quadratically, together with all else. too_short as of a span; not_converged
/// also where the rounds leave no line.
tl::expected<Branch, rope::NoCatenary> solve_branch(const rope::CatenaryRope& rope, const BranchEnd& from,
                                                    const BranchEnd& to, const machine::BranchState& start);

BranchRates rates(const rope::CatenaryRope& rope, const BranchEnd& from, const BranchEnd& to, const Branch& branch);

/// d(offset)/d(axis) times a small change of the axis, the rope's direction kept, m.
Vector3 offset_change(const BranchEnd& end, const Vector3& direction, const Vector3& axis_change);

}  // namespace taut::mechanics
