#pragma once
#include <optional>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/running.hpp"

namespace taut::solve {

/// Where the deck and its carriages do not say which way a rope runs over a contact, what takes rope in says it: by the
/// rope that passes the contact in the equilibrium without loss. That is a prescribed carriage that moves, else every
/// winch, each by itself. Where they agree, the flow is theirs. Where they do not, or no rope passes, nothing says it:
/// `run.creep` has that flow, and the band of the answer both senses. `start`: of the search for the answer without
/// loss. docs/theory/senses.md.
void set_by_winches(const machine::Model& model, const EquilibriumOptions& options,
                    const std::optional<machine::State>& start, RopesRun& run);

}  // namespace taut::solve
