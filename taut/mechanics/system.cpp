#include "taut/mechanics/system.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/mechanics/rope_load.hpp"
#include "taut/mechanics/stiff_branch.hpp"

namespace taut::mechanics {
namespace {

const machine::Reeving& reeving_of(const System& s, int reeving) { return s.model.reevings[reeving]; }

/// Adds a force that acts at `place` to the balance of the freedoms of a body.
void add_force(const System& s, const Configuration& c, int body, const Vector3& place, const Vector3& force,
               Eigen::VectorXd& residual) {
  if (body == machine::ground) return;
  const Vector3 arm = place - c.bodies[body].position;
  for (int i = s.layout.first_dof[body]; i < s.layout.first_dof[as_size(body) + 1]; ++i) {
    const machine::Freedom& way = s.layout.dofs[i].way;
    residual[i] += force.dot(way.along) + way.about.dot(arm.cross(force));
  }
}

void add_dead_forces(const System& s, const Configuration& c, Eigen::VectorXd& residual) {
  for (std::size_t b = 0; b < s.model.bodies.size(); ++b) {
    const machine::Body& body = s.model.bodies[b];
    if (body.free.empty()) continue;
    const machine::Pose& pose = c.bodies[b];
    add_force(s, c, static_cast<int>(b), pose.position + pose.orientation * body.centre,
              -body.mass * s.model.gravity * up(), residual);
  }
  for (const machine::Load& load : s.model.loads) {
    if (load.at.body == machine::ground) continue;
    const machine::Pose& pose = c.bodies[load.at.body];
    add_force(s, c, load.at.body, pose.position + pose.orientation * load.at.at, load.force, residual);
  }
}

void add_ropes(const System& s, const Configuration& c, Evaluation& e) {
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const Branch& b = e.branches[k];
    if (b.slack) continue;
    const Layout::Branch& laid = s.layout.branches[k];
    const machine::Reeving& rope = reeving_of(s, laid.reeving);
    const machine::Node &from = rope.nodes[laid.from], &to = rope.nodes[laid.to];
    e.largest_force = std::max({e.largest_force, rope.copies * std::abs(b.T_from), rope.copies * std::abs(b.T_to)});
    add_force(s, c, from.at.body, end_at(from, c.bodies).centre + b.offset_from, rope.copies * b.pull_from, e.residual);
    add_force(s, c, to.at.body, end_at(to, c.bodies).centre + b.offset_to, -rope.copies * b.pull_to, e.residual);
  }
}

/// What the tensions beside a drive are off its torque, less what its bearing takes, N.
double drop_misfit(const System& s, const Evaluation& e, int turn) {
  const Layout::Turn& t = s.layout.turns[turn];
  const auto [by_in, by_out] = drop_rates(s, t);
  return by_in * e.branches[t.before].T_to + by_out * e.branches[t.after].T_from -
         node_of(s, t).tension_drop.value_or(0);
}

/// Whether the row of a turn is a length.
bool is_length(const System& s, const Layout::Turn& t) {
  const machine::NodeKind kind = node_of(s, t).kind;
  const auto& also = reeving_of(s, t.reeving).also;
  return kind == machine::NodeKind::clamp || kind == machine::NodeKind::load ||
         (kind == machine::NodeKind::drive && also && also->first == machine::Given::length);
}

/// Laws of the contacts, places of the clamps, given quantities.
void add_laws(const System& s, const Configuration& c, Evaluation& e) {
  for (const Layout::Rope& rope : s.layout.ropes) {
    const machine::Reeving& reeving = reeving_of(s, s.layout.branches[rope.first].reeving);
    double length = 0;
    int k = rope.first;
    for (int t = rope.first_turn; t < rope.first_turn + rope.turn_count; ++t) {
      const Layout::Turn& turn = s.layout.turns[t];
      for (; k < turn.after; ++k) length += c.branches[k].length;
      const machine::Node& node = node_of(s, turn);
      const double T_in = e.branches[turn.before].T_to, T_out = e.branches[turn.after].T_from;
      if (node.kind == machine::NodeKind::clamp) {
        e.residual[*turn.row] = length - node.length_before * (1 + reeving.thermal_strain);
      } else if (node.kind == machine::NodeKind::contact && node.tension_drop) {
        e.residual[*turn.row] = drop_misfit(s, e, t);
      } else if (node.kind == machine::NodeKind::contact) {
        const double g = s.losses * turn.flow * loss(node.law, e.bends[t]).log;
        e.residual[*turn.row] = T_out * std::exp(-g / 2) - T_in * std::exp(g / 2);
      }
      length += arc(s, e, t).length;
    }
    for (; k < rope.first + rope.count; ++k) length += c.branches[k].length;
    const auto open = [&](machine::Given given, double value) {
      switch (given) {
        case machine::Given::length:
          return length - value * (1 + reeving.thermal_strain);
        case machine::Given::tension_at_start:
          return e.branches[rope.first].T_from - value;
        case machine::Given::tension_at_end:
          return e.branches[rope.first + rope.count - 1].T_to - value;
        case machine::Given::equal:
          return e.branches[rope.first].T_from - e.branches[s.layout.ropes[as_size(reeving.equal_to)].first].T_from;
        case machine::Given::torque:
          break;
      }
      return drop_misfit(s, e, *rope.drive);
    };
    e.residual[rope.row] = open(reeving.given, reeving.value);
    const auto row = rope.drive ? s.layout.turns[*rope.drive].row : std::nullopt;
    if (!row) continue;
    e.residual[*row] = reeving.also ? open(reeving.also->first, reeving.also->second) : drop_misfit(s, e, *rope.drive);
  }
}

/// The prescribed coordinate, and the force that holds the carriage there.
void add_coordinate(const System& s, const Configuration& c, Evaluation& e) {
  if (!s.layout.coordinate_row) return;
  const int body = s.layout.coordinate_body;
  e.residual[*s.layout.coordinate_row] = s.layout.coordinate_along.dot(c.bodies[body].position) - s.coordinate;
  if (s.layout.height_row) e.residual[*s.layout.height_row] = c.bodies[body].position.z() - s.layout.height;
  if (!s.layout.hold) return;
  add_force(s, c, body, hold_place(s, c), c.hold * track(s, e), e.residual);
}

void keep_shape(const machine::Reeving& rope, const Branch& branch, machine::BranchState& state) {
  state.length = branch.length;
  state.leaves = branch.leaves;
  state.arrives = branch.arrives;
  state.force = rope.weight > 0 ? std::optional(branch.span.force) : std::nullopt;
}

}  // namespace

const machine::Node& node_of(const System& s, const Layout::Turn& t) {
  return s.model.reevings[t.reeving].nodes[t.node];
}

DropRates drop_rates(const System& system, const Layout::Turn& turn) {
  const double share = system.losses * turn.runs * bearing_share(node_of(system, turn).law);
  return {.by_in = 1 + share, .by_out = share - 1};
}

rope::CatenaryRope rope_of(const machine::Reeving& reeving, double length) {
  return {.length = length, .weight = reeving.weight / (1 + reeving.thermal_strain), .stiffness = reeving.stiffness};
}

BranchEnd end_at(const machine::Node& node, const Array<machine::Pose>& bodies) {
  BranchEnd end{.centre = node.at.at, .axis = node.axis, .radius = node.side < 0 ? -node.radius : node.radius};
  if (node.at.body != machine::ground) {
    const machine::Pose& pose = bodies[node.at.body];
    end.centre = pose.position + pose.orientation * node.at.at;
    end.axis = pose.orientation * node.axis;
  }
  return end;
}

ArcLength arc(const System& s, const Evaluation& e, int turn) {
  const Layout::Turn& t = s.layout.turns[turn];
  const machine::Node& node = node_of(s, t);
  const bool runs = s.losses > 0 || node.kind == machine::NodeKind::drive;
  return arc_length({.radius = node.radius,
                     .wrap = e.bends[turn].wrap.value,
                     .T_in = e.branches[t.before].T_to,
                     .T_out = e.branches[t.after].T_from,
                     .stiffness = reeving_of(s, t.reeving).stiffness,
                     .friction = node.law.friction,
                     .flow = runs ? t.runs : 0});
}

Vector3 track(const System& s, const Evaluation& e) {
  const int before = s.layout.turns[s.layout.hold->first_turn].before;
  const int after = s.layout.turns[s.layout.hold->last_turn].after;
  return (e.branches[before].arrives + e.branches[after].leaves).normalized();
}

Vector3 hold_place(const System& s, const Configuration& c) {
  const auto place = [&](int turn) { return end_at(node_of(s, s.layout.turns[turn]), c.bodies).centre; };
  return (place(s.layout.hold->first_turn) + place(s.layout.hold->last_turn)) / 2;
}

std::optional<NoBranch> evaluate(const System& s, Configuration& c, Evaluation& e) {
  e.branches.resize(s.layout.branches.size());
  e.bends.resize(s.layout.turns.size());
  e.residual.setZero(s.layout.size);
  e.largest_force = s.layout.heaviest;
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const Layout::Branch& laid = s.layout.branches[k];
    const machine::Reeving& rope = reeving_of(s, laid.reeving);
    if (laid.force) {
      const auto stiff = stiff_branch(s, static_cast<int>(k), c, e.residual);
      if (!stiff) return NoBranch{.branch = static_cast<int>(k), .why = rope::NoCatenary::not_converged};
      e.branches[k] = *stiff;
      keep_shape(rope, *stiff, c.branches[k]);
      c.branches[k].force = stiff->span.force;
      continue;
    }
    auto branch = solve_branch(rope_of(rope, c.branches[k].length), end_at(rope.nodes[laid.from], c.bodies),
                               end_at(rope.nodes[laid.to], c.bodies), c.branches[k]);
    if (!branch) return NoBranch{.branch = static_cast<int>(k), .why = branch.error()};
    e.branches[k] = *branch;
    keep_shape(rope, *branch, c.branches[k]);
  }
  for (std::size_t t = 0; t < s.layout.turns.size(); ++t) {
    const Layout::Turn& turn = s.layout.turns[t];
    const machine::Node& node = node_of(s, turn);
    e.bends[t] = bend(node, end_at(node, c.bodies), e.branches[turn.before].arrives, e.branches[turn.after].leaves);
  }
  add_dead_forces(s, c, e.residual);
  add_ropes(s, c, e);
  add_laws(s, c, e);
  add_rope_loads(s, c, e);
  add_coordinate(s, c, e);
  add_beams(s, c, e);
  return std::nullopt;
}

Change change_of(const System& system, const Configuration& c, const Evaluation& e, const Array<BranchColumns>& columns,
                 const Eigen::VectorXd& step) {
  Change change{.step = step, .force = Array<rope::CatenaryForce>(columns.size())};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (!c.branches[k].force || system.layout.branches[k].force) continue;
    Vector3 pull = Vector3::Zero();
    double length = 0;
    for (int i = 0; i < columns[k].count; ++i) {
      pull += columns[k].pull_from[as_size(i)] * step[columns[k].unknown[as_size(i)]];
      length += columns[k].length[as_size(i)] * step[columns[k].unknown[as_size(i)]];
    }
    const rope::Span& span = e.branches[k].span;
    const double half = span.rope.weight * length / 2;
    change.force[k] = {.H = span.along.dot(pull), .V = pull.z() + half};
  }
  return change;
}

void move(const System& s, const Configuration& c, const Change& change, double part, Configuration& moved) {
  moved = c;
  for (std::size_t i = 0; i < s.layout.dofs.size(); ++i) {
    const Layout::Dof& dof = s.layout.dofs[i];
    const double by = part * change.step[static_cast<Eigen::Index>(i)];
    machine::Pose& pose = moved.bodies[dof.body];
    pose.position += by * dof.way.along;
    if (dof.way.about == Vector3::Zero()) continue;
    pose.orientation = Eigen::AngleAxisd(by, dof.way.about).toRotationMatrix() * pose.orientation;
  }
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    machine::BranchState& state = moved.branches[k];
    state.length += part * change.step[s.layout.branches[k].unknown];
    if (const auto force = s.layout.branches[k].force) {
      const int count = force_count(reeving_of(s, s.layout.branches[k].reeving));
      moved.forces[k].head(count) += part * change.step.segment(*force, count);
      continue;
    }
    if (!state.force) continue;
    const rope::CatenaryForce& by = change.force[k];
    // a force that would turn round is no start
    if (state.force->H + part * by.H > 0.1 * state.force->H) {
      state.force->H += part * by.H;
      state.force->V += part * by.V;
    }
  }
  for (std::size_t r = 0; r < s.layout.ropes.size(); ++r) {
    if (const auto open = s.layout.ropes[r].open_load) moved.open_loads[r] += part * change.step[*open];
  }
  if (s.layout.hold) moved.hold += part * change.step[s.layout.hold->unknown];
  move_beams(s, change.step, part, moved);
}

Misfit misfit(const System& s, const Evaluation& e) {
  Misfit m;
  for (std::size_t i = 0; i < s.layout.dofs.size(); ++i) {
    const bool moment = s.layout.dofs[i].way.about != Vector3::Zero();
    m.force = std::max(m.force, std::abs(e.residual[static_cast<Eigen::Index>(i)]) / (moment ? s.layout.length : 1));
  }
  const auto length = [&](int row) { m.length = std::max(m.length, std::abs(e.residual[row])); };
  const auto force = [&](int row) { m.force = std::max(m.force, std::abs(e.residual[row])); };
  for (const Layout::Turn& turn : s.layout.turns) {
    if (!turn.row) continue;
    is_length(s, turn) ? length(*turn.row) : force(*turn.row);
  }
  for (std::size_t r = 0; r < s.layout.ropes.size(); ++r) {
    const int row = s.layout.ropes[r].row;
    const bool place = row == s.layout.coordinate_row || row == s.layout.height_row;
    s.model.reevings[r].given == machine::Given::length || place ? length(row) : force(row);
  }
  if (s.layout.hold) length(*s.layout.coordinate_row);
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    m.span = std::max(m.span, e.branches[k].closure);
    const Layout::Branch& laid = s.layout.branches[k];
    for (int i = 0; laid.force && i < force_count(reeving_of(s, laid.reeving)); ++i) length(*laid.force + i);
  }
  add_beam_misfit(s, e, m.force, m.length);
  return m;
}

}  // namespace taut::mechanics
