#pragma once
#include <functional>
#include <limits>
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

/// The worst cases for sizing over all combinations of what is listed, as a deck asks for them.
struct EnvelopeRequest {
  std::optional<std::string> name;
  std::optional<std::string> carriage;
  std::optional<double> from, to;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::optional<std::string> load_at;  ///< a body or carriage, or a point of one
  std::vector<double> loads;           ///< kg
  std::vector<std::string> motions;
  std::vector<double> temperatures;  ///< K
  bool judge = true;                 ///< false: its states do not count for the verdict
  bool held = false;                 ///< whatever holds the carriage
  static const Description& describe();
};

/// One combination of load, motion and temperature, and a place. NaN: not given.
struct EnvelopeState {
  double x = none;            ///< of the carriage, m
  double load = none;         ///< kg
  std::string motion;         ///< as the deck has it
  double temperature = none;  ///< K
};

/// A quantity at its least and at its most.
struct EnvelopeExtreme {
  std::string name, what;  ///< "skyline", "tension"
  Unit unit;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  EnvelopeState at_least, at_most;
};

/// A state that is worst in something.
struct WorstState {
  std::string words;
  machine::Model model;
  solve::EquilibriumResult result;
};

/// What a deck asks, and the answer.
struct EnvelopeRun {
  std::string ending;
  std::optional<int> carriage;  ///< empty: the machine as it stands
  Way way;
  std::optional<int> load_body;              ///< empty: there are no loads
  std::optional<machine::Place> load_point;  ///< of that body; empty: the loads are at its centre of mass
  bool held = false;
  std::vector<double> loads;             ///< kg
  std::vector<std::string> motions;      ///< as the deck has them
  std::vector<RopeMotion> rope_motions;  ///< the same, resolved
  std::vector<double> temperatures;      ///< K
  const machine::Machine* machine = nullptr;
  std::vector<Winch> winches;

  std::vector<EnvelopeExtreme> extremes;  ///< in the order in which they came up
  std::vector<WorstState> worst;
  std::vector<std::string> contrary;  ///< of two ropes that can't both run as declared: sentences
  Missing missing;
  int states = 0;           ///< that were solved
  Display display = {};     ///< units of the sentences
  bool on_support = false;  ///< some position lies on a support and is left out
};

/// The request with its names resolved; complaints below `path`.
EnvelopeRun resolve(const EnvelopeRequest& request, const std::string& path, Names& names);

/// States that all combinations have together, at most.
int states_of(const EnvelopeRun& run);

/// Is shown every state, with words.
using EnvelopeStates = std::function<void(const machine::Model&, const solve::EquilibriumResult&, const std::string&)>;

/// Fills the answer.
void solve(const machine::Model& model, EnvelopeRun& run, Watch& watch, const EnvelopeStates& seen);

/// The columns of an extreme whose quantity has this unit.
Quantities<EnvelopeExtreme> envelope_quantities(const Unit& unit);

}  // namespace taut::study
