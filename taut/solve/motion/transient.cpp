#include "taut/solve/motion/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/middle.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/motion/parts/damping.hpp"
#include "taut/solve/motion/run/memory.hpp"
#include "taut/solve/motion/run/run.hpp"
#include "taut/solve/motion/step/quasi_static.hpp"
#include "taut/solve/motion/step/reference.hpp"
#include "taut/solve/motion/step/stable.hpp"
#include "taut/solve/rest/sides.hpp"

namespace taut::solve {
namespace {

using namespace dynamics;

/// Inner nodes on the catenaries of the equilibrium.
void place_inside(const machine::Model& model, const EquilibriumResult& found, DynamicState& start) {
  Array<std::size_t> next(model.reevings.size(), 0);
  for (const BranchResult& branch : found.branches) {
    const auto r = static_cast<std::size_t>(branch.reeving);
    const int segments = model.reevings[r].segments;
    for (int s = 1; s < segments; ++s) {
      const double length = branch.unstretched * (1 + model.reevings[r].thermal_strain) * s / segments;
      start.ropes[r].inside[next[r]++] = model.reevings[r].weight > 0 && !branch.slack
                                             ? Vector3(branch.start + rope::point_at(branch.shape, length))
                                             : Vector3(branch.start + (branch.end - branch.start) * s / segments);
    }
    const auto to = static_cast<std::size_t>(branch.to);
    if (segments > 1 && model.reevings[r].nodes[to].kind == machine::NodeKind::load) {
      start.ropes[r].inside[next[r]++] = branch.end;
    }
  }
}

/// Loads over time as they begin; forces along ropes as they are at rest: friction is none, others as they begin.
machine::Model with_loads_at_rest(machine::Model model) {
  for (machine::Load& load : model.loads) {
    if (load.over_time) load.force = machine::at(*load.over_time, 0).value * load.force.normalized();
  }
  for (machine::Reeving& rope : model.reevings) {
    for (machine::Node& node : rope.nodes) {
      if (node.kind != machine::NodeKind::load) continue;
      if (node.load.signal)
        (node.load.part > 0 ? node.load.rate : node.load.force) = machine::at(*node.load.signal, 0).value;
      if (node.load.by_motion && node.load.sense < 0) node.load.force = node.load.rate = 0;
    }
  }
  return model;
}

/// The equilibrium of catenaries as a start; none where statics does not know one.
std::optional<DynamicState> near_equilibrium(const machine::Model& model) {
  const auto found = rest_before_motion(model);
  if (!found) return std::nullopt;
  machine::Model by_length = model;
  for (machine::Reeving& rope : by_length.reevings) rope.given = machine::Given::length;
  DynamicState start = state_from(by_length, found->state);
  place_inside(model, *found, start);
  return start;
}

Outcome settle(Run& run) {
  const StepEnd end = settle(run.m, run.before, run.now, run.w, run.newton);
  if (end == StepEnd::ok) return {};
  run.result.interrupted = end == StepEnd::interrupted;
  return not_converged(
      "the machine does not come to rest where it is described: with 'start: assembled' the motion begins there");
}

}  // namespace

std::optional<EquilibriumResult> rest_before_motion(const machine::Model& model) {
  if (!model.contacts.empty() || !model.actuators.empty()) return std::nullopt;
  EquilibriumOptions at_rest;
  at_rest.band = false;
  at_rest.lengths_kept = true;
  EquilibriumResult found = equilibrium(with_loads_at_rest(model), at_rest);
  if (!found.outcome.ok()) return std::nullopt;
  return found;
}

namespace {

/// Where the machine has come to rest, as the state of one that begins there: the masses that its ropes share out, what
/// lies on drums, the places of loads on ropes, which branches sag and the turns of rounds are not those of the place
/// from which it was let go.
DynamicState begun_at_rest(const Run& run) {
  DynamicState state = state_of(run.m, run.before, run.origin);
  state.on_drums.clear();
  for (DynamicState::Rope& rope : state.ropes) {
    rope.lumped.clear();
    rope.angle.clear();
    rope.spin.clear();
    rope.passed.clear();
  }
  return state;
}

/// While the machine comes to rest, a drum in its brake does not turn.
void hold_brakes(Run& run) {
  for (std::size_t i = 0; i < run.before.drum_drive.size(); ++i) {
    machine::Drive& drive = run.before.drum_drive[i];
    if (drive.brake && run.model.drums[i].brake) drive = {};
  }
  run.now.drum_drive = run.before.drum_drive;
}

/// A drum or sheave with drag; empty: none.
std::string one_with_drag(const machine::Model& model) {
  for (const machine::Drum& drum : model.drums) {
    if (drum.drag > 0) return drum.name;
  }
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.drag > 0) return node.name;
    }
  }
  return {};
}

/// What a quasi-static motion can't count: without inertia a drum that turns in its brake has no speed, and what turns
/// from rest to rest has no drag.
Outcome check_slow(const Run& run) {
  if (!run.options.quasi_static) return {};
  const auto slips = [](const machine::Drum& drum) { return drum.brake.has_value(); };
  const auto found = std::find_if(run.model.drums.begin(), run.model.drums.end(), slips);
  if (found != run.model.drums.end()) {
    return infeasible(
        fmt::format("a quasi-static motion has no inertia that the brake of '{}' could stop: leave out "
                    "its 'brake_torque', or compute the motion with inertia",
                    found->name));
  }
  const std::string drags = one_with_drag(run.model);
  if (drags.empty()) return {};
  return infeasible(
      fmt::format("a quasi-static motion goes from rest to rest, where the drag of '{}' does nothing: leave out its "
                  "'drag', or compute the motion with inertia",
                  drags));
}

void prepare(Run& run, const DynamicState& start) {
  Built built = build(run.model, start, run.options);
  run.result.outcome = built.outcome;
  run.m = std::move(built.mechanism);
  run.before = std::move(built.values);
  run.now = run.before;
  run.w = work_for(run.m);
  run.scheme = scheme_of(run.options.rho);
  run.newton.tolerance = 0.01 * std::min(run.options.tolerance, 1e-3);
  run.newton.ask = run.options.progress;
  const std::size_t lines = run.m.lines.size();
  run.T_old.assign(lines, 0.0);
  run.T_older = run.T_old;
  run.rate_old = run.nu_old = run.before.rate;
  run.T_largest.assign(run.model.reevings.size(), 0.0);
  run.T_error = run.T_largest;
  forget_tension_rates(run);
  run.origin = start;
  for (DynamicState::Rope& rope : run.origin.ropes) {
    if (rope.lumped.empty()) rope.lumped = rope.length;
  }
}

/// The damping time of each rope: given, kept from before, or from its damping ratio and the lowest mode.
void damp(Run& run) {
  Array<double> time = run.origin.damping_time, frequency;
  const std::size_t ropes = run.model.reevings.size();
  for (std::size_t r = time.size(); r < ropes; ++r) {
    const machine::Reeving& rope = run.model.reevings[r];
    time.push_back(rope.damping_time);
    const double ratio = rope.damping_ratio > 0 ? rope.damping_ratio : run.options.damping_ratio;
    if (rope.damping_time > 0 || !(ratio > 0)) continue;
    if (frequency.empty()) frequency = stretching_frequencies(run.m, run.before, run.w);
    if (!(frequency[r] > 0)) continue;
    run.result.frequency[r] = frequency[r];
    time[r] = 2 * ratio / frequency[r];
  }
  for (Line& line : run.m.lines) line.damping = time[line.reeving];
  run.m.lossless = run.m.lossless && std::all_of(time.begin(), time.end(), [](double beta) { return beta == 0; });
  run.origin.damping_time = run.result.damping_time = std::move(time);
}

}  // namespace

namespace {

/// The machine with the sides that its sheaves without a given side have where it comes to rest; as described where the
/// motion begins as described.
machine::Model sided_at_rest(const machine::Model& model, Start start) {
  if (start == Start::assembled || !has_open_sides(model)) return model;
  const auto found = rest_before_motion(model);
  return found ? machine::with_sides(model, found->state) : model;
}

/// Heights stay: energies count from 0.
Vector3 in_plan(Vector3 place) {
  place.z() = 0;
  return place;
}

void shift(const Vector3& by, DynamicState& state) {
  for (DynamicState::Body& body : state.bodies) body.position += by;
  for (DynamicState::Rope& rope : state.ropes) {
    for (Vector3& joint : rope.inside) joint += by;
  }
}

/// A state that counts as the deck does.
DynamicState seen_from(const machine::Model& model, DynamicState state) {
  shift(-model.origin, state);
  return state;
}

}  // namespace

machine::Model dynamics::ready_to_move(const machine::Model& described, Start start) {
  machine::Model model = sided_at_rest(described, start);
  const Vector3 middle = in_plan(machine::far_middle(model));
  return middle == Vector3::Zero() ? model : machine::counted_from(middle, std::move(model));
}

bool dynamics::open_run(Run& run) {
  const TransientOptions& options = run.options;
  const machine::Model& model = run.model;
  const bool settles = !options.from && options.start != Start::assembled;
  const auto near = settles ? near_equilibrium(model) : std::nullopt;
  prepare(run, options.from ? seen_from(model, *options.from) : near ? *near : assembled(model));
  run.result.observed.resize(model.observed.size());
  run.reference.assign(model.observed.size(), std::numeric_limits<double>::quiet_NaN());
  run.measured.resize(model.observed.size());
  run.result.extremes.resize(model.observed.size());
  run.result.ropes.resize(model.reevings.size());
  run.result.mass_lumped.assign(model.reevings.size(), options.rope_mass);
  run.result.frequency.assign(model.reevings.size(), 0.0);
  if (!run.result.outcome.ok()) return false;
  if (options.method == TimeMethod::reference) run.result.outcome = reference_refuses(run.m);
  if (!run.result.outcome.ok()) return false;
  run.result.outcome = check_slow(run);
  if (!run.result.outcome.ok()) return false;
  const Array<machine::Drive> drives = run.before.drum_drive;
  hold_brakes(run);
  if (settles) run.result.outcome = solve::settle(run);
  if (settles && !near && run.result.outcome.ok()) {
    prepare(run, begun_at_rest(run));
    if (run.result.outcome.ok()) run.result.outcome = solve::settle(run);
  }
  run.result.sagging.assign(model.reevings.size(), 0);
  for (const Line& line : run.m.lines) run.result.sagging[line.reeving] += line.sag >= 0;
  const bool slides = !options.from && options.start == Start::sliding;
  if (slides || options.quasi_static) {
    for (Line& line : run.m.lines) line.damping = 0;
  }
  if (run.result.outcome.ok() && slides) {
    run.result.outcome = slide_into_place(run);
  }
  run.before.drum_drive = run.now.drum_drive = drives;
  if (!run.result.outcome.ok()) return false;
  if (!options.quasi_static) damp(run);
  return true;
}

namespace {

/// The breaks under way at the end of the run.
Array<DynamicState::Tear> tears_of(const Run& run) {
  Array<DynamicState::Tear> tears;
  for (const Run::Breaking& one : run.breaking) {
    if (run.before.t >= one.from + one.over) continue;
    const int reeving = run.m.lines[one.line].reeving;
    tears.push_back({reeving, one.line - run.m.first_line[reeving].first, one.from, one.over});
  }
  return tears;
}

/// The breaks under way in the state that the run goes on from. False where a part is none of the machine's.
bool take_tears(Run& run) {
  for (const DynamicState::Tear& one : run.origin.tears) {
    if (one.reeving < 0 || as_size(one.reeving) >= run.m.first_line.size()) return false;
    const auto [first, lines] = run.m.first_line[one.reeving];
    if (one.part < 0 || one.part >= lines) return false;
    run.breaking.push_back({first + one.part, one.from, one.over});
  }
  fade(run, run.before.t, run.before);
  return true;
}

TransientResult finished(Run& run) {
  // those of one step stand at the moments within it
  std::stable_sort(run.result.events.begin(), run.result.events.end(),
                   [](const TransientEvent& a, const TransientEvent& b) { return a.t < b.t; });
  run.result.iterations = run.newton.used;
  run.result.state = state_of(run.m, run.before, run.origin);
  shift(run.model.origin, run.result.state);
  run.result.state.begins_anew = false;
  run.result.state.happened.assign(run.happened.begin(), run.happened.end());
  run.result.state.tears = tears_of(run);
  run.result.state.memory = memory_of(run);
  for (std::size_t r = 0; r < run.result.ropes.size(); ++r) {
    run.result.state.ropes[r].T_static = run.result.ropes[r].T_static;
  }
  return std::move(run.result);
}

TransientResult marched(Run& run) {
  if (run.options.anew) run.options.anew();
  march(run);
  return finished(run);
}

/// The motion by Verlet's own step: the longest one below the stability limit at first, then, from the beginning, ones
/// that are so much shorter that tensions and energy are within the tolerance. `options`: those of the run.
TransientResult by_own_step(const Run& opened, TransientOptions& options) {
  Array<double> T_expected;
  VerletRun before;
  for (;;) {
    Run run = opened;
    run.h = options.step;
    run.T_expected = T_expected;
    TransientResult result = marched(run);
    const VerletRun last = {options.step, largest_error(result) / options.tolerance};
    if (result.interrupted || last.error <= 1) return result;
    options.step = shorter_step(options, before, last);
    before = last;
    if (const double steps = options.duration / options.step; steps > static_cast<double>(options.most_steps)) {
      if (options.anew) options.anew();
      TransientResult refused = opened.result;
      refused.outcome = not_converged(fmt::format(
          "Verlet's steps of {:.3g} s leave an error of {:.2g} in the tensions and of {:.2g} in the energy; "
          "a 'tolerance' of {:.2g} needs {:.3g} million steps: give a coarser one, a shorter 'duration' or "
          "a fixed 'step'",
          last.step, result.tension_error, result.open, options.tolerance, 1e-6 * steps));
      return refused;
    }
    T_expected.resize(run.T_largest.size(), 0.0);
    for (std::size_t r = 0; r < T_expected.size(); ++r) T_expected[r] = std::max(T_expected[r], run.T_largest[r]);
  }
}

}  // namespace

TransientResult transient(const machine::Model& described, const TransientOptions& given) {
  expects(given.duration > 0, "a motion lasts");
  const machine::Model model = ready_to_move(described, given.start);
  TransientOptions options = given;
  if (options.output_step <= 0) options.output_step = options.duration / 1000;
  if (options.method == TimeMethod::reference) options.step = 0;
  if (options.quasi_static) {
    options.method = TimeMethod::implicit;
    if (options.step <= 0) options.step = options.output_step;
  }
  Run run{.model = model, .options = options};
  if (!open_run(run)) return run.result;
  run.happened.assign(model.events.size(), 0);
  for (std::size_t i = 0; i < run.origin.happened.size() && i < run.happened.size(); ++i) {
    run.happened[i] = static_cast<char>(run.origin.happened[i]);
  }
  run.end = run.before.t + options.duration;
  run.stops = stops_of(run, run.before.t, run.end);
  const bool equal_steps = options.step > 0 && !options.quasi_static;
  if (!equal_steps || options.method == TimeMethod::implicit) {
    run.extremes = extremes_of(model, run.before.t, run.end, !equal_steps);
  }
  run.result.stability_limit = stability_limit(run.m, run.before);
  const bool own_step = options.method == TimeMethod::verlet && options.step <= 0;
  if (options.method == TimeMethod::verlet) {
    const double limit = run.result.stability_limit;
    if (options.step > limit) {
      run.result.outcome =
          not_converged(fmt::format("steps of {:.4g} s are too long for Verlet: stable are those up to {:.4g} s here; "
                                    "give a shorter 'step', or none",
                                    options.step, limit));
      return run.result;
    }
    options.step = equal_step(options, options.step > 0 ? options.step : verlet_share * limit);
  }
  run.h = options.step;
  std::string forgotten;
  const Remembered memory = options.from ? take_memory(run, options.from->memory, forgotten) : Remembered::other;
  if (memory == Remembered::damaged) {
    run.result.outcome =
        infeasible("the state to go on from is damaged: numbers are missing in its 'memory', or too many");
    return run.result;
  }
  if (!forgotten.empty()) {
    run.result.outcome =
        infeasible(fmt::format("the state to go on from does not know the measure '{}', which counts from before: "
                               "measure it in the first part, "
                               "too, as it is here, or give it 'since: {:.6g} s'",
                               forgotten, run.before.t));
    return run.result;
  }
  run.resumed = memory == Remembered::taken;
  run.begins_anew = run.begins_anew || (options.from && options.from->begins_anew);
  if (!run.resumed && !take_tears(run)) {
    run.result.outcome = infeasible("the state to go on from is damaged: what breaks in it is no part of the machine");
    return run.result;
  }
  if (run.resumed && options.step > 0) run.h = options.step;
  for (const LineValues& line : run.before.lines) {
    const auto r = static_cast<std::size_t>(run.m.lines[&line - run.before.lines.data()].reeving);
    run.T_largest[r] = std::max(run.T_largest[r], line.T);
  }
  if (own_step) return by_own_step(run, options);
  return marched(run);
}

}  // namespace taut::solve
