#pragma once
#include <memory>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/case_values.hpp"
#include "taut/app/prepare_machine.hpp"

namespace taut::app {

/// A deck with the numbers of one case, and what its design chooses from.
struct MachineOfCase {
  MachineDeck deck;
  design::DesignSpace space;
};

/// A machine's deck as a function of numbers. Outputs: `equilibrium.VALUE`, `load_path_sag.VALUE`, a value as the deck
/// has it when that analysis stands in it alone; `checks.NAME`, the value of a check or what `checks:` adds, of the
/// deck with all its analyses; `design.VALUE` of a deck with `design:`. An analysis is called by its kind, with
/// `_NAME` where it has a name, `_2` where it is the second of its kind without one.
MadeCases machine_cases(const ReadMachine& read, const CaseQuestion& question,
                        const DeckParameters<MachineOfCase>& parameters);

}  // namespace taut::app
