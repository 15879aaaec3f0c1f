#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/solve/continuation.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/parameter.hpp"
#include "taut/study/deck/rope_motion.hpp"
#include "taut/study/states.hpp"

namespace taut::study {

class Watch;

/// The equilibrium over a number of the deck, as a deck asks for it.
struct SweepRequest {
  std::optional<std::string> name;
  std::string parameter;
  std::string from, to;  ///< with the parameter's unit
  int steps = 20;
  std::vector<MotionRequest> motion;
  std::optional<std::string> carriage;
  std::optional<double> x;
  std::vector<double> along = {1, 0};  ///< direction of x
  bool judge = true;                   ///< false: its states do not count for the verdict
  bool held = false;                   ///< whatever holds the carriage
  /// Whether it is one of the temperature of the machine.
  bool heats() const;
  static const Description& describe();
};

/// What a deck asks, and the answer.
struct SweepRun {
  std::string ending;
  std::string words;
  std::string parameter;  ///< its path in the deck
  Unit unit;
  RopeMotion motion;
  std::optional<machine::Prescribed> prescribed;
  double from = 0, to = 0;
  int steps = 1;
  bool held = false;
  /// Whether the checks read another machine at each value (a sheave's diameter, a breaking force): each is judged as
  /// the deck with that value. Else (loads, lengths and tensions of ropes, temperature) as all states of the deck.
  bool judged_apart = false;
  const machine::Machine* machine = nullptr;
  /// The machine on which lines and guys are put up, where `machine` is a load case of another one; null: itself.
  std::shared_ptr<const machine::Machine> put_up_on;
  solve::Sweep answer;
};

/// Whether lines and guys that are put up (`install:`, `tension_equals`) get other lengths by this number of the deck.
/// They keep those that they have while loads, the lengths of other ropes and the temperature change.
bool puts_up_anew(const Parameter& parameter);

/// The machine of a sweep at one of its values.
tl::expected<machine::Machine, Outcome> machine_at(const SweepRun& run, double value);

/// `put_up_on` there: with that value where it puts lines and guys up anew.
tl::expected<std::shared_ptr<const machine::Machine>, Outcome> put_up_on_at(const SweepRun& run, double value);

/// The state of a sweep at one of its points as an equilibrium of that machine, to be solved from there.
EquilibriumRun state_at(const SweepRun& run, const solve::SweepPoint& point);

/// The request with its names resolved; complaints below `path`.
SweepRun resolve(const SweepRequest& request, const std::string& path, Names& names);

/// Fills `run.answer`. `model`: with its guys and lines put up, which keep their lengths where the parameter does not
/// change what they are built on.
void solve(const machine::Model& model, SweepRun& run, Watch& watch);

}  // namespace taut::study
