#include "taut/solve/motion/step/quasi_static.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double without_inertia = 1e4;  ///< s: of a step so long that masses are nothing
constexpr double far_away = 0.05;        ///< of the machine's size: a step that goes so far has left its way
constexpr double quiet_way = 1e-12;      ///< of the same
constexpr double deepest_fall = 4;       ///< of the same: a fall beyond it has no end
constexpr int most_falls = 1500;         ///< little steps
constexpr double brief_step = 0.02;      ///< of the usual one: then the machine may fall
constexpr int slide_steps = 50;          ///< each way

Scheme creeping(double reach, double elapsed) {
  Scheme s;
  s.at_rest = s.creeps = true;
  s.h = s.reach = reach;
  s.elapsed = elapsed;
  s.slip_now = elapsed > 0 ? 1 / elapsed : 0;
  return s;
}

/// `ahead`: the way looked for first, by column.
StepEnd from_rest(Mechanism& m, const Scheme& s, Values& before, double t, Values& now, Work& w, Newton& newton,
                  const Array<double>* ahead = nullptr) {
  std::fill(before.nu.begin(), before.nu.end(), 0.0);
  std::fill(now.rate.begin(), now.rate.end(), 0.0);
  for (std::size_t c = 0; ahead != nullptr && c < as_size(m.body_columns); ++c)
    now.rate[c] = (*ahead)[c] / (s.reach * s.reach);
  for (std::size_t i = 0; i < now.spins.size(); ++i) now.spins[i].turns = before.spins[i].turns;
  return solve_step(m, s, before, t, now, w, newton);
}

/// What has moved slowly stands `by` farther, the way of a small step of it.
void shift_slid(const Run& run, const Slid& slid, double by, Values& v) {
  if (!slid.drum) {
    v.actuators[slid.index].hold += by;
    return;
  }
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Contact& contact = run.m.contacts[i];
    if (contact.drum != slid.index) continue;
    ContactValues& is = v.contacts[i];
    is.rolled += contact.in < 0 ? -by : by;  // along its path the rope leaves the drum where it begins
  }
}

/// What has a given speed goes on by the integral of it from `from` to `to`: in these drives by its mean. At the ends
/// of a step a signal may jump, and between them it need not be straight.
void take_means(double from, double to, Array<machine::Drive>& drives) {
  for (machine::Drive& drive : drives) {
    if (drive.kind != machine::DriveKind::speed || !(to > from)) continue;
    const double mean = machine::integral(drive.signal, from, to) / (to - from);
    drive.signal.law = mean;
  }
}

/// The machine did not find its way on by little steps: it went where it rests again.
void note_fall(Run& run, const Values& from, const Values& to) {
  constexpr double worth_noting = 1e-3;  // of the machine's size
  const LargestWay largest = largest_way(run.m, from, to);
  if (largest.way < worth_noting * run.m.size_of_machine || largest.body < 0) return;
  const int body = run.m.bodies[largest.body].model;
  note(run, to.t, "fall", body < 0 ? "rope" : run.model.bodies[body].name, {{"way", largest.way}});
}

}  // namespace

LargestWay largest_way(const Mechanism& m, const Values& before, const Values& now) {
  LargestWay largest;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].count == 0) continue;
    const double way = (now.bodies[b].x - before.bodies[b].x).norm();
    if (way > largest.way) largest = {way, static_cast<int>(b)};
  }
  for (const Contact& contact : m.contacts) {
    const double way = std::abs(now.q[contact.column] - before.q[contact.column]);
    if (way > largest.way) largest = {way, -1};
  }
  return largest;
}

StepEnd quasi_static_step(Mechanism& m, double elapsed, Values& before, double t, Values& now, Work& w,
                          Newton& newton) {
  const Scheme s = creeping(without_inertia, elapsed);
  const Array<double> speed = before.nu;
  const auto near = [&](StepEnd end) {
    if (end != StepEnd::ok) return end;
    return largest_way(m, before, now).way < far_away * m.size_of_machine ? end : StepEnd::not_converged;
  };
  Array<double> ahead = speed;
  for (double& way : ahead) way *= elapsed;
  const bool moves = std::any_of(ahead.begin(), ahead.end(), [](double way) { return way != 0; });
  // what hangs on stiff ropes is not found from where it hung: it goes on as it went
  if (moves && near(from_rest(m, s, before, t, now, w, newton, &ahead)) == StepEnd::ok) return StepEnd::ok;
  const StepEnd end = near(from_rest(m, s, before, t, now, w, newton));
  if (end != StepEnd::ok) before.nu = speed;  // for the shorter step that follows
  return end;
}

StepEnd fall_to_rest(Mechanism& m, double elapsed, Values& before, double t, Values& now, Work& w, Newton& newton,
                     const std::function<bool(const Values&)>& until) {
  // as long a step as there is an answer for: what stands on a moving body has to go with it and not be left behind
  const double shortest = 1 / std::max(highest_frequency(m, before), 1e-3);
  double h = without_inertia, left = elapsed;
  double fallen = 0;
  int quiet = 0;
  for (int i = 0; i < most_falls; ++i) {
    if (newton.ask && i % 8 == 7 && !newton.ask(before.t)) return StepEnd::interrupted;
    const StepEnd end = from_rest(m, creeping(h, left), before, t, now, w, newton);
    const double way = end == StepEnd::ok ? largest_way(m, before, now).way : 0;
    if (end != StepEnd::ok || (way > far_away * m.size_of_machine && h > shortest)) {
      h /= 8;
      quiet = 0;
      if (h < 1e-12) return end;
      continue;
    }
    fallen += way;
    if (!(fallen < deepest_fall * m.size_of_machine)) return StepEnd::singular;
    quiet = way < quiet_way * m.size_of_machine ? quiet + 1 : 0;
    if ((quiet >= 2 && h > 1e3) || (until && until(now))) return StepEnd::ok;
    left = 0;
    before = now;
    if (way < far_away * m.size_of_machine) h = std::min(h * 3, 2 * without_inertia);
  }
  return StepEnd::not_converged;
}

void set_mean_velocities(const Mechanism& m, double elapsed, const Values& before, Values& now) {
  if (!(elapsed > 0)) return;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    now.bodies[b].v = (now.bodies[b].x - before.bodies[b].x) / elapsed;
    now.bodies[b].w = now.bodies[b].turned / elapsed;
  }
  for (int c = 0; c < m.body_columns; ++c) now.nu[c] = (now.q[c] - before.q[c]) / elapsed;
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const std::size_t c = as_size(m.spins[i].column);
    now.nu[c] = now.spins[i].omega = (now.q[c] - before.q[c]) / elapsed;
    now.rate[c] = now.spins[i].alpha = 0;
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    ContactValues& is = now.contacts[i];
    is.roll_rate = (is.rolled - before.contacts[i].rolled) / elapsed;
    is.slip_rate = is.slip_mean = (is.slipped - before.contacts[i].slipped) / elapsed;
    is.flow = is.roll_rate + is.slip_rate;
  }
  for (std::size_t i = 0; i < now.faces.size(); ++i) {
    const Vector3& normal = m.model->faces[m.model->contacts[i].face].normal;
    const Vector3 moved = now.faces[i].arm - before.faces[i].arm;
    const int body = m.couples[i].body[1];
    const Vector3 along = (moved - normal * normal.dot(moved)) / elapsed;
    now.faces[i].slide = body < 0 ? along : Vector3(now.bodies[body].R * along);
  }
  for (std::size_t i = 0; i < now.actuators.size(); ++i) {
    now.actuators[i].speed = (now.actuators[i].length - before.actuators[i].length) / elapsed;
  }
}

StepEnd rest_again(Run& run) {
  const Values start = run.before;
  run.h = run.options.step;
  const StepEnd end = fall_to_rest(run.m, 0, run.before, run.before.t, run.now, run.w, run.newton);
  if (end != StepEnd::ok) return end;
  note_fall(run, start, run.now);
  add_fall(run.m, start, run.now, run.ledger.damped, run.ledger);
  std::swap(run.before, run.now);
  return end;
}

void book_slow_step(Run& run) {
  if (run.fell) {
    add_fall(run.m, run.before, run.now, run.ledger.damped, run.ledger);
  } else {
    add_slow_step(run.m, run.before, run.now, run.ledger);
  }
}

StepEnd try_slowly(Run& run, double h, double t) {
  run.now.on_drums = run.before.on_drums;
  run.now.drum_drive = run.before.drum_drive;
  run.now.motor_drive = run.before.motor_drive;
  take_modes(run.before, run.now);
  fade(run, t, run.now);
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    ContactValues& contact = run.before.contacts[i];
    contact.winding = winding_stretch(run.m, run.before, run.m.contacts[i], contact);
  }
  run.newton.tolerance = 1e-3 * run.options.tolerance;
  const Array<machine::Drive> drum_drive = run.before.drum_drive, motor_drive = run.before.motor_drive;
  for (auto* drives : {&run.before.drum_drive, &run.before.motor_drive}) take_means(run.before.t, t, *drives);
  StepEnd end = quasi_static_step(run.m, h, run.before, t, run.now, run.w, run.newton);
  run.fell = end != StepEnd::ok && h < brief_step * run.options.step;
  if (run.fell) {
    const Values start = run.before;
    const auto event = [&](const Values& v) { return comes_true(run, v); };
    end = fall_to_rest(run.m, h, run.before, t, run.now, run.w, run.newton, event);
    run.before = start;
    if (end == StepEnd::ok && !comes_true(run, run.now)) note_fall(run, run.before, run.now);
  }
  run.before.drum_drive = run.now.drum_drive = drum_drive;
  run.before.motor_drive = run.now.motor_drive = motor_drive;
  if (end == StepEnd::ok) set_mean_velocities(run.m, h, run.before, run.now);
  return end;
}

Outcome slide_into_place(Run& run) {
  const double t = run.before.t;
  for (const double sense : {-1.0, 1.0}) {
    for (int i = 0; i < slide_steps; ++i) {
      if (run.newton.ask && !run.newton.ask(t)) {
        run.result.interrupted = true;
        return not_converged("interrupted where the motion begins");
      }
      for (const Slid& slid : run.options.slid) shift_slid(run, slid, sense * slid.by / slide_steps, run.before);
      StepEnd end = quasi_static_step(run.m, 0, run.before, t, run.now, run.w, run.newton);
      if (end != StepEnd::ok) end = fall_to_rest(run.m, 0, run.before, t, run.now, run.w, run.newton);
      if (end == StepEnd::interrupted) continue;
      if (end != StepEnd::ok) {
        return not_converged(
            "the machine can't come slowly into its place by the ways that 'slid' names: give a shorter way, or the "
            "other direction");
      }
      std::swap(run.before, run.now);
    }
  }
  for (auto* of : {&run.before.nu, &run.before.rate}) std::fill(of->begin(), of->end(), 0.0);
  run.now = run.before;
  return {};
}

}  // namespace taut::solve::dynamics
