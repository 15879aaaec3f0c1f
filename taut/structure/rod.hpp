#pragma once
#include <vector>

#include "taut/structure/beam.hpp"

/// One piece of an elastic beam between two of its cross-sections, with its derivatives: what a system of equations
/// needs that has the forces at the piece's start among its unknowns. All SI, z up.
namespace taut::structure {

/// Which geometry the balance of moments is written in: of the deflected axis (exact: no rotation is too large), or of
/// the axis as it was built, with small rotations (first order: bending does not know of the axial force).
enum class BeamOrder { first, second };

/// The axis as built: over the arc length s of the whole beam it is turned by angle cos(pi s/length) towards a
/// direction of the section: a half wave of sine, e = length angle/pi in its middle. Free of stress.
struct Bow {
  double angle = 0;                                    ///< at the start, rad; 0: straight
  double length = 1;                                   ///< of the whole beam, m
  Eigen::Vector2d towards{1, 0};                       ///< unit vector of the section's x and y
  double turn(double s) const;                         ///< of the axis against its chord, rad
  Matrix3 axes(const Matrix3& chord, double s) const;  ///< of the section at s; `chord`: x, y, direction of the chord
};

/// Between the sections at s = from and s = to of the whole beam.
struct RodPiece {
  BeamSection section;
  Bow bow;
  BeamOrder order = BeamOrder::second;
  double from = 0, to = 1;  ///< m
  int steps = 16;           ///< of the classical Runge-Kutta method
};

/// A cross-section of a piece. `force`, `moment`: of the part above on the part below. Second order: `axes` are those
/// of the deflected section. First order: `axes` are those of the section as built, `turn` its small rotation from
/// there.
struct RodState {
  Vector3 place = Vector3::Zero();
  Matrix3 axes = Matrix3::Identity();
  Vector3 turn = Vector3::Zero();   ///< rad
  Vector3 force = Vector3::Zero();  ///< N
  Vector3 moment = Vector3::Zero();
};

/// Carries a state from the start of a piece to its end. Second order as `carry` (Kirchhoff-Love rod); first order
/// place' = d3 + turn x d3 + (F.d3/EA) d3, turn' = curvature of M, M' = -d3 x F, with d3 and the curvatures' axes as
/// built. `each`, if given, gets all steps' ends, the start left out.
RodState along(const RodPiece& piece, const RodState& start, std::vector<RodState>* each = nullptr);

/// d(end)/d(start): rows place, turn, force, moment; columns: a turn of the start with all axes as built (second order:
/// of the start), a turn of the start alone (the same in second order), force, moment. Turns are spatial. By the
/// variational equation, integrated beside the state.
using RodRates = Eigen::Matrix<double, 12, 12>;
RodState along(const RodPiece& piece, const RodState& start, RodRates& rates);

/// Axial force, shear, bending and torsion in the axes that carry them: deflected (second order) or as built.
SectionForces section_forces(const RodState& state);

/// A rotation as the vector sin(angle) times its axis, and its derivatives by a spatial turn of the rotation from the
/// left, and by one from the right: r(exp(a) Q) = r(Q) + left a, r(Q exp(b)) = r(Q) + right b.
Vector3 sine_vector(const Matrix3& Q);
Matrix3 sine_by_left(const Matrix3& Q);
Matrix3 sine_by_right(const Matrix3& Q);

/// The matrix of the cross product: cross(a) b = a x b.
Matrix3 cross(const Vector3& a);

}  // namespace taut::structure
