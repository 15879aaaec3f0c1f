#include "taut/solve/motion/parts/couple.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve::dynamics {
namespace {

using machine::ActuatorMode;

Couple couple_between(const Mechanism& m, int body, const Vector3& place, int other, const Vector3& other_place) {
  Couple couple;
  couple.body = {body, other};
  couple.place = {place, other_place};
  int columns = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    if (couple.body[side] < 0) continue;
    const Body& of = m.bodies[couple.body[side]];
    couple.freedoms[side] = of.count;
    for (int f = 0; f < of.count; ++f) couple.column[as_size(columns++)] = of.first + f;
  }
  return couple;
}

Vector3 couple_place(const Values& v, const Couple& couple, std::size_t side) {
  const Motion3& body = motion_of(v, couple.body[side]);
  return body.x + body.R * couple.place[side];
}

const Couple& push_couple(const Mechanism& m, std::size_t i) {
  return m.couples[m.model->contacts.size() + m.model->actuators.size() + i];
}

constexpr std::size_t per_face = 3;  ///< numbers of a contact in DynamicState::force

}  // namespace

const Motion3& motion_of(const Values& v, int body) {
  static const Motion3 still;
  return body < 0 ? still : v.bodies[body];
}

void add_couples(Mechanism& m) {
  for (const machine::FaceContact& contact : m.model->contacts) {
    const machine::Face& face = m.model->faces[contact.face];
    m.couples.push_back(couple_between(m, contact.body, contact.at, face.body, face.from));
  }
  for (const machine::Actuator& actuator : m.model->actuators) {
    m.couples.push_back(couple_between(m, actuator.to_body, actuator.to, actuator.from_body, actuator.from));
  }
  for (int i = 0; i < static_cast<int>(m.model->loads.size()); ++i) {
    const machine::Load& load = m.model->loads[i];
    if (!load.over_time) continue;
    m.pushes.push_back(i);
    m.couples.push_back(couple_between(m, load.at.body, load.at.at, machine::ground, Vector3::Zero()));
  }
}

void fill_couples(const DynamicState& start, Mechanism& m, Values& v) {
  const std::size_t faces = m.model->contacts.size(), actuators = m.model->actuators.size();
  const bool known = start.force.size() == per_face * faces + actuators;
  v.faces.resize(faces);
  v.actuators.resize(actuators);
  v.pushes.resize(m.pushes.size());
  for (std::size_t i = 0; i < faces; ++i) {
    const Couple& couple = m.couples[i];
    const machine::Face& face = m.model->faces[m.model->contacts[i].face];
    const Motion3& carrier = motion_of(v, couple.body[1]);
    v.faces[i].point = couple_place(v, couple, 0);
    v.faces[i].arm = carrier.R.transpose() * (v.faces[i].point - carrier.x);
    v.faces[i].normal = carrier.R * face.normal;
    if (known) v.faces[i].bristle = Eigen::Map<const Vector3>(start.force.data() + per_face * i);
    m.size_of_machine = std::max(m.size_of_machine, (face.to - face.from).norm());
  }
  for (std::size_t i = 0; i < actuators; ++i) {
    const Couple& couple = m.couples[faces + i];
    ActuatorValues& is = v.actuators[i];
    is.mode = i < start.actuator_mode.size() ? start.actuator_mode[i] : m.model->actuators[i].mode;
    is.end = {couple_place(v, couple, 0), couple_place(v, couple, 1)};
    is.length = (is.end[0] - is.end[1]).norm();
    if (is.length > 0) is.t = (is.end[0] - is.end[1]) / is.length;
    is.hold = known ? start.force[per_face * faces + i] : is.length;
    m.size_of_machine = std::max(m.size_of_machine, is.length);
  }
  // a force rounds as its places do
  for (const machine::FaceContact& law : m.model->contacts) {
    m.stiffest = std::max(m.stiffest, law.stiffness * m.size_of_machine);
  }
  for (const machine::Actuator& law : m.model->actuators) {
    m.stiffest = std::max(m.stiffest, law.lock_stiffness * m.size_of_machine);
  }
}

void keep_couples(const Values& v, DynamicState& state) {
  state.force.clear();
  state.actuator_mode.clear();
  for (const FaceValues& face : v.faces) {
    for (const double x : face.bristle) state.force.push_back(x);
  }
  for (const ActuatorValues& actuator : v.actuators) {
    state.force.push_back(actuator.hold);
    state.actuator_mode.push_back(actuator.mode);
  }
}

void take_modes(const Values& before, Values& now) {
  for (std::size_t i = 0; i < before.actuators.size(); ++i) now.actuators[i].mode = before.actuators[i].mode;
}

Outcome check_couples(const Mechanism& m, const Values& v) {
  for (std::size_t i = 0; i < v.actuators.size(); ++i) {
    const machine::Actuator& law = m.model->actuators[i];
    if (!(v.actuators[i].length > 0)) {
      return infeasible(
          fmt::format("the ends of the actuator '{}' are at one place where the motion begins: its force "
                      "has no direction",
                      law.name));
    }
    const auto locks = [&](const machine::Event& e) {
      return e.kind == machine::EventKind::actuator && as_size(e.index) == i && e.mode == ActuatorMode::lock;
    };
    const bool held = law.kind == machine::ActuatorKind::speed || v.actuators[i].mode == ActuatorMode::lock ||
                      std::any_of(m.model->events.begin(), m.model->events.end(), locks);
    if (held && !(law.lock_stiffness > 0)) {
      return infeasible(
          fmt::format("the actuator '{}' needs its 'lock_stiffness' where it is locked or moves by a speed", law.name));
    }
  }
  return {};
}

void follow_couples(const Mechanism& m, const Scheme& s, const Values& before, Values& now) {
  for (std::size_t i = 0; i < now.faces.size(); ++i) follow_face(m, s, i, before, now);
  for (std::size_t i = 0; i < now.actuators.size(); ++i) follow_actuator(m, s, i, before, now);
  for (std::size_t i = 0; i < now.pushes.size(); ++i) {
    const machine::Load& load = m.model->loads[m.pushes[i]];
    now.pushes[i].at = couple_place(now, push_couple(m, i), 0);
    now.pushes[i].force = machine::at(*load.over_time, now.when).value * load.force.normalized();
  }
}

void assemble_couples(Mechanism& m, const Scheme& s, const Values& now, Work& w) {
  for (std::size_t i = 0; i < now.faces.size(); ++i) assemble_face(m, s, i, now, w);
  for (std::size_t i = 0; i < now.actuators.size(); ++i) assemble_actuator(m, s, i, now, w);
  for (std::size_t i = 0; i < now.pushes.size(); ++i) {
    CoupleColumns columns;
    const PushValues& is = now.pushes[i];
    const int count = couple_columns(m, push_couple(m, i), now, {is.at, Vector3::Zero()}, columns);
    for (int k = 0; k < count; ++k) columns[as_size(k)].force = Vector3::Zero();
    add_force(m, s, push_couple(m, i), is.force, false, count, columns, w);
  }
}

int couple_columns(const Mechanism& m, const Couple& couple, const Values& now, const std::array<Vector3, 2>& at_place,
                   CoupleColumns& columns) {
  int count = 0;
  for (const int side : {0, 1}) {
    for (int f = 0; f < couple.freedoms[as_size(side)]; ++f) {
      const Body& body = m.bodies[couple.body[as_size(side)]];
      CoupleColumn& c = columns[as_size(count++)];
      c.side = side;
      c.freedom = f;
      c.a = body.along[as_size(f)];
      c.b = body.about[as_size(f)];
      c.lever = at_place[as_size(side)] - now.bodies[couple.body[as_size(side)]].x;
      c.velocity = (side == 0 ? 1 : -1) * (c.a + c.b.cross(c.lever));
    }
  }
  return count;
}

void add_force(Mechanism& m, const Scheme& s, const Couple& couple, const Vector3& force, bool together, int count,
               const CoupleColumns& columns, Work& w) {
  double* const values = m.solver.values().data();
  const double square = s.reach * s.reach;
  for (int j = 0; j < count; ++j) w.residual[couple.column[as_size(j)]] -= force.dot(columns[as_size(j)].velocity);
  for (int k = 0; k < count; ++k) {
    const CoupleColumn& by = columns[as_size(k)];
    // the levers of both sides as the freedom k moves
    std::array<Vector3, 2> lever{Vector3::Zero(), Vector3::Zero()};
    lever[as_size(by.side)] = by.b.cross(by.lever);
    if (together) lever[1] = by.side == 0 ? by.velocity : Vector3(-by.a);
    const std::array<Vector3, 2> moment{square * lever[0].cross(force), -square * lever[1].cross(force)};
    for (int j = 0; j < count; ++j) {
      const CoupleColumn& row = columns[as_size(j)];
      values[couple.places[as_size(j * count + k)]] -=
          by.force.dot(row.velocity) + row.b.dot(moment[as_size(row.side)]);
    }
  }
}

CoupleChange change_of_couples(Work& w, const Values& now) {
  w.push.resize(2 * now.faces.size() + now.actuators.size() + now.pushes.size(), 0.0);
  w.push_state.resize(now.faces.size(), 0);
  CoupleChange change;
  std::size_t k = 0;
  const auto compare = [&](double force) {
    change.force = std::max(change.force, std::abs(force - w.push[k]));
    change.largest = std::max(change.largest, std::abs(force));
    w.push[k++] = force;
  };
  for (std::size_t i = 0; i < now.faces.size(); ++i) {
    const FaceValues& face = now.faces[i];
    compare(face.N);
    compare(face.friction.norm());
    const std::uint8_t state = face.sticks ? 2 : face.closed ? 1 : 0;
    change.turned = change.turned || state != w.push_state[i];
    w.push_state[i] = state;
  }
  for (const ActuatorValues& actuator : now.actuators) compare(actuator.F);
  for (const PushValues& push : now.pushes) compare(push.force.norm());
  return change;
}

namespace {

/// What one unit of force at a place of a body accelerates it by at most, 1/kg.
double yielding(const Mechanism& m, int body, const Vector3& place) {
  if (body < 0 || m.bodies[body].count == 0) return 0;
  const Body& shape = m.bodies[body];
  double yields = shape.mass > 0 ? 1 / shape.mass : 0;
  for (int f = 0; f < shape.count; ++f) {
    const Vector3& about = shape.about[as_size(f)];
    const double J = about.dot(shape.inertia * about);
    if (J > 0) yields += (place - shape.centre).squaredNorm() / J;
  }
  return yields;
}

/// Stiffness and damper of a couple as it is, N/m, N s/m.
std::pair<double, double> spring_of(const Mechanism& m, std::size_t couple, const Values& v) {
  const std::size_t faces = v.faces.size();
  if (couple >= faces + v.actuators.size()) return {0, 0};
  if (couple >= faces) return {-v.actuators[couple - faces].F_l, -v.actuators[couple - faces].F_v};
  const machine::FaceContact& law = m.model->contacts[couple];
  if (law.static_friction == 0) return {law.stiffness, law.damping};
  return {std::max(law.stiffness, law.tangential_stiffness), std::max(law.damping, law.tangential_damping)};
}

}  // namespace

CoupleBounds bounds_of_couples(const Mechanism& m, const Values& v) {
  CoupleBounds bounds;
  Array<double> stiffness(m.bodies.size(), 0.0), damping = stiffness;
  const auto add = [&](bool collect) {
    for (std::size_t i = 0; i < m.couples.size(); ++i) {
      const auto [k, c] = spring_of(m, i, v);
      double square = 0, rate = 0;
      for (std::size_t side = 0; side < 2; ++side) {
        const int body = m.couples[i].body[side];
        const Vector3 place = side == 0 || i >= v.faces.size() ? m.couples[i].place[side] : v.faces[i].arm;
        const double yields = yielding(m, body, place);
        if (yields == 0) continue;
        if (collect) {
          stiffness[body] += k * yields;
          damping[body] += c * yields;
        } else {
          square += stiffness[body];
          rate += damping[body];
        }
      }
      bounds.square = std::max(bounds.square, square);
      bounds.rate = std::max(bounds.rate, rate);
    }
  };
  add(true);
  add(false);
  return bounds;
}

CoupleWork work_of_couples(const Mechanism& m, const Values& before, const Values& now) {
  CoupleWork work;
  for (std::size_t i = 0; i < now.faces.size(); ++i) {
    const FaceValues &a = before.faces[i], &b = now.faces[i];
    const machine::FaceContact& law = m.model->contacts[i];
    const double k = law.stiffness;
    const double deep_a = a.over ? std::max(0.0, a.pen) : 0, deep_b = b.over ? std::max(0.0, b.pen) : 0;
    if (a.over == b.over) {
      work.lost += (a.N - k * deep_a + b.N - k * deep_b) / 2 * (deep_b - deep_a);
    } else {  // over the edge: nothing holds it any more
      work.lost += k * (deep_a * deep_a - deep_b * deep_b) / 2;
    }
    // in the face's frame, where the bristle stays while it sticks
    const Vector3 moved = b.arm - a.arm;
    const Matrix3 &Ra = motion_of(before, m.couples[i].body[1]).R, &Rb = motion_of(now, m.couples[i].body[1]).R;
    const Vector3 friction = (Ra.transpose() * a.friction + Rb.transpose() * b.friction) / 2;
    work.lost -= friction.dot(moved);
    work.lost -= law.tangential_stiffness * (b.bristle.squaredNorm() - a.bristle.squaredNorm()) / 2;
  }
  for (std::size_t i = 0; i < now.actuators.size(); ++i) {
    const ActuatorValues &a = before.actuators[i], &b = now.actuators[i];
    work.supplied += (a.F + b.F) / 2 * (b.length - a.length);
  }
  for (std::size_t i = 0; i < now.pushes.size(); ++i) {
    const PushValues &a = before.pushes[i], &b = now.pushes[i];
    work.supplied += (a.force + b.force).dot(b.at - a.at) / 2;
  }
  return work;
}

double taken_by_couples(const Mechanism& m, const Values& before, const Values& now) {
  double taken = 0;
  for (std::size_t i = 0; i < now.faces.size(); ++i) {
    const FaceValues &a = before.faces[i], &b = now.faces[i];
    const double deep_a = a.over ? std::max(0.0, a.pen) : 0, deep_b = b.over ? std::max(0.0, b.pen) : 0;
    if (a.over == b.over) taken += (b.N - a.N) / 2 * (deep_b - deep_a);
    const Matrix3 &Ra = motion_of(before, m.couples[i].body[1]).R, &Rb = motion_of(now, m.couples[i].body[1]).R;
    taken -= (Rb.transpose() * b.friction - Ra.transpose() * a.friction).dot(b.arm - a.arm) / 2;
  }
  for (std::size_t i = 0; i < now.actuators.size(); ++i) {
    const ActuatorValues &a = before.actuators[i], &b = now.actuators[i];
    taken -= (b.F - a.F) / 2 * (b.length - a.length);
  }
  for (std::size_t i = 0; i < now.pushes.size(); ++i) {
    const PushValues &a = before.pushes[i], &b = now.pushes[i];
    taken -= (b.force - a.force).dot(b.at - a.at) / 2;
  }
  return taken;
}

double power_of_couples(const Mechanism& m, int body, const Values& v, const Vector3& along, const Vector3& about) {
  const Motion3& is = v.bodies[body];
  double power = 0;
  const auto add = [&](const Couple& couple, std::size_t side, const Vector3& place, const Vector3& force) {
    if (couple.body[side] != body) return;
    power += (side == 0 ? 1 : -1) * force.dot(along + about.cross(place - is.x));
  };
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < v.faces.size(); ++i) {
      const FaceValues& face = v.faces[i];
      add(m.couples[i], side, face.point, face.N * face.normal + face.friction);
    }
    for (std::size_t i = 0; i < v.actuators.size(); ++i) {
      const ActuatorValues& actuator = v.actuators[i];
      add(m.couples[v.faces.size() + i], side, actuator.end[side], actuator.F * actuator.t);
    }
    if (side > 0) continue;
    for (std::size_t i = 0; i < v.pushes.size(); ++i) {
      add(push_couple(m, i), side, v.pushes[i].at, v.pushes[i].force);
    }
  }
  return power;
}

double observe_couple(const Mechanism& m, const Values& v, const machine::Observable& what) {
  using machine::Observed;
  const bool face = what.quantity <= Observed::contact_state && what.quantity >= Observed::contact_N;
  const auto i = as_size(what.index);
  if (face) {
    const TransientFrame::FaceContact f = face_frame(m, v, i);
    switch (what.quantity) {
      case Observed::contact_N:
        return f.N;
      case Observed::contact_F:
        return f.F;
      case Observed::contact_speed:
        return f.speed;
      default:
        return f.sticks ? 2 : f.closed ? 1 : 0;
    }
  }
  const ActuatorValues& a = v.actuators[i];
  switch (what.quantity) {
    case Observed::actuator_F:
      return a.F;
    case Observed::actuator_speed:
      return a.speed;
    case Observed::actuator_length:
      return a.length;
    default:
      return a.F * a.speed;
  }
}

}  // namespace taut::solve::dynamics
