#include "taut/mechanics/branch_force.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace taut::mechanics {
namespace {

constexpr int most_force_steps = 40;
constexpr int most_force_halvings = 30;
constexpr int line_steps = 8;           ///< of the straight line to its tangent points
constexpr int parts_of_radii = 8;       ///< rounds grown from points
constexpr double force_closes = 1e-11;  ///< of the size

Matrix3 cross_matrix(const Vector3& a) {
  Matrix3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

struct BranchProblem {
  rope::CatenaryRope rope;
  BranchEnd from, to;
  BranchDirections free;
  double size = 0;
};

/// How far the end of the rope is from its tangent point, and its length from what the arcs leave of it; the derivative
/// by the force and the length.
struct Gap {
  Vector4 open = Vector4::Zero();
  Matrix4 rate = Matrix4::Identity();
};

Gap gap(const BranchProblem& p, const BranchForce& at) {
  rope::CatenaryRope rope = p.rope;
  rope.length = at.length;
  const double half = rope.weight * rope.length / 2;
  // a rope in a vertical line has the limits of one beside it
  const double H = std::max(std::hypot(at.force.x(), at.force.y()), 1e-12 * (std::abs(at.force.z()) + half));
  Vector3 along(at.force.x() / H, at.force.y() / H, 0);
  if (along.norm() < 0.5) along = Vector3::UnitX();
  const rope::CatenaryForce f{.H = H, .V = at.force.z()};
  const rope::EndPosition end = rope::end_position(rope, f);
  const rope::EndRates by_length = rope::end_rates(rope, f);
  const Vector3 side(-along.y(), along.x(), 0), pull_from = at.force - half * up(), pull_to = at.force + half * up();
  const double T_from = pull_from.norm(), T_to = pull_to.norm();
  const BranchDirections now{.leaves = pull_from / T_from, .arrives = pull_to / T_to};
  Matrix3 compliance = end.dx_dH * along * along.transpose() + end.x / H * side * side.transpose();
  compliance += end.dz_dV * up() * up().transpose();
  compliance += end.dx_dV * (along * up().transpose() + up() * along.transpose());
  const Matrix3 leaves = across(now.leaves) / T_from, arrives = across(now.arrives) / T_to;
  const Vector3 leaves_L = -rope.weight / 2 * leaves.col(2), arrives_L = rope.weight / 2 * arrives.col(2);
  const Matrix3 N0 = tangent_offset_rate(p.from, now.leaves), N1 = tangent_offset_rate(p.to, now.arrives);
  const Vector3 arc0 = arc_rate(p.from, now.leaves, true), arc1 = arc_rate(p.to, now.arrives, false);
  Gap g;
  g.open.head<3>() = end.x * along + end.z * up() + tangent_offset(p.from, now.leaves) -
                     tangent_offset(p.to, now.arrives) - (p.to.centre - p.from.centre);
  g.open[3] = at.length + arcs_between(p.from, p.to, p.free, now) - p.rope.length;
  g.rate.topLeftCorner<3, 3>() = compliance + N0 * leaves - N1 * arrives;
  g.rate.topRightCorner<3, 1>() =
      by_length.dx_dlength * along + by_length.dz_dlength * up() + N0 * leaves_L - N1 * arrives_L;
  g.rate.bottomLeftCorner<1, 3>() = arc0.transpose() * leaves + arc1.transpose() * arrives;
  g.rate(3, 3) = 1 + arc0.dot(leaves_L) + arc1.dot(arrives_L);
  return g;
}

bool newton(const BranchProblem& p, BranchForce& at) {
  Gap now = gap(p, at);
  for (int step = 0; step < most_force_steps; ++step) {
    const double open = now.open.norm();
    if (!std::isfinite(open)) return false;
    if (open <= force_closes * p.size) return true;
    const Vector4 by = -now.rate.inverse() * now.open;
    if (!by.allFinite()) return false;
    bool better = false;
    double part = by[3] < -0.9 * at.length ? -0.9 * at.length / by[3] : 1;
    for (int k = 0; k < most_force_halvings && !better; ++k, part /= 2) {
      const BranchForce next{.force = at.force + part * by.head<3>(), .length = at.length + part * by[3]};
      const Gap then = gap(p, next);
      if (!(then.open.norm() < (1 - part / 10) * open)) continue;
      at = next;
      now = then;
      better = true;
    }
    if (!better) return false;
  }
  return false;
}

std::optional<BranchForce> force_of_chord(rope::CatenaryRope rope, const Vector3& chord) {
  // a rope that does not stretch is started as if it reached
  if (std::isinf(rope.stiffness)) rope.length = std::max(rope.length, 1.001 * chord.norm());
  const auto span = rope::solve_span(rope, chord);
  if (!span) return std::nullopt;
  return BranchForce{.force = span->force.H * span->along + span->force.V * up(), .length = rope.length};
}

/// From the straight line tangent to both rounds.
std::optional<BranchForce> from_line(const BranchProblem& p) {
  const BranchDirections line = straight_directions(p.from, p.to);
  const Vector3 chord =
      p.to.centre - p.from.centre + tangent_offset(p.to, line.arrives) - tangent_offset(p.from, line.leaves);
  if (!chord.allFinite() || chord.norm() < 1e-6 * p.size) return std::nullopt;
  rope::CatenaryRope rope = p.rope;
  rope.length -= arcs_between(p.from, p.to, p.free, line);
  if (!(rope.length > 0)) return std::nullopt;
  auto at = force_of_chord(rope, chord);
  if (at && newton(p, *at)) return at;
  return std::nullopt;
}

/// With rounds that grow from points.
std::optional<BranchForce> from_points(BranchProblem p) {
  const double from = p.from.radius, to = p.to.radius;
  auto at = force_of_chord(p.rope, p.to.centre - p.from.centre);
  for (int part = 1; at && part <= parts_of_radii; ++part) {
    p.from.radius = from * part / parts_of_radii;
    p.to.radius = to * part / parts_of_radii;
    if (!newton(p, *at)) return std::nullopt;
  }
  return at;
}

/// The angle from one direction to another about an axis, in (-pi, pi].
double angle_about(const Vector3& axis, const Vector3& from, const Vector3& to) {
  const Vector3 a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

}  // namespace

BranchDirections straight_directions(const BranchEnd& from, const BranchEnd& to) {
  const Vector3 X = to.centre - from.centre;
  Vector3 chord = X;
  for (int step = 0; step < line_steps; ++step) {
    const Vector3 direction = chord.normalized();
    chord = X + tangent_offset(to, direction) - tangent_offset(from, direction);
  }
  const Vector3 direction = chord.normalized();
  if (!direction.allFinite()) return {.leaves = X.normalized(), .arrives = X.normalized()};
  return {.leaves = direction, .arrives = direction};
}

double arcs_between(const BranchEnd& from, const BranchEnd& to, const BranchDirections& then,
                    const BranchDirections& now) {
  double arcs = 0;
  if (from.radius != 0) arcs += from.radius * angle_about(from.axis, then.leaves, now.leaves);
  if (to.radius != 0) arcs -= to.radius * angle_about(to.axis, then.arrives, now.arrives);
  return arcs;
}

Vector3 arc_rate(const BranchEnd& end, const Vector3& direction, bool leaves) {
  if (end.radius == 0) return Vector3::Zero();
  const Vector3 across_axis = direction - end.axis * end.axis.dot(direction);
  return (leaves ? end.radius : -end.radius) / across_axis.squaredNorm() * end.axis.cross(across_axis);
}

Vector3 tangent_offset(const BranchEnd& end, const Vector3& direction) {
  if (end.radius == 0) return Vector3::Zero();
  return end.radius * direction.cross(end.axis).normalized();
}

Matrix3 tangent_offset_rate(const BranchEnd& end, const Vector3& direction) {
  if (end.radius == 0) return Matrix3::Zero();
  const Vector3 m = direction.cross(end.axis);
  const double size = m.norm();
  return -end.radius / size * across(m / size) * cross_matrix(end.axis);
}

std::optional<BranchForce> branch_force(const rope::CatenaryRope& rope, const BranchEnd& from, const BranchEnd& to,
                                        const BranchDirections& free) {
  const double size = (to.centre - from.centre).norm() + std::abs(from.radius) + std::abs(to.radius);
  const BranchProblem p{.rope = rope, .from = from, .to = to, .free = free, .size = size};
  if (auto at = from_line(p)) return at;
  return from_points(p);
}

}  // namespace taut::mechanics
