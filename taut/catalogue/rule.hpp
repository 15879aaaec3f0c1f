#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// One rule, limit or factor of practice, with its source: "running rope of a crane in class M5: safety factor 4.5".
struct RuleRow {
  std::string id;              ///< "safety.crane_running.M5"; the part before the first point is the topic
  std::string field;           ///< where it holds: "cranes", "cable logging (CH)"; may be empty
  std::string item;            ///< what it is about: "running rope"
  std::string group;           ///< class within the item: "M5", "IWRC", "c"; may be empty
  std::optional<double> low;   ///< SI; equal to high for a single number; none when the rule is a formula or in words
  std::optional<double> high;  ///< SI
  std::string unit;            ///< of low and high, SI: "1", "rad", "m", "Pa", "s/m"
  std::string text;            ///< the formula, or what the number means
  std::string source;
  Trust trust = Trust::unverified;
  std::string trust_text;
  std::optional<double>
      up_to;  ///< of a table by a count, a temperature (K) or a diameter (m): the largest for which the row holds
};

/// Reads a table of rules. Columns: id, field, item, class, low, high, unit (1, deg, m, GPa, MPa, s/m), text, source,
/// trust, and, if wanted, trust_text and up_to. low and high are both there or both empty; an empty pair needs a text.
tl::expected<std::vector<RuleRow>, Diagnostics> read_rules(std::string_view csv, std::string file);

/// The built-in rules (data/rules/*.csv). Topics: safety (factors of ropes by field), ratio (D/d), groove, friction,
/// sheave (efficiency), termination (efficiency), strength (what else a breaking force is held against), buckling
/// (imperfection factors of EN 1993-1-1), hoist (dynamic factor phi2), layout (limits of a skyline), modulus (of wire
/// ropes, on the metallic area), pressure (in a groove), wire (outer wire over d), temperature (strength of a hot
/// rope), life (bending cycles), discard (when a rope is put away).
const std::vector<RuleRow>& rules();

/// The rules whose id begins with `prefix` and a point: "safety", "safety.crane_running". In the tables' order.
std::vector<RuleRow> rules_of(std::string_view prefix, const std::vector<RuleRow>& table = rules());

/// The rule of that id, case apart. On failure: the nearest ids.
Found<RuleRow> find_rule(std::string_view id, const std::vector<RuleRow>& table = rules());

/// The rule's single number, SI. A rule that is a range or a formula has none: the message says which.
Found<double> value_of(const RuleRow& rule);

}  // namespace taut::catalogue
