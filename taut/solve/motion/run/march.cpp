#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/run/still.hpp"
#include "taut/solve/motion/step/points.hpp"
#include "taut/solve/motion/step/quasi_static.hpp"
#include "taut/solve/motion/step/reference.hpp"
#include "taut/solve/motion/step/stable.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double smallest_share = 1e-13;  ///< of the duration: a step below it ends the run
constexpr double growth = 2;
// A step that is much longer than the last one stirs up the ropes' fast motions and errs by more than its length says.
// Where one has been taken back, steps near the limit grow a little at a time for a while.
constexpr double careful_growth = 1.1, far_below = 0.05, much_longer = 1.2;
constexpr int careful_steps = 64, steps_between_asking = 32;
constexpr double at_once = 1e-10;         ///< of the duration: how exactly the moment of a condition is found
constexpr double at_once_of_step = 1e-6;  ///< the same of a given step, whatever the duration
constexpr double shorter_at_kinks = 4;    ///< than a step that resolves the fastest motion
constexpr double least_resolved = 1e-3;   ///< of the floor: below it rounding is more than what changes
constexpr int most_rough = 64;            ///< Euler steps before the usual ones are tried again
constexpr double longest_rough = 4;       ///< their size, of the floor
constexpr long steps_at_once = 1000;      ///< of Verlet, between two looks at interrupts

/// Without consistent accelerations, where no common answer was found at an unchanged time: the first steps, very
/// short, find them.
void begin_roughly(Run& run) {
  std::fill(run.before.rate.begin(), run.before.rate.end(), 0.0);
  run.w.mean_step = 0;
  run.w.q_mean = run.before.nu;
  run.w.nu_mean = run.before.rate;
  run.now = run.before;
}

/// A run that goes on from a saved state has no step before: what begins anew does not look back at it either.
void forget_last_step(Run& run) {
  run.now = run.before;
  run.scheme = scheme_of(run.options.rho);
  run.newton.tolerance = Newton{}.tolerance;
  run.newton.largest = largest_tension(run);
  run.newton.rough = false;
  run.newton.forget();
}

/// Consistent accelerations at the time reached; what slips at once goes to `where`.
StepEnd begin_again(Run& run, double& where) {
  forget_last_step(run);
  fade(run, run.before.t, run.now);
  if (run.options.quasi_static) return rest_again(run);
  StepEnd end = restart(run.m, run.scheme, run.before, run.now, run.w, run.newton);
  const bool rough = end != StepEnd::ok && end != StepEnd::interrupted;
  if (rough) begin_roughly(run);
  if (rough) end = StepEnd::ok;
  if (end != StepEnd::ok) return end;
  add_jump(run.m, run.before, where, run.ledger);
  run.known = 0;
  forget_tension_rates(run);
  run.newton.forget();
  for (ContactValues& contact : run.before.contacts) contact.slip_mean = contact.slip_rate;
  if (run.options.step <= 0) {
    run.h = std::min(resolving_step(run), run.h > 0 ? run.h : run.options.duration);
    if (rough) run.h = std::min(run.h, floor_of(run));
  }
  run.rough_next = rough;
  run.fresh = true;
  return end;
}

/// What has become of the tries of one step.
struct Tries {
  double error = 0, h = 0;  ///< of the last one
  bool kink = false;        ///< a law changes in it
  bool rough = false;       ///< by implicit Euler
};

/// A step of h to the time t, which is before.t + h but for rounding.
/// Implicit Euler takes whatever comes in it.
StepEnd try_step(Run& run, double h, double t, const Tries& tries) {
  Scheme& s = run.scheme;
  s.h = h;
  if (run.options.quasi_static) return try_slowly(run, h, t);
  const bool rough = tries.rough;
  s = rough ? scheme_of_euler() : scheme_of(run.options.rho);
  s.h = h;
  s.fresh = rough || run.fresh;
  run.newton.rough = rough;
  s.reach = h * s.gamma * s.alpha_f / s.alpha_m;
  const double more = run.known > 0 && !rough ? h / (h + run.h_last) : 0;
  s.slip_now = (1 + more) / h;
  s.slip_before = -more;
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    ContactValues& contact = run.before.contacts[i];
    const LineValues& line = run.before.lines[winding_line(run.m.contacts[i], contact)];
    const double change = line.e > 0 ? h / 2 * line.e_rate : 0;  // in the middle of the step; no rope is pressed
    contact.winding = std::max(1.0, winding_stretch(run.m, run.before, run.m.contacts[i], contact) + change);
  }
  if (run.options.method == TimeMethod::verlet) {
    fade(run, t, run.now);
    s.reach = 0;
    s.slip_now = 1 / h;
    s.slip_before = 0;
    run.newton.tolerance = 1e-10;
    run.newton.largest = largest_tension(run);
    run.now.rate = run.before.rate;
    return verlet_step(run.m, s, run.before, t, run.now, run.w, run.newton);
  }
  // accelerations go on as they changed
  const double slope = run.known > 0 ? h / run.h_last : 0;
  for (std::size_t c = 0; c < run.now.rate.size(); ++c) {
    run.now.rate[c] = run.before.rate[c] + slope * (run.before.rate[c] - run.rate_old[c]);
  }
  fade(run, t, run.now);
  const double share = run.options.step > 0 ? 1e-3 : std::clamp(h / run.options.duration, 1e-5, 1.0);
  run.newton.tolerance = 0.02 * share * run.options.tolerance;
  run.newton.largest = largest_tension(run);
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
    OnDrumValues& end = run.now.on_drums[contact.on_drum];
    end.content = content_at(run, contact, run.now);
    if (is.entry < 0) is.lambda = 1 + end.strain[end.layer - 1];
  }
}

/// `rough`: by implicit Euler.
void accept(Run& run, bool rough = false) {
  commit_contacts(run);
  const bool slowly = run.options.quasi_static;
  const bool implicit = run.options.method == TimeMethod::implicit && !slowly;
  if (implicit) end_step(run.m, run.scheme, run.before, run.now, run.w);
  if (slowly) book_slow_step(run);
  if (!slowly && (!run.m.lossless || !run.breaking.empty())) book_step(run, rough);
  if (implicit) keep_history(run);
  if (run.options.method == TimeMethod::verlet || (implicit && run.options.step > 0)) note_tension_errors(run);
  note_changes(run);
  add_ways(run);
  ++run.result.steps;
  note_impatience(run);
  const double h = run.scheme.h;
  run.result.smallest_step = run.result.smallest_step > 0 ? std::min(run.result.smallest_step, h) : h;
  run.result.largest_step = std::max(run.result.largest_step, h);
  std::swap(run.before, run.now);
  record_extremes(run, run.before);
  show_moment(run, run.now, run.before);
}

/// Goes on by implicit Euler: the longer, the less good came of the last time.
void go_roughly(Run& run, Tries& tries) {
  run.rough_more = run.fresh ? std::min(2 * run.rough_more, most_rough) : 1;
  run.rough_left = run.rough_more;
  run.h = floor_of(run);
  tries.rough = true;
}

bool goes_roughly(const Run& run, double h) {
  return run.options.method == TimeMethod::implicit && !run.options.quasi_static && h < floor_of(run);
}

/// After a step of h without an answer. Whether one can be tried again.
bool try_shorter(Run& run, double h, Tries& tries) {
  ++run.result.rejected;
  if (!tries.rough && goes_roughly(run, h / 4)) {
    go_roughly(run, tries);
    return true;
  }
  run.h = h / 4;
  return run.h >= smallest_share * run.options.duration;
}

/// After a step of h with too large an error.
void try_closer(Run& run, double h, double error, Tries& tries) {
  ++run.result.rejected;
  if (h > much_longer * run.h_last) run.careful = careful_steps;
  if (tries.h > 0 && error > tries.error * (h / tries.h)) tries.kink = true;
  tries.error = error;
  tries.h = h;
  run.h = h * std::clamp(0.9 / std::sqrt(error), 0.1, 0.7);
  if (goes_roughly(run, tries.kink ? run.h : run.h / least_resolved)) go_roughly(run, tries);
}

/// Takes an Euler step or one of a given size, of h, as it is.
void accept_as_it_is(Run& run, double h, bool rough) {
  const bool whole = h == run.h;
  accept(run, rough);
  run.fresh = rough;
  if (rough) {
    run.known = 0;
    run.newton.forget();
  }
  run.rough_left = std::max(0, run.rough_left - 1);
  if (whole) run.h = run.rough_left > 0 ? std::min(growth * h, longest_rough * floor_of(run)) : growth * h;
  if (run.options.step > 0) run.h = run.options.step;
}

/// The size of the next step, at most to `limit`; no rest that is next to nothing stays behind. Of Verlet one of equal
/// steps: its dampers go by the velocity of half a step before.
double size_of_step(const Run& run, double limit) {
  const bool fixed = run.options.step > 0;  // of Verlet always
  const double left = limit - run.before.t, h = std::min(run.h, fixed ? stable_step(run) : step_of_fading(run));
  if (h > 0.999999 * left) return left;
  if (run.options.method == TimeMethod::verlet) {
    constexpr double rounding = 1e-6;  // of the number of steps: then h itself fits
    const double parts = left / h;
    return std::abs(parts - std::round(parts)) < rounding * parts ? h : left / std::ceil(parts);
  }
  return !fixed && h > left / 2 ? left / 2 : h;
}

/// Asks now and then, by the tries of steps.
bool is_interrupted(Run& run) {
  if (!run.options.progress || ++run.since_asked < steps_between_asking) return false;
  run.since_asked = 0;
  return !run.options.progress(run.before.t);
}

/// One accepted step, at most to `limit`. Steps that fail or err are tried again, shorter.
StepEnd advance(Run& run, double limit) {
  Tries tries;
  tries.rough = run.rough_next || run.rough_left > 0;
  run.rough_next = false;
  const bool given = run.options.step > 0;
  const double shortest = given ? at_once_of_step * run.options.step : at_once * run.options.duration;
  for (;;) {
    if (is_interrupted(run)) return StepEnd::interrupted;
    const double h = size_of_step(run, limit);
    const bool last = h == limit - run.before.t;
    const StepEnd end = try_step(run, h, last ? limit : run.before.t + h, tries);
    if (end != StepEnd::ok) {
      if (!try_shorter(run, h, tries)) return end;
      continue;
    }
    const bool passes_by = h > shortest && comes_true(run, run.now);
    if (passes_by || (!given && !tries.rough && snatches_too_far(run))) {  // halve the way to the moment
      run.h = h / 2;
      ++run.result.rejected;
      continue;
    }
    if (given || tries.rough) {
      accept_as_it_is(run, h, tries.rough);
      return StepEnd::ok;
    }
    const double error = error_of(run, tries.kink);
    if (error > 1 && h > 1e-12 * run.options.duration) {
      try_closer(run, h, error, tries);
      continue;
    }
    const double most = error < far_below || run.careful == 0 ? growth : careful_growth;
    if (run.careful > 0) --run.careful;
    const double factor = error > 0 ? std::clamp(0.9 / std::sqrt(error), 0.3, most) : growth;
    const bool shortened = h < 0.9 * run.h;
    if (!tries.kink) run.result.spent += error * allowed_share(run, false);
    accept(run);
    run.fresh = false;
    if (tries.kink) run.known = 0;
    if (!shortened || factor < 1) run.h = h * factor;
    return StepEnd::ok;
  }
}

/// The end of a broken rope has run over the round that it lay on: what it held is free too. Else a part is used up.
StepEnd run_off(Run& run, std::size_t line) {
  if (run.before.lines[line].gone > 0) return StepEnd::no_place;
  for (const int index : run.m.lines[line].contact) {
    if (index < 0) continue;
    const Contact& contact = run.m.contacts[index];
    const int other = contact.in == static_cast<int>(line) ? contact.out : contact.in;
    if (other < 0 || run.before.lines[other].gone == 0) continue;  // a drum has all of it
    run.breaking.push_back({other, run.before.t, 0});
    note(run, run.before.t, "run_off", run.model.reevings[contact.reeving].nodes[contact.node].name);
  }
  mark_run_off(run, line);
  fade(run, run.before.t, run.before);
  double freed = 0;
  const StepEnd end = begin_again(run, freed);
  run.ledger.broken += freed;
  return end;
}

StepEnd begin(Run& run) {
  StepEnd end = StepEnd::ok;
  if (!run.resumed) {
    run.L_first.clear();
    run.tight_first.clear();
    for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
      run.L_first.push_back(free_rope(run.before.lines[i]));
      run.tight_first.push_back(strain_of_chord(run.m.lines[i], run.before.lines[i]));
    }
  }
  if (!run.resumed) run.floor = resolving_step(run) / shorter_at_kinks;
  run.ledger = open_ledger(run.m, run.before);
  // where a run left off, its accelerations stand, unless something happens or jumps at that very time
  if (!run.resumed || run.begins_anew || jumps_at(run, run.before.t)) end = begin_again(run, run.ledger.slipped);
  run.ledger = open_ledger(run.m, run.before);
  if (run.options.quasi_static) run.ledger.start.kinetic = run.ledger.now.kinetic = 0;
  record_extremes(run, run.before);
  if (end == StepEnd::ok) note_unstable(run);
  record_frame(run, run.before);
  const double step = run.options.output_step;
  if (!run.resumed || run.grid_step != step) run.grid_from = run.before.t;
  run.grid_step = step;
  // a run that ends at an output ends at the very time that a longer one would give that output
  const double outputs = std::round((run.end - run.grid_from) / step), last = run.grid_from + outputs * step;
  if (std::abs(run.end - last) < 1e-12 * std::max(run.end, step)) run.end = last;
  return end;
}

/// One step of the reference; where a law changes, everything begins anew.
StepEnd advance_reference(Run& run, Reference& reference, double limit) {
  if (is_interrupted(run)) return StepEnd::interrupted;
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
  const bool joints = lay_out_joints(run, run.before);
  const bool jolts = joints || (jump && !run.options.quasi_static);
  if (joints) run.floor = resolving_step(run) / shorter_at_kinks;
  run.begins_anew = event || joints;
  if ((event || jolts) && !stop && run.before.t < run.end) {
    run.begins_anew = false;
    end = begin_again(run, broken);
    (event ? run.ledger.broken : run.ledger.slipped) += broken;
  }
  for (std::size_t i = 0; i < run.m.lines.size() && end == StepEnd::ok; ++i) {
    if (used_up(run, i)) end = run_off(run, i);
  }
  if (end == StepEnd::ok) stop = run_out(run) || stop;
  return end;
}

/// Where the next step has to end: at the output or at what comes before it, an extreme of a signal too. Times that
/// differ by their rounding alone (0.01 s * 610 and 6.1 s) are one: between them there is no step.
double next_limit(const Run& run, double output, std::size_t next) {
  constexpr double rounding = 1e-13;
  const auto same_as = [&](double t) { return t + rounding * std::max(std::abs(t), run.options.duration); };
  double limit = next < run.stops.size() ? std::min(output, run.stops[next]) : output;
  const auto extreme = std::upper_bound(run.extremes.begin(), run.extremes.end(), same_as(run.before.t));
  if (extreme != run.extremes.end()) limit = std::min(limit, *extreme);
  const double same = same_as(limit);
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
  if (end == StepEnd::ok) end = look_round(run, false, stop);  // what happens, or holds, at the very start
  while (end == StepEnd::ok && !stop && run.before.t < run.end) {
    const double output = std::min(run.end, first + static_cast<double>(frame) * step);
    while (next < run.stops.size() && run.stops[next] <= run.before.t) ++next;
    end = go_on(run, points, reference, next_limit(run, output, next));
    if (end != StepEnd::ok) break;
    if (run.before.t >= output) {
      if (run.m.lossless && run.breaking.empty() && !run.options.quasi_static)
        add_step(run.m, run.before, run.before, run.ledger);
      note_unstable(run);
      record_frame(run, run.before);
      run.newton.forget();
      ++frame;
      if (run.options.progress && !run.options.progress(run.before.t)) end = StepEnd::interrupted;
      if (!run.T_expected.empty() && tension_error(run) > run.options.tolerance) break;  // it begins anew
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
  const double turnover = run.result.frames.back().energy.turnover;
  run.result.open = turnover > 0 ? run.lacks / turnover : 0;
  run.result.tension_error = tension_error(run);
}

}  // namespace taut::solve::dynamics
