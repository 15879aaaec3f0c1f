#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/deck/given.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/least_tension.hpp"

namespace taut::study {

/// One rope tightened at one of its ends until something is reached.
struct PullRequest {
  std::string rope;
  RopeEnd end = RopeEnd::start;
  std::optional<double> force;       ///< N
  std::optional<double> take_up;     ///< m
  std::optional<std::string> until;  ///< a path as in `observe`, or a measure, that has moved ...
  std::optional<std::string> moves;  ///< ... by so much, with its unit
  static const Description& describe();
};

/// Ropes pulled tight in turn, or as little as keeps them taut.
struct PretensionRequest {
  enum class Start { settled, assembled };
  std::optional<std::string> name;  ///< ending of its tables' names
  std::vector<PullRequest> pull;    ///< in this order
  std::optional<LeastTensionRequest> least;
  int rounds = 1;                 ///< and again from the first
  std::optional<double> longest;  ///< m
  double tolerance = 1e-9;
  Start start = Start::settled;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

/// One rope tightened at one of its ends: unstretched rope is taken out there (let out, where it is too tight already)
/// until one of these is reached.
struct Pull {
  int reeving = 0;
  bool at_end = false;            ///< of its path; else at its start
  std::optional<double> force;    ///< N: its tension at that end
  std::optional<double> take_up;  ///< m: so much rope is out; < 0: in
  /// Something has left its place by `moves`, either way: a section that the rope draws along begins to slide.
  std::optional<machine::Observable> until;
  double moves = 0;  ///< in the unit of `until`, > 0
};

/// The machine as a pull has ended.
struct PullEnd {
  double taken = 0;                            ///< unstretched rope taken out by this pull, m
  double taken_in_all = 0;                     ///< of this rope, by all pulls so far, m
  Array<double> T_start, T_end;                ///< by reeving, N
  Array<double> observed;                      ///< as in the model
  Array<double> unstretched;                   ///< by reeving, m
  std::optional<solve::EquilibriumResult> at;  ///< of a machine without friction
};

/// A state at rest as such an end.
PullEnd end_of(const machine::Model& model, const solve::EquilibriumResult& result);

struct PretensionOptions {
  std::optional<double> longest;  ///< m: a pull of more is not right; empty: 0.5 m where it is slow, else any
  double tolerance = 1e-9;
  solve::Start start = solve::Start::settled;  ///< of a machine with friction, before the first pull
  /// Before each pull, with its number; false interrupts.
  std::function<bool(std::size_t)> progress;
  /// Of a machine with friction: each slow motion, from state to state, with its machine.
  std::function<void(const machine::Model&, const solve::TransientResult&)> moved;
};

/// `outcome` not ok: the pulls in `ends` are a result, the message says what happened in the next one.
struct PretensionResult {
  Outcome outcome;
  bool interrupted = false;
  bool slowly = false;   ///< with friction, as a quasi-static motion; else by equilibria without
  PullEnd before;        ///< any pull
  Array<PullEnd> ends;   ///< by pull
  machine::Model model;  ///< of a machine without friction: with the lengths that its ropes have after the last one
  std::optional<solve::DynamicState> state;  ///< after the last one, of a machine with friction
  Array<solve::TransientFrame> frames;  ///< of such a one: before any pull and as each ends, its number as the time
};

/// Whether friction holds parts of the machine: contacts on faces, cylinders, or sheaves with losses in motion alone.
bool pulled_slowly(const machine::Model& model, const Array<Pull>& pulls);

/// Ropes pulled in turn, as they are put up. A machine with contacts or cylinders moves quasi-statically with all its
/// friction (TransientOptions::quasi_static); else each pull ends in an equilibrium at rest. Drives and signals stand
/// still, and no events happen. docs/theory/motion.md.
PretensionResult pretension(const machine::Model& model, const Array<Pull>& pulls,
                            const PretensionOptions& options = {});

/// What a deck asks, and the answer.
struct PretensionRun {
  std::string ending;
  std::string words = "pretension";  ///< "pretension, second round"
  int rounds = 1;                    ///< of all pulls
  PretensionOptions options;
  Array<Pull> pulls;      ///< of one round
  bool observes = false;  ///< the deck names what it observes
  PretensionResult answer;
};

/// The request, of pulls, with its names resolved; complaints below `path`.
PretensionRun resolve(const PretensionRequest& request, const std::string& path, Names& names);

/// Fills `run.answer`. `go_on`: is asked before each pull with its number, from 0, and how many there are. `moved`: see
/// PretensionOptions.
void solve(const machine::Model& model, PretensionRun& run, const std::function<bool(std::size_t, std::size_t)>& go_on,
           const std::function<void(const machine::Model&, const solve::TransientResult&)>& moved = {});

/// A pull as it ends; 0: before any of them. Tensions and what is observed besides.
struct PullRow {
  double step = 0;
  std::string pulled;  ///< the rope
  const PullEnd& end;
};
const Quantities<PullRow>& pull_quantities();

}  // namespace taut::study
