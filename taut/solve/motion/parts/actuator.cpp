#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {
namespace {

using machine::ActuatorKind;
using machine::ActuatorMode;

/// Its force by a spring of the length `hold`: locked, or driven by a speed.
bool holds_length(const machine::Actuator& law, ActuatorMode mode, bool at_rest) {
  if (mode == ActuatorMode::free) return false;
  if (mode == ActuatorMode::lock || law.kind == ActuatorKind::speed) return true;
  return at_rest && law.kind == ActuatorKind::law && law.lock_stiffness > 0;
}

void push_actuator(const machine::Actuator& law, const Scheme& s, double when, const ActuatorValues& was,
                   ActuatorValues& is) {
  const double sense = is.mode == ActuatorMode::retract ? -1 : 1;
  is.hold = was.hold;
  is.F = is.F_l = is.F_v = 0;
  if (is.mode == ActuatorMode::free) return;
  if (holds_length(law, is.mode, s.at_rest)) {
    const double passed = s.at_rest ? s.elapsed : s.h;
    const bool moves = is.mode != ActuatorMode::lock && (!s.at_rest || passed > 0);
    const double rate = moves ? sense * machine::at(law.signal, when).value : 0;
    if (moves && passed > 0) is.hold += sense * machine::integral(law.signal, when - passed, when);
    const double c = s.at_rest ? 0 : law.lock_damping;
    is.F = law.lock_stiffness * (is.hold - is.length) + c * (rate - is.speed);
    is.F_l = -law.lock_stiffness;
    is.F_v = -c;
    if (is.mode == ActuatorMode::lock || std::abs(is.F) <= law.force_limit) return;
    // at its limit it stays behind
    is.F = std::copysign(law.force_limit, is.F);
    is.hold = is.length + (is.F - c * (rate - is.speed)) / law.lock_stiffness;
    is.F_l = is.F_v = 0;
    return;
  }
  const double value = machine::at(law.signal, when).value;
  if (law.kind == ActuatorKind::force) {
    is.F = sense * value;
  } else {
    is.F = (sense > 0 ? law.F0 : 0) + law.gain * (sense * value - is.speed);
    is.F_v = -law.gain;
  }
  if (std::abs(is.F) <= law.force_limit) return;
  is.F = std::copysign(law.force_limit, is.F);
  is.F_v = 0;
}

}  // namespace

void follow_actuator(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now) {
  const Couple& couple = m.couples[m.model->contacts.size() + i];
  const ActuatorValues& was = before.actuators[i];
  ActuatorValues& is = now.actuators[i];
  std::array<Vector3, 2> velocity;
  for (std::size_t end = 0; end < 2; ++end) {
    const Motion3& body = motion_of(now, couple.body[end]);
    const Vector3 lever = body.R * couple.place[end];
    is.end[end] = body.x + lever;
    velocity[end] = body.v + body.w.cross(lever);
  }
  const Vector3 d = is.end[0] - is.end[1];
  is.length = d.norm();
  if (is.length > 0) is.t = d / is.length;
  const bool settles = s.at_rest && !s.creeps;  // in long steps, which may turn it round
  if (!settles && is.t.dot(was.t) < 0) {        // it has gone through itself, and pushes on the same way
    is.t = -is.t;
    is.length = -is.length;
  }
  is.apart = s.at_rest ? Vector3(Vector3::Zero()) : Vector3(velocity[0] - velocity[1]);
  is.speed = is.t.dot(is.apart);
  push_actuator(m.model->actuators[i], s, now.when, was, is);
}

void assemble_actuator(Mechanism& m, const Scheme& s, std::size_t i, const Values& now, Work& w) {
  const Couple& couple = m.couples[m.model->contacts.size() + i];
  const ActuatorValues& is = now.actuators[i];
  if (is.F == 0 && is.F_l == 0 && is.F_v == 0) return;
  CoupleColumns columns;
  const int count = couple_columns(m, couple, now, is.end, columns);
  const double r = s.reach, square = r * r;
  for (int k = 0; k < count; ++k) {
    CoupleColumn& column = columns[as_size(k)];
    const Vector3& V = column.velocity;
    const Vector3 t = (V - is.t * is.t.dot(V)) / is.length;
    const Vector3 w_side = motion_of(now, couple.body[as_size(column.side)]).w;
    const Vector3 carried = (column.side == 0 ? 1 : -1) * w_side.cross(column.b.cross(column.lever));
    const double l = square * is.t.dot(V);
    const double v = r * is.t.dot(V) + square * (is.t.dot(carried) + is.apart.dot(t));
    column.force = (is.F_l * l + is.F_v * v) * is.t + square * is.F * t;
  }
  add_force(m, s, couple, is.F * is.t, false, count, columns, w);
}

void set_mode(const Mechanism& m, Values& v, int actuator, ActuatorMode mode) {
  ActuatorValues& is = v.actuators[actuator];
  const machine::Actuator& law = m.model->actuators[actuator];
  is.mode = mode;
  if (holds_length(law, mode, false) && law.lock_stiffness > 0) is.hold = is.length + is.F / law.lock_stiffness;
}

Array<TransientFrame::Actuator> actuator_frames(const Values& v) {
  Array<TransientFrame::Actuator> all;
  all.reserve(v.actuators.size());
  for (const ActuatorValues& is : v.actuators) {
    all.push_back({is.F, is.length, is.speed, is.F * is.speed, is.end[1], is.end[0]});
  }
  return all;
}

}  // namespace taut::solve::dynamics
