#include "taut/mechanics/rope_load.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::mechanics {
namespace {

bool is_load(const System& s, const Layout::Turn& t) { return node_of(s, t).kind == machine::NodeKind::load; }

/// The branches of the span in which a load stands: between it and the next nodes of other kinds.
struct LoadedSpan {
  int first = 0, last = 0;
};

LoadedSpan span_of(const System& s, int turn) {
  const Array<Layout::Turn>& turns = s.layout.turns;
  const Layout::Rope& rope = s.layout.ropes[turns[turn].reeving];
  int first = turn, last = turn;
  while (first > rope.first_turn && is_load(s, turns[first - 1])) --first;
  while (last + 1 < rope.first_turn + rope.turn_count && is_load(s, turns[last + 1])) ++last;
  return {.first = turns[first].before, .last = turns[last].after};
}

double length_between(const Configuration& c, int first, int last) {
  double length = 0;
  for (int k = first; k <= last; ++k) length += c.branches[k].length;
  return length;
}

/// The direction of the rope at a load, and the length of the sum of both unit vectors there.
struct Along {
  Vector3 d = Vector3::UnitX();
  double size = 2;
};

Along along(const Layout::Turn& t, const Evaluation& e) {
  const Vector3 sum = e.branches[t.before].arrives + e.branches[t.after].leaves;
  const double size = sum.norm();
  return {.d = size > 0 ? Vector3(sum / size) : Vector3(Vector3::UnitX()), .size = std::max(size, 1e-3)};
}

/// Rows of a load's point: its three translations.
int first_row(const System& s, const Layout::Turn& t) { return s.layout.first_dof[node_of(s, t).at.body]; }

int row_count(const System& s, const Layout::Turn& t) {
  return s.layout.first_dof[as_size(node_of(s, t).at.body) + 1] - first_row(s, t);
}

}  // namespace

double rope_load(const System& s, const Configuration& c, const Evaluation&, int turn) {
  const Layout::Turn& t = s.layout.turns[turn];
  const machine::RopeLoad& load = node_of(s, t).load;
  double force = load.open ? c.open_loads[t.reeving] : load.force;
  if (load.rate != 0) {
    const auto [first, last] = span_of(s, turn);
    force += load.rate * load.part * length_between(c, first, last);
  }
  return t.flow * force;
}

void add_rope_loads(const System& s, const Configuration& c, Evaluation& e) {
  for (int i = 0; i < static_cast<int>(s.layout.turns.size()); ++i) {
    const Layout::Turn& t = s.layout.turns[i];
    if (!is_load(s, t)) continue;
    const double force = s.model.reevings[t.reeving].copies * rope_load(s, c, e, i);
    const Vector3 d = along(t, e).d;
    for (int k = 0; k < row_count(s, t); ++k) {
      e.residual[first_row(s, t) + k] += force * d.dot(s.layout.dofs[first_row(s, t) + k].way.along);
    }
    e.largest_force = std::max(e.largest_force, std::abs(force));
    const auto [first, last] = span_of(s, i);
    e.residual[*t.row] = length_between(c, first, t.before) - node_of(s, t).load.share * length_between(c, first, last);
  }
}

namespace {

/// The row of a load's place: its share of the free length of its span.
void add_share_row(const System& s, const Layout::Turn& t, const LoadedSpan& span, const Array<BranchColumns>& columns,
                   Entries& J) {
  const double share = node_of(s, t).load.share;
  for (int k = span.first; k <= span.last; ++k) {
    const BranchColumns& free = columns[k];
    for (std::size_t i = 0; i < as_size(free.count); ++i) {
      J.add(*t.row, free.unknown[i], ((k <= t.before ? 1 : 0) - share) * free.length[i]);
    }
  }
}

}  // namespace

void add_rope_loads(const System& s, const Configuration& c, const Evaluation& e, const Array<BranchColumns>& columns,
                    Entries& J) {
  for (int turn = 0; turn < static_cast<int>(s.layout.turns.size()); ++turn) {
    const Layout::Turn& t = s.layout.turns[turn];
    if (!is_load(s, t)) continue;
    const machine::RopeLoad& load = node_of(s, t).load;
    const LoadedSpan span = span_of(s, turn);
    add_share_row(s, t, span, columns, J);
    const Along way = along(t, e);
    const double copies = s.model.reevings[t.reeving].copies;
    const double force = copies * rope_load(s, c, e, turn);
    const auto add = [&](int unknown, const Vector3& by) {
      for (int k = 0; k < row_count(s, t); ++k) {
        const int row = first_row(s, t) + k;
        J.add(row, unknown, by.dot(s.layout.dofs[row].way.along));
      }
    };
    const auto turned = [&](const Vector3& change) -> Vector3 {
      return force / way.size * (change - way.d * way.d.dot(change));
    };
    const BranchColumns &in = columns[t.before], &out = columns[t.after];
    for (std::size_t k = 0; k < as_size(in.count); ++k) add(in.unknown[k], turned(in.arrives[k]));
    for (std::size_t k = 0; k < as_size(out.count); ++k) add(out.unknown[k], turned(out.leaves[k]));
    for (int k = span.first; k <= span.last && load.rate != 0; ++k) {
      const BranchColumns& free = columns[k];
      for (std::size_t i = 0; i < as_size(free.count); ++i) {
        add(free.unknown[i], copies * t.flow * load.rate * load.part * free.length[i] * way.d);
      }
    }
    if (load.open) add(*s.layout.ropes[t.reeving].open_load, copies * t.flow * way.d);
  }
}

}  // namespace taut::mechanics
