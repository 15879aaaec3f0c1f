#pragma once
#include <string>
#include <vector>

#include "taut/app/guy_checks.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/app/machine_masts.hpp"
#include "taut/app/machine_run.hpp"
#include "taut/app/rope_uses.hpp"

namespace taut::app {

/// What the checks of a deck keep of every state that is a load case: equilibria, load paths, envelopes, cycles and
/// motions. The places of a sweep and the limits of a payload are none. The deck outlives it.
struct CheckedParts {
  CheckedParts(const MachineDeck& given, const model::Model& model);

  /// Equilibria and load paths of a run; other analyses show their states themselves.
  void take_answers(const MachineRun& run);
  /// `words`: which state it is; `analysis`: the name of its analysis, for load combinations.
  void take(const model::Model& model, const analysis::EquilibriumResult& state, const std::string& words,
            const std::string& analysis);
  /// A line as it is put up, empty, in a model without what hangs on it: for its bends, angles and clearance alone.
  void take_empty(const model::Model& model, const analysis::EquilibriumResult& state, const std::string& line,
                  const std::string& words);
  /// A motion: tensions at all its steps, forces and places at its output steps.
  void take(const model::Model& model, const analysis::TransientResult& motion, const std::string& words,
            const std::string& analysis);

  const MachineDeck* deck = nullptr;
  RopeUses ropes;
  std::vector<GuyStates> guys;
  std::vector<AnchorStates> anchors;
  std::vector<LineStates> lines;
  std::vector<MastStates> masts;
};

}  // namespace taut::app
