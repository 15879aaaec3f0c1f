#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/results/answers/key_figure.hpp"
#include "taut/study/analyses.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {
struct CheckedParts;
}

namespace taut::results {

/// A state that another analysis found worth showing: where a payload is least. One that only `explores`, the hardest
/// of a sweep, counts where nothing else does, and for pictures.
struct OtherAnswer {
  std::string words;
  machine::Model model;
  solve::EquilibriumResult result;
  bool explores = false;
  bool judged = true;  ///< whether its analysis counts for the verdict
};

/// Everything that was computed of a machine.
struct MachineRun {
  machine::Model model;
  std::vector<study::EquilibriumRun> equilibria;
  std::vector<study::LoadPathRun> paths;
  std::vector<OtherAnswer> others;
  std::shared_ptr<checks::CheckedParts> checked;   ///< is shown every state that is judged; empty where none is
  std::vector<study::SweepRun> judged_apart = {};  ///< solved, see SweepRun::judged_apart
  std::function<bool(const Progress&)> progress;   ///< as in a Job
  Display display;                                 ///< units for the sentences of the result
  KeyFigure key_figure;
  bool several = false;  ///< the deck has several analyses: each has its heading
  /// Whether values are wanted whose names begin so, "sky", "sky.T_start"; empty: all are.
  std::function<bool(std::string_view name)> wants;
  std::optional<double> least_carried;  ///< kg, of the judged payloads: the one in the headline
  bool judges = true;                   ///< whether equilibria and load paths are shown to the verdict
  bool tells = true;                    ///< whether the verdict's own values and warnings are wanted of them
};

/// An equilibrium that was found.
struct Answer {
  const machine::Model* model = nullptr;
  const solve::EquilibriumResult* result = nullptr;
  const study::LoadPathPoint* point = nullptr;  ///< of a load path
  std::string words;                            ///< as in the checks: "hoist, hoist", "load path, sky -1, x = 12 m"
  bool judged = true;                           ///< whether it counts for the verdict
};

/// All that were found, equilibria first.
std::vector<Answer> answers_of(const MachineRun& run);

/// What a picture may show: these, and the hardest state of each analysis that only explores and is judged.
std::vector<Answer> pictured_of(const MachineRun& run);

/// How much a state strains its ropes: the largest share of its breaking force that one bears, and the largest tension,
/// N, which counts where no breaking force is known. Pairs are compared in this order.
using Strain = std::pair<double, double>;
Strain strain_of(const machine::Model& model, const solve::EquilibriumResult& state);

/// "largest tension of hoist (transient, t = 0.2 s), 22.08 kN": the rope that is strained more than `strain` in a
/// judged state of any analysis, and that state, by the values of the result; empty where none is.
std::string strained_more(const MachineRun& run, const Strain& strain, const Result& r);

/// Over the values and tables of one analysis, "equilibrium, at rest", "load path sag, in"; empty where the deck has
/// only one.
std::string heading_of(const MachineRun& run, const study::EquilibriumRun& one);
std::string heading_of(const MachineRun& run, const study::LoadPathRun& one);

/// "haulback -1", "sag, haulback -1": how a load path goes, by its name where it has one.
std::string path_words(const study::LoadPathRun& one);
std::string state_words(const study::EquilibriumRun& one);

/// Shows the checks its equilibria and load paths; other analyses show their states themselves.
void show_answers(const MachineRun& run, checks::CheckedParts& checked);

}  // namespace taut::results
