#include "taut/checks/described.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/checks/anchor/support_checks.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/mast/mast_checks.hpp"
#include "taut/checks/rope/rope_life.hpp"
#include "taut/checks/yarder/yarder_checks.hpp"

namespace taut::checks {
namespace {

constexpr const char* every_state = "every judged state of a machine";

ValueKind of_states(std::string name, std::string symbol, const Unit& unit, std::string words, std::string page) {
  return {.about = {.name = std::move(name), .symbol = std::move(symbol), .unit = unit, .words = std::move(words)},
          .of = every_state,
          .page = std::move(page)};
}

ValueKind of_checks(const char* block, std::string name, const Unit& unit, std::string words, std::string page) {
  return {.about = {.name = std::move(name), .symbol = "", .unit = unit, .words = std::move(words)},
          .of = fmt::format("`checks: {}:`", block),
          .page = std::move(page)};
}

}  // namespace

const std::vector<ValueKind>& value_kinds() {
  static const std::vector<ValueKind> all = {
      of_states("T_max", "", si::N, "largest tension", "guide/verdict.md"),
      of_states("ROPE.T_max", "", si::N, "largest tension", "guide/verdict.md"),
      of_states("ROPE.safety_factor", "ROPE.S", si::one, "breaking force over the largest static tension",
                "theory/rope-checks.md"),
      of_states("clearance_min", "c_min", si::m, "least height of a carriage over the ground", "theory/load-path.md"),
      of_states("rope_clearance_min", "c_r_min", si::m, "least height of a rope over the ground",
                "theory/load-path.md"),
      of_checks("ropes", "ROPE.dynamic_safety_factor", si::one, "breaking force over the peak tension",
                "theory/rope-checks.md"),
      of_checks("ropes", "ROPE.life_damage", si::one, "damage in the wanted life", "theory/rope-life.md"),
      of_checks("ropes", "ROPE.life_repeats", si::one, "how often the duty can run", "theory/rope-life.md"),
      of_checks("masts", "MAST.utilisation", si::one, "largest use by EN 1993-1-1", "theory/mast-checks.md"),
      of_checks("masts", "MAST.service_stress", si::Pa, "largest |N|/A + M/W without factors", "theory/mast-checks.md"),
      of_checks("masts", "MAST.chosen_mass", si::kg_per_m, "mass per metre of the lightest section that passes",
                "theory/mast-checks.md"),
      of_checks("anchors", "ANCHOR.tree_diameter", si::m.in("cm"),
                "diameter of the tree that holds the anchor, by force and angle", "guide/checks.md"),
      of_checks("supports", "SUPPORT.tree_diameter", si::m.in("cm"),
                "diameter at breast height of the tree that carries the support, by force and height",
                "guide/checks.md")};
  return all;
}

std::optional<Sense> worst_side(const std::string& name) {
  const auto part_of = [](const std::string& of) { return of.substr(of.rfind('.') + 1); };
  const std::string part = part_of(name);
  const bool known = std::any_of(value_kinds().begin(), value_kinds().end(), [&](const ValueKind& kind) {
    return kind.of != every_state && part_of(kind.about.name) == part;
  });
  if (!known) return std::nullopt;
  return part == "dynamic_safety_factor" || part == "life_repeats" ? Sense::at_least : Sense::at_most;
}

std::vector<TableWords> table_words() {
  return {life_words(),   discard_words(), mast_words(),  mast_choice_words(),
          anchor_words(), support_words(), yarder_words()};
}

}  // namespace taut::checks
