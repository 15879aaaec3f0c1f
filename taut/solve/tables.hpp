#pragma once
#include "taut/mechanics/system.hpp"

namespace taut::analysis {

/// Fills spans, contacts, ropes, reactions, hold and closure of a solved configuration. `touched` as in the state.
void fill_tables(const System& system, const Configuration& c, const Evaluation& e, const model::State& state,
                 EquilibriumResult& result);

}  // namespace taut::analysis
