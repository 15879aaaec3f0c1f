#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/catalogue/rule.hpp"

namespace taut::app {

/// Anything with a name that taut knows from one of its descriptions: a key of a deck, a rule, a result.
struct Term {
  enum class Kind { key, rule, value, column, observable };
  Kind kind = Kind::key;
  std::string path;   ///< "machine.reevings[].length", "safety.skyline.ch", "ROPE.T_max", "payload.payload"
  std::string unit;   ///< as print shows it: "m", "kN"; of a key what it takes; may be empty
  std::string words;  ///< its meaning in one line
  std::string place;  ///< where it stands: "machine: reevings: paths of the ropes", "table payload", "the deck"
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::string page = {};                     ///< of the docs, of a value: "docs/theory/payload.md"; may be empty
  const Description* description = nullptr;  ///< of a key: the one in which it stands
  const Field* field = nullptr;              ///< of a key
  const catalogue::RuleRow* rule = nullptr;  ///< of a rule
};

/// All of them: keys of machines, checks, designs and methods, rules, values and tables of results, observed
/// quantities. Made once.
const std::vector<Term>& terms();

/// How well a name fits a path, best first.
enum class Fit { whole, tail, by_name, part, below, none };

/// `name`: as a user writes it, "reevings.length", "machine.reevings[0].length", "break_angle"; case does not count.
/// whole: the same path. tail: the last words of the path; NAME and [] may be left out. by_name: the same with names
/// of a deck at NAME and [], "reevings.skyline.length". part: its last word contains the name as a word of its own,
/// "friction" of "static_friction". below: the name is among the words before the last one, "safety.skyline" of
/// "safety.skyline.ch".
Fit fit_of(std::string_view name, std::string_view path);

}  // namespace taut::app
