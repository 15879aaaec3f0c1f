#pragma once
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/payload.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// The limits of a deck's judged payloads over the states of all its judged analyses: a rope that has its limit from a
/// payload is not limited in that payload's states alone. The states of a payload are held against its own limits, and
/// against those of other payloads where it has none of that kind for that part.
class LimitsOfPayloads {
 public:
  explicit LimitsOfPayloads(Display display = {}) : display_(std::move(display)) {}

  /// Before any state is shown. `model`: of the machine.
  void add(const study::PayloadRun& run, const CheckedDeck& deck, const machine::Model& model);
  /// States from here on are those of the payload with this ending.
  void begin(const std::string& ending) { running_ = &ending; }
  void end() { running_ = nullptr; }

  /// `words`: which state it is. The model has the machine's ropes and bodies.
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// Of a model of some of the ropes, known by their names: tensions alone.
  void take_ropes(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// A motion as a whole: tensions alone. `slowly`: all its steps are at rest.
  void take(const machine::Model& model, const solve::TransientResult& motion, const std::string& words, bool slowly);

  /// NAME.payload_T_max of each rope with a limit of its tension: largest tension at rest over all states. It is no
  /// limit of a rope that has more in a motion. What another limit does not allow in a state of another analysis is
  /// left unjudged (Result::unmade).
  void add_checks(Result& r) const;

 private:
  struct Largest {
    double T = 0;  ///< N
    std::string where;
  };
  struct RopeSeen {
    std::string name;
    double limit = std::numeric_limits<double>::infinity();    ///< of the payload, the rope being cold, N
    double tension = std::numeric_limits<double>::infinity();  ///< the deck's own, N
    double strength = 0;                                       ///< breaking force by which these limits may be, N
    StrengthInUse in_use;
    std::vector<study::PayloadFactor> factors;
    bool seen = false;
    double own = 0;  ///< largest tension with the payload, N
    Largest elsewhere, moving;
    std::string weaker;  ///< the first state in which it breaks at less
  };
  struct Exceeded {
    double margin = 0;
    std::string words;
  };
  struct Payload {
    std::string ending;
    int carriage = 0;
    study::Way way;
    study::PayloadLimits limits;
    std::vector<RopeSeen> ropes;
    std::map<std::string, Exceeded> exceeded;  ///< by the words of the limit
  };

  bool runs(const Payload& one) const { return running_ != nullptr && *running_ == one.ending; }
  bool limits_itself(const std::string& rope) const;
  void take_tension(const std::string& rope, double T, const std::string& words);
  void take_strength(const machine::Reeving& rope, const std::string& words);
  static void tell_of_weaker(const RopeSeen& rope, Result& r);
  void add_checks_of(const RopeSeen& rope, const std::string& ending, Result& r) const;
  void take_others(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words,
                   Payload& one) const;

  Display display_;
  std::vector<Payload> payloads_;
  const std::string* running_ = nullptr;
};

}  // namespace taut::checks
