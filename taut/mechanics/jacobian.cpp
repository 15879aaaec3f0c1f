#include <Eigen/Geometry>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/mechanics/rope_load.hpp"
#include "taut/mechanics/stiff_branch.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::mechanics {
namespace {

using Columns = BranchColumns;

struct Assembly {
  const System& system;
  const Configuration& c;
  const Evaluation& e;
  Entries& J;
  Array<Columns>& columns;
};

/// `ends` gets how the way from centre to centre follows each column.
void add_columns_of_end(const BranchAt& at, const BranchRates& r, const BranchEnd& end, bool start, Columns& columns,
                        BranchWays& ends) {
  const Layout& layout = at.system.layout;
  const Branch& b = at.branch;
  const int body = start ? columns.from_body : columns.to_body;
  if (body == machine::ground) return;
  const Vector3 arm = end.centre - at.c.bodies[body].position;
  for (int i = layout.first_dof[body]; i < layout.first_dof[as_size(body) + 1]; ++i) {
    const machine::Freedom& way = layout.dofs[i].way;
    const int k = columns.count++;
    columns.unknown[as_size(k)] = i;
    const Vector3 turn = way.about.cross(arm);
    const Vector3 shift = offset_change(end, start ? b.leaves : b.arrives, way.about.cross(end.axis));
    const Vector3 X = (start ? -1 : 1) * (way.along + turn + shift);
    ends[as_size(k)] = X;
    columns.pull_from[as_size(k)] = r.pull_from_X * X;
    columns.pull_to[as_size(k)] = r.pull_to_X * X;
    columns.length[as_size(k)] = r.length_X.dot(X);
    columns.leaves[as_size(k)] = r.leaves_X * X;
    columns.arrives[as_size(k)] = r.arrives_X * X;
    columns.arm_from[as_size(k)] = r.offset_from_X * X;
    columns.arm_to[as_size(k)] = r.offset_to_X * X;
    (start ? columns.arm_from : columns.arm_to)[as_size(k)] += turn + shift;
  }
}

void fill_columns(const Assembly& a, int branch_index, Columns& columns) {
  const Layout::Branch& laid = a.system.layout.branches[branch_index];
  const machine::Reeving& rope = a.system.model.reevings[laid.reeving];
  const machine::Node &from = rope.nodes[laid.from], &to = rope.nodes[laid.to];
  const BranchEnd start = end_at(from, a.c.bodies), end = end_at(to, a.c.bodies);
  const Branch& b = a.e.branches[branch_index];
  const BranchAt at{.system = a.system, .c = a.c, .index = branch_index, .branch = b};
  const bool stiff = laid.force.has_value();
  const BranchRates r =
      stiff ? stiff_rates(at) : rates(rope_of(rope, a.c.branches[branch_index].length), start, end, b);
  BranchWays ends;
  columns.count = 0;
  columns.from_body = from.at.body;
  columns.to_body = to.at.body;
  add_columns_of_end(at, r, start, true, columns, ends);
  add_columns_of_end(at, r, end, false, columns, ends);
  const std::size_t k = as_size(columns.count++);
  columns.unknown[k] = laid.unknown;
  columns.length[k] = r.length_u;
  columns.pull_from[k] = r.pull_from_u;
  columns.pull_to[k] = r.pull_to_u;
  columns.leaves[k] = r.leaves_u;
  columns.arrives[k] = r.arrives_u;
  columns.arm_from[k] = r.offset_from_u;
  columns.arm_to[k] = r.offset_to_u;
  if (stiff) add_stiff_columns(at, ends, columns, a.J);
}

/// A branch's pull on the body at one of its ends: the force, its arm from the body's origin, and how both follow the
/// branch's columns.
struct EndPull {
  int body;
  const Vector3& F;
  Vector3 arm;
  const BranchWays &dF, &darm;
};

/// Rows of the body's freedoms from a pull.
void add_force_rows(Assembly& a, const EndPull& at, const Columns& columns, double factor) {
  if (at.body == machine::ground) return;
  const Layout& layout = a.system.layout;
  for (int i = layout.first_dof[at.body]; i < layout.first_dof[as_size(at.body) + 1]; ++i) {
    const machine::Freedom& way = layout.dofs[i].way;
    const bool turns = way.about != Vector3::Zero();
    for (std::size_t k = 0; k < as_size(columns.count); ++k) {
      const Vector3& dF = at.dF[k];
      double value = dF.dot(way.along);
      if (turns) value += way.about.dot(at.darm[k].cross(at.F) + at.arm.cross(dF));
      a.J.add(i, columns.unknown[k], factor * value);
    }
  }
}

void add_ropes(Assembly& a) {
  for (std::size_t k = 0; k < a.columns.size(); ++k) {
    const Branch& b = a.e.branches[k];
    if (b.slack) continue;
    const Layout::Branch& laid = a.system.layout.branches[k];
    const machine::Reeving& rope = a.system.model.reevings[laid.reeving];
    const Columns& columns = a.columns[k];
    const auto arm = [&](int node, int body, const Vector3& offset) -> Vector3 {
      if (body == machine::ground) return Vector3::Zero();
      return end_at(rope.nodes[node], a.c.bodies).centre + offset - a.c.bodies[body].position;
    };
    const Vector3 from = arm(laid.from, columns.from_body, b.offset_from);
    const Vector3 to = arm(laid.to, columns.to_body, b.offset_to);
    add_force_rows(
        a,
        {.body = columns.from_body, .F = b.pull_from, .arm = from, .dF = columns.pull_from, .darm = columns.arm_from},
        columns, rope.copies);
    add_force_rows(a,
                   {.body = columns.to_body, .F = b.pull_to, .arm = to, .dF = columns.pull_to, .darm = columns.arm_to},
                   columns, -rope.copies);
  }
}

/// A dead force turns with nothing; its arm does.
void add_dead_force(Assembly& a, int body, const Vector3& arm, const Vector3& F) {
  const Layout& layout = a.system.layout;
  for (int i = layout.first_dof[body]; i < layout.first_dof[as_size(body) + 1]; ++i) {
    const Vector3& row = layout.dofs[i].way.about;
    if (row == Vector3::Zero()) continue;
    for (int j = layout.first_dof[body]; j < layout.first_dof[as_size(body) + 1]; ++j) {
      a.J.add(i, j, row.dot(layout.dofs[j].way.about.cross(arm).cross(F)));
    }
  }
}

void add_dead_forces(Assembly& a) {
  const machine::Model& model = a.system.model;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const machine::Body& body = model.bodies[b];
    add_dead_force(a, static_cast<int>(b), a.c.bodies[b].orientation * body.centre, -body.mass * model.gravity * up());
  }
  for (const machine::Load& load : model.loads) {
    if (load.at.body == machine::ground) continue;
    add_dead_force(a, load.at.body, a.c.bodies[load.at.body].orientation * load.at.at, load.force);
  }
}

/// The derivatives of something at a turn by its tensions and by an angle there.
struct ByTurn {
  double in = 0, out = 0, angle = 0;
};

/// Adds the derivative of such a thing to a row.
void add_turn(Assembly& a, int turn, int row, const ByTurn& by, const Angle& angle) {
  const Layout::Turn& t = a.system.layout.turns[turn];
  const Columns &in = a.columns[t.before], &out = a.columns[t.after];
  const Vector3 &d_in = a.e.branches[t.before].arrives, &d_out = a.e.branches[t.after].leaves;
  for (std::size_t k = 0; k < as_size(in.count); ++k) {
    a.J.add(row, in.unknown[k], by.in * d_in.dot(in.pull_to[k]) + by.angle * angle.by_in.dot(in.arrives[k]));
  }
  for (std::size_t k = 0; k < as_size(out.count); ++k) {
    a.J.add(row, out.unknown[k], by.out * d_out.dot(out.pull_from[k]) + by.angle * angle.by_out.dot(out.leaves[k]));
  }
}

void add_drop(Assembly& a, int turn, int row) {
  const DropRates rates = drop_rates(a.system, a.system.layout.turns[turn]);
  add_turn(a, turn, row, {.in = rates.by_in, .out = rates.by_out}, {});
}

void add_arc(Assembly& a, int turn, int row) {
  const Layout::Turn& t = a.system.layout.turns[turn];
  const machine::Reeving& rope = a.system.model.reevings[t.reeving];
  const double radius = rope.nodes[t.node].radius;
  if (radius == 0) return;
  const ArcLength length = arc(a.system, a.e, turn);
  add_turn(a, turn, row, {.in = length.by_in, .out = length.by_out, .angle = length.by_wrap}, a.e.bends[turn].wrap);
}

void add_contact(Assembly& a, int turn) {
  const Layout::Turn& t = a.system.layout.turns[turn];
  const machine::Node& node = a.system.model.reevings[t.reeving].nodes[t.node];
  if (node.tension_drop) {
    add_drop(a, turn, *t.row);
    return;
  }
  const Loss lost = loss(node.law, a.e.bends[turn]);
  const double flow = a.system.losses * t.flow;
  const double in = std::exp(flow * lost.log / 2), out = 1 / in;
  const double T_in = a.e.branches[t.before].T_to, T_out = a.e.branches[t.after].T_from;
  const double by_angle = -(out * T_out + in * T_in) / 2 * flow * lost.by_turning;
  add_turn(a, turn, *t.row, {.in = -in, .out = out, .angle = by_angle}, a.e.bends[turn].turning);
}

/// The free length of a branch in a row.
void add_length(Assembly& a, int index, int row) {
  const Columns& columns = a.columns[index];
  for (std::size_t k = 0; k < as_size(columns.count); ++k) a.J.add(row, columns.unknown[k], columns.length[k]);
}

/// The end tension of a rope as a row, `sign` times.
void add_tension(Assembly& a, int index, bool start, int row, double sign = 1) {
  const Columns& columns = a.columns[index];
  const Branch& b = a.e.branches[index];
  for (std::size_t k = 0; k < as_size(columns.count); ++k) {
    const double rate = start ? b.leaves.dot(columns.pull_from[k]) : b.arrives.dot(columns.pull_to[k]);
    a.J.add(row, columns.unknown[k], sign * rate);
  }
}

/// What is given of a rope as a row.
void add_given(Assembly& a, const Layout::Rope& rope, machine::Given given, int equal_to, int row) {
  switch (given) {
    case machine::Given::length:
      for (int k = rope.first; k < rope.first + rope.count; ++k) add_length(a, k, row);
      for (int t = rope.first_turn; t < rope.first_turn + rope.turn_count; ++t) add_arc(a, t, row);
      break;
    case machine::Given::tension_at_start:
      add_tension(a, rope.first, true, row);
      break;
    case machine::Given::tension_at_end:
      add_tension(a, rope.first + rope.count - 1, false, row);
      break;
    case machine::Given::equal:
      add_tension(a, rope.first, true, row);
      add_tension(a, a.system.layout.ropes[as_size(equal_to)].first, true, row, -1);
      break;
    case machine::Given::torque:
      add_drop(a, *rope.drive, row);
      break;
  }
}

/// A clamp keeps the length of rope before it.
void add_clamp(Assembly& a, const Layout::Rope& rope, int turn) {
  const Layout::Turn& t = a.system.layout.turns[turn];
  for (int k = rope.first; k < t.after; ++k) add_length(a, k, *t.row);
  for (int before = rope.first_turn; before < turn; ++before) add_arc(a, before, *t.row);
}

void add_laws(Assembly& a) {
  const Layout& layout = a.system.layout;
  for (std::size_t r = 0; r < layout.ropes.size(); ++r) {
    const Layout::Rope& rope = layout.ropes[r];
    const machine::Reeving& reeving = a.system.model.reevings[r];
    const int last = rope.first_turn + rope.turn_count;
    for (int t = rope.first_turn; t < last; ++t) {
      const Layout::Turn& turn = layout.turns[t];
      if (!turn.row || turn.row == layout.coordinate_row) continue;
      const machine::NodeKind kind = reeving.nodes[turn.node].kind;
      if (kind == machine::NodeKind::contact) add_contact(a, t);
      if (kind == machine::NodeKind::clamp) add_clamp(a, rope, t);
    }
    if (rope.row != layout.coordinate_row && rope.row != layout.height_row) {
      add_given(a, rope, reeving.given, reeving.equal_to, rope.row);
    }
    const auto row = rope.drive ? layout.turns[*rope.drive].row : std::nullopt;
    if (row) add_given(a, rope, reeving.also ? reeving.also->first : machine::Given::torque, reeving.equal_to, *row);
  }
}

void add_coordinate(Assembly& a) {
  const Layout& layout = a.system.layout;
  if (!layout.coordinate_row) return;
  const int body = layout.coordinate_body;
  const int first = layout.first_dof[body], last = layout.first_dof[as_size(body) + 1];
  for (int i = first; i < last; ++i)
    a.J.add(*layout.coordinate_row, i, layout.dofs[i].way.along.dot(layout.coordinate_along));
  if (layout.height_row) {
    for (int i = first; i < last; ++i) a.J.add(*layout.height_row, i, layout.dofs[i].way.along.z());
  }
  if (!layout.hold) return;
  const std::size_t before = as_size(layout.turns[layout.hold->first_turn].before);
  const std::size_t after = as_size(layout.turns[layout.hold->last_turn].after);
  const Columns &in = a.columns[before], &out = a.columns[after];
  const Vector3 along = track(a.system, a.e);
  const double size = (a.e.branches[before].arrives + a.e.branches[after].leaves).norm();
  const Vector3 arm = hold_place(a.system, a.c) - a.c.bodies[body].position;
  const auto add = [&](int unknown, const Vector3& d, const Vector3& darm) {
    const Vector3 turn = a.c.hold / size * (d - along * along.dot(d));
    for (int i = first; i < last; ++i) {
      const machine::Freedom& way = layout.dofs[i].way;
      a.J.add(i, unknown, turn.dot(way.along) + way.about.dot(arm.cross(turn) + a.c.hold * darm.cross(along)));
    }
  };
  for (std::size_t k = 0; k < as_size(in.count); ++k) add(in.unknown[k], in.arrives[k], Vector3::Zero());
  for (std::size_t k = 0; k < as_size(out.count); ++k) add(out.unknown[k], out.leaves[k], Vector3::Zero());
  for (int j = first; j < last; ++j) add(j, Vector3::Zero(), layout.dofs[j].way.about.cross(arm));
  for (int i = first; i < last; ++i) {
    const machine::Freedom& way = layout.dofs[i].way;
    a.J.add(i, layout.hold->unknown, along.dot(way.along) + way.about.dot(arm.cross(along)));
  }
}

}  // namespace

void jacobian(const System& system, const Configuration& c, const Evaluation& e, Entries& J,
              Array<BranchColumns>& columns) {
  J.reset(system.layout.size);
  columns.resize(system.layout.branches.size());
  Assembly a{.system = system, .c = c, .e = e, .J = J, .columns = columns};
  for (int k = 0; k < static_cast<int>(columns.size()); ++k) fill_columns(a, k, columns[k]);
  add_ropes(a);
  add_dead_forces(a);
  add_laws(a);
  add_rope_loads(system, c, e, columns, J);
  add_coordinate(a);
  add_beam_rates(system, c, J);
}

}  // namespace taut::mechanics
