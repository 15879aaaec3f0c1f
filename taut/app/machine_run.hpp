#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/analysis/load_path.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/calc/result.hpp"
#include "taut/io/node.hpp"

namespace taut::app {

/// One analysis that was run.
struct EquilibriumRun {
  std::string ending;  ///< of its tables' names: "", "_2", "_lower"
  std::string words;   ///< "at rest", "hoist"
  analysis::EquilibriumOptions options;
  analysis::EquilibriumResult result;
};
struct LoadPathRun {
  std::string ending;
  std::string words;
  analysis::LoadPathOptions options;
  analysis::LoadPath result;
};

/// Everything that was computed of a machine.
struct MachineRun {
  model::Model model;
  std::vector<EquilibriumRun> equilibria;
  std::vector<LoadPathRun> paths;
};

/// Reads a deck's `machine` and `analyses` and notes every mistake; without mistakes returns the calculation, ready to
/// be called; else an empty one. `input`: the map with both keys; a terrain's file is looked for beside the file that
/// names it.
std::function<Result()> prepare_machine(const io::Node& input, Diagnostics& mistakes);

}  // namespace taut::app
