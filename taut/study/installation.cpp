#include "taut/study/installation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/math/index.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::study {
namespace {

bool is_on(const machine::Node& node, const Array<bool>& bodies) {
  return node.at.body != machine::ground && bodies[node.at.body];
}

bool touches(const machine::Reeving& rope, const Array<bool>& bodies) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& n) { return is_on(n, bodies); });
}

/// Whether a node of a rope is the wheel or the clamp of a carriage that rides on it: without the carriage the rope is
/// empty there.
bool is_riding(const machine::Model& model, std::size_t reeving, const machine::Node& node) {
  if (node.kind != machine::NodeKind::contact && node.kind != machine::NodeKind::clamp) return false;
  return std::any_of(model.carriages.begin(), model.carriages.end(), [&](const machine::Carriage& car) {
    return as_size(car.reeving) == reeving && car.body == node.at.body;
  });
}

/// Whether a rope ends on what is gone, or runs over it, and does not only lose a carriage that rides on it.
bool goes_with(const machine::Model& model, std::size_t reeving, const Array<bool>& gone) {
  const auto& nodes = model.reevings[reeving].nodes;
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](const machine::Node& n) { return is_on(n, gone) && !is_riding(model, reeving, n); });
}

bool holds(const machine::Reeving& rope, int body) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& n) { return n.at.body == body; });
}

bool is_in(const Array<int>& all, std::size_t index) {
  return std::find(all.begin(), all.end(), static_cast<int>(index)) != all.end();
}

/// A body that ropes held and none holds any more.
bool has_lost_its_ropes(const machine::Model& model, int body, const Array<bool>& ropes_gone) {
  bool had = false;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    if (!holds(model.reevings[r], body)) continue;
    if (!ropes_gone[r]) return false;
    had = true;
  }
  return had;
}

/// A carriage that rolls on a rope, and of which every other rope is gone: nothing holds it along the line.
bool has_lost_its_pull(const machine::Model& model, int body, const Array<bool>& ropes_gone) {
  for (const machine::Carriage& car : model.carriages) {
    const machine::Reeving& line = model.reevings[car.reeving];
    if (car.body != body || line.nodes[as_size(car.node)].kind != machine::NodeKind::contact) continue;
    bool had = false;
    for (std::size_t r = 0; r < model.reevings.size(); ++r) {
      if (static_cast<int>(r) == car.reeving || !holds(model.reevings[r], body)) continue;
      if (!ropes_gone[r]) return false;
      had = true;
    }
    if (had) return true;
  }
  return false;
}

/// Which bodies and ropes go, until nothing more does. `gone` bodies and ropes are given; those in `with` stay.
void spread(const machine::Model& model, int kept, const PutUpWith& with, Array<bool>& gone, Array<bool>& ropes_gone) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t r = 0; r < model.reevings.size(); ++r) {
      if (static_cast<int>(r) == kept || ropes_gone[r] || !goes_with(model, r, gone)) continue;
      changed = ropes_gone[r] = true;
    }
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (gone[b] || model.bodies[b].free.empty() || is_in(with.bodies, b)) continue;
      if (model.bodies[b].beam) continue;  // its beam holds a section
      const int body = static_cast<int>(b);
      if (has_lost_its_ropes(model, body, ropes_gone) || has_lost_its_pull(model, body, ropes_gone))
        changed = gone[b] = true;
    }
  }
}

/// Loads on what is still there; of those on a body that stays on the rope the ones that are named.
Array<machine::Load> loads_left(const machine::Model& model, const PutUpWith& with, const Array<bool>& gone) {
  Array<machine::Load> all;
  for (std::size_t i = 0; i < model.loads.size(); ++i) {
    const int body = model.loads[i].at.body;
    const bool off =
        body != machine::ground && (gone[body] || (is_in(with.bodies, as_size(body)) && !is_in(with.loads, i)));
    if (!off) all.push_back(model.loads[i]);
  }
  return all;
}

/// The stretched length of what lies on the contacts of a rope: R theta.
double on_contacts(const machine::Model& model, const solve::EquilibriumResult& r, int reeving) {
  double length = 0;
  for (const solve::ContactResult& c : r.contacts) {
    if (c.reeving == reeving) length += model.reevings[reeving].nodes[c.node].radius * c.wrap;
  }
  return length;
}

/// Leaves the carriages that are still there, with their ropes and nodes by the numbers that these will have.
template <class Taken>
void keep_carriages(machine::Model& model, const Array<bool>& gone, const Array<bool>& ropes_gone, const Taken& taken) {
  const auto rope = [&](int r) {
    return ropes_gone[r]
               ? std::nullopt
               : std::optional(static_cast<int>(std::count(ropes_gone.begin(), ropes_gone.begin() + r, false)));
  };
  const auto node = [&](int r, int k) {
    const auto& nodes = model.reevings[r].nodes;
    return k - static_cast<int>(std::count_if(nodes.begin(), nodes.begin() + k,
                                              [&](const machine::Node& n) { return taken(as_size(r), n); }));
  };
  std::erase_if(model.carriages,
                [&](const machine::Carriage& car) { return gone[car.body] || ropes_gone[car.reeving]; });
  for (machine::Carriage& car : model.carriages) {
    car.node = node(car.reeving, car.node);
    car.reeving = *rope(car.reeving);
    for (std::optional<int>* r : {&car.mainline, &car.haulback}) {
      if (*r) *r = rope(**r);
    }
    const auto running = car.grip ? rope(car.grip->reeving) : std::nullopt;
    if (running) {
      car.grip = machine::Grip{.reeving = *running, .node = node(car.grip->reeving, car.grip->node)};
    } else {
      car.grip.reset();
    }
  }
}

using Kind = solve::Condition::Kind;

/// What the machine itself has given of the rope.
solve::Condition own_condition(const machine::Reeving& rope) {
  switch (rope.given) {
    case machine::Given::tension_at_start:
      return {.kind = Kind::tension_at_start, .reeving = 0, .value = rope.value, .span = 0};
    case machine::Given::tension_at_end:
      return {.kind = Kind::tension_at_end, .reeving = 0, .value = rope.value, .span = 0};
    case machine::Given::length:
    case machine::Given::torque:
    case machine::Given::equal:
      break;
  }
  return {.kind = Kind::length, .reeving = 0, .value = rope.value, .span = 0};
}

solve::Condition condition_of(const InstallationRun& run, const EmptyLine& line) {
  if (!run.given) return own_condition(line.model.reevings[line.reeving]);
  const InstallationGivenRequest& g = *run.given;
  if (g.tension)
    return {.kind = g.at == RopeEnd::end ? Kind::tension_at_end : Kind::tension_at_start,
            .reeving = 0,
            .value = *g.tension,
            .span = 0};
  if (g.length) return {.kind = Kind::length, .reeving = 0, .value = *g.length, .span = 0};
  return {.kind = Kind::sag_of_span,
          .reeving = 0,
          .value = *g.sag,
          .span = g.span ? *g.span - 1 : longest_span(line.model, line.reeving)};
}

void resolve_temperatures(const InstallationRequest& request, const std::string& path, Names& p, InstallationRun& run) {
  run.temperatures = request.temperatures;
  if (request.from.has_value() != request.to.has_value() || (request.steps && !request.from)) {
    p.complaints.push_back({path, "'from' and 'to' belong together, with or without 'steps'"});
  } else if (request.from && !request.temperatures.empty()) {
    p.complaints.push_back({path + ".from", "give either 'temperatures' or 'from' and 'to'"});
  } else if (request.from) {
    const int steps = request.steps.value_or(10);
    for (int i = 0; i <= steps; ++i) {
      run.temperatures.push_back(step_between(*request.from, *request.to, i, steps));
    }
  }
  const std::string key = request.from ? ".from" : ".temperatures";
  if (!run.temperatures.empty()) require_references(p.machine, path + key, p.complaints);
  if (request.given && request.given->temperature) {
    require_references(p.machine, path + ".given.temperature", p.complaints);
  }
}

/// `model`: with its guides at the start.
EmptyLine emptied(const machine::Model& model, int reeving, const PutUpWith& with) {
  expects(reeving >= 0 && as_size(reeving) < model.reevings.size(), "a rope of the model");
  EmptyLine line;
  Array<bool> gone(model.bodies.size(), false), ropes_gone(model.reevings.size(), false);
  for (const machine::Carriage& car : model.carriages) {
    if (car.reeving == reeving && !is_in(with.bodies, as_size(car.body))) gone[car.body] = true;
  }
  for (const int rope : with.absent) ropes_gone[rope] = true;
  spread(model, reeving, with, gone, ropes_gone);
  line.model = model;
  machine::Reeving& own = line.model.reevings[reeving];
  const auto taken = [&](std::size_t r, const machine::Node& n) {
    const bool empties = static_cast<int>(r) == reeving ? n.kind != machine::NodeKind::anchor : is_riding(model, r, n);
    return empties && is_on(n, gone);
  };
  keep_carriages(line.model, gone, ropes_gone, taken);
  for (std::size_t r = 0; r < line.model.reevings.size(); ++r) {
    std::erase_if(line.model.reevings[r].nodes, [&](const machine::Node& n) { return taken(r, n); });
  }
  const bool loses_drive = own.closed && (own.nodes.empty() || own.nodes.front().kind != machine::NodeKind::drive);
  if (touches(own, gone) || own.nodes.size() < 2 || loses_drive) {
    line.outcome = infeasible(fmt::format("'{}' ends on what rides on it: it is never empty", own.name));
    return line;
  }
  for (std::size_t b = 0; b < gone.size(); ++b) {
    if (!gone[b]) continue;
    line.removed.push_back(model.bodies[b].name);
    line.model.bodies[b].free.clear();
    line.model.bodies[b].mass = 0;
  }
  line.model.loads = loads_left(model, with, gone);
  Array<machine::Reeving> kept;
  for (std::size_t r = 0; r < ropes_gone.size(); ++r) {
    if (static_cast<int>(r) == reeving) line.reeving = static_cast<int>(kept.size());
    if (ropes_gone[r]) {
      line.removed.push_back(model.reevings[r].name);
    } else {
      kept.push_back(line.model.reevings[r]);
    }
  }
  line.model.reevings = std::move(kept);
  return line;
}

}  // namespace

EmptyLine empty_line(const machine::Model& model, int reeving, const PutUpWith& with) {
  return emptied(machine::with_guides_at_start(model), reeving, with);
}

RopeLengths lengths_of(const machine::Model& model, const solve::EquilibriumResult& r, int reeving) {
  RopeLengths all;
  all.unstretched = r.ropes[reeving].unstretched;
  all.cut = all.unstretched * (1 + model.reevings[reeving].thermal_strain);
  for (const solve::BranchResult& s : r.branches) {
    if (s.reeving == reeving) all.free += s.stretched;
  }
  all.on_sheaves = on_contacts(model, r, reeving);
  all.stretched = all.free + all.on_sheaves;
  return all;
}

Installation installation(const EmptyLine& line, const solve::Condition& given,
                          const std::optional<machine::State>& near) {
  Installation i;
  i.outcome = line.outcome;
  if (!i.outcome.ok()) return i;
  solve::Condition condition = given;
  condition.reeving = line.reeving;
  i.at = solve::equilibrium_under(line.model, condition, {}, near);
  const solve::EquilibriumResult& r = i.at.result;
  i.outcome = r.outcome;
  if (!i.outcome.ok()) return i;
  const solve::BranchResult* last = nullptr;
  for (const solve::BranchResult& s : r.branches) {
    if (s.reeving != line.reeving) continue;
    if (last == nullptr) {
      i.T_start = s.T_from;
      i.H = s.H;
    }
    i.sag.push_back(solve::sag_at_middle(s));
    last = &s;
  }
  i.T_end = last->T_to;
  const RopeLengths lengths = lengths_of(i.at.model, r, line.reeving);
  i.unstretched = lengths.unstretched;
  i.cut = lengths.cut;
  i.stretched = lengths.stretched;
  return i;
}

const Description& InstallationGivenRequest::describe() {
  static const Description d =
      Describe<InstallationGivenRequest>()
          .field(&InstallationGivenRequest::tension, "tension", "T", si::N, "tension of the empty rope at one end")
          .above(0)
          .at_most(strongest)
          .field(&InstallationGivenRequest::length, "length", "L", si::m,
                 "unstretched length at the reference temperature")
          .above(0)
          .at_most(farthest)
          .field(&InstallationGivenRequest::sag, "sag", "f", si::m,
                 "sag of a free span below its chord, at half its horizontal length")
          .above(0)
          .at_most(farthest)
          .choice(&InstallationGivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "end of the path with this tension")
          .field(&InstallationGivenRequest::span, "span", "", si::one,
                 "number of the free span with the sag, from 1; default: the longest")
          .at_least(1)
          .field(&InstallationGivenRequest::temperature, "temperature", "", si::K.in("degC"),
                 "temperature at which it holds; the length found there is kept at the others. Default: it holds at "
                 "each temperature, and the length follows")
          .above(0)
          .at_most(2000)
          .exactly_one({"tension", "length", "sag"});
  return d;
}

const Description& InstallationRequest::describe() {
  static const Description d =
      Describe<InstallationRequest>()
          .field(&InstallationRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&InstallationRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&InstallationRequest::reeving, "reeving",
                 "the rope that is put up empty, without its carriages and what hangs on them")
          .required()
          .field(&InstallationRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "temperatures, such as 15 degC; default: that of the machine")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::from, "from", "", si::K.in("degC"), "first temperature, in place of a list")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::to, "to", "", si::K.in("degC"), "last temperature")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::steps, "steps", "n", si::one, "equal steps between them; default: 10")
          .at_least(1)
          .at_most(10000)
          .record(&InstallationRequest::given, "given", "tension, length or sag; default: what the reeving gives");
  return d;
}

InstallationRun resolve(const InstallationRequest& request, const std::string& path, Names& names) {
  InstallationRun run;
  run.ending = ending_of(names, "installation", request.name, path);
  run.words = request.reeving;
  const auto reeving = reeving_of(names, request.reeving, path + ".reeving");
  run.reeving = reeving.value_or(0);
  run.given = request.given;
  run.machine = &names.machine;
  resolve_temperatures(request, path, names, run);
  if (!reeving) return run;
  const EmptyLine line = empty_line(names.model, run.reeving);
  if (!line.outcome.ok()) names.complaints.push_back({path + ".reeving", line.outcome.message});
  if (names.model.reevings[run.reeving].closed && request.given && !request.given->length) {
    names.complaints.push_back({path + ".given", "an endless rope is given by its 'length'"});
  }
  if (names.model.reevings[run.reeving].given == machine::Given::torque && !request.given) {
    names.complaints.push_back({path, "the rope is given by a torque: say what is given when it is put up"});
  }
  if (request.given && request.given->span) {
    const auto spans = line.model.reevings[line.reeving].nodes.size() - 1;
    if (!request.given->sag) names.complaints.push_back({path + ".given.span", "belongs to a 'sag'"});
    if (line.outcome.ok() && static_cast<std::size_t>(*request.given->span) > spans) {
      names.complaints.push_back({path + ".given.span", fmt::format("the empty rope has {} free spans", spans)});
    }
  }
  return run;
}

void solve(const machine::Model& model, InstallationRun& run) {
  const auto line_at = [&](double temperature) {
    machine::Model warm = model;
    if (!std::isnan(temperature)) set_temperature(warm, *run.machine, temperature);
    return empty_line(warm, run.reeving);
  };
  std::vector<double> temperatures = run.temperatures;
  if (temperatures.empty()) temperatures.push_back(run.machine->temperature.value_or(none));
  EmptyLine first = line_at(temperatures.front());
  if (!first.outcome.ok()) {
    run.rows.emplace_back().at.outcome = first.outcome;
    return;
  }
  solve::Condition condition = condition_of(run, first);
  std::optional<machine::State> near;
  if (run.given && run.given->temperature) {
    const auto there = installation(line_at(*run.given->temperature), condition);
    if (!there.outcome.ok()) {
      run.rows.push_back({*run.given->temperature, there});
      return;
    }
    condition = {.kind = Kind::length, .reeving = 0, .value = there.unstretched, .span = 0};
    near = there.at.result.state;
  }
  for (const double temperature : temperatures) {
    InstallationAt& row = run.rows.emplace_back();
    row.temperature = temperature;
    row.at = installation(line_at(temperature), condition, near);
    if (row.at.outcome.ok()) near = row.at.at.result.state;
  }
}

const Quantities<InstallationAt>& installation_quantities() {
  using Row = InstallationAt;
  const auto known = [](double Installation::*of) {
    return [of](const Row& r) { return r.at.outcome.ok() ? r.at.*of : none; };
  };
  static const Quantities<Row> all = {
      {"temperature", "", si::K.in("degC"), "of all ropes", &Row::temperature},
      {"T_start", "T_start", si::N, "tension at its start", known(&Installation::T_start)},
      {"T_end", "T_end", si::N, "tension at its end", known(&Installation::T_end)},
      {"H", "H", si::N, "horizontal part in the first span", known(&Installation::H)},
      {"unstretched", "L", si::m, "unstretched length at the reference temperature", known(&Installation::unstretched)},
      {"installed", "", si::m, "the same at this temperature: as cut", known(&Installation::cut)},
      {"stretched", "l", si::m, "length under its tension", known(&Installation::stretched)}};
  return all;
}

const Quantities<RopeLengths>& length_quantities() {
  static const Quantities<RopeLengths> all = {
      {"unstretched", "L", si::m, "unstretched length at the reference temperature", &RopeLengths::unstretched},
      {"installed", "", si::m, "the same at this temperature: as cut", &RopeLengths::cut},
      {"stretched", "l", si::m, "length under its tension", &RopeLengths::stretched},
      {"free", "", si::m, "part of it between sheaves", &RopeLengths::free},
      {"on_sheaves", "", si::m, "part of it on sheaves, saddles and drives", &RopeLengths::on_sheaves}};
  return all;
}

}  // namespace taut::study
