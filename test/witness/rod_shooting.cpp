#include "test/witness/rod_shooting.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "taut/base/expects.hpp"

namespace taut_test::witness {

using taut::structure::BeamSection;
using taut::structure::SectionForces;

namespace {

/// place, quaternion (w, x, y, z), moment, force.
using PackedState = Eigen::Matrix<double, 13, 1>;

PackedState pack(const BeamState& s) {
  const Eigen::Quaterniond q(s.axes);
  PackedState p;
  p << s.place, q.w(), q.x(), q.y(), q.z(), s.moment, s.force;
  return p;
}

Eigen::Quaterniond turn_of(const PackedState& p) { return Eigen::Quaterniond(p[3], p[4], p[5], p[6]); }

BeamState unpack(const PackedState& p) {
  BeamState s;
  s.place = p.head<3>();
  s.axes = turn_of(p).normalized().toRotationMatrix();
  s.moment = p.segment<3>(7);
  s.force = p.tail<3>();
  return s;
}

PackedState rate(const BeamSection& b, const PackedState& p) {
  const Eigen::Quaterniond q = turn_of(p);
  const Matrix3 axes = q.normalized().toRotationMatrix();
  const Vector3 M = p.segment<3>(7), F = p.tail<3>();
  const Vector3 m = axes.transpose() * M;
  const Vector3 along = axes.col(2) * (1 + F.dot(axes.col(2)) / b.EA);
  const Eigen::Quaterniond spin(0, m.x() / b.EI_y / 2, m.y() / b.EI_x / 2, m.z() / b.GJ / 2);
  const Eigen::Quaterniond turning = q * spin;
  PackedState d;
  d << along, turning.w(), turning.x(), turning.y(), turning.z(), F.cross(along), b.weight * taut::up();
  return d;
}

/// The turn that takes one set of axes to another, as a spatial vector, rad.
Vector3 turn_between(const Matrix3& from, const Matrix3& to) {
  const Eigen::AngleAxisd a(Matrix3(to * from.transpose()));
  return a.angle() * a.axis();
}

}  // namespace

SectionForces section_forces(const BeamState& state) {
  const Vector3 f = state.axes.transpose() * state.force, m = state.axes.transpose() * state.moment;
  return {
      .axial = f.z(), .shear_x = f.x(), .shear_y = f.y(), .bends_to_x = m.y(), .bends_to_y = -m.x(), .torsion = m.z()};
}

BeamState carry(const BeamSection& section, const BeamState& from, double length, int steps,
                std::vector<BeamState>* each) {
  taut::expects(steps > 0, "a beam is carried in at least one step");
  const double h = length / steps;
  PackedState p = pack(from);
  for (int i = 0; i < steps; ++i) {
    const PackedState k1 = rate(section, p), k2 = rate(section, p + h / 2 * k1), k3 = rate(section, p + h / 2 * k2),
                      k4 = rate(section, p + h * k3);
    p += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (each != nullptr) each->push_back(unpack(p));
  }
  return unpack(p);
}

Eigen::Matrix<double, 12, 12> piece_stiffness(const std::function<BeamState(const BeamState&)>& carry_on,
                                              const BeamState& from, double length, double EI) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  const BeamState end = carry_on(from);
  constexpr double angle = 1e-4;
  const double shift = angle * length, force = angle * EI / (length * length), moment = angle * EI / length;
  Matrix6 A, B, C, D;
  const auto column = [&](const BeamState& plus, const BeamState& minus, double step, auto place, auto load) {
    const BeamState p = carry_on(plus), m = carry_on(minus);
    place << (p.place - m.place) / (2 * step),
        (turn_between(end.axes, p.axes) - turn_between(end.axes, m.axes)) / (2 * step);
    load << (p.force - m.force) / (2 * step), (p.moment - m.moment) / (2 * step);
  };
  for (int i = 0; i < 3; ++i) {
    const Vector3 e = Vector3::Unit(i);
    BeamState plus = from, minus = from;
    plus.place += shift * e, minus.place -= shift * e;
    column(plus, minus, shift, A.col(i), C.col(i));
    plus = minus = from;
    plus.axes = Eigen::AngleAxisd(angle, e) * from.axes, minus.axes = Eigen::AngleAxisd(-angle, e) * from.axes;
    column(plus, minus, angle, A.col(3 + i), C.col(3 + i));
    plus = minus = from;
    plus.force += force * e, minus.force -= force * e;
    column(plus, minus, force, B.col(i), D.col(i));
    plus = minus = from;
    plus.moment += moment * e, minus.moment -= moment * e;
    column(plus, minus, moment, B.col(3 + i), D.col(3 + i));
  }
  const Matrix6 inverse = B.fullPivLu().inverse();
  Eigen::Matrix<double, 12, 12> K;
  K << inverse * A, -inverse, C - D * inverse * A, D * inverse;
  return K;
}

}  // namespace taut_test::witness
