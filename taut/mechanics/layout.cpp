#include "taut/mechanics/layout.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut::mechanics {
namespace {

using machine::NodeKind;

int count(std::size_t n) { return static_cast<int>(n); }

void check(const machine::Reeving& rope) {
  expects(rope.nodes.size() >= 2, "a rope runs from somewhere to somewhere");
  expects(!rope.closed || rope.nodes.front().kind == NodeKind::drive, "a closed rope begins at its drive");
  const bool torque = rope.given == machine::Given::torque;
  expects(!rope.closed || torque || rope.given == machine::Given::length, "a closed rope is given by length or torque");
  expects(!torque || (rope.closed && rope.nodes.front().tension_drop), "a given torque needs a closed rope's drive");
}

/// Which way along the path the force of a load points.
int sense_of(const machine::Reeving& rope, const machine::RopeLoad& load, int flow) {
  return load.by_motion ? load.sense * (flow == 0 ? rope.haul : flow) : load.sense;
}

/// Whether a drive has an equation of its own: of a rope with ends, or where an open load follows from its torque.
bool has_row(const machine::Reeving& rope, const Layout::Rope& r) { return !rope.closed || r.open_load; }

/// The nodes of a path that its rope touches, in their order.
Array<int> touched_nodes(const machine::Reeving& rope, const Array<bool>& touched) {
  Array<int> nodes;
  for (int k = 0; k < count(rope.nodes.size()); ++k) {
    if (touched[k]) nodes.push_back(k);
  }
  return nodes;
}

void add_rope(Layout& l, const machine::Reeving& rope, int index, const Array<bool>& touched, const Array<int>& flow) {
  check(rope);
  const Array<int> nodes = touched_nodes(rope, touched);
  const int branches = rope.closed ? count(nodes.size()) : count(nodes.size()) - 1;
  Layout::Rope r;
  r.first = count(l.branches.size());
  r.count = branches;
  r.first_turn = count(l.turns.size());
  for (int k = 0; k < branches; ++k) {
    l.branches.push_back({index, nodes[k], nodes[(k + 1) % count(nodes.size())], l.size + k});
  }
  int row = l.size;
  const auto is_open = [](const machine::Node& node) { return node.kind == NodeKind::load && node.load.open; };
  if (std::any_of(rope.nodes.begin(), rope.nodes.end(), is_open)) r.open_load = l.size + branches;
  for (int k = rope.closed ? 0 : 1; k < branches; ++k) {
    const int node = nodes[k];
    const NodeKind kind = rope.nodes[node].kind;
    expects(kind != NodeKind::anchor && (!rope.closed || (kind == NodeKind::drive) == (k == 0)),
            "anchors stand at the ends of a rope, its drive at the start of a closed one");
    const int before = k > 0 ? r.first + k - 1 : r.first + branches - 1;
    const bool drives = kind == NodeKind::drive;
    int runs = flow.empty() || drives ? 0 : flow[node];
    if (kind == NodeKind::load) runs = sense_of(rope, rope.nodes[node].load, runs);
    if (drives) r.drive = count(l.turns.size());
    const auto own = drives && !has_row(rope, r) ? std::nullopt : std::optional(row++);
    l.turns.push_back({index, node, before, r.first + k, own, runs, flow.empty() ? 0 : flow[node]});
  }
  r.turn_count = count(l.turns.size()) - r.first_turn;
  r.row = row;
  l.size += branches + (r.open_load ? 1 : 0);
  l.ropes.push_back(r);
}

int turn_at(const Layout& l, int reeving, int node) {
  const auto turn = std::find_if(l.turns.begin(), l.turns.end(),
                                 [&](const Layout::Turn& t) { return t.reeving == reeving && t.node == node; });
  expects(turn != l.turns.end(), "a carriage rides on its rope");
  return count(static_cast<std::size_t>(turn - l.turns.begin()));
}

/// The rope whose length or tension follows from a carriage's place.
std::optional<int> gives_way(const machine::Model& model, const machine::Carriage& carriage) {
  const auto by_length = [&](int rope) { return model.reevings.at(as_size(rope)).given == machine::Given::length; };
  const bool both = carriage.mainline && carriage.haulback;
  if (both && !by_length(*carriage.mainline) && by_length(*carriage.haulback)) return carriage.haulback;
  return carriage.mainline ? carriage.mainline : carriage.haulback;
}

void prescribe(Layout& l, const machine::Model& model, const machine::Prescribed& prescribed) {
  const machine::Carriage& carriage = model.carriages.at(as_size(prescribed.carriage));
  const int turn = turn_at(l, carriage.reeving, carriage.node);
  const auto rope = gives_way(model, carriage);
  l.coordinate_body = carriage.body;
  l.coordinate_along = prescribed.along;
  if (prescribed.z) {
    l.height_row = l.ropes.at(as_size(carriage.reeving)).row;
    l.height = *prescribed.z;
  }
  if (model.reevings[carriage.reeving].nodes[carriage.node].kind == NodeKind::clamp) {
    l.coordinate_row = l.turns[turn].row;
  } else if (carriage.grip) {
    l.coordinate_row = l.turns[turn_at(l, carriage.grip->reeving, carriage.grip->node)].row;
  } else if (rope) {
    l.coordinate_row = l.ropes.at(as_size(*rope)).row;
  } else {
    const int last = turn_at(l, carriage.reeving, carriage.node + carriage.rollers - 1);
    l.coordinate_row = l.size++;
    l.hold = Layout::Hold{.unknown = *l.coordinate_row, .first_turn = turn, .last_turn = last};
  }
}

/// The scales of force and length.
void measure(Layout& l, const machine::Model& model, const machine::State& state) {
  for (const machine::Body& body : model.bodies) l.heaviest = std::max(l.heaviest, body.mass * model.gravity);
  for (const machine::Load& load : model.loads) l.heaviest = std::max(l.heaviest, load.force.norm());
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      l.heaviest = std::max({l.heaviest, node.load.force, std::abs(node.tension_drop.value_or(0))});
    }
  }
  Eigen::AlignedBox3d box;
  for (const Layout::Branch& laid : l.branches) {
    const machine::Reeving& rope = model.reevings[laid.reeving];
    const Vector3 from = machine::in_ground(state, rope.nodes[laid.from].at),
                  to = machine::in_ground(state, rope.nodes[laid.to].at), chord = to - from;
    box.extend(from);
    box.extend(to);
    l.length = std::max(l.length, chord.norm());
    l.heaviest = std::max(l.heaviest, rope.weight * chord.norm());
    if (std::isfinite(rope.stiffness)) l.stiffest = std::max(l.stiffest, rope.stiffness);
  }
  for (const machine::Beam& beam : model.beams) {
    l.length = std::max(l.length, beam.length);
    if (!beam.pieces.empty()) l.heaviest = std::max(l.heaviest, beam.length * beam.pieces.front().rod.section.weight);
  }
  if (l.length == 0) l.length = 1;
  l.extent = std::max(l.length, box.isEmpty() ? 0 : box.sizes().norm());
}

void add_beams(Layout& l, const machine::Model& model) {
  for (std::size_t b = 0; b < model.beams.size(); ++b) {
    for (std::size_t k = 0; k < model.beams[b].pieces.size(); ++k) {
      const bool hinged = model.beams[b].pieces[k].start_hold == machine::BeamHold::hinged;
      l.pieces.push_back({count(b), count(k), l.size, hinged});
      l.size += l.pieces.back().count();
    }
  }
}

}  // namespace

Layout layout(const machine::Model& model, const machine::State& state,
              const std::optional<machine::Prescribed>& prescribed, const Array<Array<int>>& flow) {
  Layout l;
  for (int b = 0; b < count(model.bodies.size()); ++b) {
    l.first_dof.push_back(count(l.dofs.size()));
    for (const machine::Freedom& way : model.bodies[b].free) l.dofs.push_back({b, way});
  }
  l.first_dof.push_back(count(l.dofs.size()));
  l.size = count(l.dofs.size());
  for (int r = 0; r < count(model.reevings.size()); ++r) {
    add_rope(l, model.reevings[r], r, state.touched[r], flow.empty() ? Array<int>{} : flow[r]);
  }
  if (prescribed) prescribe(l, model, *prescribed);
  add_beams(l, model);
  measure(l, model, state);
  return l;
}

}  // namespace taut::mechanics
