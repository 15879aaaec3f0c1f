#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/none.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/deck/rope_motion.hpp"
#include "taut/study/line/carriage_way.hpp"
#include "taut/study/line/rope_sense.hpp"

namespace taut::study {

class Watch;

struct Names;

struct PhaseRequest {
  std::string name;
  std::vector<MotionRequest> motion;
  double load = 0;  ///< kg on the carriage
  std::optional<double> from, to;
  std::optional<double> speed;  ///< of the carriage, m/s
  static const Description& describe();
};

/// Pulls and energies of a working cycle, as a deck asks for them.
struct CycleRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0, to = 0;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::optional<double> speed;
  std::vector<PhaseRequest> phases;
  bool judge = true;  ///< false: its states do not count for the verdict
  bool held = false;  ///< whatever holds the carriage
  static const Description& describe();
};

/// One phase, with its names resolved.
struct Phase {
  std::string name;
  RopeMotion motion;
  double load = 0;  ///< kg on the carriage
  Way way;
  double speed = none;  ///< of the carriage, m/s
};

/// One winch at one position.
struct WinchPull {
  double tension = 0;  ///< of a drive: by how much the rope is tighter behind it than before it, N
  double paid = 0;     ///< rope that is out, as it passes the winch: stretched; of a drive what has passed it, m
};

/// One place of the carriage in a phase.
struct CyclePosition {
  double x = 0, z = none;
  Vector3 place = Vector3::Zero();  ///< of the carriage, m
  double way = 0;                   ///< of the carriage since the phase began, m
  std::vector<WinchPull> pulls;
  bool known = false;
};

/// What a winch does in a phase.
struct WinchWork {
  double pull_max = 0, pull_mean = 0;  ///< N
  double at = none;                    ///< x of the carriage at the largest pull
  double taken = 0;                    ///< rope taken in (out: negative), m
  double energy = 0;                   ///< done by the winch, J; negative: braked
  double power_max = none;             ///< the largest of either sign, W
  double power_given = none;           ///< the largest that it gives, W; negative: it only brakes
  std::vector<double> powers;          ///< mean from the place before to each one, W; NaN: none
};

struct PhaseAnswer {
  std::vector<CyclePosition> positions;
  std::vector<WinchWork> works;  ///< by winch; empty where the watch ended the phase
  std::vector<RopeSense> senses;
  Missing missing;
  double way = 0;      ///< m
  double time = none;  ///< s
};

/// What a deck asks, and the answer phase by phase.
struct CycleRun {
  std::string ending;
  int carriage = 0;
  bool held = false;
  std::vector<Phase> phases;
  std::vector<Winch> winches;
  std::vector<PhaseAnswer> answers;  ///< fewer than phases where the watch ended them
  Display display = {};              ///< units of the sentences
};

/// The request with its names resolved; complaints below `path`.
CycleRun resolve(const CycleRequest& request, const std::string& path, Names& names);

/// Is shown every state of a phase as it counts, with its model.
using CycleStates = std::function<void(const machine::Model&, const LoadPathPoint&, const Phase&)>;

/// States that all phases have together.
int states_of(const CycleRun& run);

/// Fills `run.answers`.
void solve(const machine::Model& model, CycleRun& run, Watch& watch, const CycleStates& seen);

/// A line of the table of positions, and of what each winch does.
struct CycleRow {
  const Phase& phase;
  const CyclePosition& position;
};
struct WinchRow {
  const Phase& phase;
  const Winch& winch;
  const WinchWork& work;
  double time = none;
};
const Quantities<CycleRow>& cycle_quantities();
const Quantities<WinchRow>& winch_quantities();

}  // namespace taut::study
