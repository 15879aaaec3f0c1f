#pragma once
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Whether motion changes tensions: by losses, or by the weight of rope that runs round.
bool differs_in_motion(const machine::Model& model);

/// Widens the tensions of an answer at rest to those of both directions of motion, which friction holds it between. A
/// direction without an answer leaves `result.band` false.
void add_band(const machine::Model& model, const EquilibriumOptions& options, EquilibriumResult& result);

}  // namespace taut::solve
