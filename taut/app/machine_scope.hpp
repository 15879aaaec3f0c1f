#pragma once
#include <vector>

#include "taut/app/machine_deck.hpp"

namespace taut::app {

/// What a deck describes and no analysis that it asks for computes yet, each at its place below the deck.
std::vector<Complaint> not_computed(const MachineDeck& deck);

}  // namespace taut::app
