#pragma once
#include <functional>
#include <vector>

#include "taut/math/vector.hpp"
#include "taut/structure/beam.hpp"

/// An elastic rod by an integration that shares nothing with the engine's: quaternions and Runge-Kutta steps, rates by
/// differences. All SI, z up.
namespace taut_test::witness {

using taut::Matrix3;
using taut::Vector3;

/// State of a cross-section of a beam in space. `force`, `moment`: exerted by the part above on the part below.
struct BeamState {
  Vector3 place = Vector3::Zero();
  Matrix3 axes = Matrix3::Identity();  ///< columns: the section's x and y, and the beam's direction
  Vector3 force = Vector3::Zero();     ///< N
  Vector3 moment = Vector3::Zero();    ///< N m
};

taut::structure::SectionForces section_forces(const BeamState& state);

/// Integrates a state along `length` of a beam whose only load is its own weight (Kirchhoff-Love rod, rigid in shear):
/// F' = weight up, M' = -r' x F, r' = (1 + N/EA) d3; the axes rotate with the curvatures M_1/EI_y, M_2/EI_x, M_3/GJ
/// (Antman, Nonlinear Problems of Elasticity, ch. 8). Classical Runge-Kutta method with `steps` equal steps, the axes
/// as a quaternion. `each`, if given, receives the states after each step.
BeamState carry(const taut::structure::BeamSection& section, const BeamState& from, double length, int steps,
                std::vector<BeamState>* each = nullptr);

/// Stiffness of a piece between two sections about an equilibrium, 12 x 12: forces and moments required at its ends by
/// displacements and (spatial) rotations of its ends. Rows F0, M0, F1, M1; columns u0, turn0, u1, turn1. From the
/// transfer matrix by central differences. `carry_on` takes a state at the lower end to the upper one, including
/// whatever acts between them; `length`, m, and `EI`, N m2, set the size of the differences. Symmetric except for terms
/// of the end moments.
Eigen::Matrix<double, 12, 12> piece_stiffness(const std::function<BeamState(const BeamState&)>& carry_on,
                                              const BeamState& from, double length, double EI);

}  // namespace taut_test::witness
