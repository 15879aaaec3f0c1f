#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/rope.hpp"
#include "taut/checks/asked_checks.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/analyses.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// A view of what a deck says of a machine and of its checks: who keeps one copies it, and the deck outlives it.
struct CheckedDeck {
  const machine::Machine& machine;
  const std::vector<study::AnalysisRequest>& analyses;
  const std::optional<ChecksRequest>& checks;
  const AskedChecks& asked;                                 ///< as resolve() has found them
  const std::map<std::string, catalogue::RopeRow>& chosen;  ///< rows of the ropes that a design has put in
  const Display& display;                                   ///< units of the sentences of the result
};

}  // namespace taut::checks
