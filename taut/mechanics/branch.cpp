#include "taut/mechanics/branch.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "taut/mechanics/branch_force.hpp"

namespace taut::mechanics {
namespace {

constexpr int most_tangent_steps = 30;
constexpr double tangents_settled = 1e-14;  ///< of the size, for tangent points
constexpr double branch_closes = 1e-10;
constexpr double nearly = 2e-2;  ///< of the chord: one step of the span is enough
constexpr double steep = 1e-3;   ///< x/z of a span that is solved in its own way

/// Projection across a unit vector: d(v/|v|)/dv times |v|.

/// Derivatives by the chord and the length, tangent points apart.
struct SpanRates {
  Matrix3 pull = Matrix3::Zero(), leaves = Matrix3::Zero(), arrives = Matrix3::Zero();
  Vector3 pull_from_L = Vector3::Zero(), pull_to_L = Vector3::Zero();
  Vector3 leaves_L = Vector3::Zero(), arrives_L = Vector3::Zero();
};

/// The weightless rope as a straight two-sided spring.
void solve_straight(const rope::CatenaryRope& rope, Branch& b) {
  const double c = b.chord.norm();
  const Vector3 d = c > 0 ? Vector3(b.chord / c) : -up();
  b.leaves = b.arrives = d;
  b.T_from = b.T_to = rope.stiffness * (c / rope.length - 1);
  b.pull_from = b.pull_to = b.T_from * d;
  b.slack = b.T_from <= 0;
}

SpanRates straight_rates(const rope::CatenaryRope& rope, const Branch& b) {
  const Vector3& d = b.leaves;
  const double c = std::max(b.chord.norm(), 1e-9 * rope.length);
  SpanRates r;
  r.pull = rope.stiffness / rope.length * d * d.transpose() + b.T_from / c * across(d);
  r.leaves = r.arrives = across(d) / c;
  r.pull_from_L = r.pull_to_L = -rope.stiffness * c / (rope.length * rope.length) * d;
  return r;
}

/// Derivatives of the force in the middle, from those of the end's place.
rope::CatenaryStiffness stiffness_of(const rope::CatenaryRope& rope, const rope::CatenaryForce& f,
                                     const rope::EndPosition& p) {
  const double half = rope.weight * rope.length / 2, V0 = f.V - half, V1 = f.V + half;
  const double T0 = std::sqrt(f.H * f.H + V0 * V0), T1 = std::sqrt(f.H * f.H + V1 * V1);
  const double dx_dlength = f.H / rope.stiffness + f.H * (1 / T0 + 1 / T1) / 2;
  const double dz_dlength = f.V / rope.stiffness + (V0 / T0 + V1 / T1) / 2;
  const double determinant = p.dx_dH * p.dz_dV - p.dx_dV * p.dx_dV;
  rope::CatenaryStiffness k;
  k.dH_dx = p.dz_dV / determinant;
  k.dH_dz = -p.dx_dV / determinant;
  k.dV_dz = p.dx_dH / determinant;
  k.out_of_plane = f.H / p.x;
  k.dH_dlength = -(k.dH_dx * dx_dlength + k.dH_dz * dz_dlength);
  k.dV_dlength = -(k.dH_dz * dx_dlength + k.dV_dz * dz_dlength);
  return k;
}

/// One Newton step from a force that nearly closes the span. False: too far, or too steep for it.
bool step_sagging(const rope::CatenaryRope& rope, Branch& b, const rope::CatenaryForce& f) {
  const double x = std::hypot(b.chord.x(), b.chord.y());
  if (!(f.H > 0) || !(x > steep * std::abs(b.chord.z())) || !std::isfinite(f.V)) return false;
  const rope::EndPosition p = rope::end_position(rope, f);
  const double open_x = x - p.x, open_z = b.chord.z() - p.z;
  const double open = std::sqrt(open_x * open_x + open_z * open_z);
  if (!(open <= nearly * (x + std::abs(b.chord.z())))) return false;
  const rope::CatenaryStiffness k = stiffness_of(rope, f, p);
  const rope::CatenaryForce next{.H = f.H + k.dH_dx * open_x + k.dH_dz * open_z,
                                 .V = f.V + k.dH_dz * open_x + k.dV_dz * open_z};
  const bool near = next.H > f.H / 2 && next.H < 2 * f.H;  // false for NaN too
  if (!near) return false;
  b.span.rope = rope;
  b.span.chord = b.chord;
  b.span.along = Vector3(b.chord.x() / x, b.chord.y() / x, 0);
  b.span.force = next;
  b.span.closure = open;
  b.stiffness = k;
  return true;
}

bool solve_sagging(const rope::CatenaryRope& rope, Branch& b, const std::optional<rope::CatenaryForce>& start,
                   rope::NoCatenary& why) {
  b.stiffness.reset();
  if (!start || !step_sagging(rope, b, *start)) {
    auto span = rope::solve_span(rope, b.chord, start);
    if (!span) {
      why = span.error();
      return false;
    }
    b.span = *span;
  }
  b.pull_from = rope::force_on_start(b.span);
  b.pull_to = -rope::force_on_end(b.span);
  b.T_from = b.pull_from.norm();
  b.T_to = b.pull_to.norm();
  // no tension at an end: the rope hangs straight down in a loop, or ends at its lowest point
  b.leaves = b.T_from > 0 ? Vector3(b.pull_from / b.T_from) : -up();
  b.arrives = b.T_to > 0 ? Vector3(b.pull_to / b.T_to) : up();
  return true;
}

SpanRates sagging_rates(const Branch& b) {
  SpanRates r;
  const rope::CatenaryStiffness k = b.stiffness ? *b.stiffness : rope::stiffness(b.span.rope, b.span.force);
  const Vector3& along = b.span.along;
  const Vector3 side(-along.y(), along.x(), 0);
  r.pull = k.dH_dx * along * along.transpose() + k.out_of_plane * side * side.transpose();
  r.pull.col(2) += k.dH_dz * along;
  r.pull.row(2) += k.dH_dz * along.transpose();
  r.pull(2, 2) += k.dV_dz;
  const Vector3 by_length = k.dH_dlength * along + k.dV_dlength * up();
  r.pull_from_L = by_length - b.span.rope.weight / 2 * up();
  r.pull_to_L = by_length + b.span.rope.weight / 2 * up();
  if (b.T_from > 0) {
    const Matrix3 turn = across(b.leaves) / b.T_from;
    r.leaves = turn * r.pull;
    r.leaves_L = turn * r.pull_from_L;
  }
  if (b.T_to > 0) {
    const Matrix3 turn = across(b.arrives) / b.T_to;
    r.arrives = turn * r.pull;
    r.arrives_L = turn * r.pull_to_L;
  }
  return r;
}

SpanRates span_rates(const rope::CatenaryRope& rope, const Branch& b) {
  return rope.weight > 0 ? sagging_rates(b) : straight_rates(rope, b);
}

/// How far chord and length move away from what their own tangent points leave, by chord and length.
Eigen::Matrix4d tangent_rates(const rope::CatenaryRope& rope, const BranchEnd& from, const BranchEnd& to,
                              const Branch& b) {
  const SpanRates r = span_rates(rope, b);
  const Matrix3 N0 = tangent_offset_rate(from, b.leaves), N1 = tangent_offset_rate(to, b.arrives);
  const Vector3 arc0 = arc_rate(from, b.leaves, true), arc1 = arc_rate(to, b.arrives, false);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() += N0 * r.leaves - N1 * r.arrives;
  m.topRightCorner<3, 1>() = N0 * r.leaves_L - N1 * r.arrives_L;
  m.bottomLeftCorner<1, 3>() = arc0.transpose() * r.leaves + arc1.transpose() * r.arrives;
  m(3, 3) += arc0.dot(r.leaves_L) + arc1.dot(r.arrives_L);
  return m;
}

}  // namespace

namespace {

/// Closes chord, tangent points and free length, from `start`.
std::optional<rope::NoCatenary> close(rope::CatenaryRope rope, const BranchEnd& from, const BranchEnd& to,
                                      const BranchDirections& free, const machine::BranchState& start, Branch& b) {
  const Vector3 X = to.centre - from.centre;
  const bool round = from.radius != 0 || to.radius != 0;
  const double given = rope.length;
  b.chord = X;
  if (round) {
    b.chord += tangent_offset(to, start.arrives) - tangent_offset(from, start.leaves);
    rope.length = start.length;
  }
  const double size = X.norm() + std::abs(from.radius) + std::abs(to.radius);
  auto force = start.force;
  for (int step = 0; step < most_tangent_steps; ++step) {
    rope::NoCatenary why{};
    // a step of the solver, or of the chord, that went out of all bounds
    if (!b.chord.allFinite() || !(rope.length > 0)) return rope::NoCatenary::not_converged;
    b.length = rope.length;
    if (rope.weight == 0) {
      solve_straight(rope, b);
    } else if (!solve_sagging(rope, b, force, why)) {
      return why;
    }
    force = b.span.force;
    if (!round) break;
    b.offset_from = tangent_offset(from, b.leaves);
    b.offset_to = tangent_offset(to, b.arrives);
    Eigen::Vector4d open;
    open << X + b.offset_to - b.offset_from - b.chord,
        given - arcs_between(from, to, free, {.leaves = b.leaves, .arrives = b.arrives}) - rope.length;
    b.closure = open.norm();
    if (b.closure <= tangents_settled * size) break;
    if (!std::isfinite(b.closure)) return rope::NoCatenary::not_converged;
    const Eigen::Vector4d by = tangent_rates(rope, from, to, b).inverse() * open;
    b.chord += by.head<3>();
    rope.length += by[3];
  }
  if (!(b.closure <= branch_closes * size)) return rope::NoCatenary::not_converged;
  b.closure += b.span.closure;
  return std::nullopt;
}

}  // namespace

tl::expected<Branch, rope::NoCatenary> solve_branch(const rope::CatenaryRope& rope, const BranchEnd& from,
                                                    const BranchEnd& to, const machine::BranchState& start) {
  Branch b;
  const bool round = from.radius != 0 || to.radius != 0;
  machine::BranchState near = start;
  near.length = rope.length;
  const bool known = start.leaves != Vector3::Zero() && start.arrives != Vector3::Zero();
  BranchDirections free{.leaves = start.leaves, .arrives = start.arrives};
  if (round && !known) {
    free = straight_directions(from, to);
    near.leaves = free.leaves;
    near.arrives = free.arrives;
  }
  const auto no = close(rope, from, to, free, near, b);
  if (!no) return b;
  const bool finite = to.centre.allFinite() && from.centre.allFinite();
  if (!round || rope.weight == 0 || !(rope.length > 0) || !finite) return tl::unexpected(*no);
  const auto at = branch_force(rope, from, to, free);
  if (!at) return tl::unexpected(*no);
  const Vector3 half = rope.weight * at->length / 2 * up();
  near = {.length = at->length,
          .leaves = (at->force - half).normalized(),
          .arrives = (at->force + half).normalized(),
          .force = rope::CatenaryForce{.H = std::hypot(at->force.x(), at->force.y()), .V = at->force.z()}};
  b = {};
  if (close(rope, from, to, free, near, b)) return tl::unexpected(*no);
  return b;
}

BranchRates rates(const rope::CatenaryRope& rope, const BranchEnd& from, const BranchEnd& to, const Branch& b) {
  const SpanRates s = span_rates(rope, b);
  BranchRates r;
  r.pull_from_X = r.pull_to_X = s.pull;
  r.leaves_X = s.leaves;
  r.arrives_X = s.arrives;
  r.pull_from_u = s.pull_from_L;
  r.pull_to_u = s.pull_to_L;
  r.leaves_u = s.leaves_L;
  r.arrives_u = s.arrives_L;
  if (from.radius == 0 && to.radius == 0) return r;
  // chord and length follow their own tangent points: M (dchord, dL) = (dX, du)
  const Eigen::Matrix4d follow = tangent_rates(rope, from, to, b).inverse();
  const Matrix3 chord_X = follow.topLeftCorner<3, 3>();
  const Vector3 chord_u = follow.topRightCorner<3, 1>();
  r.length_X = follow.bottomLeftCorner<1, 3>().transpose();
  r.length_u = follow(3, 3);
  const auto by_X = [&](const Matrix3& chord, const Vector3& length) -> Matrix3 {
    return chord * chord_X + length * r.length_X.transpose();
  };
  const auto by_u = [&](const Matrix3& chord, const Vector3& length) -> Vector3 {
    return chord * chord_u + length * r.length_u;
  };
  r.pull_from_X = by_X(s.pull, s.pull_from_L);
  r.pull_to_X = by_X(s.pull, s.pull_to_L);
  r.leaves_X = by_X(s.leaves, s.leaves_L);
  r.arrives_X = by_X(s.arrives, s.arrives_L);
  r.pull_from_u = by_u(s.pull, s.pull_from_L);
  r.pull_to_u = by_u(s.pull, s.pull_to_L);
  r.leaves_u = by_u(s.leaves, s.leaves_L);
  r.arrives_u = by_u(s.arrives, s.arrives_L);
  const Matrix3 N0 = tangent_offset_rate(from, b.leaves), N1 = tangent_offset_rate(to, b.arrives);
  r.offset_from_X = N0 * r.leaves_X;
  r.offset_to_X = N1 * r.arrives_X;
  r.offset_from_u = N0 * r.leaves_u;
  r.offset_to_u = N1 * r.arrives_u;
  return r;
}

Vector3 offset_change(const BranchEnd& end, const Vector3& direction, const Vector3& axis_change) {
  if (end.radius == 0) return Vector3::Zero();
  const Vector3 m = direction.cross(end.axis);
  const double size = m.norm();
  return end.radius / size * across(m / size) * direction.cross(axis_change);
}

}  // namespace taut::mechanics
