#include "taut/solve/tables.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/mechanics/rope_load.hpp"
#include "taut/rope/exact_end.hpp"
#include "taut/solve/beam_tables.hpp"
#include "taut/solve/stability.hpp"

namespace taut::solve {
namespace {

BranchResult branch_result(const mechanics::System& s, const mechanics::Configuration& c,
                           const mechanics::Evaluation& e, std::size_t k) {
  const mechanics::Layout::Branch& laid = s.layout.branches[k];
  const machine::Reeving& rope = s.model.reevings[laid.reeving];
  const mechanics::Branch& b = e.branches[k];
  BranchResult r;
  r.reeving = laid.reeving;
  r.from = laid.from;
  r.to = laid.to;
  r.slack = b.slack;
  r.T_from = b.slack ? 0 : b.T_from;
  r.T_to = b.slack ? 0 : b.T_to;
  r.H = b.slack ? 0 : std::hypot(b.pull_from.x(), b.pull_from.y());
  r.V_from = b.slack ? 0 : b.pull_from.z();
  r.V_to = b.slack ? 0 : b.pull_to.z();
  r.chord = b.chord.norm();
  const double length = c.branches[k].length;  // in this state: at the rope's temperature, of a running rope with its c
  r.unstretched = length / (1 + rope.thermal_strain);
  r.start = mechanics::end_at(rope.nodes[laid.from], c.bodies).centre + b.offset_from;
  r.end = mechanics::end_at(rope.nodes[laid.to], c.bodies).centre + b.offset_to;
  r.shape = b.span;
  if (rope.weight == 0 && !laid.force) {
    if (const auto straight = rope::solve_span(mechanics::rope_of(rope, length), b.chord)) r.shape = *straight;
  }
  r.stretched = b.slack ? length : rope::stretched_length(r.shape);
  r.sag = rope::largest_sag(r.shape);
  r.T_from_min = r.T_from_max = r.T_from;
  r.T_to_min = r.T_to_max = r.T_to;
  return r;
}

/// How far the end of a branch, at the given force, is from where it should be, m.
double open_end(const mechanics::Branch& b) {
  if (b.span.rope.weight == 0) return b.closure;
  const rope::ExactEnd end = rope::exact_end(b.span.rope, b.span.force);
  const double x = std::hypot(b.chord.x(), b.chord.y());
  const double open = std::hypot(static_cast<double>(end.x - x), static_cast<double>(end.z - b.chord.z()));
  return open + b.closure - b.span.closure;
}

/// Whether the rope presses away from what supports it.
bool pulled(const machine::Node& node, const mechanics::Bend& bend, const Vector3& force) {
  if (node.radius > 0) return bend.wrap.value < 0;
  return node.support != Vector3::Zero() && force.dot(node.support) > 0;
}

ContactState state_of(const machine::Node& node, const mechanics::Bend& bend, const Vector3& force, int flow) {
  if (node.kind != machine::NodeKind::contact) return ContactState::held;
  if (pulled(node, bend, force)) return ContactState::pulled;
  const bool turns = node.law.efficiency > 0;
  const bool lossless = node.law.efficiency == 1 || node.law.friction == 0;
  if (flow == 0) return lossless ? ContactState::turning : ContactState::stuck;
  const double grip = node.law.friction * bend.turning.value;
  const bool slips = !turns || (std::isfinite(node.law.friction) && grip < -std::log(node.law.efficiency));
  return slips ? ContactState::slipping : ContactState::turning;
}

ContactResult contact_of(const mechanics::System& s, const mechanics::Evaluation& e, int index) {
  const mechanics::Layout::Turn& turn = s.layout.turns[index];
  const mechanics::Branch &in = e.branches[turn.before], &out = e.branches[turn.after];
  const machine::Node& node = s.model.reevings[turn.reeving].nodes[turn.node];
  ContactResult r;
  r.reeving = turn.reeving;
  r.node = turn.node;
  r.T_in = in.slack ? 0 : in.T_to;
  r.T_out = out.slack ? 0 : out.T_from;
  r.wrap = e.bends[index].wrap.value;
  r.turning = node.kind == machine::NodeKind::contact ? e.bends[index].turning.value : std::max(0.0, r.wrap);
  r.unstretched = mechanics::arc(s, e, index).length / (1 + s.model.reevings[turn.reeving].thermal_strain);
  if (!in.slack) r.force -= in.pull_to;
  if (!out.slack) r.force += out.pull_from;
  r.state = state_of(node, e.bends[index], r.force, turn.flow);
  r.T_in_min = r.T_in_max = r.T_in;
  r.T_out_min = r.T_out_max = r.T_out;
  return r;
}

void fill_rope_loads(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                     EquilibriumResult& result) {
  for (int i = 0; i < static_cast<int>(s.layout.turns.size()); ++i) {
    const mechanics::Layout::Turn& turn = s.layout.turns[i];
    const machine::Node& node = s.model.reevings[turn.reeving].nodes[turn.node];
    if (node.kind != machine::NodeKind::load) continue;
    const mechanics::Branch &in = e.branches[turn.before], &out = e.branches[turn.after];
    RopeLoadResult r;
    r.reeving = turn.reeving;
    r.node = turn.node;
    r.at = c.bodies[node.at.body].position;
    r.along_path = rope_load(s, c, e, i);
    r.force = r.along_path * (in.arrives + out.leaves).normalized();
    r.T_in = in.T_to;
    r.T_out = out.T_from;
    result.rope_loads.push_back(r);
  }
}

void fill_contacts(const mechanics::System& s, const mechanics::Evaluation& e, const machine::State& state,
                   EquilibriumResult& result) {
  int turn = 0;
  for (int r = 0; r < static_cast<int>(s.model.reevings.size()); ++r) {
    const machine::Reeving& rope = s.model.reevings[r];
    const int last = static_cast<int>(rope.nodes.size()) - (rope.closed ? 0 : 1);
    for (int n = rope.closed ? 0 : 1; n < last; ++n) {
      if (state.touched[r][n]) {
        result.contacts.push_back(contact_of(s, e, turn++));
      } else {
        ContactResult lifted;
        lifted.reeving = r;
        lifted.node = n;
        lifted.state = ContactState::lifted;
        result.contacts.push_back(lifted);
      }
    }
  }
}

/// By its branches and contacts.
void fill_ropes(const mechanics::System& s, EquilibriumResult& result) {
  for (std::size_t r = 0; r < s.model.reevings.size(); ++r) {
    const mechanics::Layout::Rope& rope = s.layout.ropes[r];
    RopeResult row;
    row.branch = rope.first;
    for (int k = rope.first; k < rope.first + rope.count; ++k) {
      const BranchResult& branch = result.branches[k];
      row.unstretched += branch.unstretched;
      if (std::max(branch.T_from, branch.T_to) <= row.T_max) continue;
      row.branch = k;
      row.at_end = branch.T_to > branch.T_from;
      row.T_max = std::max(branch.T_from, branch.T_to);
    }
    for (const ContactResult& contact : result.contacts) {
      if (contact.reeving == static_cast<int>(r)) row.unstretched += contact.unstretched;
    }
    const double breaks = s.model.reevings[r].breaking_force;
    row.safety_factor = breaks > 0 && row.T_max > 0 ? breaks / row.T_max : 0;
    result.ropes.push_back(row);
  }
}

/// What is left of a force across the directions in which a body is free to move.
Vector3 across_freedoms(const machine::Body& body, Vector3 force) {
  Array<Vector3> basis;
  for (const machine::Freedom& way : body.free) {
    Vector3 d = way.along;
    for (const Vector3& b : basis) d -= b * b.dot(d);
    if (d.norm() > 1e-9) basis.push_back(d.normalized());
  }
  for (const Vector3& b : basis) force -= b * b.dot(force);
  return force;
}

/// Reactions, and all forces on the machine from outside together.
void fill_balance(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                  EquilibriumResult& result) {
  Array<Vector3> on_body(s.model.bodies.size(), Vector3::Zero());
  Vector3 outside = Vector3::Zero();
  const auto act = [&](int body, const Vector3& force) {
    if (body == machine::ground) {
      outside -= force;
    } else {
      on_body[body] += force;
    }
  };
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const mechanics::Branch& b = e.branches[k];
    if (b.slack) continue;
    const mechanics::Layout::Branch& laid = s.layout.branches[k];
    const machine::Reeving& rope = s.model.reevings[laid.reeving];
    act(rope.nodes[laid.from].at.body, rope.copies * b.pull_from);
    act(rope.nodes[laid.to].at.body, -rope.copies * b.pull_to);
    outside -= rope.copies * mechanics::rope_of(rope, 1).weight * c.branches[k].length * up();
  }
  act_beams(s, c, act, outside);
  const auto dead = [&](int body, const Vector3& force) {
    on_body[body] += force;
    outside += force;
  };
  for (std::size_t b = 0; b < on_body.size(); ++b) {
    dead(static_cast<int>(b), -s.model.bodies[b].mass * s.model.gravity * up());
  }
  for (const machine::Load& load : s.model.loads) {
    if (load.at.body != machine::ground) dead(load.at.body, load.force);
  }
  for (const RopeLoadResult& load : result.rope_loads) {
    const machine::Reeving& rope = s.model.reevings[load.reeving];
    dead(rope.nodes[load.node].at.body, rope.copies * load.force);
  }
  if (s.layout.hold) {
    result.hold = c.hold * track(s, e);
    dead(s.layout.coordinate_body, result.hold);
  }
  for (std::size_t b = 0; b < on_body.size(); ++b) {
    result.reactions.emplace_back(-across_freedoms(s.model.bodies[b], on_body[b]));
    outside += result.reactions.back();
  }
  result.closure.balance = outside.norm();
}

}  // namespace

void fill_tables(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                 const machine::State& state, EquilibriumResult& result) {
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) result.branches.push_back(branch_result(s, c, e, k));
  fill_contacts(s, e, state, result);
  fill_rope_loads(s, c, e, result);
  fill_ropes(s, result);
  fill_balance(s, c, e, result);
  result.beams = beam_results(s, c);
  result.indifferent = indifferent(s, c, e);
  const mechanics::Misfit m = mechanics::misfit(s, e);
  result.closure.rope = m.length;
  for (const mechanics::Branch& b : e.branches) result.closure.rope = std::max(result.closure.rope, open_end(b));
  result.closure.force = m.force;
}

}  // namespace taut::solve
