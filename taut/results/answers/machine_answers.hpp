#pragma once
#include "taut/checks/checked_deck.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// Lines of the main answer on the machine as a whole, over all states at rest that are judged (where none is: over all
/// that were found): its ropes with designation and length ("Build" those that a design has chosen), the largest
/// tension of each with where it is, its beams, and the least clearance. Other analyses add their own lines. Behind all
/// values.
void add_answers(const checks::CheckedDeck& deck, const MachineRun& run, Result& r);

/// What a deck says of a rope: "EN 12385-4 6x36-IWRC 20 mm 1960 MPa"; without a row of the catalogue its diameter,
/// breaking force and mass as far as they are given. Empty: nothing is.
std::string designation_of(const machine::description::Rope& rope, const Display& display);

}  // namespace taut::results
