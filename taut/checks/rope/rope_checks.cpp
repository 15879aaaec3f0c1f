#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "taut/base/suggest.hpp"
#include "taut/calc/shown.hpp"
#include "taut/checks/checks.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/rope/rope_life.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/checks/rope/rope_uses.hpp"
#include "taut/study/analyses.hpp"

namespace taut::checks {
namespace {

/// Names of what bends these ropes.
std::vector<std::string> rounds_of(const machine::Model& model, const std::vector<std::size_t>& reevings) {
  std::vector<std::string> known;
  for (const std::size_t i : reevings) {
    for (const machine::Node& node : model.reevings[i].nodes) {
      if (node.radius > 0) known.push_back(node.name);
    }
  }
  return known;
}

/// What a round is that never compensates; empty: a sheave that may.
const char* never_compensates(const machine::Node& node) {
  if (node.drum) return "a drum";
  if (node.kind == machine::NodeKind::drive) return "driven";
  if (node.kind == machine::NodeKind::clamp) return "a place where the rope is held";
  return kind_of(node) == rope::BendKind::sheave ? "" : "a saddle, over which the rope slides";
}

/// Why D/d of a compensating sheave is not that of this round; empty: it is.
std::string no_compensating_sheave(const machine::Model& model, const std::vector<std::size_t>& reevings,
                                   const std::string& name) {
  std::vector<std::string> sheaves;
  std::string other;
  for (const std::size_t i : reevings) {
    for (const machine::Node& node : model.reevings[i].nodes) {
      if (!(node.radius > 0)) continue;
      const std::string never = never_compensates(node);
      if (never.empty()) sheaves.push_back(node.name);
      if (!never.empty() && node.name == name) other = never;
    }
  }
  if (!other.empty())
    return fmt::format("'{}' is {}: name a sheave that stands while the rope is hauled, or leave it out", name, other);
  if (std::find(sheaves.begin(), sheaves.end(), name) != sheaves.end()) return {};
  return fmt::format("the rope runs over no sheave '{}' with a diameter{}", name, did_you_mean(name, sheaves));
}

void complain_of_places(const RopeCheckRequest& request, const std::string& path, const machine::Model& model,
                        const std::vector<std::size_t>& reevings, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < request.compensating.size(); ++i) {
    std::string why = no_compensating_sheave(model, reevings, request.compensating[i]);
    if (!why.empty()) complaints.push_back({fmt::format("{}.compensating[{}]", path, i), std::move(why)});
  }
}

/// A compensating sheave stands while the rope is hauled. With one end on a drum and the other one fixed all sheaves
/// between them turn.
void add_running(const RopeCheckRequest& request, const machine::Reeving& rope, Result& r) {
  const bool one_drum = !rope.closed && rope.nodes.front().drum.has_value() != rope.nodes.back().drum.has_value();
  if (request.compensating.empty() || !one_drum) return;
  r.unmade.push_back(
      fmt::format("'{}' is hauled at one end and fixed at the other one, so all of its sheaves turn: "
                  "'{}' does not compensate",
                  rope.name, request.compensating.front()));
  r.warnings.push_back(r.unmade.back());
}

void set_compensating(const RopeCheckRequest& request, rope::RopeUse& use) {
  for (rope::Bend& bend : use.bends) {
    const auto& all = request.compensating;
    if (std::find(all.begin(), all.end(), bend.name) != all.end()) bend.kind = rope::BendKind::compensating_sheave;
  }
}

}  // namespace

namespace {

/// A rope has one entry. One of its own leaves that of what it is made of to the others, which may be none; a heat that
/// is said there alone would be lost.
void complain_of_second_entry(std::size_t entry, const std::vector<std::size_t>& reevings, const CheckedDeck& deck,
                              const std::string& path, std::vector<Complaint>& complaints) {
  const auto& ropes = deck.checks->ropes;
  const RopeCheckRequest& one = ropes[entry];
  if (reevings_of_entry(deck, entry).empty()) {
    std::vector<std::string> own;
    own.reserve(reevings.size());
    for (const std::size_t i : reevings) own.push_back(fmt::format("'{}'", reeving_name_of(deck.machine, i)));
    complaints.push_back({path, fmt::format("each reeving or guy of '{}' has an entry of its own here, {}, by which it "
                                            "is judged: write there what this entry says, and leave this one out",
                                            one.name, fmt::join(own, ", "))});
    return;
  }
  if (!one.temperature) return;
  for (const std::size_t i : reevings) {
    const RopeCheckRequest& own = ropes[*entry_of(deck, i)];
    if (own.name == one.name || own.temperature) continue;
    complaints.push_back({fmt::format("checks.ropes.{}", own.name),
                          fmt::format("'{}' gives the rope of '{}' a temperature, and '{}' is judged by this entry "
                                      "alone: give its 'temperature' here too",
                                      one.name, own.name, own.name)});
  }
}

}  // namespace

std::vector<AskedRules> resolve_ropes(const ChecksRequest& request, const CheckedDeck& deck,
                                      const machine::Model& model, std::vector<Complaint>& complaints) {
  std::vector<AskedRules> all;
  for (std::size_t k = 0; k < request.ropes.size(); ++k) {
    const RopeCheckRequest& one = request.ropes[k];
    const std::string path = fmt::format("checks.ropes.{}", one.name);
    const std::vector<std::size_t> reevings = reevings_named(one.name, deck.machine);
    if (reevings.empty()) {
      std::vector<std::string> known;
      known.reserve(model.reevings.size());
      for (const machine::Reeving& r : model.reevings) known.push_back(r.name);
      complaints.push_back(
          {path, fmt::format("there is no reeving, guy or rope '{}'{}", one.name, did_you_mean(one.name, known))});
      continue;
    }
    complain_of_second_entry(k, reevings, deck, path, complaints);
    const std::string& name = rope_name_of(deck.machine, reevings.front());
    const AskedRules& asked = all.emplace_back(asked_rules(one, path, complaints));
    catalogue::RopeRow rope;
    // each candidate of a design has a row of its own, by which it is judged
    if (deck.chosen.contains(name)) {
      complain_of_candidates(one, path, complaints);
    } else {
      const catalogue::RopeRow own = row_in(deck, name);
      complain_of_values(one, own, path, complaints);
      rope = with_request(own, one);
      complain_of_limits(one, asked, rope, path, complaints);
    }
    complain_of_life(one, rope, rounds_of(model, reevings), path, complaints);
    complain_of_places(one, path, model, reevings, complaints);
  }
  return all;
}

/// A rated pull is one that lasts. A winch has to be able to make the peaks of a motion too.
void warn_of_peaks(const rope::RopeUse& use, const rope::RopeRules& rules, Result& r) {
  for (const rope::DrumEnd& drum : use.drums) {
    if (!rules.rated_pull) continue;
    const bool layers = drum.first_radius && drum.last_radius;
    const double rated = *rules.rated_pull * (layers ? *drum.first_radius / *drum.last_radius : 1);
    if (!(drum.haul_peak > rated)) continue;
    const auto [pull, most] = brief_apart(drum.haul_peak, rated, si::N, use.display);
    warn_unsafe(r, fmt::format("'{}' pulls up to {} in a motion, {:.3g} of its rated pull of {}{}: its drive has to be "
                               "able to",
                               drum.name, pull, drum.haul_peak / rated, most, layers ? " in its last layer" : ""));
  }
}

/// A termination of which the tables say nothing but what the deck gives, its efficiency. Some of theirs are too weak
/// in the heat, and some are not for lifting.
void doubt_termination(const rope::RopeUse& use, const AskedRules& asked, const rope::RopeRules& rules, Result& r) {
  if (asked.unknown_termination.empty()) return;
  const std::string words = fmt::format(
      "{}: the tables do not have the termination '{}': whether it is for lifting, and "
      "how hot it may be, is not checked",
      use.name, asked.unknown_termination);
  warn_unsafe(r, words);
  if (rules.temperature && weakens(*rules.temperature)) r.unmade.push_back(words);
}

void put_request(const RopeCheckRequest& request, rope::RopeUse& use, Result& r) {
  if (!use.chosen) {
    use.rope = with_request(std::move(use.rope), request);
    return;
  }
  std::vector<std::string> denied;
  use.rope = candidate_with_request(std::move(use.rope), request, fmt::format("checks.ropes.{}", request.name), denied);
  for (std::string& one : denied) one = fmt::format("{}: {}", use.name, one);
  r.warnings.insert(r.warnings.end(), denied.begin(), denied.end());
  std::move(denied.begin(), denied.end(), std::back_inserter(r.unmade));
}

namespace {

/// The value beside the check is that of the cold rope so far, and so is that of each state in its tables.
void weaken_factors(const std::string& rope, double share, Result& r) {
  for (Value& value : r.values) {
    if (value.name == rope + ".safety_factor") value.value *= share;
  }
  for (Table& table : r.tables) {
    const auto factor = std::find_if(table.columns.begin(), table.columns.end(),
                                     [](const Column& one) { return one.name == "safety_factor"; });
    if (factor == table.columns.end() || table.columns.front().name != "name") continue;
    for (std::vector<Cell>& row : table.rows) {
      const auto* name = std::get_if<std::string>(&row.front());
      if (name == nullptr || *name != rope) continue;
      if (auto* cell = std::get_if<double>(&row[static_cast<std::size_t>(factor - table.columns.begin())]))
        *cell *= share;
    }
  }
}

}  // namespace

void add_checks_of(const RopeCheckRequest& request, const AskedRules& asked, const rope::RopeUse& use, Result& r,
                   std::optional<double> around) {
  const rope::RopeRules rules = rope_rules(request, asked, use.rope, around);
  rope::RopeChecks found = rope::check_rope(use, rules);
  // the rope of the deck has them; a candidate of a design need not
  for (const MissingLimit& one : missing_limits(request, asked, use.rope, rules, use.display)) {
    found.left_out.push_back(fmt::format("{}: {} is not checked: {}", use.name, one.key, one.words));
  }
  std::move(found.checks.begin(), found.checks.end(), std::back_inserter(r.checks));
  for (const auto& [sentence, thing] : found.no_load) {
    r.about.insert_or_assign(sentence, About{.part = {.kind = PartKind::rope, .name = use.name}, .no_load = thing});
  }
  r.loaded.merge(found.loaded);
  r.warnings.insert(r.warnings.end(), found.left_out.begin(), found.left_out.end());
  r.warnings.insert(r.warnings.end(), found.remarks.begin(), found.remarks.end());
  std::move(found.left_out.begin(), found.left_out.end(), std::back_inserter(r.unmade));
  warn_of_peaks(use, rules, r);
  doubt_termination(use, asked, rules, r);
  const double heat_share = rope::heat_share(rules);
  weaken_factors(use.name, heat_share, r);
  if (const double peak = rope::peak_tension(use, rules); peak > 0 && use.rope.breaking_force > 0) {
    const bool moves = use.peak > 0 && use.peak >= rules.dynamic_factor * use.tension;
    const ValueKind& kind = named(value_kinds(), "ROPE.dynamic_safety_factor");
    r.values.push_back(make_value(
        kind, use.name, "", heat_share * use.rope.breaking_force / peak,
        fmt::format("{} of {} ({})", kind.about.words, use.name, moves ? use.peak_where : rules.dynamic_words)));
  }
  Sheet<Num> s("rope", RopeCheckRequest::describe(), &request);
  rope::write_rope(s, use, rules);
  s.move_to(r);
  add_life(request, rope::rest_is_known(use) ? use : rope::at_peak(use), rules, r);
}

void add_rope_checks(const ChecksRequest& request, const CheckedDeck& deck, const machine::Model& model,
                     const std::vector<rope::RopeUse>& uses, Result& r) {
  const std::optional<double> hottest = study::hottest_of(deck.machine, deck.analyses);
  for (std::size_t k = 0; k < request.ropes.size(); ++k) {
    const RopeCheckRequest& one = request.ropes[k];
    for (const std::size_t i : reevings_of_entry(deck, k)) {
      rope::RopeUse use = uses[i];
      const AboutPart about(r, {.kind = PartKind::rope, .name = use.name});
      use.chosen = deck.chosen.contains(rope_name_of(deck.machine, i));
      put_request(one, use, r);
      set_compensating(one, use);
      add_running(one, model.reevings[i], r);
      add_checks_of(one, deck.asked.ropes.at(k), use, r, hottest);
    }
  }
}

}  // namespace taut::checks
