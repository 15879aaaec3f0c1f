#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/machine/rounds.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/tangent.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {
namespace {

/// Inner nodes on the straight line of a branch.
void add_inside(const machine::State& state, const machine::Node& from, const machine::Node& to, int segments,
                DynamicState::Rope& rope) {
  if (segments <= 1) return;
  const auto line = rope::tangent_line(round_at(state, from), round_at(state, to));
  const Vector3 start = line ? line->from : machine::in_ground(state, from.at);
  const Vector3 end = line ? line->to : machine::in_ground(state, to.at);
  for (int s = 1; s < segments; ++s) rope.inside.emplace_back(start + (end - start) * s / segments);
}

/// Tension that the description gives a branch; a rope over a drive has one on either side. None: not known.
std::optional<double> given_tension(const machine::Reeving& rope, std::size_t branch) {
  using machine::Given;
  if (rope.given == Given::torque) return {};
  if (!rope.also) return rope.given == Given::length ? std::optional<double>() : rope.value;
  const auto drive = std::find_if(rope.nodes.begin(), rope.nodes.end(),
                                  [](const machine::Node& node) { return node.motor.has_value(); });
  const bool before = static_cast<std::ptrdiff_t>(branch) < drive - rope.nodes.begin();
  const Given side = before ? Given::tension_at_start : Given::tension_at_end;
  if (rope.given == side) return rope.value;
  return rope.also->first == side ? rope.also->second : std::optional<double>();
}

/// Unstretched lengths of a rope's branches at the start: by the tensions that are given, the others share what is
/// left.
Array<double> lengths_of(const machine::State& state, const machine::Reeving& rope,
                         const Array<machine::BranchState>& found) {
  Array<double> lengths;
  double whole = 0, known = 0, others = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const machine::Node &from = rope.nodes[k], &to = rope.nodes[(k + 1) % rope.nodes.size()];
    const auto tension = given_tension(rope, k);
    lengths.push_back(tension ? machine::straight_length(state, from, to) / (1 + *tension / rope.stiffness)
                              : found[k].length);
    whole += found[k].length;
    (tension ? known : others) += lengths.back();
  }
  const bool shares = rope.given == machine::Given::length && rope.also && others > 0 && whole > known;
  for (std::size_t k = 0; k < found.size() && shares; ++k) {
    if (!given_tension(rope, k)) lengths[k] *= (whole - known) / others;
  }
  return lengths;
}

}  // namespace

DynamicState state_from(const machine::Model& model, const machine::State& state) {
  DynamicState start;
  for (const machine::Pose& pose : state.bodies) {
    start.bodies.push_back({pose.position, pose.orientation, Vector3::Zero(), Vector3::Zero()});
  }
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    const machine::Reeving& given = model.reevings[r];
    DynamicState::Rope rope;
    const int segments = std::max(1, given.segments);
    const Array<double> lengths = lengths_of(state, given, state.branches[r]);
    for (std::size_t k = 0; k < state.branches[r].size(); ++k) {
      const machine::Node &from = given.nodes[k], &to = given.nodes[(k + 1) % given.nodes.size()];
      for (int s = 0; s < segments; ++s) rope.length.push_back(lengths[k] / segments);
      const bool known = given.given == machine::Given::length;
      rope.leaves.push_back(known ? state.branches[r][k].leaves : Vector3(Vector3::Zero()));
      rope.arrives.push_back(known ? state.branches[r][k].arrives : Vector3(Vector3::Zero()));
      add_inside(state, from, to, segments, rope);
      if (segments > 1 && to.kind == machine::NodeKind::load) rope.inside.push_back(machine::in_ground(state, to.at));
    }
    rope.whole.assign(rope.length.size(), 1);
    rope.inside_velocity.assign(rope.inside.size(), Vector3::Zero());
    start.ropes.push_back(std::move(rope));
  }
  return start;
}

namespace {

/// Rope on the round of an inner node between two straight branches, m.
double arc_on(const machine::State& state, const machine::Reeving& given, std::size_t node) {
  const machine::Node& here = given.nodes[node];
  if (here.radius == 0) return 0;
  const std::size_t nodes = given.nodes.size();
  const rope::Round round = round_at(state, here);
  const auto before = rope::tangent_line(round_at(state, given.nodes[(node + nodes - 1) % nodes]), round);
  const auto behind = rope::tangent_line(round, round_at(state, given.nodes[(node + 1) % nodes]));
  if (!before || !behind) return 0;
  double wrap = rope::wrap_angle(here.side, before->angle_to, behind->angle_from);
  if (wrap >= 1.5 * std::numbers::pi) wrap -= 2 * std::numbers::pi;  // the rope passes above the round
  return here.radius * (wrap + 2 * std::numbers::pi * here.turns);
}

/// The rope before a clamp and behind it, as far as the next one, has the length that the description says, with what
/// lies on its rounds. A taut one has one strain, there as well.
void keep_lengths(const machine::Model& model, machine::State& state) {
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    if (rope.given != machine::Given::length) continue;
    Array<machine::BranchState>& branches = state.branches[r];
    const std::size_t nodes = rope.nodes.size();
    double from = 0, rigid = 0, stretches = 0, straight = 0, free = 0;
    std::size_t first = 0;
    const auto on_round = [&](std::size_t node) {
      const double arc = arc_on(state, rope, node), wrap = arc / std::max(rope.nodes[node].radius, 1e-300);
      const double share = share_that_stretches(rope.nodes[node], wrap);
      stretches += share * arc;
      rigid += (1 - share) * arc;
    };
    if (rope.closed) on_round(0);
    for (std::size_t k = 0; k < branches.size(); ++k) {
      const std::size_t node = (k + 1) % nodes;
      free += branches[k].length;
      straight += machine::straight_length(state, rope.nodes[k], rope.nodes[node]);
      const bool last = k + 1 == branches.size(), clamp = !last && rope.nodes[node].kind == machine::NodeKind::clamp;
      if (!last && !clamp) on_round(node);
      if (!last && !clamp) continue;
      const double to = (clamp ? rope.nodes[node].length_before : rope.value) * (1 + rope.thermal_strain);
      const double slack = to - from - rigid - stretches;
      const double left = straight > slack ? (to - from - rigid) * straight / (straight + stretches) : slack;
      for (std::size_t i = first; i <= k && left > 0 && slack > 0 && free > 0; ++i) branches[i].length *= left / free;
      from = to;
      free = straight = rigid = stretches = 0;
      first = k + 1;
    }
  }
}

}  // namespace

double share_that_stretches(const machine::Node& node, double wrap) {
  const bool turns = node.motor.has_value() || (node.inertia > 0 && node.law.efficiency > 0);
  const double grip = node.law.friction * wrap;
  const bool rolls = node.law.efficiency > 0 && -std::log(node.law.efficiency) <= grip;
  if (turns || wrap <= 0 || rolls) return 1;
  return std::isinf(grip) ? 0 : grip > 0 ? std::tanh(grip / 2) / (grip / 2) : 1;
}

DynamicState assembled(const machine::Model& model) {
  machine::State state = machine::initial_state(model);
  keep_lengths(model, state);
  return state_from(model, state);
}

DynamicState state_of(const Mechanism& m, const Values& v, const DynamicState& before) {
  DynamicState state = before;
  state.t = v.t;
  const machine::Model& model = *m.model;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Motion3& is = v.bodies[b];
    state.bodies[b] = {is.x, is.R, is.v, is.w};
  }
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    DynamicState::Rope& rope = state.ropes[r];
    const auto [first, lines] = m.first_line[r];
    rope.whole.resize(as_size(lines));
    rope.on_rounds.clear();
    bool stretches = false;
    if (std::max(1, model.reevings[r].segments) == 1) {
      rope.leaves.assign(as_size(lines), Vector3::Zero());
      rope.arrives = rope.leaves;
    }
    for (int i = 0; i < lines; ++i) {
      const LineValues& line = v.lines[first + i];
      const bool whole = line.gone > 0;
      rope.length[i] = whole ? free_rope(line) : line.L;
      for (const std::size_t end : {0U, 1U}) rope.on_rounds.push_back(whole ? line.arc[end] : 0);
      stretches = stretches || m.lines[first + i].arcs[0] || m.lines[first + i].arcs[1];
      rope.whole[i] = v.lines[first + i].gone > 0 ? 1 : 0;
      if (!sags(m.lines[first + i], v.lines[first + i])) continue;
      const SagValues& shape = v.sags[m.lines[first + i].sag];
      rope.leaves[i] = shape.direction[0];
      rope.arrives[i] = shape.direction[1];
    }
    if (!stretches) rope.on_rounds.clear();
    const std::size_t nodes = model.reevings[r].nodes.size();
    rope.angle.assign(nodes, 0.0);
    rope.spin = rope.passed = rope.wrap = rope.angle;
    rope.inside.clear();
    rope.inside_velocity.clear();
    for (const int body : m.inside[r]) {
      rope.inside.push_back(v.bodies[body].x);
      rope.inside_velocity.push_back(v.bodies[body].v);
    }
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    DynamicState::Rope& rope = state.ropes[contact.reeving];
    rope.passed[contact.node] = v.q[contact.column];
    rope.wrap[contact.node] = wrap_of(m, i, v);
    if (contact.spin < 0) continue;
    rope.angle[contact.node] = contact.sense * v.spins[contact.spin].angle;
    rope.spin[contact.node] = contact.sense * v.spins[contact.spin].omega;
  }
  state.on_drums.clear();
  for (const OnDrumValues& end : v.on_drums) state.on_drums.push_back({end.content, end.layer, end.strain});
  state.drum_drive = v.drum_drive;
  state.motor_drive = v.motor_drive;
  keep_couples(v, state);
  return state;
}

}  // namespace taut::solve::dynamics
