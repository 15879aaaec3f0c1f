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

namespace {

/// Each line on a drum of a yarder has checks of its own.
void add_lines_of_yarders(std::vector<CheckWords>& all) {
  for (const char* line : {"skyline", "mainline", "haulback"}) {
    all.push_back(
        {.key = fmt::format("{}_length", line),
         .of = "yarder",
         .words = fmt::format("rope that its {} needs, with what is spare: at most what the drum takes", line)});
    all.push_back(
        {.key = fmt::format("{}_pull", line),
         .of = "yarder",
         .words = fmt::format("largest tension of its {} at the yarder: at most the pull with a full drum, or "
                              "what the brake holds",
                              line)});
    all.push_back({.key = fmt::format("{}_base_tension", line),
                   .of = "yarder",
                   .words = fmt::format("tension at which its {} is put up: at most the pull with a full drum", line)});
  }
}

std::vector<CheckWords> all_check_words() {
  std::vector<CheckWords> all = {
      {.key = "on_sheave",
       .of = "rope",
       .words = "safety factor of the rope weakened on a sheave, at the worst sheave"},
      {.key = "sheave_ratio",
       .of = "rope",
       .words = "D/d of the worst sheave, pitch diameter over rope diameter: at least that of the rules"},
      {.key = "drum_ratio",
       .of = "rope",
       .words = "D/d of the worst drum in its first layer: at least that of the rules"},
      {.key = "compensating_ratio",
       .of = "rope",
       .words = "D/d of the worst sheave that `compensating` names: at least that of the rules"},
      {.key = "resistance",
       .of = "rope",
       .words = "static proof of EN 13001-3-2: the pull at a round, at most F_u/gamma_rb"},
      {.key = "fatigue",
       .of = "rope",
       .words = "fatigue proof of EN 13001-3-2: the largest pull, by the number of bendings"},
      {.key = "wire_stress",
       .of = "rope",
       .words = "tension and bending in the outer wires: at most the grade of the wires"},
      {.key = "end_temperature", .of = "rope", .words = "temperature of the rope: at most what its terminations stand"},
      {.key = "drum_layers", .of = "rope", .words = "layers on a grooved drum: at most those of the rules"},
      {.key = "last_layer_pull",
       .of = "rope",
       .words = "pull of all ropes that are wound the same way, in the last layer of a drum"},
      {.key = "donandt",
       .of = "rope",
       .words = "largest pull at a round: at most the Donandt force, above which the life falls off"},
      {.key = "guy_safety", .of = "guy", .words = "breaking force over the largest tension in any state"},
      {.key = "slackness", .of = "guy", .words = "least tension: at least that of a rope as long as its chord"},
      {.key = "pretension_min", .of = "guy", .words = "least tension as put up, over the breaking force"},
      {.key = "pretension_max", .of = "guy", .words = "largest tension as put up, over the breaking force"},
      {.key = "anchor_strength",
       .of = "point",
       .words = "pull of all ropes at the point together, over the strength of the anchor"},
      {.key = "anchor_as_rope",
       .of = "point",
       .words = "strength of the anchor: at least the breaking forces of the ropes there"},
      {.key = "anchor_uplift", .of = "point", .words = "upward force at the point"},
      {.key = "anchor_angle", .of = "point", .words = "angle of the pull at the point"},
      {.key = "anchor_tree",
       .of = "point",
       .words = "diameter of the tree at the point: at least that which the pull needs"},
      {.key = "anchor_wraps", .of = "point", .words = "wraps of the line round the stump: at least those of the rule"},
      {.key = "anchor_spikes",
       .of = "point",
       .words = "spikes that hold the line at the stump: at least those of the rule"},
      {.key = "anchor_staples",
       .of = "point",
       .words = "staples that hold the line at the stump: at least those of the rule"},
      {.key = "anchor_clips",
       .of = "point",
       .words = "clips on the end of the line: at least those of the rule, by its diameter"},
      {.key = "support_tree",
       .of = "support",
       .words = "diameter of the tree that carries the support: at least that which the force needs"},
      {.key = "buckling", .of = "mast", .words = "utilisation by flexural buckling, EN 1993-1-1 (6.46)"},
      {.key = "member", .of = "mast", .words = "utilisation by buckling with bending, EN 1993-1-1 (6.61) and (6.62)"},
      {.key = "shear", .of = "mast", .words = "utilisation by the shear force, EN 1993-1-1 (6.17)"},
      {.key = "wall", .of = "mast", .words = "class of the wall by its slenderness: class 4 is refused"},
      {.key = "guys_by_plate", .of = "mast", .words = "number of the guys: at least that on the plate of the spar"},
      {.key = "guy_strength_by_plate",
       .of = "mast",
       .words = "strength of the guys: at least that on the plate of the spar"},
      {.key = "break_angle",
       .of = "line",
       .words = "angle by which the line bends on a support: at most that of the rules"},
      {.key = "least_break_angle",
       .of = "line",
       .words = "angle by which the empty line bends on a support: at least that of the rules"},
      {.key = "anchor_off_line",
       .of = "line",
       .words = "angle of the anchor behind the tail tree off the line, seen from above: at most that of the rules"},
      {.key = "limiter_tension", .of = "line", .words = "largest tension of the line: at most that of its limiter"},
      {.key = "payload_T_max", .of = "rope", .words = "largest tension at rest: at most the limit of the payload"},
      {.key = "phi2",
       .of = "rope",
       .words = "peak over the tension at rest while a load is hoisted: at most phi2 of EN 13001-2"},
      {.key = "payload_min", .of = "carriage", .words = "the payload at the places where nothing can be carried"},
      {.key = "least_rope", .of = "carriage", .words = "diameter of the rope: at least the least that fits it"},
      {.key = "most_rope", .of = "carriage", .words = "diameter of the rope: at most the largest that fits it"},
      {.key = "capacity", .of = "drum", .words = "rope on the drum: at most what its flanges hold"},
      {.key = "slipped",
       .of = "driven sheave",
       .words = "how far the rope slips on it in a motion: at most what a rope creeps there"},
      {.key = "ground", .of = "part", .words = "a part of the machine must not lie in the ground"}};
  add_lines_of_yarders(all);
  return all;
}

}  // namespace

const std::vector<CheckWords>& check_words() {
  static const std::vector<CheckWords> all = all_check_words();
  return all;
}

std::optional<Sense> worst_side(const std::string& name) {
  const auto part_of = [](const std::string& of) { return of.substr(of.rfind('.') + 1); };
  const std::string part = part_of(name);
  const bool known = std::any_of(value_kinds().begin(), value_kinds().end(),
                                 [&](const ValueKind& kind) { return part_of(kind.about.name) == part; });
  if (!known) return std::nullopt;
  for (const char* least :
       {"safety_factor", "dynamic_safety_factor", "life_repeats", "clearance_min", "rope_clearance_min"}) {
    if (part == least) return Sense::at_least;
  }
  return Sense::at_most;
}

std::vector<std::string> worst_columns(const std::string& table) {
  if (table == anchor_words().name || table == support_words().name) return {"force"};
  if (table == mast_words().name) return {"section_use", "buckling", "member"};
  return {};
}

std::vector<std::string> largest_columns(const std::string& table) {
  if (table == anchor_words().name || table == support_words().name) return {"tree_diameter"};
  return {};
}

std::vector<TableWords> table_words() {
  return {life_words(),   discard_words(), mast_words(),  mast_choice_words(),
          anchor_words(), support_words(), yarder_words()};
}

}  // namespace taut::checks
