#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/app/cases/study_deck.hpp"
#include "taut/calc/field.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/design/design_deck.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/state.hpp"
#include "taut/study/analyses.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// How much of a machine's result is wanted: the values alone, those with tables and checks, or all that a report
/// shows.
enum class RunDepth { values, checks, report };

/// The states of a deck's equilibria, in its order.
using States = std::vector<machine::State>;

/// A deck with `machine:`, `analyses:` and `checks:`. Without analyses: the equilibrium at rest.
struct MachineDeck {
  machine::Machine machine;
  std::vector<study::AnalysisRequest> analyses;
  std::optional<checks::ChecksRequest> checks;
  std::optional<design::DesignRequest> design;
  std::optional<StudyRequest> study;
  std::optional<CalibrateRequest> calibrate;
  checks::AskedChecks asked;                         ///< not of the deck: what its checks name
  std::map<std::string, catalogue::RopeRow> chosen;  ///< not of the deck: rows of the ropes that a design has put in
  /// Not of the deck: the machine on which its lines and guys are put up, where this deck is a load case of another
  /// one. Empty: its own.
  std::shared_ptr<const machine::Machine> put_up_on;
  Display display;  ///< not of the deck's machine: units for the sentences of a result
  static const Description& describe();

  /// What its checks see of it; it outlives that.
  operator checks::CheckedDeck() const {
    return {.machine = machine,
            .analyses = analyses,
            .checks = checks,
            .asked = asked,
            .chosen = chosen,
            .display = display};
  }
};

}  // namespace taut::app
