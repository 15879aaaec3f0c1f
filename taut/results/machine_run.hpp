#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/study/load_path.hpp"
#include "taut/study/requests/motion.hpp"

namespace taut::checks {
struct CheckedParts;
}

namespace taut::results {

/// One equilibrium: what was asked, and the answer. `model`: with the carriage in the span where it is put.
struct EquilibriumRun {
  std::string ending;  ///< of its tables' names: "", "_2", "_lower"
  std::string words;   ///< "at rest", "hoist"
  std::vector<study::MotionRequest> motion;
  std::optional<machine::Prescribed> prescribed;
  bool held = false;
  std::optional<solve::Condition> given;
  machine::Model model;
  solve::EquilibriumResult result;
  bool judged = true;
};

/// The positions of a load path within one span.
struct LoadPathPart {
  machine::Model model;
  study::LoadPath result;
};
struct LoadPathRun {
  std::string ending;
  std::string words;
  std::vector<study::MotionRequest> motion;
  int carriage = 0;
  double from = 0, to = 0;
  Vector3 along = Vector3::UnitX();  ///< along which x is measured
  int steps = 1;
  bool held = false;
  std::optional<solve::Condition> given;
  std::vector<LoadPathPart> parts;  ///< in the order of the positions
  bool judged = true;
};

struct MachineRun;
/// Another analysis, ready to run: calculates on the run's model and adds to the result.
using Analysis = std::function<void(MachineRun&, Result&)>;

/// A state that another analysis found worth showing: where a payload is least. One that only `explores` counts where
/// nothing else does.
struct OtherAnswer {
  std::string words;
  machine::Model model;
  solve::EquilibriumResult result;
  bool explores = false;
};

/// Everything that was computed of a machine.
struct MachineRun {
  machine::Model model;
  std::vector<EquilibriumRun> equilibria;
  std::vector<LoadPathRun> paths;
  std::vector<Analysis> more;  ///< in the deck's order
  std::vector<OtherAnswer> others;
  std::shared_ptr<checks::CheckedParts> checked;  ///< is shown every state that is judged
  std::function<bool(const Progress&)> progress;  ///< as in a Job
};

/// An equilibrium that was found.
struct Answer {
  const machine::Model* model = nullptr;
  const solve::EquilibriumResult* result = nullptr;
  const study::LoadPathPoint* point = nullptr;  ///< of a load path
  std::string words;                            ///< "hoist", "load path at x = 12 m"
};

/// All that were found, equilibria first.
std::vector<Answer> answers_of(const MachineRun& run);

/// Shows the checks its equilibria and load paths; other analyses show their states themselves.
void show_answers(const MachineRun& run, checks::CheckedParts& checked);

}  // namespace taut::results
