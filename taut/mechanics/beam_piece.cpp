#include "taut/mechanics/beam_piece.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"

namespace taut::mechanics {
namespace {

using machine::BeamHold;
using structure::BeamOrder;
using structure::RodState;

Matrix3 turn_of(const Configuration& c, int body) {
  return body == machine::ground ? Matrix3(Matrix3::Identity()) : c.bodies[body].orientation;
}

/// From a body's origin to a place on it.
Vector3 arm_of(const Configuration& c, const machine::Place& place) {
  return place.body == machine::ground ? place.at : Vector3(turn_of(c, place.body) * place.at);
}

Vector3 in_ground(const Configuration& c, const machine::Place& place) {
  return place.body == machine::ground ? place.at : Vector3(c.bodies[place.body].position + arm_of(c, place));
}

/// A hinged start: the rotation of the section against what it stands on, the axis about which it may not turn, and the
/// direction in which its torque acts: the gradient of the twist by a turn of the section.
struct Hinge {
  Matrix3 Q;
  Vector3 axis, gradient;
  double twist = 0;
};

Hinge hinge_of(const Configuration& c, const machine::BeamPiece& piece, const machine::PieceState& state) {
  Hinge h;
  const Matrix3 held = turn_of(c, piece.start.body) * piece.start_axes;
  h.Q = state.axes * held.transpose();
  h.axis = held.col(2);
  h.twist = structure::sine_vector(h.Q).dot(h.axis);
  h.gradient = structure::sine_by_left(h.Q).transpose() * h.axis;
  return h;
}

/// The section at a piece's start, as it stands.
Matrix3 start_axes(const Configuration& c, const machine::BeamPiece& piece, const machine::PieceState& state) {
  return piece.start_hold == BeamHold::hinged ? state.axes : Matrix3(turn_of(c, piece.start.body) * piece.start_axes);
}

/// First order: from the section as built to the section as it stands.
Matrix3 small_turn(const Configuration& c, const machine::BeamPiece& piece, const Matrix3& stands) {
  return stands * (turn_of(c, piece.reference) * piece.reference_axes).transpose();
}

RodState start_of(const Configuration& c, const machine::BeamPiece& piece, const machine::PieceState& state) {
  RodState s;
  s.place = in_ground(c, piece.start);
  s.axes = start_axes(c, piece, state);
  if (piece.rod.order == BeamOrder::first) {
    s.turn = structure::sine_vector(small_turn(c, piece, s.axes));
    s.axes = turn_of(c, piece.reference) * piece.reference_axes;
  }
  s.force = state.force;
  s.moment =
      piece.start_hold == BeamHold::hinged ? Vector3(state.torque * hinge_of(c, piece, state).gradient) : state.moment;
  return s;
}

/// Rotation of a clamped end against the body that it ends on: second order Q of the end against the body, first order
/// of the body against the end as built.
Matrix3 end_rotation(const Configuration& c, const machine::BeamPiece& piece, const RodState& end) {
  const Matrix3 held = turn_of(c, piece.end.body) * piece.end_axes;
  return piece.rod.order == BeamOrder::second ? Matrix3(end.axes * held.transpose())
                                              : Matrix3(held * end.axes.transpose());
}

Vector3 end_turn(const Configuration& c, const machine::BeamPiece& piece, const RodState& end) {
  const Vector3 r = structure::sine_vector(end_rotation(c, piece, end));
  return piece.rod.order == BeamOrder::second ? r : Vector3(end.turn - r);
}

/// The force and moment of a section in the rows of the body that it stands on or ends at.
void add_force(const System& s, const Configuration& c, const machine::Place& place, const RodState& section,
               double factor, Eigen::VectorXd& residual) {
  if (place.body == machine::ground) return;
  const Vector3 all = arm_of(c, place).cross(section.force) + section.moment;
  for (int i = s.layout.first_dof[place.body]; i < s.layout.first_dof[as_size(place.body) + 1]; ++i) {
    const machine::Freedom& way = s.layout.dofs[i].way;
    residual[i] += factor * (section.force.dot(way.along) + all.dot(way.about));
  }
}

/// A small rotation of the axes of a hinged start.
Matrix3 turned(const Vector3& by, const Matrix3& axes) {
  const double angle = by.norm();
  return angle > 0 ? Matrix3(Eigen::AngleAxisd(angle, by / angle).toRotationMatrix() * axes) : axes;
}

/// One change of the unknowns as a piece feels it.
struct Input {
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();            ///< of its ends' places
  Vector3 start_body = Vector3::Zero(), end_body = Vector3::Zero();  ///< turns of the bodies there
  Vector3 section = Vector3::Zero();                                 ///< turn of the section at its start
  Vector3 reference = Vector3::Zero();                               ///< turn of the geometry as built
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();         ///< at its start
  double twist = 0;
};

/// What a section bears, and how that changes with one unknown.
struct SectionRate {
  const Vector3& turn;  ///< of the body there
  const Vector3& force;
  Vector3 dF, dM;
};

/// A piece with all its derivatives.
class PieceRates {
 public:
  PieceRates(const System& s, const Configuration& c, std::size_t index, Entries& J)
      : s_(s),
        c_(c),
        p_(s.layout.pieces[index]),
        piece_(piece_of(s, p_)),
        state_(c.pieces[index]),
        J_(J),
        start_(start_of(c, piece_, state_)),
        end_(along(piece_.rod, start_, rates_)) {
    if (p_.hinged) hinge_ = hinge_of(c, piece_, state_);
    if (first()) small_ = small_turn(c, piece_, start_axes(c, piece_, state_));
    Q_end_ = end_rotation(c, piece_, end_);
  }

  void add() {
    add_body(piece_.start.body, true, false, false);
    add_body(piece_.end.body, false, true, false);
    if (first()) add_body(piece_.reference, false, false, true);
    add_own();
  }

 private:
  bool first() const { return piece_.rod.order == BeamOrder::first; }

  void add_body(int body, bool start, bool end, bool reference) {
    if (body == machine::ground) return;
    for (int i = s_.layout.first_dof[body]; i < s_.layout.first_dof[as_size(body) + 1]; ++i) {
      const machine::Freedom& way = s_.layout.dofs[i].way;
      Input in;
      if (start) {
        in.start = way.along + way.about.cross(arm_of(c_, piece_.start));
        in.start_body = way.about;
        if (p_.hinged) {
          turn_hinge(Vector3::Zero(), way.about, in);
        } else {
          in.section = way.about;
        }
      }
      if (end) {
        in.end = way.along + way.about.cross(arm_of(c_, piece_.end));
        in.end_body = way.about;
      }
      if (reference) in.reference = way.about;
      add_column(i, in);
    }
  }

  /// A turn of the section, or of what it stands on, at a hinge: twist, and direction of the torque.
  void turn_hinge(const Vector3& section, const Vector3& body, Input& in) const {
    const Matrix3& Q = hinge_.Q;
    const Vector3 sine = structure::sine_vector(Q);
    in.section = section;
    in.twist = hinge_.gradient.dot(section - body);
    const double trace = 2 * sine.dot(body - section);
    const Vector3 transposed = body.cross(Q.transpose() * hinge_.axis) - Q.transpose() * section.cross(hinge_.axis);
    in.moment = state_.torque * ((trace * hinge_.axis - transposed) / 2 +
                                 structure::sine_by_left(Q).transpose() * body.cross(hinge_.axis));
  }

  void add_own() {
    for (int i = 0; i < 3; ++i) {
      Input in;
      in.force = Vector3::Unit(i);
      add_column(p_.unknown + i, in);
    }
    if (p_.hinged) {
      Input in;
      in.moment = hinge_.gradient;
      add_column(p_.unknown + 3, in);
    }
    for (int i = 0; i < 3; ++i) {
      Input in;
      if (p_.hinged) {
        turn_hinge(Vector3::Unit(i), Vector3::Zero(), in);
      } else {
        in.moment = Vector3::Unit(i);
      }
      add_column(p_.unknown + (p_.hinged ? 4 : 3) + i, in);
    }
  }

  void add_column(int column, const Input& in) {
    Eigen::Matrix<double, 12, 1> start;
    start << in.reference, first() ? small_by(in) : in.section, in.force, in.moment;
    if (!first()) start.head<3>().setZero();
    const Eigen::Matrix<double, 12, 1> end = rates_ * start;
    add_force_rows(column, piece_.start,
                   {.turn = in.start_body, .force = start_.force, .dF = in.force, .dM = in.moment}, 1);
    add_force_rows(column, piece_.end,
                   {.turn = in.end_body, .force = end_.force, .dF = end.segment<3>(6), .dM = end.tail<3>()}, -1);
    const int row = p_.unknown;
    J_.add_below(row, column, in.start + end.head<3>() - in.end);
    if (piece_.end_hold == BeamHold::hinged) {
      J_.add_below(row + 3, column, end.tail<3>());
    } else if (first()) {
      J_.add_below(row + 3, column,
                   end.segment<3>(3) - structure::sine_by_left(Q_end_) * in.end_body +
                       structure::sine_by_right(Q_end_) * in.reference);
    } else {
      J_.add_below(
          row + 3, column,
          structure::sine_by_left(Q_end_) * end.segment<3>(3) - structure::sine_by_right(Q_end_) * in.end_body);
    }
    if (p_.hinged) J_.add(row + 6, column, in.twist);
  }

  Vector3 small_by(const Input& in) const {
    return structure::sine_by_left(small_) * in.section - structure::sine_by_right(small_) * in.reference;
  }

  void add_force_rows(int column, const machine::Place& place, const SectionRate& by, double factor) {
    if (place.body == machine::ground) return;
    const Vector3 arm = arm_of(c_, place);
    const Vector3 all = by.turn.cross(arm).cross(by.force) + arm.cross(by.dF) + by.dM;
    for (int i = s_.layout.first_dof[place.body]; i < s_.layout.first_dof[as_size(place.body) + 1]; ++i) {
      const machine::Freedom& way = s_.layout.dofs[i].way;
      J_.add(i, column, factor * (by.dF.dot(way.along) + all.dot(way.about)));
    }
  }

  const System& s_;
  const Configuration& c_;
  const Layout::Piece& p_;
  const machine::BeamPiece& piece_;
  const machine::PieceState& state_;
  Entries& J_;
  structure::RodRates rates_;
  RodState start_, end_;
  Hinge hinge_;
  Matrix3 small_, Q_end_;
};

}  // namespace

const machine::BeamPiece& piece_of(const System& s, const Layout::Piece& p) {
  return s.model.beams[p.beam].pieces[p.piece];
}

structure::RodState piece_start(const System& s, const Configuration& c, std::size_t index) {
  return start_of(c, piece_of(s, s.layout.pieces[index]), c.pieces[index]);
}

void add_beams(const System& s, const Configuration& c, Evaluation& e) {
  for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) {
    const Layout::Piece& p = s.layout.pieces[k];
    const machine::BeamPiece& piece = piece_of(s, p);
    const RodState start = start_of(c, piece, c.pieces[k]);
    const RodState end = along(piece.rod, start);
    add_force(s, c, piece.start, start, 1, e.residual);
    add_force(s, c, piece.end, end, -1, e.residual);
    e.residual.segment<3>(p.unknown) = end.place - in_ground(c, piece.end);
    e.residual.segment<3>(p.unknown + 3) = piece.end_hold == BeamHold::hinged ? end.moment : end_turn(c, piece, end);
    if (p.hinged) e.residual[p.unknown + 6] = hinge_of(c, piece, c.pieces[k]).twist;
    e.largest_force = std::max({e.largest_force, start.force.norm(), end.force.norm(),
                                std::max(start.moment.norm(), end.moment.norm()) / s.layout.length});
  }
}

void add_beam_rates(const System& s, const Configuration& c, Entries& J) {
  for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) PieceRates(s, c, k, J).add();
}

void move_beams(const System& s, const Eigen::VectorXd& step, double part, Configuration& moved) {
  for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) {
    const Layout::Piece& p = s.layout.pieces[k];
    machine::PieceState& state = moved.pieces[k];
    state.force += part * step.segment<3>(p.unknown);
    if (p.hinged) {
      state.torque += part * step[p.unknown + 3];
      state.axes = turned(part * step.segment<3>(p.unknown + 4), state.axes);
    } else {
      state.moment += part * step.segment<3>(p.unknown + 3);
    }
  }
}

void add_beam_misfit(const System& s, const Evaluation& e, double& force, double& length) {
  for (const Layout::Piece& p : s.layout.pieces) {
    const double turn = e.residual.segment<3>(p.unknown + 3).cwiseAbs().maxCoeff();
    length = std::max(length, e.residual.segment<3>(p.unknown).cwiseAbs().maxCoeff());
    if (piece_of(s, p).end_hold == BeamHold::hinged) {
      force = std::max(force, turn / s.layout.length);
    } else {
      length = std::max(length, turn * s.layout.length);
    }
    if (p.hinged) length = std::max(length, std::abs(e.residual[p.unknown + 6]) * s.layout.length);
  }
}

void scale_beams(const System& s, Eigen::VectorXd& columns) {
  const double force = std::max(1.0, s.layout.heaviest);
  for (const Layout::Piece& p : s.layout.pieces) {
    columns.segment<3>(p.unknown).setConstant(force);
    columns.segment(p.unknown + 3, p.hinged ? 1 : 3).setConstant(force * s.layout.length);
    if (p.hinged) columns.segment<3>(p.unknown + 4).setOnes();
  }
}

}  // namespace taut::mechanics
