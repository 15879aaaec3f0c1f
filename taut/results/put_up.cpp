#include "taut/results/put_up.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "taut/checks/checked_parts.hpp"
#include "taut/math/index.hpp"
#include "taut/results/described.hpp"
#include "taut/solve/drives.hpp"

namespace taut::results {
namespace {

constexpr double in_balance = 0.05;  ///< share of its tension that a guy may have more or less, let go

/// A tension that a rope has at one of its ends in every state.
struct HeldTension {
  double tension = 0;  ///< N
  bool at_end = false;
};

std::vector<HeldTension> held_tensions(const machine::description::Reeving& rope) {
  std::vector<HeldTension> all;
  if (rope.tension_at_start) all.push_back({*rope.tension_at_start, false});
  if (rope.tension_at_end) all.push_back({*rope.tension_at_end, true});
  return all;
}

const char* end_name(bool at_end) { return at_end ? "end" : "start"; }

bool has_take_up(const machine::Machine& machine, const std::string& body) {
  return std::any_of(machine.take_up.begin(), machine.take_up.end(), [&](const auto& t) { return t.body == body; });
}

/// Whether something at this end of a rope can hold a tension: a drum, a take-up, or a body that may move.
bool can_hold(const machine::Machine& machine, const machine::Model& model, const machine::Node& end) {
  if (end.drum) return true;
  if (end.at.body == machine::ground) return false;
  const machine::Body& body = model.bodies[end.at.body];
  return !body.free.empty() || has_take_up(machine, body.name);
}

}  // namespace

void add_put_up(const machine::Model& model, const std::vector<study::PutUpLine>& lines, Result& r) {
  if (lines.empty()) return;
  std::vector<study::PutUpRow> rows;
  for (const study::PutUpLine& one : lines) {
    const std::string& name = model.reevings[one.reeving].name;
    const std::string words = put_up_words(model, one);
    rows.push_back({model, one});
    const ValueKind& base = named(value_kinds(), "ROPE.base_tension");
    r.values.push_back(make_value(base, name, "", one.at_end ? one.at.T_end : one.at.T_start,
                                  fmt::format("{}: at its {}, {}", base.about.words, end_name(one.at_end), words)));
    const double warmth = one.at.cut / one.at.unstretched;
    const auto wound = solve::length_on_drums(model, one.reeving);
    r.values.push_back(
        make_value(named(value_kinds(), "ROPE.cut_length"), name, "", one.at.cut + wound.value_or(0) * warmth,
                   fmt::format("length of {} to cut: unstretched, at the temperature at which it is put up{}; kept "
                               "from there on",
                               name,
                               !wound       ? "; what is on its drum is not known: give the drum its 'length_on_drum'"
                               : *wound > 0 ? ", with what is on its drum"
                                            : "")));
  }
  r.tables.push_back(
      make_table("put_up",
                 "Lines as they are put up; lengths at the reference temperature, as cut, and under these tensions; "
                 "the length is kept from there on",
                 study::put_up_quantities(), rows));
}

void show_put_up(const machine::Model& model, const std::vector<study::PutUpLine>& lines,
                 checks::CheckedParts& checked) {
  for (const study::PutUpLine& one : lines) {
    if (!one.at.outcome.ok()) continue;
    checked.take_empty(one.at.at.model, one.at.at.result, model.reevings[one.reeving].name, put_up_words(model, one),
                       std::string(checks::put_up_analysis), true);
  }
}

namespace {

/// The guy of that name of a machine that stands on its guys: its tension where it is put up, N. None where it has a
/// length, or balances lines and not other guys.
std::optional<double> tension_of(const machine::description::Guy& guy, const study::PutUpMoment& stand) {
  if (!guy.install) return std::nullopt;
  const bool at_anchor = guy.install->at == machine::description::InstallAt::anchor;
  for (const solve::BranchResult& one : stand.state.branches) {
    if (stand.model.reevings[one.reeving].name != guy.name) continue;
    if (!study::has_guys_around(stand.model, 0, as_size(one.reeving))) return std::nullopt;
    return at_anchor ? one.T_to : one.T_from;
  }
  return std::nullopt;
}

}  // namespace

void show_stand_on_guys(const machine::Machine& machine, const study::PutUpMoment& stand,
                        checks::CheckedParts& checked) {
  if (!stand.state.outcome.ok()) return;
  checked.take_put_up(stand.model, stand.state, stand.words);
  for (checks::GuyStates& one : checked.guys) {
    const std::string& name = checked.reevings[as_size(one.reeving)];
    const auto guy =
        std::find_if(machine.guys.begin(), machine.guys.end(), [&](const auto& each) { return each.name == name; });
    if (guy == machine.guys.end()) continue;
    if (const auto T = tension_of(*guy, stand)) one.pulled.emplace_back(*T, stand.words);
  }
}

void note_fallen(const machine::Model& model, std::size_t first_guy, const study::PutUpMoment& stand, Result& r) {
  const Outcome& outcome = stand.state.outcome;
  if (outcome.ok()) return;
  std::string text = fmt::format("{}: {}", stand.words, outcome.message);
  if (study::other_ropes_hold_beams(model, first_guy)) {
    warn_unsafe(r, std::move(text));
    return;
  }
  r.unmade.push_back(text);
  r.warnings.push_back(std::move(text));
}

std::optional<std::string> unbalanced_guys(const machine::Machine& machine, const study::PutUpMoment& stand,
                                           const Display& display) {
  if (!stand.state.outcome.ok()) return std::nullopt;
  std::vector<std::string> all;
  for (const auto& guy : machine.guys) {
    const auto T = tension_of(guy, stand);
    if (!T) continue;
    const double more = *T / guy.install->tension - 1;
    if (std::abs(more) <= in_balance) continue;
    all.push_back(fmt::format("'{}' has {} in place of {} ({:+.0f} %)", guy.name, display.brief(*T, si::N),
                              display.brief(guy.install->tension, si::N), 100 * more));
  }
  if (all.empty()) return std::nullopt;
  return fmt::format(
      "the guys are not in balance as they are put up: when the unloaded machine is let go on them, {}. Give them "
      "'install' tensions that balance, where these are to be the tensions of the machine as it stands",
      fmt::join(all, ", "));
}

std::vector<std::string> tension_assumptions(const machine::Machine& machine, const Display& display) {
  const auto force = [&](double x) { return display.quantity(x, si::N); };
  std::vector<std::string> all;
  for (const auto& rope : machine.reevings) {
    for (const HeldTension& held : held_tensions(rope)) {
      all.push_back(
          fmt::format("Rope {}: its tension at its {} is held at {} in every state at rest, as by a counterweight "
                      "or a winch that holds its pull; a motion begins with it.",
                      name_of(rope), end_name(held.at_end), force(held.tension)));
    }
    if (!rope.install) continue;
    const bool at_end = rope.install->at == machine::description::BaseTensionAt::end;
    all.push_back(fmt::format(
        "Rope {}: put up {} with {} at its {}, at the machine's temperature; its unstretched length is kept in "
        "all other states.",
        name_of(rope),
        rope.install->with.empty() ? "empty" : fmt::format("with {}", fmt::join(rope.install->with, ", ")),
        force(rope.install->tension), end_name(at_end)));
  }
  for (const auto& one : machine.take_up) {
    if (!one.screw) continue;
    const bool stays = one.keeps == machine::description::ScrewKeeps::place;
    all.push_back(stays ? fmt::format("The screw of {} pulls {} where it is set: at rest, at the machine's "
                                      "temperature, without its loads. {} stays there in all other states.",
                                      one.body, force(*one.screw), one.body)
                        : fmt::format("The screw of {} pulls {} in every state, as a ram does that keeps its "
                                      "force.",
                                      one.body, force(*one.screw)));
  }
  return all;
}

std::vector<std::string> held_tension_warnings(const machine::Machine& machine, const machine::Model& model,
                                               const Display& display) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < machine.reevings.size(); ++i) {
    const auto& rope = machine.reevings[i];
    const std::string name = name_of(rope);
    const bool rides = std::any_of(machine.carriages.begin(), machine.carriages.end(),
                                   [&](const auto& car) { return car.rides == name; });
    if (!rides) continue;
    const auto& nodes = model.reevings[i].nodes;
    for (const HeldTension& held : held_tensions(rope)) {
      const machine::Node& end = held.at_end ? nodes.back() : nodes.front();
      if (can_hold(machine, model, end)) continue;
      all.push_back(fmt::format(
          "tension_at_{0} of '{1}': the tension at '{2}' is held at {3} in every state at rest, and no drum or take-up "
          "is there; for a line with fixed ends give install: {{tension: {3}, at: {0}}}",
          end_name(held.at_end), name, end.name, display.quantity(held.tension, si::N)));
    }
  }
  return all;
}

}  // namespace taut::results
