#pragma once
#include "taut/mechanics/system.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Fills spans, contacts, ropes, reactions, hold and closure of a solved configuration. `touched` as in the state.
void fill_tables(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                 const machine::State& state, EquilibriumResult& result);

}  // namespace taut::solve
