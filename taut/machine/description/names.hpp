#pragma once
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"

namespace taut::machine {

/// Names that a machine mentions and that nothing in it has, each with the path of its place below `machine`. Only
/// names are looked at, no values: it serves decks that could be read in part only, so that these mistakes are reported
/// in the same run as the others. `compile` finds them too, and names of the wrong kind besides.
std::vector<Complaint> unknown_names(const Machine& machine);

}  // namespace taut::machine
