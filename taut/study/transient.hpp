#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/calc/progress.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/transient_record.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

/// The dynamic factor of hoisting after EN 13001-2, phi2 = phi2_min + beta2 v_h, against which a rope's is checked.
struct HoistFactor {
  enum class Class { HC1, HC2, HC3, HC4 };
  std::string rope;  ///< a reeving
  Class hoisting_class = Class::HC2;
  double speed = 0;  ///< steady hoisting speed of the load, m/s
  static const Description& describe();
};

/// What has come slowly into its place before a motion begins, with all friction against that.
struct SlidRequest {
  std::optional<std::string> actuator, drum;
  double by = 0;  ///< m: extended, or taken in
  static const Description& describe();
};

/// A motion of the machine from its start on.
struct TransientRequest {
  enum class Method { implicit, verlet, reference };
  enum class Start { settled, assembled, sliding };
  enum class Branches { straight, catenary, by_weight };
  enum class Arcs { stretch, rigid };

  std::optional<std::string> name;    ///< ending of its files' names
  double duration = 0;                ///< s
  std::optional<double> output_step;  ///< s
  std::optional<double> tolerance;
  std::optional<double> step;  ///< s, fixed
  Method method = Method::implicit;
  Start start = Start::settled;
  std::vector<SlidRequest> slid;
  bool quasi_static = false;
  double damping_ratio = 0;
  bool rope_mass = true;
  Branches branches = Branches::straight;
  Arcs arcs = Arcs::stretch;
  std::optional<std::string> save;     ///< file for the state at the end, in the folder of the results
  std::optional<std::string> restart;  ///< file with such a state, looked for beside the deck
  std::optional<HoistFactor> hoist_factor;
  std::string state;  ///< text of that file, read before
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

/// One motion: what was asked, and the answer.
struct TransientRun {
  std::string ending;                 ///< of its tables' and files' names: "", "_2", "_stop"
  std::string envelope = "envelope";  ///< name of that table: another one where the deck has that analysis too
  TransientRequest request;
  std::vector<solve::Slid> slid;  ///< of a sliding start
  solve::TransientOptions options;
  machine::Model model;
  TransientRecord record;         ///< what was taken as it went
  solve::TransientResult result;  ///< with the frames that pictures show
};

/// The request with its names resolved; complaints below `path`.
TransientRun resolve(const TransientRequest& request, const std::string& path, Names& names);

/// What sees a motion as it goes.
struct TransientWatchers {
  std::function<bool(const Progress&)> progress;              ///< as in a Job; may be empty
  std::function<void()> anew;                                 ///< what was seen so far does not count
  std::function<void(const solve::TransientResult&)> so_far;  ///< after each output step
  std::function<void(const solve::TransientResult&, const solve::TransientFrame&)> moment;  ///< as in its options
  bool closely = false;                                         ///< as in its options: when `moment` is called
  std::function<void(const solve::TransientResult&)> as_whole;  ///< at the end, before frames are thinned
};

/// Fills `run.record` and `run.result` for `run.model`, from `from` on where that is given.
void solve(TransientRun& run, const std::optional<solve::DynamicState>& from, const TransientWatchers& watchers);

/// How it has free ropes.
solve::Branches branches_of(TransientRequest::Branches branches);

constexpr double coarse_tolerance = 1e-3;  ///< of a motion in given steps where the deck gives none

/// The share of the energy exchanged that the energy ledger may leave open: the tolerance. Where the deck gives none
/// and the steps do not follow each error (a given step, Verlet): a thousandth.
double energy_tolerance(const TransientRun& run);

/// A branch of a rope by the nodes at its ends, "head to block"; empty where there is none.
std::string branch_words(const machine::Reeving& rope, int branch);

/// "transient, stop": for messages.
std::string words_of(const TransientRun& run);

/// A rope over the whole motion.
struct DynamicRow {
  const TransientRun& run;
  int reeving = 0;
};
/// What was observed over the whole motion; `observed`: its index.
struct ObservedRow {
  const TransientRun& run;
  std::size_t observed = 0;
};
/// Whether the tensions of a rope where the motion begins are those at rest: an assembled machine may be out of
/// balance, and what the rope holds then moves at once.
bool begins_at_rest(const TransientRun& run, int reeving);
/// Whether a rope lifts what stands on a face where the motion begins: its tension there is not that of the load.
bool lifts_from_face(const TransientRun& run, int reeving);
const Quantities<solve::TransientEvent>& event_quantities();

/// The last of them in units of a display: "T = 11.77 kN".
std::string values_in_words(const solve::TransientEvent& event, const Display& display);
const Quantities<ObservedRow>& observed_quantities();
const Quantities<DynamicRow>& dynamic_quantities();

}  // namespace taut::study
