#pragma once
#include <vector>

#include "taut/structure/beam.hpp"

/// One piece of an elastic beam between two of its cross-sections, with its derivatives. A system of equations uses it
/// with the forces at the start of the piece among its unknowns. All SI, z up.
namespace taut::structure {

/// Geometry in which the moments are balanced. second: the deflected axis (exact for rotations of any size). first: the
/// axis as built, with small rotations; bending then does not depend on the axial force.
enum class BeamOrder { first, second };

/// The axis as built, free of stress: at the arc length s of the whole beam it is rotated by angle * cos(pi s/length)
/// towards a direction of the section. That is a half sine wave with e = length * angle/pi in the middle.
struct Bow {
  double angle = 0;               ///< at the start, rad; 0: straight
  double length = 1;              ///< of the whole beam, m
  Eigen::Vector2d towards{1, 0};  ///< unit vector of the section's x and y
  double turn(double s) const;    ///< rotation of the axis against its chord, rad
  /// Axes of the section at s. Columns of `chord`: x, y, direction of the chord.
  Matrix3 axes(const Matrix3& chord, double s) const;
};

/// The piece between the sections at s = from and s = to of the whole beam.
struct RodPiece {
  BeamSection section;
  Bow bow;
  BeamOrder order = BeamOrder::second;
  double from = 0, to = 1;    ///< m
  int steps = 16;             ///< of the classical Runge-Kutta method
  double thermal_strain = 0;  ///< expansion coefficient times (temperature - that at which it is as built), > -1
};

/// State of a cross-section of a piece. `force`, `moment`: exerted by the part above on the part below. Second order:
/// `axes` are those of the deflected section. First order: `axes` are those of the section as built, `turn` its small
/// rotation against them.
struct RodState {
  Vector3 place = Vector3::Zero();
  Matrix3 axes = Matrix3::Identity();
  Vector3 turn = Vector3::Zero();   ///< rad
  Vector3 force = Vector3::Zero();  ///< N
  Vector3 moment = Vector3::Zero();
};

/// Integrates a state from the start of a piece to its end. Second order: a Kirchhoff-Love rod whose only load is its
/// own weight w, rigid in shear: F' = w up, M' = -place' x F, place' = (1 + N/EA + thermal_strain) d3, the axes turn
/// with the curvatures M_1/EI_y, M_2/EI_x, M_3/GJ (Antman, Nonlinear Problems of Elasticity, ch. 8). First order:
/// place' = d3 + turn x d3 + (F.d3/EA + thermal_strain) d3, turn' = curvature of M, M' = -d3 x F, with d3 and the axes
/// of the curvatures as built. `each`, if given, receives the states after each step.
RodState along(const RodPiece& piece, const RodState& start, std::vector<RodState>* each = nullptr);

/// d(end)/d(start), 12 x 12. Rows: place, turn, force, moment. Columns: a rotation of the start together with all axes
/// as built (second order: of the start); a rotation of the start alone (second order: the same); force; moment.
/// Rotations are spatial. From the variational equation, integrated together with the state.
using RodRates = Eigen::Matrix<double, 12, 12>;
RodState along(const RodPiece& piece, const RodState& start, RodRates& rates);

/// Section forces of a state, in the deflected axes (second order) or those as built (first order).
SectionForces section_forces(const RodState& state);

/// r(Q) = sin(angle) times the axis of the rotation Q, and its derivatives by a spatial rotation from the left and from
/// the right: r(exp(a) Q) = r(Q) + left a, r(Q exp(b)) = r(Q) + right b.
Vector3 sine_vector(const Matrix3& Q);
Matrix3 sine_by_left(const Matrix3& Q);
Matrix3 sine_by_right(const Matrix3& Q);

/// The matrix of the cross product: cross(a) b = a x b.
Matrix3 cross(const Vector3& a);

}  // namespace taut::structure
