#pragma once
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Whether motion changes tensions: by losses, or by the weight of rope that runs round.
bool differs_in_motion(const machine::Model& model);

/// The flows, [reeving][node], of the combinations of ropes' directions that bound what friction holds at rest.
Array<Array<Array<int>>> flows_at_rest(const machine::Model& model);

/// Widens the tensions of an answer to those that friction may hold: at rest those of all motions of its ropes, each
/// for itself; in a motion, where ropes creep, those of rope that creeps one way and the other. `creep`: as
/// EquilibriumOptions::creep. The answers that bound them come into `result.bounds`. A combination without an answer
/// leaves `result.band` false and is in `result.unheld`; one in which the ropes touch other supports is a bound, but
/// its tensions are in no column beside those of the answer: it leaves `result.band` false too. What is left out is in
/// `result.unbounded`.
void add_band(const machine::Model& model, const EquilibriumOptions& options, const Array<Array<int>>& creep,
              EquilibriumResult& result);

}  // namespace taut::solve
