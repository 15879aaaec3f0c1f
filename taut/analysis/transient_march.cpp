#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/analysis/transient_couple.hpp"
#include "taut/analysis/transient_points.hpp"
#include "taut/analysis/transient_quasi_static.hpp"
#include "taut/analysis/transient_reference.hpp"
#include "taut/analysis/transient_run.hpp"

namespace taut::analysis::dynamics {
namespace {

constexpr double smallest_share = 1e-13;  ///< of the duration: a step below it ends the run
constexpr double growth = 2;
// A step that is much longer than the last one stirs up the ropes' fast motions and errs by more than its length says.
// Where one has been taken back, steps near the limit grow a little at a time for a while.
constexpr double careful_growth = 1.1, far_below = 0.05, much_longer = 1.2;
constexpr int careful_steps = 64;
constexpr double at_once = 1e-10;  ///< of the duration: how exactly the moment of a condition is found

constexpr int steps_between_asking = 32;
constexpr long steps_at_once = 1000;  ///< of Verlet, between two looks at interrupts

constexpr double no_rope = 1e-3;          ///< of a line's first length
constexpr double nearly_no_rope = 0.1;    ///< the same, where a step finds no place for a line
constexpr double hardly_any_rope = 0.02;  ///< the same, where no answer is found

bool used_up(const Run& run, std::size_t i) {
  const LineValues& line = run.before.lines[i];
  return !(line.L > no_rope * run.L_first[i] && line.l > no_rope * run.L_first[i]);
}

/// The line with the least rope left, by its first length, and that share.
std::pair<std::size_t, double> shortest(const Run& run) {
  std::pair<std::size_t, double> found{0, 1};
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const LineValues& line = run.before.lines[i];
    const double share = line.gone > 0 ? std::min(line.L, line.l) / run.L_first[i] : 1;
    if (share < found.second) found = {i, share};
  }
  return found;
}

/// Whether two rounds of a rope nearly touch.
bool rounds_touch(const Run& run) {
  constexpr double near = 1.1;
  return std::any_of(run.before.lines.begin(), run.before.lines.end(), [](const LineValues& line) {
    const double between = (line.centre[1] - line.centre[0]).norm();
    return line.radius[0] > 0 && line.radius[1] > 0 && between < near * (line.radius[0] + line.radius[1]);
  });
}

Outcome failure(Run& run, StepEnd end, double t) {
  const auto [line, share] = shortest(run);
  const double left = end == StepEnd::no_place ? nearly_no_rope : hardly_any_rope;
  if (!run.m.lines.empty() && share <= left) {
    const Line& of = run.m.lines[line];
    const model::Reeving& rope = run.model.reevings[at(of.reeving)];
    note(run, t, "length_zero", rope.name, {{"L", run.before.lines[line].L}});
    return infeasible(
        fmt::format("at t = {:.6g} s no rope is left between '{}' and '{}' of '{}': stop the motion before", t,
                    rope.nodes[at(of.from)].name, rope.nodes[at(of.to)].name, rope.name));
  }
  if (end == StepEnd::no_place && rounds_touch(run)) {
    return infeasible(fmt::format(
        "at t = {:.6g} s two rounds of a rope come so near to each other that no rope goes between them", t));
  }
  if (run.options.quasi_static && end == StepEnd::singular) {
    return infeasible(fmt::format(
        "at t = {:.6g} s there is no equilibrium any more: what is no longer held goes on without end; give it a stop, or "
        "end the motion by an event before",
        t));
  }
  // bodies have masses: what has no answer now is a fault of the search, not of the machine
  return not_converged(fmt::format(
      "at t = {:.6g} s no common answer of all ropes and contacts was found, down to steps of {:.3g} s", t, run.h));
}

/// Without consistent accelerations, where no common answer was found at an unchanged time: the first steps, very
/// short, find them.
void begin_roughly(Run& run) {
  std::fill(run.before.rate.begin(), run.before.rate.end(), 0.0);
  run.w.mean_step = 0;
  run.w.q_mean = run.before.nu;
  run.w.nu_mean = run.before.rate;
  run.now = run.before;
}

/// Consistent accelerations at the time reached; what slips at once goes to `where`.
StepEnd begin_again(Run& run, double& where) {
  run.now.drums = run.before.drums;
  run.now.drum_drive = run.before.drum_drive;
  run.now.motor_drive = run.before.motor_drive;
  take_modes(run.before, run.now);
  fade(run, run.before.t, run.now);
  if (run.options.quasi_static) return rest_again(run);
  StepEnd end = restart(run.m, run.scheme, run.before, run.now, run.w, run.newton);
  const bool rough = end == StepEnd::not_converged || end == StepEnd::singular;
  if (rough) begin_roughly(run);
  if (rough) end = StepEnd::ok;
  if (end != StepEnd::ok) return end;
  add_jump(run.m, run.before, where, run.ledger);
  run.known = 0;
  run.newton.forget();
  for (ContactValues& contact : run.before.contacts) contact.slip_mean = contact.slip_rate;
  if (run.options.step <= 0) {
    const double fastest = std::max(highest_frequency(run.m, run.before), 1 / run.options.duration);
    run.h = std::min({std::cbrt(run.options.tolerance) / (2 * fastest), run.options.duration / 100,
                      run.h > 0 ? run.h : run.options.duration});
    if (rough) run.h *= 1e-3;
  }
  return end;
}

/// A step of h to the time t, which is before.t + h but for rounding.
/// `last`: of those to an output or an event.
StepEnd try_step(Run& run, double h, double t, bool last) {
  Scheme& s = run.scheme;
  s.h = h;
  if (run.options.quasi_static) return try_slowly(run, h, t);
  s.reach = h * s.gamma * s.alpha_f / s.alpha_m;
  const double more = run.known > 0 ? h / (h + run.h_last) : 0;
  s.slip_now = (1 + more) / h;
  s.slip_before = -more;
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    ContactValues& contact = run.before.contacts[i];
    const bool rope = contact.entry >= 0;
    contact.winding =
        contact.lambda +
        (rope && run.before.lines[at(contact.entry)].e > 0 ? h / 2 * run.before.lines[at(contact.entry)].e_rate : 0);
  }
  if (run.options.method == TimeMethod::verlet) {
    fade(run, t, run.now);
    s.reach = 0;
    s.slip_now = 1 / h;
    s.slip_before = 0;
    run.newton.tolerance = 1e-10;
    return verlet_step(run.m, s, run.before, t, run.now, run.w, run.newton, last);
  }
  // accelerations go on as they changed
  const double slope = run.known > 0 ? h / run.h_last : 0;
  for (std::size_t c = 0; c < run.now.rate.size(); ++c) {
    run.now.rate[c] = run.before.rate[c] + slope * (run.before.rate[c] - run.rate_old[c]);
  }
  fade(run, t, run.now);
  const double share = run.options.step > 0 ? 1e-3 : std::clamp(h / run.options.duration, 1e-5, 1.0);
  run.newton.tolerance = 0.02 * run.options.tolerance * share;
  run.newton.largest = 0;
  for (const double T : run.T_largest) run.newton.largest = std::max(run.newton.largest, T);
  for (std::size_t i = 0; i < run.now.spins.size(); ++i) run.now.spins[i].turns = run.before.spins[i].turns;
  return solve_step(run.m, s, run.before, t, run.now, run.w, run.newton);
}

/// From which side the rope comes next, what drums hold.
void commit_contacts(Run& run) {
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Contact& contact = run.m.contacts[i];
    ContactValues& is = run.now.contacts[i];
    is.slip_mean = (is.slipped - run.before.contacts[i].slipped) / run.scheme.h;
    const int from = is.flow >= 0 ? contact.in : contact.out;
    const int other = is.flow >= 0 ? contact.out : contact.in;
    is.entry = from >= 0 ? from : contact.drum >= 0 ? -1 : other;
    if (contact.drum < 0) continue;
    DrumValues& drum = run.now.drums[at(contact.drum)];
    const double onto = (contact.in < 0 ? -1 : 1) * (run.now.q[at(contact.column)] - run.before.q[at(contact.column)]);
    drum.content = run.before.drums[at(contact.drum)].content + onto;
    if (is.entry < 0) is.lambda = 1 + drum.strain[at(drum.layer - 1)];
  }
}

void accept(Run& run) {
  commit_contacts(run);
  const bool slowly = run.options.quasi_static;
  const bool implicit = run.options.method == TimeMethod::implicit && !slowly;
  if (implicit) end_step(run.m, run.scheme, run.before, run.now, run.w);
  if (!slowly && (!run.m.lossless || !run.breaking.empty())) add_step(run.m, run.before, run.now, run.ledger);
  if (implicit) keep_history(run);
  note_changes(run);
  ++run.result.steps;
  const double h = run.scheme.h;
  run.result.smallest_step = run.result.smallest_step > 0 ? std::min(run.result.smallest_step, h) : h;
  run.result.largest_step = std::max(run.result.largest_step, h);
  std::swap(run.before, run.now);
  record_extremes(run, run.before);
}

/// One accepted step, at most to `limit`. Steps that fail or err are tried again, shorter.
StepEnd advance(Run& run, double limit) {
  const bool fixed = run.options.step > 0;  // of Verlet always
  double last_error = 0, last_h = 0;
  bool kink = false;
  for (;;) {
    if (run.options.progress && ++run.since_asked >= steps_between_asking) {
      run.since_asked = 0;
      if (!run.options.progress(run.before.t)) return StepEnd::interrupted;
    }
    const double left = limit - run.before.t;
    double h = fixed ? std::min(run.options.step, run.h) : run.h;
    if (h > 0.999999 * left)
      h = left;
    else if (!fixed && h > left / 2)
      h = left / 2;
    const StepEnd end = try_step(run, h, h == left ? limit : run.before.t + h, h == left);
    if (end != StepEnd::ok) {
      ++run.result.rejected;
      run.h = h / 4;
      if (run.h < smallest_share * run.options.duration) return end;
      continue;
    }
    if (h > at_once * run.options.duration && comes_true(run, run.now)) {  // halve the way to the moment
      run.h = h / 2;
      ++run.result.rejected;
      continue;
    }
    if (fixed) {
      run.h = run.options.step;
      accept(run);
      return StepEnd::ok;
    }
    const double error = error_of(run, kink);
    if (error > 1 && h > 1e-12 * run.options.duration) {
      ++run.result.rejected;
      if (h > much_longer * run.h_last) run.careful = careful_steps;
      if (last_h > 0 && !kink && error > last_error * (h / last_h)) kink = true;
      last_error = error;
      last_h = h;
      run.h = h * std::clamp(0.9 / std::sqrt(error), 0.1, 0.7);
      continue;
    }
    const double most = error < far_below || run.careful == 0 ? growth : careful_growth;
    if (run.careful > 0) --run.careful;
    const double factor = error > 0 ? std::clamp(0.9 / std::sqrt(error), 0.3, most) : growth;
    const bool shortened = h < 0.9 * run.h;
    accept(run);
    if (kink) run.known = 0;
    if (!shortened || factor < 1) run.h = h * factor;
    return StepEnd::ok;
  }
}

/// The end of a broken rope has run over the round that it lay on: what it held is free too. Else a part is used up.
StepEnd run_off(Run& run, std::size_t line) {
  if (run.before.lines[line].gone > 0) return StepEnd::no_place;
  for (const int index : run.m.lines[line].contact) {
    if (index < 0) continue;
    const Contact& contact = run.m.contacts[at(index)];
    const int other = contact.in == static_cast<int>(line) ? contact.out : contact.in;
    if (other < 0) return StepEnd::no_place;
    if (run.before.lines[at(other)].gone == 0) continue;
    run.breaking.push_back({other, run.before.t, 0});
    note(run, run.before.t, "run_off", run.model.reevings[at(contact.reeving)].nodes[at(contact.node)].name);
  }
  run.L_first[line] = 0;
  fade(run, run.before.t, run.before);
  double freed = 0;
  const StepEnd end = begin_again(run, freed);
  run.ledger.broken += freed;
  return end;
}

/// Whether an event is due at t or a signal jumps there.
bool jumps_at(const Run& run, double t) {
  const double near = 1e-12 * std::max(std::abs(t), run.options.duration);
  const std::vector<double> stops = stops_of(run.model, t - near, t + near);
  return !stops.empty();
}

StepEnd begin(Run& run) {
  StepEnd end = StepEnd::ok;
  if (!run.resumed) {
    run.L_first.clear();
    for (const LineValues& line : run.before.lines) run.L_first.push_back(line.L);
  }
  // where a run left off, its accelerations stand, unless something happens or jumps at that very time
  if (!run.resumed || jumps_at(run, run.before.t)) end = begin_again(run, run.ledger.slipped);
  run.ledger = open_ledger(run.m, run.before);
  record_extremes(run, run.before);
  record_frame(run, run.before);
  const double step = run.options.output_step;
  if (!run.resumed || run.grid_step != step) run.grid_from = run.before.t;
  run.grid_step = step;
  return end;
}

/// One step of the reference; where a law changes, everything begins anew.
StepEnd advance_reference(Run& run, Reference& reference, double limit) {
  if (run.known == 0 || !reference.begun()) {
    const StepEnd end = reference.begin(run);
    if (end != StepEnd::ok) return end;
  }
  bool changed = false;
  const StepEnd end = reference.step(run, limit, changed);
  if (end != StepEnd::ok) return end;
  accept(run);
  return changed && run.before.t < limit ? begin_again(run, run.ledger.slipped) : StepEnd::ok;
}

/// One step by the scheme that is asked for, or many of points.
StepEnd go_on(Run& run, Points& points, Reference& reference, double limit) {
  if (steps_as_points(run)) {
    step_points(run, points, limit, steps_at_once);
    run.since_asked += steps_between_asking;
  }
  const bool slow = run.options.method == TimeMethod::reference;
  const StepEnd end = slow ? advance_reference(run, reference, limit) : advance(run, limit);
  if (end == StepEnd::ok && run.before.t >= limit) run.before.t = limit;
  return end;
}

/// Events, layers, jumps of signals (`jump`), ropes that are used up.
StepEnd look_round(Run& run, bool jump, bool& stop) {
  StepEnd end = StepEnd::ok;
  double broken = 0;
  const bool event = happen(run, run.before, stop) || change_layers(run, run.before);
  const bool jolts = jump && !run.options.quasi_static;
  if ((event || jolts) && !stop && run.before.t < run.end) {
    end = begin_again(run, broken);
    (event ? run.ledger.broken : run.ledger.slipped) += broken;
  }
  for (std::size_t i = 0; i < run.m.lines.size() && end == StepEnd::ok; ++i) {
    if (used_up(run, i)) end = run_off(run, i);
  }
  return end;
}

/// Where the next step has to end: at the output or at what comes before it. Times that differ by their rounding alone
/// (0.01 s * 610 and 6.1 s) are one: between them there is no step.
double next_limit(const Run& run, double output, std::size_t next) {
  constexpr double rounding = 1e-13;
  double limit = next < run.stops.size() ? std::min(output, run.stops[next]) : output;
  const double same = limit + rounding * std::max(std::abs(limit), run.options.duration);
  if (output <= same) limit = output;
  for (; next < run.stops.size() && run.stops[next] <= same; ++next) limit = std::max(limit, run.stops[next]);
  return limit;
}

}  // namespace

void march(Run& run) {
  bool stop = false;
  StepEnd end = begin(run);
  const double first = run.grid_from, step = run.grid_step;
  long frame = std::lround(std::floor((run.before.t - first) / step + 1e-6)) + 1;
  std::size_t next = 0;
  Points points;
  Reference reference;
  while (end == StepEnd::ok && !stop && run.before.t < run.end) {
    const double output = std::min(run.end, first + static_cast<double>(frame) * step);
    while (next < run.stops.size() && run.stops[next] <= run.before.t) ++next;
    end = go_on(run, points, reference, next_limit(run, output, next));
    if (end != StepEnd::ok) break;
    if (run.before.t >= output) {
      if (run.m.lossless && run.breaking.empty() && !run.options.quasi_static)
        add_step(run.m, run.before, run.before, run.ledger);
      record_frame(run, run.before);
      run.newton.forget();
      ++frame;
      if (run.options.progress && !run.options.progress(run.before.t)) end = StepEnd::interrupted;
    }
    if (end == StepEnd::ok) end = look_round(run, next < run.stops.size() && run.before.t >= run.stops[next], stop);
    if (run.result.steps + run.result.rejected > run.options.most_steps) {
      run.result.outcome = not_converged(fmt::format(
          "after {} steps only t = {:.6g} s is reached: a coarser 'tolerance' or a shorter 'duration' is needed",
          run.options.most_steps, run.before.t));
      break;
    }
  }
  run.result.interrupted = end == StepEnd::interrupted;
  if (end != StepEnd::ok && end != StepEnd::interrupted) run.result.outcome = failure(run, end, run.before.t);
  if (run.result.frames.back().t < run.before.t) record_frame(run, run.before);
  run.result.t_end = run.before.t;
}

}  // namespace taut::analysis::dynamics
