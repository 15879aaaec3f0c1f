#pragma once
#include "taut/app/machine_deck.hpp"
#include "taut/base/diagnostic.hpp"
#include "taut/io/deck/node.hpp"

namespace taut::app {

/// Fills what a deck takes from the catalogues of carriages and yarders: the figures of every carriage with
/// `carriage:` that the deck does not give itself, and the row of every yarder in `checks:`. Tables of the user's are
/// read from the files that `catalogue` names, beside the deck. `input`: the map with `machine` and `checks`.
/// Mistakes: no such row, a file that can't be read, mistakes in it.
void take_from_library(const io::Node& input, MachineDeck& deck, Diagnostics& mistakes);

}  // namespace taut::app
