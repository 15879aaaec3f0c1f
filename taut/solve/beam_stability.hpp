#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

struct BeamStability {
  bool stable = true;     ///< the machine's tangent stiffness is positive (neutral ways not counted)
  Array<double> factors;  ///< by beam: see BeamResult::critical_factor; 0: not stable without its forces either; empty
                          ///< where they are not asked for
  double together = 0;    ///< the same with the forces of all beams growing alike
  double swings = std::numeric_limits<double>::infinity();  ///< see BeamResult::swing_factor
};

/// Tangent stiffness of the machine around an equilibrium: ropes and dead forces as in the Jacobian, the unknowns that
/// are no places eliminated; each beam by short straight elements on its deflected axis, with the textbook's geometric
/// stiffness of their axial forces (Przemieniecki, Theory of Matrix Structural Analysis, 1968, ch. 15), so that it may
/// buckle between what holds it. With losses, which make it unsymmetric, its symmetric part. A carriage prescribed by
/// its ropes may move as they let it; one that a force holds may not. Empty where the ropes alone leave it
/// undetermined.
/// `factors`: critical factors are asked for, which cost ten times more than whether it is stable.
std::optional<BeamStability> beam_stability(const mechanics::System& system, const mechanics::Configuration& c,
                                            bool factors = true);

}  // namespace taut::solve
