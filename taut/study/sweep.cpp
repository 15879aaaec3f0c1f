#include "taut/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/parameter.hpp"
#include "taut/study/deck/temperature.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/put_up.hpp"
#include "taut/units/display.hpp"

namespace taut::study {
namespace {

/// Guys put up once keep their lengths while loads, ropes' lengths and the temperature change; where the machine is
/// built otherwise they are put up anew.
bool changes_the_building(const Parameter& parameter) {
  const std::string below = below_machine(parameter.place);
  for (const char* kind : {"points", "sheaves", "supports", "guys", "ropes", "beams", "terrain", "gravity"}) {
    if (below.starts_with(kind)) return true;
  }
  if (!below.starts_with("bodies")) return false;
  // where a body stands, not what it weighs
  for (const char* place : {".at", ".turned", ".on"}) {
    const auto found = below.rfind(place);
    if (found == std::string::npos) continue;
    const std::string rest = below.substr(found + std::string(place).size());
    if (rest.empty() || rest.front() == '.' || rest.front() == '[') return true;
  }
  return false;
}

/// Whether the unloaded machine stays as it is: its screws too.
bool loads_alone(const Parameter& parameter) {
  const std::string below = below_machine(parameter.place);
  return below.starts_with("loads") || below.starts_with("rope_loads");
}

/// Whether checks see it in the states of the machine alone: its loads and temperature, the lengths and tensions of its
/// ropes. Anything else they may read from the machine itself.
bool is_in_states(const Parameter& parameter) {
  const std::string below = below_machine(parameter.place);
  for (const char* kind : {"loads", "rope_loads", "temperature"}) {
    if (below.starts_with(kind)) return true;
  }
  const auto given = {".length", ".tension_at_start", ".tension_at_end"};
  return below.starts_with("reevings") &&
         std::any_of(given.begin(), given.end(), [&](const char* field) { return below.ends_with(field); });
}

/// Whether it is the free length of a rope, of which the rest is on its drum.
bool hauls(const Parameter& parameter) {
  const std::string below = below_machine(parameter.place);
  return below.starts_with("reevings") && below.ends_with(".length");
}

/// Ropes on drums are as long, with what is on the drums, as those of the machine that is described.
void keep_wholes(const machine::Model& described, machine::Model& model) {
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    model.reevings[i].described_length = described.reevings[i].described_length;
  }
}

/// With the carriage in its span.
machine::Model placed(const machine::Model& model, const SweepRun& run) {
  if (!run.prescribed) return machine::with_guides_at_start(model);
  return machine::with_carriage_at(model, run.prescribed->carriage, run.prescribed->x, run.prescribed->along);
}

tl::expected<Parameter, Outcome> put_into(machine::Machine& machine, const SweepRun& run, double value) {
  auto parameter = find_parameter(machine::Machine::describe(), &machine, run.parameter);
  if (!parameter) return tl::unexpected(infeasible(parameter.error()));
  if (Outcome outcome = put(*parameter, value); !outcome.ok()) return tl::unexpected(std::move(outcome));
  return *std::move(parameter);
}

/// Guys and lines at a value of the sweep: put up anew where it changes what they are built on, else as `installed`.
Outcome put_up_at(const Parameter& parameter, const machine::Machine& machine, const machine::Model& installed,
                  machine::Model& model) {
  if (!changes_the_building(parameter)) {
    keep_guys(machine, installed, model);
  } else if (Outcome outcome = install_guys(model); !outcome.ok()) {
    return outcome;
  }
  if (!puts_up_anew(parameter)) {
    keep_lines(installed, model);
    return {};
  }
  std::vector<PutUpLine> lines;
  return put_up_lines(model, lines);
}

/// The same on the machine on which they are put up.
Outcome put_up_on_other(const SweepRun& run, double value, const Parameter& parameter, const machine::Model& installed,
                        machine::Model& model) {
  const auto on = put_up_on_at(run, value);
  if (!on) return on.error();
  auto built = machine::compile(**on, machine::ModelFor::rest);
  if (!built) return infeasible(built.error().front().message);
  if (Outcome outcome = put_up_at(parameter, **on, installed, *built); !outcome.ok()) return outcome;
  keep_guys(**on, *built, model);
  keep_lines(*built, model);
  return {};
}

tl::expected<machine::Model, Outcome> model_at(const SweepRun& run, const machine::Model& installed, double value) {
  if (below_machine(run.parameter) == "temperature") {
    machine::Model warm = installed;
    set_temperature(warm, *run.machine, value);
    return warm;
  }
  machine::Machine machine = *run.machine;
  const auto parameter = put_into(machine, run, value);
  if (!parameter) return tl::unexpected(parameter.error());
  auto model = machine::compile(machine, machine::ModelFor::rest);
  if (!model) return tl::unexpected(infeasible(model.error().front().message));
  Outcome outcome = run.put_up_on ? put_up_on_other(run, value, *parameter, installed, *model)
                                  : put_up_at(*parameter, machine, installed, *model);
  if (!outcome.ok()) return tl::unexpected(std::move(outcome));
  if (hauls(*parameter)) keep_wholes(installed, *model);
  if (loads_alone(*parameter)) {
    keep_screws(installed, *model);
  } else {
    outcome = set_screws_as_on(run.put_up_on ? *run.put_up_on : machine, machine, *model);
    if (!outcome.ok()) return tl::unexpected(std::move(outcome));
  }
  return placed(*model, run);
}

void resolve_values(const SweepRequest& request, const std::string& path, Names& p, SweepRun& run) {
  machine::Machine machine = p.machine;
  const auto parameter = find_parameter(machine::Machine::describe(), &machine, request.parameter);
  if (!parameter) {
    p.complaints.push_back({path + ".parameter", parameter.error()});
    return;
  }
  if (const std::string below = below_machine(parameter->place); below.starts_with("loads[")) {
    const int body = p.model.loads.at(std::stoul(below.substr(6))).at.body;
    if (body != machine::ground && machine::stands_fast(p.model.bodies[body])) {
      p.complaints.push_back(
          {path + ".parameter", fmt::format("'{}' cannot move: no rope feels a load on it; say what is "
                                            "'free' of it",
                                            p.model.bodies[body].name)});
    }
  }
  run.unit = parameter->unit;
  run.judged_apart = !is_in_states(*parameter);
  if (std::isnan(parameter->value) && !request.heats()) {
    p.complaints.push_back({path + ".parameter", fmt::format("'{}' has no value in the deck that could change: write "
                                                             "one there",
                                                             request.parameter)});
  }
  const auto from = value_of(request.from, *parameter, path + ".from", p.complaints);
  const auto to = value_of(request.to, *parameter, path + ".to", p.complaints);
  if (!from || !to) return;
  run.from = *from;
  run.to = *to;
  if (run.from == run.to) p.complaints.push_back({path + ".to", "is the same value as 'from'"});
  if (request.heats()) {
    require_references(p.machine, path + ".parameter", p.complaints);
  }
}

}  // namespace

bool SweepRequest::heats() const { return below_machine(parameter) == "temperature"; }

bool puts_up_anew(const Parameter& parameter) {
  const std::string below = below_machine(parameter.place);
  if (changes_the_building(parameter) || below.find(".install") != std::string::npos) return true;
  const auto kinds = {"loads", "rope_loads", "temperature", "reevings", "analyses"};
  return std::none_of(kinds.begin(), kinds.end(), [&](const char* kind) { return below.starts_with(kind); });
}

const Description& SweepRequest::describe() {
  static const Description d =
      Describe<SweepRequest>()
          .field(&SweepRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&SweepRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&SweepRequest::parameter, "parameter",
                 "a number of the machine by its path in the deck: 'loads[0].mass', 'reevings.skyline.length', "
                 "'temperature', 'points.head[2]', 'loads[0].force.angle'")
          .required()
          .field(&SweepRequest::from, "from", "first value, with the unit of the parameter")
          .required()
          .field(&SweepRequest::to, "to", "last value")
          .required()
          .field(&SweepRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .named_records(&SweepRequest::motion, "motion", "as for an equilibrium")
          .shorthand("sense")
          .one_for_all()
          .field(&SweepRequest::carriage, "carriage", "the carriage that is placed at x")
          .field(&SweepRequest::x, "x", "x", si::m, "its place")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&SweepRequest::along, "along", "", si::one, "as for an equilibrium")
          .field(&SweepRequest::held, "held", "as for an equilibrium");
  return d;
}

tl::expected<machine::Machine, Outcome> machine_at(const SweepRun& run, double value) {
  machine::Machine machine = *run.machine;
  if (auto parameter = put_into(machine, run, value); !parameter) return tl::unexpected(parameter.error());
  return machine;
}

tl::expected<std::shared_ptr<const machine::Machine>, Outcome> put_up_on_at(const SweepRun& run, double value) {
  if (!run.put_up_on) return run.put_up_on;
  machine::Machine machine = *run.put_up_on;
  const auto parameter = put_into(machine, run, value);
  if (!parameter) return tl::unexpected(parameter.error());
  if (!puts_up_anew(*parameter)) return run.put_up_on;
  return std::make_shared<const machine::Machine>(std::move(machine));
}

EquilibriumRun state_at(const SweepRun& run, const solve::SweepPoint& point) {
  EquilibriumRun state;
  state.kind = "sweep";
  state.ending = run.ending;
  state.words = fmt::format("{} = {}, {}", run.parameter, Display().quantity(point.value, run.unit), run.words);
  state.motion = run.motion;
  state.prescribed = run.prescribed;
  state.held = run.held;
  state.near = point.at.state;
  return state;
}

SweepRun resolve(const SweepRequest& request, const std::string& path, Names& names) {
  SweepRun run;
  run.ending = ending_of(names, "sweep", request.name, path);
  run.motion = rope_motion(request.motion, names.model, path + ".motion", names.complaints);
  run.words = run.motion.words;
  run.parameter = request.parameter;
  run.steps = request.steps;
  run.held = request.held;
  run.machine = &names.machine;
  resolve_values(request, path, names, run);
  run.prescribed = prescribed_of(request.carriage, request.x, request.along, path, names);
  return run;
}

void solve(const machine::Model& model, SweepRun& run, Watch& watch) {
  const machine::Model base = placed(model, run);
  solve::SweepOptions options;
  options.from = run.from;
  options.to = run.to;
  options.steps = run.steps;
  options.equilibrium = run.motion.options(base);
  options.equilibrium.prescribed = run.prescribed;
  options.equilibrium.held = run.held;
  options.go_on = [&](double value) {
    return watch.go_on(fmt::format("{} = {}", run.parameter, Display().quantity(value, run.unit)));
  };
  run.answer = solve::sweep([&](double value) { return model_at(run, base, value); }, options);
}

}  // namespace taut::study
