#pragma once
#include "taut/mechanics/system.hpp"

/// Beams in the equations of equilibrium. The forces at the start of each piece are unknowns of their own, and its
/// closure (the piece carried from its start ends where the next body is) are equations: nothing becomes stiff where a
/// beam does, and a rigid beam is no special case.
namespace taut::mechanics {

/// The piece of a beam.
const machine::BeamPiece& piece_of(const System& s, const Layout::Piece& p);

/// The start of a piece in the ground frame, as it follows from the unknowns.
structure::RodState piece_start(const System& s, const Configuration& c, std::size_t index);

/// Adds the beams' rows, and their forces on bodies, to the residual.
void add_beams(const System& system, const Configuration& c, Evaluation& e);

/// Their derivatives.
void add_beam_rates(const System& system, const Configuration& c, Entries& J);

/// The unknowns of the pieces moved by `part` of a step.
void move_beams(const System& system, const Eigen::VectorXd& step, double part, Configuration& moved);

/// The worst of forces (moments over the machine's length) and of lengths (turns times it) that the beams leave open.
void add_beam_misfit(const System& system, const Evaluation& e, double& force, double& length);

/// Scales of the beams' unknowns.
void scale_beams(const System& system, Eigen::VectorXd& columns);

}  // namespace taut::mechanics
