#pragma once
#include <optional>

#include "taut/analysis/system.hpp"

namespace taut::analysis {

/// The second derivative of the potential energy of a machine without losses, by the freedoms of its bodies and, behind
/// them, the rope that passes each contact; `rows` tells which. From the Jacobian at
/// an equilibrium: rope that passes contact i leaves the branch before it and is fed into the one behind, and the
/// energy falls by T_out - T_in; on a round the rope is held at a direction fixed in its body, so that moving the round
/// does the work of the pulls alone. Symmetric but for the weight of rope on rounds, which the machine leaves out.
struct EnergyCurvature {
  struct Row {
    int freedom = -1;  ///< index in the layout's dofs, or
    int turn = -1;     ///< in its turns
  };
  std::vector<Row> rows;
  Eigen::MatrixXd matrix;    ///< N/m, N, N m
  Eigen::MatrixXd unknowns;  ///< of the machine, by these coordinates
};

/// Empty where it has none: beams (see beam_stability.hpp), losses. Ropes that carry nothing are left out. The length
/// of a mainline and the place of a clamp that follow from a prescribed x are kept as found; so is that x where a force
/// holds the carriage.
std::optional<EnergyCurvature> energy_curvature(const System& system, const Configuration& c, const Evaluation& e);

/// A direction in which a symmetric matrix is negative; empty where there is none beyond rounding. By elimination
/// (Sylvester's law of inertia).
std::optional<Eigen::VectorXd> negative_direction(const Eigen::MatrixXd& matrix);

struct Stability {
  Outcome outcome;       ///< not ok: at the least push the machine moves away; the message names what moves most
  bool rope = false;     ///< that is a rope over its contacts, and no body
  Eigen::VectorXd push;  ///< of the unknowns, in that direction; a hundredth of the longest span
};

/// Whether an equilibrium is one to stay in. Ok also where energy does not tell.
Stability stability(const System& system, const Configuration& c, const Evaluation& e);

}  // namespace taut::analysis
