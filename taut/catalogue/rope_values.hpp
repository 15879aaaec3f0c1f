#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/units/display.hpp"

/// Values of a deck that contradict the row of the catalogue that it names: a slip of a unit (kN, MN). What no rope
/// bears, whatever the deck asks.
namespace taut::catalogue {

/// A rope of a deck that is one of the catalogue.
struct NamedRope {
  std::string name;  ///< in the deck
  RopeRow row;
  std::string id;    ///< of the row, as the deck has it
  std::string mend;  ///< what to do about a value that no such rope has
};

/// What the deck has in place of the row's values, SI; 0: nothing. No weight (0 kg/m) and no stretch (infinite) are
/// ways to calculate.
struct OwnValues {
  double mass = 0;  ///< kg/m
  double diameter = 0;
  double breaking_force = 0;
  double stiffness = 0;  ///< EA, N
};

/// A sentence about a value.
struct ValueDoubt {
  std::string words;
  bool unsafe = true;  ///< else it is on the safe side
};

/// Values that no rope of the row has. The mass per metre, the diameter and the breaking force are compared with those
/// of the row; the stiffness with its metallic area times the least modulus of a new rope and that of the wire. A
/// breaking force that is far below that of the row is on the safe side.
std::vector<ValueDoubt> doubts_of(const NamedRope& rope, const OwnValues& own);

/// Where the largest tension (N) strains a rope of a stiffness (N) by more than a steel rope bears. `key`: what the
/// stiffness is from in the deck.
std::optional<std::string> doubt_of_strain(const std::string& rope, double tension, double stiffness,
                                           const Display& display, const std::string& key = "stiffness");

/// A rope's largest tension (N) against its breaking force, by name, rule and trust of `strength`. It may fail without
/// being asked; it is no limit by which the rope `part` passes.
Check breaking_check(std::string name, std::string part, double tension, Bound strength);

/// The same of a rope of the catalogue that a published method calls `part`: "return rope does not break".
Check breaking_check(const std::string& part, const RopeRow& rope, double tension);

}  // namespace taut::catalogue
