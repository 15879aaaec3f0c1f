#pragma once
#include <optional>
#include <string>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/math/sparse_rows.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// The second derivative of the potential energy of a machine, by the rope that passes each contact or is fed in where
/// a tension is given and, behind them, the freedoms of its bodies; `rows` tells which. From the Jacobian at
/// an equilibrium: rope that passes contact i leaves the branch before it and is fed into the one behind, and the
/// energy falls by T_out - T_in; on a round the rope is held at a direction fixed in its body, so that moving the round
/// does the work of the pulls alone. A rope fed in at its end works against the given tension, which is held (not with
/// System::lengths_kept). Symmetric but for the weight of rope on rounds, which the machine leaves out, and for losses:
/// with these it is the stiffness of the machine as it runs.
struct EnergyCurvature {
  /// What a coordinate is of.
  enum class Of { freedom, contact, fed_end };
  struct Row {
    Of of = Of::freedom;
    int index = 0;  ///< in the layout's dofs, its turns, its fed_ends
  };
  Array<Row> rows;
  SparseRows matrix;    ///< N/m, N, N m
  SparseRows unknowns;  ///< of the machine, by these coordinates
};

/// Empty where it has none: beams (see beam_stability.hpp), forces along ropes (see places_stiffness.hpp). Ropes that
/// carry nothing are left out. The length of a mainline and the place of a clamp that follow from a prescribed x are
/// kept as found; so is that x where a force holds the carriage.
std::optional<EnergyCurvature> energy_curvature(const mechanics::System& system, const mechanics::Configuration& c,
                                                const mechanics::Evaluation& e);

/// A direction in which a matrix that is symmetric, or nearly so, is negative; empty where there is none beyond
/// rounding. By elimination in the order of its rows (Sylvester's law of inertia): what is left of a row is the force
/// against it while those before it follow freely, right also where they are stiff and not quite symmetric.
std::optional<Eigen::VectorXd> negative_direction(const SparseRows& matrix);

/// Whether forces act along ropes: these follow their rope, and have no potential.
bool has_rope_loads(const mechanics::System& system);

struct Stability {
  Outcome outcome;       ///< not ok: at the least push the machine moves away; the message names what moves most
  bool rope = false;     ///< that is a rope over its contacts, or at its end, and no body
  bool beam = false;     ///< it is a beam; `check_beams` tells which, and by how much
  Eigen::VectorXd push;  ///< of the unknowns, in that direction; a hundredth of the longest span
};

/// Bodies that could as well stand elsewhere (an indifferent equilibrium: the energy is the same all along a way) and
/// are, along that way, more than a hundredth of the longest span from where they are described; in words: which
/// bodies, and by how much; empty without one. No way is sought with a carriage at a prescribed x, as this costs a
/// fifth of a load path, nor with forces along ropes or beams.
std::string indifferent(const mechanics::System& system, const mechanics::Configuration& c,
                        const mechanics::Evaluation& e);

/// Whether an equilibrium is one to stay in. With losses: whether the machine stays as it runs, each loss as large as
/// its rope's tension makes it.
Stability stability(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e);

}  // namespace taut::solve
