#include "taut/study/put_up.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/math/index.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::study {
namespace {

PutUpWith with_of(const machine::Model& model, std::size_t reeving) {
  const machine::PutUp& asked = *model.reevings[reeving].put_up;
  PutUpWith with{.bodies = asked.bodies, .loads = asked.loads, .absent = {}};
  for (std::size_t later = 0; later < model.reevings.size(); ++later) {
    const machine::Reeving& rope = model.reevings[later];
    const bool to_come = (rope.put_up && later > reeving) || rope.given == machine::Given::equal;
    if (to_come) with.absent.push_back(static_cast<int>(later));
  }
  return with;
}

}  // namespace

Array<PutUpLine> put_up(machine::Model& model) {
  Array<PutUpLine> all;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    machine::Reeving& rope = model.reevings[r];
    if (!rope.put_up) continue;
    PutUpLine& one = all.emplace_back();
    one.reeving = static_cast<int>(r);
    one.tension = rope.put_up->tension;
    one.at_end = rope.put_up->at_end;
    one.line = empty_line(model, one.reeving, with_of(model, r));
    const auto kind = one.at_end ? solve::Condition::Kind::tension_at_end : solve::Condition::Kind::tension_at_start;
    one.at = installation(one.line, {.kind = kind, .reeving = 0, .value = one.tension, .span = 0});
    if (!one.at.outcome.ok()) {
      one.at.outcome.message = fmt::format("'{}' can't be put up with {:.4g} kN at its {}: {}", rope.name,
                                           one.tension / 1000, one.at_end ? "end" : "start", one.at.outcome.message);
      return all;
    }
    rope.given = machine::Given::length;
    rope.value = one.at.unstretched;
    rope.described_length = rope.value;
  }
  return all;
}

Outcome draw_equal(machine::Model& model) {
  const auto is_equal = [](const machine::Reeving& rope) { return rope.given == machine::Given::equal; };
  if (std::none_of(model.reevings.begin(), model.reevings.end(), is_equal)) return {};
  solve::EquilibriumOptions options;
  options.band = options.beam_factors = false;
  options.lengths_kept = true;
  const solve::EquilibriumResult found = solve::equilibrium(model, options);
  const auto refused = [&](const std::string& why) {
    return Outcome{.status = found.outcome.ok() ? Status::infeasible : found.outcome.status,
                   .message = "the ropes with 'tension_equals' can't be drawn to equal tensions: " + why};
  };
  if (!found.outcome.ok()) return refused(found.outcome.message);
  for (const machine::Reeving& rope : model.reevings) {
    if (is_equal(rope) && !(found.ropes[as_size(rope.equal_to)].T_max > 0)) {
      return refused(fmt::format("'{}' is slack", model.reevings[as_size(rope.equal_to)].name));
    }
  }
  const machine::Model drawn = solve::installed(model, found);
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    machine::Reeving& rope = model.reevings[r];
    if (!is_equal(rope)) continue;
    rope.given = machine::Given::length;
    rope.value = drawn.reevings[r].value;
    rope.described_length = rope.value;
  }
  return {};
}

namespace {

bool is_fed(const machine::Reeving& rope) {
  return rope.given == machine::Given::tension_at_start || rope.given == machine::Given::tension_at_end;
}

/// How long the ropes of given tension are beside what is on their drums. Where the machine as described has no
/// equilibrium, that is not known.
void measure_fed_ropes(machine::Model& model) {
  const auto asked = [&](const machine::Reeving& rope) {
    const auto holds = [&](const machine::Node& end) {
      return end.drum && model.drums[*end.drum].length_on_drum.has_value();
    };
    return is_fed(rope) && !rope.closed && (holds(rope.nodes.front()) || holds(rope.nodes.back()));
  };
  if (std::none_of(model.reevings.begin(), model.reevings.end(), asked)) return;
  solve::EquilibriumOptions options;
  options.band = options.beam_factors = false;
  const solve::EquilibriumResult found = solve::equilibrium(model, options);
  if (!found.outcome.ok()) return;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    if (asked(model.reevings[r])) model.reevings[r].described_length = found.ropes[r].unstretched;
  }
}

}  // namespace

Outcome put_up_lines(machine::Model& model, std::vector<PutUpLine>& lines) {
  lines = put_up(model);
  if (!lines.empty() && !lines.back().at.outcome.ok()) return lines.back().at.outcome;
  if (Outcome outcome = draw_equal(model); !outcome.ok()) return outcome;
  measure_fed_ropes(model);
  return {};
}

machine::Model without_loads(const machine::Model& model) {
  machine::Model bare = model;
  for (machine::Load& load : bare.loads) {
    if (!load.tightens) load.force = Vector3::Zero();
  }
  for (machine::Reeving& rope : bare.reevings) {
    rope.speed = 0;
    for (machine::Node& node : rope.nodes) {
      node.load.force = node.load.rate = 0;
      node.load.open = false;
      node.tension_drop.reset();
    }
  }
  return bare;
}

Outcome set_screws(machine::Model& model, std::vector<PutUpMoment>* moments) {
  if (model.screws.empty()) return {};
  const machine::Model bare = without_loads(model);
  const auto refused = [&](Status status, const std::string& why) {
    return Outcome{.status = status,
                   .message = fmt::format("the screw of '{}' can't be set in the machine without its loads: {}",
                                          model.bodies[model.screws.front().body].name, why)};
  };
  for (const machine::Reeving& rope : bare.reevings) {
    if (rope.given == machine::Given::torque) {
      return refused(Status::infeasible, fmt::format("'{}' needs its 'length'", rope.name));
    }
  }
  solve::EquilibriumOptions options;
  options.band = false;
  options.beam_factors = moments != nullptr;
  const solve::EquilibriumResult found = solve::equilibrium(machine::with_guides_at_start(bare), options);
  if (!found.outcome.ok()) return refused(found.outcome.status, found.outcome.message);
  if (moments != nullptr) moments->push_back({.model = bare, .state = found, .words = "as its screws are set"});
  for (const machine::Screw& screw : model.screws) {
    machine::Body& body = model.bodies[screw.body];
    body.position = found.state.bodies[screw.body].position;
    body.orientation = found.state.bodies[screw.body].orientation;
    body.free.clear();
    model.loads[screw.load].force = Vector3::Zero();
  }
  return {};
}

Outcome set_screws_as_on(const machine::Machine& on, const machine::Machine& own, machine::Model& model,
                         std::vector<PutUpMoment>* moments) {
  if (model.screws.empty()) return {};
  machine::Model set = model;
  if (&on != &own && on.temperature) set_temperature(set, own, *on.temperature);
  if (Outcome outcome = set_screws(set, moments); !outcome.ok()) return outcome;
  keep_screws(set, model);
  return {};
}

Outcome install_guys(machine::Model& model, std::vector<PutUpMoment>* moments) {
  machine::Model bare;
  bare.gravity = model.gravity;
  bare.bodies = model.bodies;
  for (machine::Body& body : bare.bodies) body.free.clear();
  for (const machine::Reeving& rope : model.reevings) {
    if (!rope.is_to_install) continue;
    bare.reevings.push_back(rope);
    bare.reevings.back().is_to_install = false;
  }
  if (bare.reevings.empty()) return {};
  solve::EquilibriumOptions options;
  options.band = false;
  const auto result = solve::equilibrium(bare, options);
  if (!result.outcome.ok()) {
    return {.status = result.outcome.status,
            .message = fmt::format("the guys can't be put up: {}", result.outcome.message)};
  }
  if (moments != nullptr) moments->push_back({.model = bare, .state = result, .words = "as the guys are put up"});
  const machine::Model done = solve::installed(bare, result);
  auto next = done.reevings.begin();
  for (machine::Reeving& rope : model.reevings) {
    if (rope.is_to_install) rope = *next++;
  }
  return {};
}

namespace {

constexpr double fallen = std::numbers::pi / 3;  ///< rad: what is turned by more does not stand any more

bool has_fallen(const machine::Model& model, const machine::State& state) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Matrix3 turned = state.bodies[b].orientation * model.bodies[b].orientation.transpose();
    if (turned.trace() < 1 + 2 * std::cos(fallen)) return true;
  }
  return false;
}

/// The body or beam that holds a place, numbered together; empty on what stands fast.
std::optional<std::size_t> mast_at(const machine::Model& model, const machine::Place& place) {
  if (place.body == machine::ground || machine::stands_fast(model.bodies[place.body])) return std::nullopt;
  const std::optional<int>& beam = model.bodies[place.body].beam;
  return beam ? model.bodies.size() + as_size(*beam) : as_size(place.body);
}

Vector3 place_as_described(const machine::Model& model, const machine::Place& place) {
  if (place.body == machine::ground) return place.at;
  const machine::Body& body = model.bodies[place.body];
  return body.position + body.orientation * place.at;
}

/// Directions in plan in which guys pull at a mast, rad, in order.
std::vector<double> azimuths_at(const machine::Model& model, std::size_t first_guy, std::size_t mast) {
  std::vector<double> all;
  for (std::size_t r = first_guy; r < model.reevings.size(); ++r) {
    const machine::Place &start = model.reevings[r].nodes.front().at, &end = model.reevings[r].nodes.back().at;
    const Vector3 way = place_as_described(model, end) - place_as_described(model, start);
    if (mast_at(model, start) == mast) all.push_back(std::atan2(way.y(), way.x()));
    if (mast_at(model, end) == mast) all.push_back(std::atan2(-way.y(), -way.x()));
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Whether directions in order leave no half of the plan free.
bool go_around(const std::vector<double>& azimuths) {
  constexpr double rounding = 1e-6;  // of guys that are exactly opposite
  double gap = azimuths.front() + 2 * std::numbers::pi - azimuths.back();
  for (std::size_t i = 1; i < azimuths.size(); ++i) gap = std::max(gap, azimuths[i] - azimuths[i - 1]);
  return gap <= std::numbers::pi + rounding;
}

}  // namespace

bool has_guys_around(const machine::Model& model, std::size_t first_guy, std::size_t guy) {
  const auto& nodes = model.reevings[guy].nodes;
  bool on_mast = false;
  for (const machine::Node* end : {&nodes.front(), &nodes.back()}) {
    const auto mast = mast_at(model, end->at);
    if (!mast) continue;
    if (!go_around(azimuths_at(model, first_guy, *mast))) return false;
    on_mast = true;
  }
  return on_mast;
}

bool other_ropes_hold_beams(const machine::Model& model, std::size_t first_guy) {
  for (std::size_t r = 0; r < first_guy; ++r) {
    for (const machine::Node& node : model.reevings[r].nodes) {
      const auto mast = mast_at(model, node.at);
      if (mast && *mast >= model.bodies.size() && azimuths_at(model, first_guy, *mast).empty()) return true;
    }
  }
  return false;
}

std::optional<PutUpMoment> stand_on_guys(const machine::Model& model, std::size_t first_guy) {
  bool any = false;
  for (std::size_t r = first_guy; r < model.reevings.size() && !any; ++r) any = has_guys_around(model, first_guy, r);
  if (!any) return std::nullopt;
  PutUpWith alone;
  for (std::size_t r = 0; r < first_guy; ++r) alone.absent.push_back(static_cast<int>(r));
  EmptyLine line = empty_line(without_loads(model), static_cast<int>(first_guy), alone);
  // a guy on what hangs on another rope is not the mast's alone
  if (!line.outcome.ok() || line.model.reevings.size() != model.reevings.size() - first_guy) return std::nullopt;
  solve::EquilibriumOptions options;
  options.band = false;
  solve::EquilibriumResult found = solve::equilibrium(line.model, options);
  if (found.outcome.ok() && has_fallen(line.model, found.state)) {
    found.outcome = {.status = Status::infeasible, .message = "its guys do not hold it, it falls over"};
  }
  return PutUpMoment{.model = std::move(line.model),
                     .state = std::move(found),
                     .words = "as the machine stands on its guys alone, unloaded"};
}

void keep_guys(const machine::Machine& machine, const machine::Model& installed, machine::Model& model) {
  for (std::size_t i = machine.reevings.size(); i < model.reevings.size(); ++i) {
    model.reevings[i].given = installed.reevings[i].given;
    model.reevings[i].value = installed.reevings[i].value;
    model.reevings[i].is_to_install = installed.reevings[i].is_to_install;
  }
}

void keep_lines(const machine::Model& installed, machine::Model& model) {
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    machine::Reeving& rope = model.reevings[i];
    const bool is_put_up = rope.put_up || rope.given == machine::Given::equal;
    if (is_put_up || is_fed(rope)) rope.described_length = installed.reevings[i].described_length;
    if (!is_put_up) continue;
    rope.given = installed.reevings[i].given;
    rope.value = installed.reevings[i].value;
  }
}

void keep_screws(const machine::Model& installed, machine::Model& model) {
  for (std::size_t i = 0; i < model.screws.size(); ++i) {
    const machine::Body& set = installed.bodies[installed.screws[i].body];
    machine::Body& body = model.bodies[model.screws[i].body];
    body.position = set.position;
    body.orientation = set.orientation;
    body.free.clear();
    model.loads[model.screws[i].load].force = Vector3::Zero();
  }
}

std::string put_up_words(const machine::Model& model, const PutUpLine& line) {
  const machine::Reeving& rope = model.reevings[line.reeving];
  std::vector<std::string> with;
  for (const int body : rope.put_up->bodies) {
    const auto& loads = rope.put_up->loads;
    const bool loaded =
        std::any_of(loads.begin(), loads.end(), [&](int load) { return model.loads[as_size(load)].at.body == body; });
    with.push_back(model.bodies[body].name + (loaded ? " and its load" : ""));
  }
  return with.empty() ? fmt::format("{} as put up, empty", rope.name)
                      : fmt::format("{} as put up, with {}", rope.name, fmt::join(with, ", "));
}

const Quantities<PutUpRow>& put_up_quantities() {
  using Row = PutUpRow;
  const auto at = [](double Installation::*of) { return [of](const Row& r) { return r.line.at.*of; }; };
  static const Quantities<Row> all = {
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.line.reeving].name; }},
      {"state", "", si::one, "empty, or with what it is put up with",
       [](const Row& r) { return put_up_words(r.model, r.line); }},
      {"T_start", "T_start", si::N, "tension at its start", at(&Installation::T_start)},
      {"T_end", "T_end", si::N, "tension at its end", at(&Installation::T_end)},
      {"H", "H", si::N, "horizontal part in the first span", at(&Installation::H)},
      {"unstretched", "L", si::m, "unstretched length at the reference temperature", at(&Installation::unstretched)},
      {"installed", "", si::m, "the same at the temperature: as cut", at(&Installation::cut)},
      {"stretched", "l", si::m, "length under its tension", at(&Installation::stretched)}};
  return all;
}

}  // namespace taut::study
