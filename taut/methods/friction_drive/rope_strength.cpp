#include "taut/methods/friction_drive/rope_strength.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/expects.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rope_values.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive {
namespace {

/// "6x36WS IWRC" names a construction and a core, "18x7 / 19x7" two constructions.
bool advice_fits(const std::string& group, const catalogue::RopeRow& rope) {
  std::size_t from = 0;
  while (from < group.size()) {
    const std::size_t to = std::min(group.find(' ', from), group.size());
    const std::string word = group.substr(from, to - from);
    if (catalogue::parse_construction(word) && catalogue::matches_construction(rope.construction, word)) return true;
    from = to + 1;
  }
  return false;
}

}  // namespace

std::optional<catalogue::RuleRow> diameter_rule(const catalogue::RopeRow& rope) {
  std::optional<catalogue::RuleRow> strictest;
  for (const catalogue::RuleRow& rule : catalogue::rules_of("ratio.maker")) {
    if (!rule.low || !advice_fits(rule.group, rope)) continue;
    if (!strictest || *rule.low > *strictest->low) strictest = rule;
  }
  if (strictest) return strictest;
  const auto block = catalogue::find_rule("ratio.mainline_block.us_wa");
  return block ? std::optional(*block) : std::nullopt;
}

std::optional<catalogue::RopeRow> rope_of(const Input& in) {
  if (!in.rope) return std::nullopt;
  const auto rope = catalogue::find_rope_in_words(*in.rope);
  expects(rope.has_value(), "friction_drive takes inputs without complaints");
  return *rope;
}

void take_tension(const catalogue::RopeRow& rope, double tension, Result& r) {
  for (Check& c : r.checks) {
    if (c.name != "rope does not break" || !(tension > c.value)) continue;
    c = catalogue::breaking_check("rope", rope, tension);
    c.where = "tight branch with the take-up, exact";
    for (Value& v : r.values) {
      if (v.name == "safety_factor") v.value = rope.breaking_force / tension;
    }
  }
}

void check_rope(const Input& in, const catalogue::RopeRow& rope, const Display& display, Output& out, Result& r) {
  const double largest = std::max({out.P_tight, out.T_1, out.T_1_no_slip});
  out.safety_factor = rope.breaking_force / largest;
  if (rope.trust == catalogue::Trust::unverified) {
    r.warnings.push_back(
        fmt::format("the breaking force of {} is unverified ({}): compare it with the maker's certificate", rope.id,
                    rope.trust_text));
  }
  r.checks.push_back(catalogue::breaking_check("rope", rope, largest));
  if (in.rope_mass < rope.mass_per_length) {
    r.warnings.push_back(fmt::format(
        "rope_mass {} is less than that of the bare rope {}, {}: the cutters come on top of it",
        display.brief(in.rope_mass, si::kg_per_m), rope.id, display.brief(rope.mass_per_length, si::kg_per_m)));
  }
  if (!in.sheave_radius) return;
  out.diameter_ratio = 2 * *in.sheave_radius / rope.diameter;
  const auto rule = diameter_rule(rope);
  if (!rule || !rule->low) return;
  r.checks.push_back(
      make_check("D/d of the driving sheave", out.diameter_ratio, si::one,
                 {.sense = Sense::at_least,
                  .limit = *rule->low,
                  .rule = fmt::format("{}: {} {}, {}", rule->field, rule->item, rule->group, rule->source),
                  .trust = catalogue::trust_words(*rule)}));
}

}  // namespace taut::friction_drive
