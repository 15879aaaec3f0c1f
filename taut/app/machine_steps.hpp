#pragma once
#include "taut/app/machine_deck.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::app {

/// The laws of the answer written once with their numbers: the span with the largest tension of all analyses as an
/// elastic catenary, the loss at each contact that turns or slips in that state, the rope's safety factor.
void add_steps(const MachineDeck& deck, const results::MachineRun& run, Result& r);

}  // namespace taut::app
