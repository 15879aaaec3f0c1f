#include "taut/structure/rod.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/base/expects.hpp"

namespace taut::structure {
namespace {

/// First order: of place, turn, force and moment by a turn of all axes as built and by turn, force and moment at the
/// start.
using RatesOfFirst = Eigen::Matrix<double, 12, 12>;
/// Second order: of place, turn and moment by turn, force and moment at the start; the force changes as it does there.
using RatesOfSecond = Eigen::Matrix<double, 9, 9>;

/// What is integrated: second order: the quaternion of the section; first order: `turn`.
struct Packed {
  Vector3 place, turn, force, moment;
  Eigen::Vector4d q;  ///< w, x, y, z
};

Packed operator+(const Packed& a, const Packed& b) {
  return {.place = a.place + b.place,
          .turn = a.turn + b.turn,
          .force = a.force + b.force,
          .moment = a.moment + b.moment,
          .q = a.q + b.q};
}
Packed operator*(double f, const Packed& a) {
  return {.place = f * a.place, .turn = f * a.turn, .force = f * a.force, .moment = f * a.moment, .q = f * a.q};
}

Eigen::Quaterniond quaternion(const Eigen::Vector4d& q) { return {q[0], q[1], q[2], q[3]}; }

Eigen::Vector4d product(const Eigen::Vector4d& q, const Vector3& half_spin) {
  const Eigen::Quaterniond r = quaternion(q) * Eigen::Quaterniond(0, half_spin.x(), half_spin.y(), half_spin.z());
  return {r.w(), r.x(), r.y(), r.z()};
}

/// Curvatures by moments, in the section's own axes.
Vector3 compliance(const BeamSection& b) { return {1 / b.EI_y, 1 / b.EI_x, 1 / b.GJ}; }

/// Curvature as built, in the section's own axes, 1/m.
Vector3 built_curvature(const Bow& bow, double s) {
  const double by_length = -bow.angle * std::numbers::pi / bow.length * std::sin(std::numbers::pi * s / bow.length);
  return by_length * Vector3(-bow.towards.y(), bow.towards.x(), 0);
}

/// The equation of one order at one place: the rate of the state, and, with `variation`, that of its derivatives.
class Equation {
 public:
  Equation(const RodPiece& piece, Matrix3 start_axes)
      : piece_(piece),
        chord_(piece.bow.axes(Matrix3::Identity(), piece.from).transpose()),
        start_(std::move(start_axes)) {}

  /// First order: axes as built at s.
  Matrix3 built(double s) const { return piece_.bow.axes(start_ * chord_, s); }

  Packed rate(double s, const Packed& p, const RatesOfSecond* v, RatesOfSecond* v_rate) const {
    const BeamSection& b = piece_.section;
    const Matrix3 R = quaternion(p.q).normalized().toRotationMatrix();
    const Vector3 c = compliance(b), d = R.col(2);
    const double stretch = p.force.dot(d) / b.EA + piece_.thermal_strain;
    const Vector3 along = (1 + stretch) * d;
    const Vector3 curvature = c.cwiseProduct(R.transpose() * p.moment) + built_curvature(piece_.bow, s);
    if (v != nullptr) {
      const auto turn = v->middleRows<3>(3), moment = v->bottomRows<3>();
      const Matrix3 D = -cross(d);  // of d by a turn
      const Matrix3 by_turn = (1 + stretch) * D + d * (p.force.transpose() * D) / b.EA;
      const Matrix3 C = R * c.asDiagonal() * R.transpose();
      v_rate->topRows<3>().noalias() = by_turn * turn;
      v_rate->block<3, 3>(0, 3) += d * d.transpose() / b.EA;
      v_rate->middleRows<3>(3).noalias() = C * moment;
      v_rate->middleRows<3>(3).noalias() += (C * cross(p.moment)) * turn;
      v_rate->bottomRows<3>().noalias() = cross(p.force) * v_rate->topRows<3>();
      v_rate->block<3, 3>(6, 3) -= cross(along);
    }
    return {.place = along,
            .turn = Vector3::Zero(),
            .force = b.weight * up(),
            .moment = p.force.cross(along),
            .q = product(p.q, curvature / 2)};
  }

  Packed rate(double s, const Packed& p, const RatesOfFirst* v, RatesOfFirst* v_rate) const {
    const BeamSection& b = piece_.section;
    const Matrix3 A = built(s);
    const Vector3 d = A.col(2);
    const Matrix3 C = A * compliance(b).asDiagonal() * A.transpose();
    const double stretch = p.force.dot(d) / b.EA + piece_.thermal_strain;
    if (v != nullptr) {
      const auto turn = v->middleRows<3>(3), force = v->middleRows<3>(6), moment = v->bottomRows<3>();
      v_rate->topRows<3>() = -cross(d) * turn + d * (d.transpose() * force) / b.EA;
      v_rate->middleRows<3>(3) = C * moment;
      v_rate->middleRows<3>(6).setZero();
      v_rate->bottomRows<3>() = -cross(d) * force;
      // columns of a turn of all axes as built
      const Matrix3 D = -cross(d);
      v_rate->topLeftCorner<3, 3>() += (1 + stretch) * D + cross(p.turn) * D + d * (p.force.transpose() * D) / b.EA;
      v_rate->block<3, 3>(3, 0) += C * cross(p.moment) - cross(C * p.moment);
      v_rate->block<3, 3>(9, 0) += cross(p.force) * D;
    }
    return {.place = (1 + stretch) * d + p.turn.cross(d),
            .turn = C * p.moment,
            .force = b.weight * up(),
            .moment = p.force.cross(d),
            .q = Eigen::Vector4d::Zero()};
  }

 private:
  const RodPiece& piece_;
  Matrix3 chord_;  ///< from the axes at the piece's start to those of the beam's chord
  Matrix3 start_;
};

RodState unpack(const RodPiece& piece, const Equation& equation, double s, const Packed& p) {
  RodState state{.place = p.place, .axes = Matrix3::Identity(), .turn = p.turn, .force = p.force, .moment = p.moment};
  state.axes = piece.order == BeamOrder::second ? quaternion(p.q).normalized().toRotationMatrix() : equation.built(s);
  return state;
}

template <class Rates>
RodState integrate(const RodPiece& piece, const RodState& start, std::vector<RodState>* each, Rates* v) {
  expects(piece.steps > 0 && piece.to > piece.from, "a piece has a length and at least one step");
  const Equation equation(piece, start.axes);
  const double h = (piece.to - piece.from) / piece.steps;
  const Eigen::Quaterniond q(start.axes);
  Packed p{.place = start.place,
           .turn = start.turn,
           .force = start.force,
           .moment = start.moment,
           .q = {q.w(), q.x(), q.y(), q.z()}};
  Rates v1, v2, v3, v4, next;
  for (int i = 0; i < piece.steps; ++i) {
    const double s = piece.from + i * h;
    const Packed k1 = equation.rate(s, p, v, &v1);
    if (v != nullptr) next = *v + h / 2 * v1;
    const Packed k2 = equation.rate(s + h / 2, p + h / 2 * k1, v != nullptr ? &next : nullptr, &v2);
    if (v != nullptr) next = *v + h / 2 * v2;
    const Packed k3 = equation.rate(s + h / 2, p + h / 2 * k2, v != nullptr ? &next : nullptr, &v3);
    if (v != nullptr) next = *v + h * v3;
    const Packed k4 = equation.rate(s + h, p + h * k3, v != nullptr ? &next : nullptr, &v4);
    p = p + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (v != nullptr) *v += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    if (each != nullptr) each->push_back(unpack(piece, equation, s + h, p));
  }
  return unpack(piece, equation, piece.to, p);
}

}  // namespace

double Bow::turn(double s) const { return angle == 0 ? 0 : angle * std::cos(std::numbers::pi * s / length); }

Matrix3 Bow::axes(const Matrix3& chord, double s) const {
  if (angle == 0) return chord;
  const Vector3 about(-towards.y(), towards.x(), 0);
  return chord * Eigen::AngleAxisd(turn(s), about).toRotationMatrix();
}

RodState along(const RodPiece& piece, const RodState& start, std::vector<RodState>* each) {
  return piece.order == BeamOrder::second ? integrate<RatesOfSecond>(piece, start, each, nullptr)
                                          : integrate<RatesOfFirst>(piece, start, each, nullptr);
}

RodState along(const RodPiece& piece, const RodState& start, RodRates& rates) {
  rates.setZero();
  rates.bottomRightCorner<9, 9>().setIdentity();
  if (piece.order == BeamOrder::first) return integrate(piece, start, nullptr, &rates);
  RatesOfSecond second = RatesOfSecond::Zero();
  second.block<3, 3>(3, 0).setIdentity();
  second.block<3, 3>(6, 6).setIdentity();
  const RodState end = integrate(piece, start, nullptr, &second);
  rates.topRightCorner<6, 9>() = second.topRows<6>();
  rates.bottomRightCorner<3, 9>() = second.bottomRows<3>();
  rates.leftCols<3>() = rates.middleCols<3>(3);
  return end;
}

SectionForces section_forces(const RodState& state) {
  const Vector3 f = state.axes.transpose() * state.force, m = state.axes.transpose() * state.moment;
  return {
      .axial = f.z(), .shear_x = f.x(), .shear_y = f.y(), .bends_to_x = m.y(), .bends_to_y = -m.x(), .torsion = m.z()};
}

Matrix3 cross(const Vector3& a) {
  Matrix3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

Vector3 sine_vector(const Matrix3& Q) {
  return {(Q(2, 1) - Q(1, 2)) / 2, (Q(0, 2) - Q(2, 0)) / 2, (Q(1, 0) - Q(0, 1)) / 2};
}

Matrix3 sine_by_left(const Matrix3& Q) { return (Q.trace() * Matrix3::Identity() - Q) / 2; }

Matrix3 sine_by_right(const Matrix3& Q) { return (Q.trace() * Matrix3::Identity() - Q.transpose()) / 2; }

}  // namespace taut::structure
