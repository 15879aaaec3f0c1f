#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/checks/anchor/rope_ends.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/parts.hpp"
#include "taut/checks/rope/rope_strength.hpp"

namespace taut::checks {
namespace {

std::vector<std::string> anchors_of(const machine::Model& model) {
  std::vector<std::string> known;
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.closed) continue;
    for (const std::string& name : {rope.nodes.front().name, rope.nodes.back().name}) {
      if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    }
  }
  return known;
}

constexpr const char* fastening =
    "Lines on stumps and trees: 2.5 wraps, 8 spikes or 6 staples on the first and the last wrap, 2 clips up to 1 in. "
    "and 3 above (WAC 296-54-569): say 'fastening' of an anchor to have it checked; a skyline does not count as a "
    "guyline.";
constexpr double inch = 0.0254;  // m

double elevation(const Vector3& F) { return std::atan2(F.z(), std::hypot(F.x(), F.y())); }

const Quantities<AnchorStates>& anchor_quantities() {
  using Row = AnchorStates;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the anchor, or the point where ropes end", [](const Row& s) { return s.request->name; }},
      {"force", "F", si::N,
       "largest pull of all that ends there, runs over it, or stands on it and pulls it up, without factors",
       [](const Row& s) { return s.pull.norm(); }},
      {"horizontal", "", si::N, "its horizontal part", [](const Row& s) { return std::hypot(s.pull.x(), s.pull.y()); }},
      {"upwards", "", si::N, "its vertical part, uplift positive", [](const Row& s) { return s.pull.z(); }},
      {"angle", "", si::rad, "its angle above the horizontal", [](const Row& s) { return elevation(s.pull); }},
      {"where", "", si::one, "state in which that is", &Row::where},
      {"tree_diameter", "", si::m.in("cm"), "diameter of a tree that holds it, by force and angle, in the worst state",
       [](const Row& s) { return s.tree.needed().value_or(none); }}};
  return all;
}

void add_anchor_row(const AnchorStates& s, Result& r) {
  add_line(r, "anchor_forces",
           "Largest pull of all ropes together on what holds them, without factors (angle: above the horizontal)",
           anchor_quantities(), s);
}

}  // namespace

TableWords anchor_words() {
  return {
      .name = "anchor_forces", .rows = "every anchor of `checks: anchors:`", .columns = words_of(anchor_quantities())};
}

void complain_of_anchors(const std::vector<AnchorCheckRequest>& anchors, const machine::Machine& described,
                         const machine::Model& model, std::vector<Complaint>& complaints) {
  const std::vector<std::string> of_ropes = anchors_of(model);
  std::vector<std::string> known = of_ropes;
  for (const Footing& one : footings_of(described, model)) known.push_back(one.name);
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const AnchorCheckRequest& one : anchors) {
    const std::string path = fmt::format("checks.anchors.{}", one.name);
    if (!has(known, one.name)) {
      complaints.push_back({path, fmt::format("no rope ends at '{}', and nothing stands there{}", one.name,
                                              did_you_mean(one.name, known))});
    } else if (!has(of_ropes, one.name) && (one.as_strong_as_rope || one.tree_diameter || one.fastening)) {
      complaints.push_back({path, fmt::format("no rope ends at '{}': 'as_strong_as_rope', 'tree_diameter' and "
                                              "'fastening' are for what holds ropes",
                                              one.name)});
    }
    if (one.fastening && one.fastening->spikes && one.fastening->staples) {
      complaints.push_back({path + ".fastening", "either 'spikes' or 'staples'"});
    }
    if (one.as_strong_as_rope && !one.strength) complaints.push_back({path, "'as_strong_as_rope' needs 'strength'"});
    if (one.safety_factor != 1 && !one.strength) complaints.push_back({path, "'safety_factor' needs 'strength'"});
  }
}

std::vector<AnchorStates> anchor_states(const std::vector<AnchorCheckRequest>& anchors,
                                        const machine::Machine& described, const machine::Model& model) {
  const std::vector<Footing> footings = footings_of(described, model);
  std::vector<AnchorStates> all;
  for (const AnchorCheckRequest& one : anchors) {
    AnchorStates& anchor = all.emplace_back();
    anchor.request = &one;
    anchor.tree.level = one.ground_slope == 0;
    const auto own = std::find_if(footings.begin(), footings.end(), [&](const auto& f) { return f.name == one.name; });
    if (own != footings.end()) anchor.footing = *own;
  }
  return all;
}

namespace {

constexpr std::size_t most_combined = 12;  ///< ropes at an anchor of which every combination is tried

/// The largest pull that ropes make together, each with its breaking force or not loaded: one that pulls
/// against the others does not help the anchor. Of very many ropes their sum, which is not less. N
double strongest_together(const std::vector<Vector3>& ropes) {
  double largest = 0;
  if (ropes.size() > most_combined) {
    for (const Vector3& one : ropes) largest += one.norm();
    return largest;
  }
  for (std::size_t loaded = 1; loaded < std::size_t{1} << ropes.size(); ++loaded) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < ropes.size(); ++i) {
      if ((loaded >> i & 1U) != 0) sum += ropes[i];
    }
    largest = std::max(largest, sum.norm());
  }
  return largest;
}

/// Adds what stands there where it pulls up: what presses does not hold down the ropes beside it. The force of a body
/// on its joint has that of the ropes at its origin in it.
void add_footing(const CheckState& state, Vector3& F, AnchorStates& anchor) {
  if (!anchor.footing) return;
  const bool beams = !anchor.footing->of.empty();
  if (state.rest == nullptr) {
    if (!beams && anchor.unknown.empty()) anchor.unknown = state.words;
    return;
  }
  const Vector3 force = force_on(*anchor.footing, *state.model, *state.rest);
  if (force.z() > force_rounding(*state.model, *state.rest)) {
    F = beams ? F + force : force;
  } else if (F.norm() == 0 && anchor.uplift < 0) {
    anchor.uplift = 0;
    anchor.where_uplift = state.words;
  }
}

}  // namespace

void take(const CheckState& state, AnchorStates& anchor) {
  const double factor = state.moves ? 1 : anchor.request->dynamic_factor;
  Vector3 F = Vector3::Zero();
  std::vector<Vector3> strengths;
  each_pull_at(state, anchor.request->name, [&](const RopePull& pull) {
    F += pull.force;
    anchor.strongest_rope = std::max(anchor.strongest_rope, pull.rope.breaking_force * pull.rope.copies);
    // over a round it pulls with both of its parts
    if (pull.tension > 0) strengths.emplace_back(pull.rope.breaking_force / pull.tension * pull.force);
    if (pull.rope.breaking_force > 0) anchor.strong.insert(pull.rope.name);
    anchor.strength_unknown |= pull.rope.breaking_force == 0;
    anchor.thickest_rope = std::max(anchor.thickest_rope, pull.rope.diameter);
  });
  anchor.strongest_rope = std::max(anchor.strongest_rope, strongest_together(strengths));
  const bool ropes = F.norm() > 0;
  anchor.ropes |= ropes;
  add_footing(state, F, anchor);
  if (F.norm() == 0) return;
  if (ropes) {
    anchor.tree.take(factor * F.norm(), elevation(F) - anchor.request->ground_slope, with_factor(state.words, factor));
  }
  if (factor * F.norm() > anchor.force) {
    anchor.force = factor * F.norm();
    anchor.pull = F;
    anchor.factor = factor;
    anchor.where = state.words;
  }
  if (factor * F.z() > anchor.uplift) {
    anchor.uplift = factor * F.z();
    anchor.where_uplift = with_factor(state.words, factor);
  }
  if (elevation(F) > anchor.angle) {
    anchor.angle = elevation(F);
    anchor.where_angle = state.words;
  }
}

namespace {

/// What is doubted of the breaking forces of the ropes at an anchor.
std::vector<Doubt> doubts_of_ropes(const AnchorStates& s, const CheckedDeck& deck) {
  std::vector<Doubt> doubts;
  for (const std::string& name : s.strong) {
    for (const std::size_t i : reevings_named(name, deck.machine)) add_doubt_of_rope(deck, i, doubts);
  }
  return doubts;
}

/// Force against what the anchor holds: declared, by its ropes, by the tree that it is. A rope is as strong as it can
/// be when it is cold, and that is what the anchor has to hold.
void check_holding(const AnchorStates& s, const CheckedDeck& deck, Result& r) {
  const AnchorCheckRequest& one = *s.request;
  const std::string where = with_factor(s.where, s.factor);
  const auto force = [&](double x) { return s.tree.display.brief(x, si::N); };
  if (one.strength) {
    add_part_check(
        one.name, "anchor_strength", *one.strength / s.force, si::one,
        {.sense = Sense::at_least,
         .limit = one.safety_factor,
         .rule = fmt::format("strength {} over the largest pull {} ({})", force(*one.strength), force(s.force), where),
         .trust = "user"},
        r);
  }
  if (one.as_strong_as_rope) {
    if (s.strength_unknown) {
      r.unmade.push_back(
          fmt::format("{}: 'as_strong_as_rope' is not checked: a rope fixed to it has no 'breaking_force' in "
                      "'machine.ropes'",
                      one.name));
      r.warnings.push_back(r.unmade.back());
    }
    if (s.strongest_rope > 0) {
      add_part_check(
          one.name, "anchor_as_rope", *one.strength, si::N,
          with_doubts({.sense = Sense::at_least,
                       .limit = s.strongest_rope,
                       .rule = "strength of the anchor not below the breaking forces of the ropes fixed to it, all "
                               "copies, as far as they pull together",
                       .trust = "derived"},
                      {}, doubts_of_ropes(s, deck)),
          r);
    }
  }
  // a declared strength, of a deadman or a plate, needs no tree
  if (one.tree_diameter || !one.strength) add_anchor_tree(one.name, s.tree, one.tree_diameter, r);
}

void check_fastening(const AnchorStates& s, Result& r) {
  if (!s.request->fastening) return;
  const FasteningRequest& f = *s.request->fastening;
  const auto check = [&](const std::optional<double>& have, const char* name, const std::string& id) {
    if (!have) return;
    const RuleLimit rule = rule_limit(id, true);
    add_part_check(s.request->name, name, *have, si::one,
                   {.sense = Sense::at_least, .limit = rule.value, .rule = rule.words, .trust = rule.trust}, r);
  };
  check(f.wraps, "anchor_wraps", "layout.anchor_wraps");
  check(f.spikes, "anchor_spikes", "layout.anchor_spikes");
  check(f.staples, "anchor_staples", "layout.anchor_staples");
  // a line of unknown diameter counts as a thick one
  const bool thin = s.thickest_rope > 0 && s.thickest_rope <= inch * (1 + 1e-9);
  check(f.clips, "anchor_clips", thin ? "layout.anchor_clips.thin" : "layout.anchor_clips.thick");
  std::vector<std::string> missing;
  if (!f.wraps) missing.emplace_back("'wraps'");
  if (!f.spikes && !f.staples) missing.emplace_back("'spikes' or 'staples'");
  if (!f.clips) missing.emplace_back("'clips'");
  if (missing.empty()) return;
  r.unmade.push_back(fmt::format("{}: its fastening is not checked in full: it needs {} too", s.request->name,
                                 fmt::join(missing, ", ")));
  r.warnings.push_back(r.unmade.back());
}

}  // namespace

void add_anchor_checks(const std::vector<AnchorStates>& anchors, const CheckedDeck& deck, Result& r) {
  bool reported = false;
  for (const AnchorStates& s : anchors) {
    const AnchorCheckRequest& one = *s.request;
    const Part part = part_of_anchor(deck.machine, one.name);
    const AboutPart about(r, part);
    if (s.force > 0) r.loaded.insert("anchor " + one.name);
    if (!s.unknown.empty()) {
      r.unmade.push_back(fmt::format("{} is not checked in a motion ({}), which does not know the force on its joint",
                                     one.name, s.unknown));
      r.warnings.push_back(r.unmade.back());
    }
    const bool pressed = s.force == 0 && s.uplift == 0;
    if (s.force == 0 && !(pressed && one.uplift && !one.strength && !one.angle)) {
      leave_unmade(
          r,
          fmt::format("{} is not checked: no load case of the deck pulls {}", one.name,
                      s.footing ? "it up, and what only presses it or pulls it aside is not counted" : "at it"),
          {.part = part, .no_load = "anchor " + one.name});
      continue;
    }
    if (!reported && s.ropes) r.assumptions.emplace_back(fastening);
    reported |= s.ropes;
    if (!pressed) {
      add_anchor_row(s, r);
      check_holding(s, deck, r);
    }
    check_fastening(s, r);
    if (one.uplift) {
      add_part_check(one.name, "anchor_uplift", s.uplift, si::N,
                     {.sense = Sense::at_most,
                      .limit = *one.uplift,
                      .rule = fmt::format("pull upwards ({})", s.where_uplift),
                      .trust = "user"},
                     r);
    }
    if (one.angle) {
      add_part_check(one.name, "anchor_angle", s.angle, si::rad,
                     {.sense = Sense::at_most,
                      .limit = *one.angle,
                      .rule = fmt::format("angle of the pull above the horizontal ({})", s.where_angle),
                      .trust = "user"},
                     r);
    }
  }
}

}  // namespace taut::checks
