#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/guy/guy_checks.hpp"

/// Carriages whose rated payload is known, from the catalogue or the deck: checked without being named in `checks:`.
namespace taut::checks {

/// A carriage over all states that were shown.
struct CarriageStates {
  const machine::description::Carriage* given = nullptr;
  double rope_diameter = 0;  ///< of the rope on which it rides, m; 0: not known
  LineExtreme load;          ///< on it, kg
  Display display = {};      ///< units of the sentences
};
std::vector<CarriageStates> carriage_states(const CheckedDeck& deck, const machine::Model& model);
void take(const CheckState& state, CarriageStates& carriage);
void add_carriage_checks(const std::vector<CarriageStates>& carriages, Result& r);

}  // namespace taut::checks
