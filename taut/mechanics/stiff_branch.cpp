#include "taut/mechanics/stiff_branch.hpp"

#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/mechanics/branch_force.hpp"
#include "taut/rope/exact_end.hpp"

namespace taut::mechanics {
namespace {

constexpr double least_level = 1e-12;  ///< of the force: a rope in a vertical line has the limits of one beside it

const machine::Reeving& rope_at(const System& s, int index) {
  return s.model.reevings[s.layout.branches[index].reeving];
}

struct BranchEnds {
  BranchEnd from, to;
};

BranchEnds ends_of(const System& s, int index, const Configuration& c) {
  const Layout::Branch& l = s.layout.branches[index];
  const machine::Reeving& rope = rope_at(s, index);
  return {.from = end_at(rope.nodes[l.from], c.bodies), .to = end_at(rope.nodes[l.to], c.bodies)};
}

/// A line between the same ends with the same length: its strain is its tension.
rope::CatenaryRope unit_line(double length) { return {.length = length, .weight = 0, .stiffness = 1}; }

/// Where a rope with weight ends, seen from its start, at the force in its middle.
struct EndInSpace {
  Vector3 along = Vector3::UnitX();
  rope::CatenaryForce force;
};

EndInSpace in_plane(const rope::CatenaryRope& rope, const Vector3& F) {
  const double level = std::hypot(F.x(), F.y()), half = rope.weight * rope.length / 2;
  EndInSpace p;
  p.force = {.H = std::max(level, least_level * (std::abs(F.z()) + half)), .V = F.z()};
  if (level > 0) p.along = Vector3(F.x() / level, F.y() / level, 0);
  return p;
}

/// What is open between the end of a rope with weight and where it should be, in extended precision.
Vector3 open_end_of(const rope::CatenaryRope& rope, const Vector3& F, const Vector3& chord) {
  const EndInSpace p = in_plane(rope, F);
  const rope::ExactEnd end = rope::exact_end(rope, p.force);
  const math::TwoDoubles by_force = end.x / p.force.H;
  return {static_cast<double>(by_force * F.x() - chord.x()), static_cast<double>(by_force * F.y() - chord.y()),
          static_cast<double>(end.z - chord.z())};
}

Branch heavy_branch(const rope::CatenaryRope& rope, const BranchEnds& ends, const Vector3& F) {
  Branch b;
  const Vector3 half = rope.weight * rope.length / 2 * up();
  b.length = rope.length;
  b.pull_from = F - half;
  b.pull_to = F + half;
  b.T_from = b.pull_from.norm();
  b.T_to = b.pull_to.norm();
  b.leaves = b.T_from > 0 ? Vector3(b.pull_from / b.T_from) : -up();
  b.arrives = b.T_to > 0 ? Vector3(b.pull_to / b.T_to) : up();
  b.offset_from = tangent_offset(ends.from, b.leaves);
  b.offset_to = tangent_offset(ends.to, b.arrives);
  b.chord = ends.to.centre + b.offset_to - ends.from.centre - b.offset_from;
  const EndInSpace p = in_plane(rope, F);
  b.span.rope = rope;
  b.span.chord = b.chord;
  b.span.along = p.along;
  b.span.force = p.force;
  return b;
}

/// The straight line of a rope without weight takes its tension.
void pull_straight(const rope::CatenaryRope& rope, double T, Branch& b) {
  b.T_from = b.T_to = T;
  b.pull_from = b.pull_to = T * b.leaves;
  b.slack = T <= 0;
  b.span = {};
  b.span.rope = rope;
  b.span.chord = b.chord;
  const double x = std::hypot(b.chord.x(), b.chord.y());
  if (x > 0) b.span.along = Vector3(b.chord.x() / x, b.chord.y() / x, 0);
  b.span.slack = b.slack;
  if (!b.slack) b.span.force = {.H = T * std::hypot(b.leaves.x(), b.leaves.y()), .V = T * b.leaves.z()};
}

double stretching(const System& s, const machine::Reeving& rope, double T) {
  return T > 0 ? rope.stiffness : std::min(rope.stiffness, s.layout.slack_stiffness);
}

}  // namespace

int force_count(const machine::Reeving& rope) { return rope.weight > 0 ? 3 : 1; }

std::optional<Branch> stiff_branch(const System& s, int index, const Configuration& c, Eigen::VectorXd& residual) {
  const machine::Reeving& reeving = rope_at(s, index);
  const BranchEnds ends = ends_of(s, index, c);
  const int row = *s.layout.branches[index].force;
  const Vector3& F = c.forces[index];
  const rope::CatenaryRope rope = rope_of(reeving, c.branches[index].length);
  if (!(rope.length > 0) || !F.allFinite()) return std::nullopt;
  if (rope.weight > 0) {
    Branch b = heavy_branch(rope, ends, F);
    const Vector3 open = open_end_of(rope, F, b.chord);
    residual.segment<3>(row) = open;
    b.closure = b.span.closure = open.norm();
    return b;
  }
  const auto line = solve_branch(unit_line(rope.length), ends.from, ends.to, c.branches[index]);
  if (!line) return std::nullopt;
  Branch b = *line;
  residual[row] = s.layout.length * (line->T_from - F.x() / stretching(s, reeving, F.x()));
  pull_straight({.length = b.length, .weight = 0, .stiffness = reeving.stiffness}, F.x(), b);
  return b;
}

BranchRates stiff_rates(const BranchAt& at) {
  const Branch& b = at.branch;
  const BranchEnds ends = ends_of(at.system, at.index, at.c);
  if (rope_at(at.system, at.index).weight == 0) {
    BranchRates r = rates(unit_line(b.length), ends.from, ends.to, b);
    r.pull_from_X = r.pull_to_X = b.T_from * r.leaves_X;
    r.pull_from_u = r.pull_to_u = b.T_from * r.leaves_u;
    return r;
  }
  BranchRates r;
  const double half = b.span.rope.weight / 2;
  r.pull_from_u = -half * up();
  r.pull_to_u = half * up();
  if (b.T_from > 0) r.leaves_u = across(b.leaves) / b.T_from * r.pull_from_u;
  if (b.T_to > 0) r.arrives_u = across(b.arrives) / b.T_to * r.pull_to_u;
  r.offset_from_u = tangent_offset_rate(ends.from, b.leaves) * r.leaves_u;
  r.offset_to_u = tangent_offset_rate(ends.to, b.arrives) * r.arrives_u;
  return r;
}

namespace {

void add_heavy(const BranchAt& at, const BranchWays& ends, BranchColumns& columns, Entries& J) {
  const Branch& b = at.branch;
  const int row = *at.system.layout.branches[at.index].force;
  const BranchEnds l = ends_of(at.system, at.index, at.c);
  const rope::CatenaryRope& rope = b.span.rope;
  const rope::EndPosition p = rope::end_position(rope, b.span.force);
  const rope::EndRates by_length = rope::end_rates(rope, b.span.force);
  const Vector3& along = b.span.along;
  const Vector3 side(-along.y(), along.x(), 0);
  Matrix3 compliance = p.dx_dH * along * along.transpose() + p.x / b.span.force.H * side * side.transpose();
  compliance += p.dz_dV * up() * up().transpose();
  compliance += p.dx_dV * (along * up().transpose() + up() * along.transpose());
  const Matrix3 leaves = b.T_from > 0 ? Matrix3(across(b.leaves) / b.T_from) : Matrix3(Matrix3::Zero());
  const Matrix3 arrives = b.T_to > 0 ? Matrix3(across(b.arrives) / b.T_to) : Matrix3(Matrix3::Zero());
  const Matrix3 from = tangent_offset_rate(l.from, b.leaves) * leaves;
  const Matrix3 to = tangent_offset_rate(l.to, b.arrives) * arrives;
  // the columns of the ends' bodies, then the length
  const std::size_t own = as_size(columns.count - 1);
  for (std::size_t i = 0; i < own; ++i) J.add_below(row, columns.unknown[i], -ends[i]);
  J.add_below(row, columns.unknown[own],
              by_length.dx_dlength * along + by_length.dz_dlength * up() + columns.arm_from[own] - columns.arm_to[own]);
  const Matrix3 by_force = compliance + from - to;
  for (int i = 0; i < 3; ++i) {
    J.add_below(row, row + i, by_force.col(i));
    const std::size_t k = as_size(columns.count++);
    columns.unknown[k] = row + i;
    columns.length[k] = 0;
    columns.pull_from[k] = columns.pull_to[k] = Vector3::Unit(i);
    columns.leaves[k] = leaves.col(i);
    columns.arrives[k] = arrives.col(i);
    columns.arm_from[k] = from.col(i);
    columns.arm_to[k] = to.col(i);
  }
}

void add_line(const BranchAt& at, const BranchWays& ends, BranchColumns& columns, Entries& J) {
  const System& s = at.system;
  const Branch& b = at.branch;
  const int row = *s.layout.branches[at.index].force;
  const BranchEnds l = ends_of(s, at.index, at.c);
  const BranchRates strain = rates(unit_line(b.length), l.from, l.to, b);
  const double scale = s.layout.length;
  const std::size_t own = as_size(columns.count - 1);
  for (std::size_t i = 0; i < own; ++i) {
    J.add(row, columns.unknown[i], scale * b.leaves.dot(strain.pull_from_X * ends[i]));
  }
  J.add(row, columns.unknown[own], scale * b.leaves.dot(strain.pull_from_u));
  J.add(row, row, -scale / stretching(s, rope_at(s, at.index), b.T_from));
  const std::size_t k = as_size(columns.count++);
  columns.unknown[k] = row;
  columns.length[k] = 0;
  columns.pull_from[k] = columns.pull_to[k] = b.leaves;
  columns.leaves[k] = columns.arrives[k] = columns.arm_from[k] = columns.arm_to[k] = Vector3::Zero();
}

}  // namespace

void add_stiff_columns(const BranchAt& at, const BranchWays& ends, BranchColumns& columns, Entries& J) {
  rope_at(at.system, at.index).weight > 0 ? add_heavy(at, ends, columns, J) : add_line(at, ends, columns, J);
}

Layout with_forces(Layout layout, const machine::Model& model, double limit, double slack_stiffness) {
  layout.slack_stiffness = slack_stiffness;
  layout.stiffest = 0;
  for (Layout::Branch& laid : layout.branches) {
    const machine::Reeving& rope = model.reevings[laid.reeving];
    if (!(rope.stiffness > limit)) {
      layout.stiffest = std::max(layout.stiffest, rope.stiffness);
      continue;
    }
    laid.force = layout.size;
    layout.size += force_count(rope);
  }
  return layout;
}

Configuration with_forces(const System& s, Configuration c, const Evaluation& e) {
  c.forces.assign(c.branches.size(), Vector3::Zero());
  for (std::size_t k = 0; k < c.branches.size(); ++k) {
    if (!s.layout.branches[k].force) continue;
    const Branch& b = e.branches[k];
    const bool heavy = rope_at(s, static_cast<int>(k)).weight > 0;
    c.forces[k] = heavy ? Vector3((b.pull_from + b.pull_to) / 2) : Vector3(b.T_from, 0, 0);
  }
  return c;
}

}  // namespace taut::mechanics
