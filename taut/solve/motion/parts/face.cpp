#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {
namespace {

/// The part of a vector along the face.
Vector3 along_face(const Vector3& normal, const Vector3& v) { return v - normal * normal.dot(v); }

/// By the speed of the contact; in a quasi-static step by that of the step before.
Friction friction_of(const machine::FaceContact& law, const FaceValues& is) {
  if (is.held_by >= 0) return {is.held_by, 0};
  return friction_at(law, is.slide.norm());
}

/// How a point has slid in a quasi-static step: as soon as that is farther, since it stuck, than its bristle yields,
/// with the speed of this step; where no time passes (it falls, or comes to its start) that is fast.
void pace_face(const machine::FaceContact& law, const Scheme& s, double slid, const FaceValues& was, FaceValues& is) {
  is.pace = is.gone = 0;
  if (!s.creeps || !is.closed || is.sticks) return;
  is.gone = was.gone + slid;
  if (is.gone * law.tangential_stiffness <= is.limit) return;
  is.pace = s.elapsed > 0 ? slid / s.elapsed : std::numeric_limits<double>::infinity();
}

/// Pressure and friction by the strain and speed of the contact; the bristle as it ends.
void push_face(const machine::FaceContact& law, const Matrix3& R, bool at_rest, FaceValues& is) {
  const double c = at_rest ? 0 : law.damping, ct = at_rest ? 0 : law.tangential_damping;
  is.N = is.over && is.pen > 0 ? std::max(0.0, law.stiffness * is.pen + c * is.pen_rate) : 0;
  is.closed = is.N > 0;
  is.limit = friction_of(law, is).f * is.N;
  is.sticks = false;
  is.friction.setZero();
  if (!(is.limit > 0)) {
    is.bristle.setZero();
    return;
  }
  is.pull = law.tangential_stiffness * (R * is.bristle) + ct * is.slide;
  const double size = is.pull.norm();
  is.sticks = size <= is.limit;
  is.friction = is.sticks ? Vector3(-is.pull) : Vector3(-is.limit / size * is.pull);
  // the damper gives way with the contact: what slides is not strained by it
  if (!is.sticks) is.bristle = R.transpose() * -is.friction / law.tangential_stiffness;
}

/// How the velocity of the point seen from the face's body follows a freedom's place.
Vector3 velocity_carried(const Values& now, const Couple& couple, const CoupleColumn& c, const Vector3& lever) {
  const Vector3& w1 = motion_of(now, couple.body[1]).w;
  if (c.side == 1) return w1.cross(c.a);
  return motion_of(now, couple.body[0]).w.cross(c.b.cross(lever)) - w1.cross(c.velocity);
}

}  // namespace

Friction friction_at(const machine::FaceContact& law, double speed) {
  const double more = (law.static_friction - law.kinetic_friction) * std::exp(-speed / law.stribeck_speed);
  return {law.kinetic_friction + more, -more / law.stribeck_speed};
}

bool is_over(const machine::Face& face, const Vector3& arm) {
  const Vector3 along = face.to - face.from;
  const double part = (arm - face.from).dot(along);
  return part >= 0 && part <= along.squaredNorm();
}

void follow_face(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now) {
  const machine::FaceContact& law = m.model->contacts[i];
  const machine::Face& face = m.model->faces[law.face];
  const Couple& couple = m.couples[i];
  const Motion3 &of_point = motion_of(now, couple.body[0]), &of_face = motion_of(now, couple.body[1]);
  const FaceValues& was = before.faces[i];
  FaceValues& is = now.faces[i];
  const Vector3 lever = of_point.R * couple.place[0];
  is.point = of_point.x + lever;
  is.normal = of_face.R * face.normal;
  is.arm = of_face.R.transpose() * (is.point - of_face.x);
  is.over = is_over(face, was.arm);
  is.pen = -(is.arm - face.from).dot(face.normal) - law.clearance;
  Vector3 apart = Vector3::Zero();
  if (!s.at_rest) apart = of_point.v + of_point.w.cross(lever) - of_face.v - of_face.w.cross(is.point - of_face.x);
  is.pen_rate = -is.normal.dot(apart);
  is.slide = along_face(is.normal, apart);
  is.held_by = s.creeps ? friction_at(law, was.pace).f : -1;
  const Vector3 strained = was.bristle + along_face(face.normal, is.arm - was.arm);
  is.bristle = strained;
  push_face(law, of_face.R, s.at_rest, is);
  pace_face(law, s, (strained - is.bristle).norm(), was, is);
}

void assemble_face(Mechanism& m, const Scheme& s, std::size_t i, const Values& now, Work& w) {
  const FaceValues& is = now.faces[i];
  if (!is.closed) return;
  const machine::FaceContact& law = m.model->contacts[i];
  const Couple& couple = m.couples[i];
  const double c = s.at_rest ? 0 : law.damping, ct = s.at_rest ? 0 : law.tangential_damping;
  const double r = s.reach, square = r * r;
  CoupleColumns columns;
  const int count = couple_columns(m, couple, now, {is.point, is.point}, columns);
  const Vector3& n = is.normal;
  const Vector3 strain = (is.pull - ct * is.slide) / law.tangential_stiffness;  // as if it stuck
  const Vector3 apart = is.slide - is.pen_rate * n;
  const double speed = is.slide.norm(), size = is.pull.norm();
  const Friction f = friction_of(law, is);
  const Vector3 d = size > 0 ? Vector3(is.pull / size) : Vector3(Vector3::Zero());
  for (int k = 0; k < count; ++k) {
    CoupleColumn& column = columns[as_size(k)];
    const Vector3& V = column.velocity;
    const Vector3 turned = column.side == 1 ? Vector3(column.b.cross(n)) : Vector3(Vector3::Zero());
    const Vector3 v = r * V + square * velocity_carried(now, couple, column, column.lever);
    const double rate = -n.dot(v) - square * apart.dot(turned);
    const double N = -square * law.stiffness * n.dot(V) + c * rate;
    column.force = N * n + square * is.N * turned;
    if (!(is.limit > 0)) continue;
    const Vector3 slide = along_face(n, v) + square * is.pen_rate * turned - square * n * turned.dot(apart);
    Vector3 strained = square * along_face(n, V);
    if (column.side == 1) strained += square * column.b.cross(strain);
    const Vector3 tau = law.tangential_stiffness * strained + ct * slide;
    if (is.sticks) {
      column.force -= tau;
      continue;
    }
    const double faster = speed > 0 ? is.slide.dot(slide) / speed : 0;
    // of a pull beyond the bound only the direction counts
    column.force -= (f.slope * faster * is.N + f.f * N) * d + is.limit / size * (tau - d * d.dot(tau));
  }
  add_force(m, s, couple, is.N * n + is.friction, true, count, columns, w);
}

bool meets_an_edge(const Mechanism& m, const Values& now) {
  for (std::size_t i = 0; i < now.faces.size(); ++i) {
    const FaceValues& is = now.faces[i];
    if (is.pen > 0 && is.over != is_over(m.model->faces[m.model->contacts[i].face], is.arm)) return true;
  }
  return false;
}

double energy_of_faces(const Mechanism& m, const Values& v) {
  double energy = 0;
  for (std::size_t i = 0; i < v.faces.size(); ++i) {
    const machine::FaceContact& law = m.model->contacts[i];
    const FaceValues& is = v.faces[i];
    if (is.over && is.pen > 0) energy += law.stiffness * is.pen * is.pen / 2;
    energy += law.tangential_stiffness * is.bristle.squaredNorm() / 2;
  }
  return energy;
}

TransientFrame::FaceContact face_frame(const Mechanism& m, const Values& v, std::size_t i) {
  const FaceValues& is = v.faces[i];
  const machine::Face& face = m.model->faces[m.model->contacts[i].face];
  const Vector3 along = motion_of(v, m.couples[i].body[1]).R * (face.to - face.from);
  const auto signed_size = [&](const Vector3& x) { return std::copysign(x.norm(), x.dot(along)); };
  TransientFrame::FaceContact frame;
  frame.N = is.N;
  frame.F = signed_size(is.friction);
  frame.speed = signed_size(is.slide);
  frame.closed = is.closed;
  frame.sticks = is.sticks;
  frame.point = is.point;
  frame.normal = is.normal;
  frame.force = is.N * is.normal + is.friction;
  return frame;
}

}  // namespace taut::solve::dynamics
