#include "taut/solve/motion/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>

#include "taut/base/array.hpp"

namespace taut::solve::dynamics {
namespace {

/// Shows every number to `see`, which reads or writes it. Lists keep their lengths.
template <class See>
class Walk {
 public:
  explicit Walk(See& see) : see_(see) {}

  void number(double& x) { see_(x); }
  template <class Whole>
  void whole(Whole& x) {
    auto as_number = static_cast<double>(x);
    see_(as_number);
    if constexpr (std::is_same_v<Whole, bool>) {
      x = as_number != 0;
    } else {
      x = static_cast<Whole>(as_number);
    }
  }
  template <class Numbers>
  void all(Numbers& list) {
    for (double& x : list) see_(x);
  }
  void matrix(Vector3& x) { eigen(x); }
  void matrix(Matrix3& x) { eigen(x); }

 private:
  template <class M>
  void eigen(M& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i) see_(x.data()[i]);
  }
  See& see_;
};

template <class W>
void walk_body(W& w, Motion3& b) {
  for (Vector3* one : {&b.x, &b.v, &b.w, &b.driven_v, &b.driven_w, &b.driven_a, &b.driven_b, &b.turned}) w.matrix(*one);
  w.matrix(b.R);
}

template <class W>
void walk_line(W& w, LineValues& l) {
  for (auto* pair : {&l.centre, &l.touch}) {
    for (Vector3& one : *pair) w.matrix(one);
  }
  for (Vector3* one : {&l.t, &l.axis, &l.flat, &l.apart}) w.matrix(*one);
  for (double* one : {&l.l, &l.flat_l, &l.L, &l.hung, &l.e, &l.e_rate, &l.T, &l.T_e, &l.T_rate, &l.gone})
    w.number(*one);
  for (auto* pair : {&l.angle, &l.skew_angle, &l.radius, &l.arc, &l.end_T, &l.thrust, &l.surge, &l.surge_share})
    w.all(*pair);
}

template <class W>
void walk_sag(W& w, SagValues& s) {
  for (auto* pair : {&s.direction, &s.seat, &s.pull}) {
    for (Vector3& one : *pair) w.matrix(one);
  }
  w.matrix(s.along);
  for (double* one : {&s.H, &s.V, &s.lowest, &s.stretches, &s.chord_rate, &s.damper, &s.damper_rate, &s.damper_share})
    w.number(*one);
  w.whole(s.bounded);
}

template <class W>
void walk_contact(W& w, ContactValues& c) {
  for (double* one : {&c.rolled, &c.slipped, &c.flow, &c.steady, &c.roll_rate, &c.slip_rate, &c.slip_mean, &c.wrap,
                      &c.log_ratio, &c.log_by_wrap, &c.ratio, &c.lambda, &c.winding}) {
    w.number(*one);
  }
  w.whole(c.entry);
  w.whole(c.grip);
}

template <class W>
void walk_couples(W& w, Values& v) {
  for (FaceValues& f : v.faces) {
    for (bool* one : {&f.over, &f.closed, &f.sticks}) w.whole(*one);
    for (double* one : {&f.pen, &f.pen_rate, &f.N, &f.limit, &f.pace, &f.gone}) w.number(*one);
    for (Vector3* one : {&f.normal, &f.point, &f.arm, &f.slide, &f.bristle, &f.pull, &f.friction}) w.matrix(*one);
  }
  for (ActuatorValues& a : v.actuators) {
    w.whole(a.mode);
    for (double* one : {&a.hold, &a.length, &a.speed, &a.F, &a.F_l, &a.F_v}) w.number(*one);
    for (Vector3& one : a.end) w.matrix(one);
    w.matrix(a.t);
    w.matrix(a.apart);
  }
}

template <class W>
void walk_values(W& w, Values& v) {
  w.number(v.t);
  w.number(v.when);
  for (Motion3& body : v.bodies) walk_body(w, body);
  for (auto* list : {&v.q, &v.nu, &v.rate, &v.tensioned, &v.tension_rate}) w.all(*list);
  for (LineValues& line : v.lines) walk_line(w, line);
  for (SagValues& sag : v.sags) walk_sag(w, sag);
  for (ContactValues& contact : v.contacts) walk_contact(w, contact);
  for (SpinValues& s : v.spins) {
    for (double* one : {&s.angle, &s.omega, &s.alpha, &s.bearing, &s.capacity, &s.torque, &s.speed}) w.number(*one);
    w.whole(s.turns);
  }
  for (ChainLoadValues& load : v.chain_loads) {
    for (double* one : {&load.share, &load.force, &load.speed, &load.bristle, &load.stiffness}) w.number(*one);
    w.all(load.on_end);
    w.whole(load.line);
    w.whole(load.holds);
  }
  walk_couples(w, v);
}

template <class W>
void walk_run(W& w, Run& run) {
  walk_values(w, run.before);
  w.all(run.w.q_mean);
  w.all(run.w.nu_mean);
  w.number(run.w.mean_step);
  for (auto* list :
       {&run.nu_old, &run.rate_old, &run.T_old, &run.T_older, &run.T_largest, &run.L_first, &run.tight_first}) {
    w.all(*list);
  }
  for (double* one :
       {&run.h, &run.h_last, &run.h_older, &run.m.size_of_machine, &run.grid_from, &run.grid_step, &run.floor}) {
    w.number(*one);
  }
  for (int* one : {&run.known, &run.rough_left, &run.rough_more, &run.careful}) w.whole(*one);
  for (bool* one : {&run.fresh, &run.rough_next, &run.begins_anew}) w.whole(*one);
  for (Line& line : run.m.lines) {
    if (!line.part) continue;
    w.number(line.ahead_more);
    w.number(line.more);
  }
  for (ChainLoad& load : run.m.chain_loads) w.number(load.more);
}

constexpr double layout = 6;  ///< of the list: another one is not understood

/// What the numbers belong to: how many they are, the method, its damping, the kinds of steps, the rope on rounds.
Array<double> head_of(Run& run) {
  double count = 0;
  auto see = [&](double&) { ++count; };
  Walk walk(see);
  walk_run(walk, run);
  const bool explicit_steps = run.options.method == TimeMethod::verlet, given = run.options.step > 0;
  return {layout,
          count,
          explicit_steps ? 1.0 : 0.0,
          run.options.rho,
          given ? 1.0 : 0.0,
          run.options.arcs == Arcs::rigid ? 1.0 : 0.0};
}

/// Measures: what they relate to and their means so far. A deck that observes something else goes on without those that
/// it does not have.
constexpr std::size_t per_measure = 7;

/// All that an observable says. What is numbered among others of its kind may have another number in another deck.
std::string words_of(const machine::Model& m, const machine::Observable& what) {
  const auto number = [](const auto& x) { return x ? static_cast<double>(*x) : -1.0; };
  std::string all = what.name;
  if (what.mean_of) all += " over " + words_of(m, m.mean_windows[*what.mean_of]);
  for (const double x : {static_cast<double>(what.quantity), static_cast<double>(what.index), number(what.part),
                         what.at.x(), what.at.y(), what.at.z(), static_cast<double>(what.seen_from), what.factor,
                         what.offset, what.since, static_cast<double>(what.relative), what.has_mean ? 1.0 : 0.0,
                         what.mean_from, what.mean_to, number(what.joint)}) {
    all += fmt::format(" {:.17g}", x);
  }
  return all;
}

/// A number that tells what is observed apart (Fowler, Noll, Vo: FNV-1a, 52 bits).
double mark_of(const machine::Model& m, const machine::Observable& what) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : words_of(m, what)) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return static_cast<double>(hash >> 12U);
}

/// Whether a measure that counts from before the restart on needs what was before.
bool looks_back(const Run& run, const machine::Observable& what) {
  const bool relates = what.relative != machine::description::Relative::none && what.slot;
  return (relates || what.has_mean) && what.since < run.before.t;
}

void keep_measures(const Run& run, Array<double>& memory) {
  memory.push_back(static_cast<double>(run.model.observed.size()));
  for (std::size_t i = 0; i < run.model.observed.size(); ++i) {
    const Run::Measured& all = run.measured[i];
    memory.insert(memory.end(), {mark_of(run.model, run.model.observed[i]), run.reference[i], all.integral,
                                 all.duration, all.t, all.value, all.window});
  }
}

/// Those that the state does not have begin anew; `forgotten` is one that needs what was before.
void take_measures(Run& run, const Array<double>& memory, std::size_t first, std::size_t kept, std::string& forgotten) {
  for (std::size_t i = 0; i < run.model.observed.size(); ++i) {
    const double mark = mark_of(run.model, run.model.observed[i]);
    bool known = false;
    for (std::size_t k = first; k < first + kept * per_measure; k += per_measure) {
      if (memory[k] != mark) continue;
      known = true;
      run.reference[i] = memory[k + 1];
      run.measured[i] = {memory[k + 2], memory[k + 3], memory[k + 4], memory[k + 5], memory[k + 6], memory[k + 5]};
    }
    if (!known && looks_back(run, run.model.observed[i])) forgotten = run.model.observed[i].name;
  }
}

}  // namespace

Array<double> memory_of(Run& run) {
  Array<double> memory = head_of(run);
  auto see = [&](double& x) { memory.push_back(x); };
  Walk walk(see);
  walk_run(walk, run);
  keep_measures(run, memory);
  for (const Run::Breaking& one : run.breaking) memory.insert(memory.end(), {1.0 * one.line, one.from, one.over});
  return memory;
}

Remembered take_memory(Run& run, const Array<double>& memory, std::string& forgotten) {
  run.L_first.resize(run.m.lines.size());
  run.tight_first.resize(run.m.lines.size());
  const Array<double> head = head_of(run);
  if (memory.empty() || memory.front() != layout) return Remembered::other;
  if (memory.size() < head.size() || !(memory[1] >= 0 && memory[1] <= static_cast<double>(memory.size())))
    return Remembered::damaged;
  const std::size_t numbers = head.size(), measures = numbers + static_cast<std::size_t>(memory[1]);
  if (memory.size() <= measures) return Remembered::damaged;
  const double most = static_cast<double>(memory.size()) / per_measure;
  if (!(memory[measures] >= 0 && memory[measures] <= most)) return Remembered::damaged;
  const auto kept = static_cast<std::size_t>(memory[measures]);
  const std::size_t breaks = measures + 1 + kept * per_measure;
  if (memory.size() < breaks || (memory.size() - breaks) % 3 != 0) return Remembered::damaged;
  for (std::size_t i = breaks; i < memory.size(); i += 3) {
    if (!(memory[i] >= 0 && memory[i] < static_cast<double>(run.m.lines.size()))) return Remembered::damaged;
  }
  take_measures(run, memory, measures + 1, kept, forgotten);
  if (!std::equal(head.begin(), head.end(), memory.begin())) return Remembered::other;
  std::size_t next = numbers;
  auto see = [&](double& x) { x = memory[next++]; };
  Walk walk(see);
  walk_run(walk, run);
  for (next = breaks; next < memory.size(); next += 3) {
    run.breaking.push_back({static_cast<int>(memory[next]), memory[next + 1], memory[next + 2]});
  }
  run.now = run.before;
  return Remembered::taken;
}

}  // namespace taut::solve::dynamics
