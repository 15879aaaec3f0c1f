#pragma once
#include "taut/checks/checked_deck.hpp"
#include "taut/machine/model.hpp"

namespace taut {
struct Result;
}

namespace taut::checks {

/// What is not judged because a machine is hotter than 100 degC in some state. A rope under
/// `checks: ropes` is weakened by its temperature in all checks of its strength; others have a cold one. Beams and
/// masts have the modulus and strength of cold steel, which fall above 100 degC (EN 1993-1-2, table 3.1).
void add_unjudged_heat(const CheckedDeck& deck, const machine::Model& model, Result& r);

/// Warns where something is judged in a state below -40 degC: down to there ropes with common lubricants and ends are
/// used (EN 12385-3, EN 13414-1; recalled), and whether a steel is tough enough below is not in the deck
/// (EN 1993-1-10).
void warn_of_cold(const CheckedDeck& deck, Result& r);

}  // namespace taut::checks
