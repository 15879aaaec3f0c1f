#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "taut/app/machine_deck.hpp"
#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/design/design.hpp"
#include "taut/io/deck/node.hpp"
#include "taut/machine/state.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// A machine's deck that was read without a mistake.
struct ReadMachine {
  std::shared_ptr<const MachineDeck> deck;
  std::shared_ptr<const MachineDeck> first;  ///< what a design leaves free is the first of its candidates
  design::DesignSpace space;                 ///< of a design
  machine::Model model;                      ///< of `first`, and what it asks
  study::AskedAll asked;
  std::optional<StudyRequest> study;  ///< not in `deck`, as what follows
  std::optional<CalibrateRequest> calibrate;
};

/// Reads a deck's `machine`, `analyses`, `checks` and `design` and notes every mistake; empty where there is one.
/// `input`: the map with these keys; a file that the deck names is looked for beside the file that names it.
/// `display`: for the sentences of the result.
std::optional<ReadMachine> read_machine(const io::Node& input, const Display& display, Diagnostics& mistakes);

/// What makes a run of many cheaper.
struct OneOfMany {
  const States* near = nullptr;                           ///< where each equilibrium begins
  States* found = nullptr;                                ///< in which the equilibria are put
  std::function<bool(std::string_view name)> wants = {};  ///< as in results::MachineRun
  bool judges = true;                                     ///< the same
  /// In which the names of all values and checks are put that need `judges`.
  std::set<std::string>* judged = nullptr;
  /// In which the ropes are put whose motions have more than the tension at rest (rope::rest_is_known), each with why.
  std::map<std::string, std::string>* beyond_rest = nullptr;
};

/// What the checks of a deck name holds their numbers: it is found anew after one of them was changed. Infeasible where
/// the checks would be a mistake with these numbers. `space`: of its design.
Outcome renew_checks(const design::DesignSpace& space, MachineDeck& deck);

/// Runs a deck whose mistakes were told when it was read, with other numbers than it had then. Infeasible where a
/// number makes no machine.
Result run_machine(const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>& progress = {},
                   const OneOfMany& many = {});

/// The same for a machine whose numbers change from run to run: its equilibria begin from `states`, which then are its
/// own where it has an answer.
Result run_near(const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>& progress,
                States& states);

/// Reads such a deck; without mistakes returns the calculation, ready to be called; else an empty one. `progress`: as
/// in a Job.
std::function<Result()> prepare_machine(const io::Node& input, Diagnostics& mistakes,
                                        std::function<bool(const Progress&)> progress = {},
                                        const Display& display = Display());

}  // namespace taut::app
