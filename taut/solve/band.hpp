#pragma once
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Whether motion changes tensions: by losses, or by the weight of rope that runs round.
bool differs_in_motion(const machine::Model& model);

/// Widens the tensions of an answer to those that friction may hold: at rest those of both directions of motion; where
/// ropes creep in a motion, those of rope drawn to the carriage and let out, on either side of it. The answers that
/// bound them come into `result.bounds`. A direction without an answer leaves `result.band` false.
void add_band(const machine::Model& model, const EquilibriumOptions& options, EquilibriumResult& result);

}  // namespace taut::solve
