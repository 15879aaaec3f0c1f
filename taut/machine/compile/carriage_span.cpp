#include "taut/machine/compile/carriage_span.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/machine/compile/carriages.hpp"
#include "taut/machine/compile/guides.hpp"

namespace taut::machine {
namespace {

/// Where a node stands at the start; empty on a carriage, which may stand anywhere.
std::optional<Vector3> stands_at(const Model& model, const Node& node) {
  if (node.at.body == ground) return node.at.at;
  const auto rides = [&](const Carriage& car) { return car.body == node.at.body; };
  if (std::any_of(model.carriages.begin(), model.carriages.end(), rides)) return std::nullopt;
  const Body& body = model.bodies[node.at.body];
  return Vector3(body.position + body.orientation * node.at.at);
}

/// The index in `nodes` (without the carriage) behind which x lies; nearest to `old`. Node n + 1 of an endless rope is
/// its first.
std::optional<std::size_t> span_of(const Model& model, const Array<Node>& nodes, bool closed, double x,
                                   const Vector3& along, std::size_t old) {
  std::optional<std::size_t> best;
  const auto far = [&](std::size_t k) { return k + 1 > old ? k + 1 - old : old - (k + 1); };
  const std::size_t spans = closed ? nodes.size() : nodes.size() - 1;
  for (std::size_t k = 0; k < spans; ++k) {
    const auto from = stands_at(model, nodes[k]), to = stands_at(model, nodes[(k + 1) % nodes.size()]);
    if (!from || !to) continue;
    const auto [low, high] = std::minmax({from->dot(along), to->dot(along)});
    if (x < low || x > high || low == high) continue;
    if (!best || far(k) < far(*best)) best = k;
  }
  return best;
}

/// Straight way along the nodes to each of them, and of an endless rope back to the first, m; nodes on bodies where the
/// bodies start.
Array<double> ways(const Model& model, const Reeving& rope) {
  const auto place = [&](const Node& n) {
    if (n.at.body == ground) return n.at.at;
    const Body& body = model.bodies[n.at.body];
    return Vector3(body.position + body.orientation * n.at.at);
  };
  Array<double> all = {0};
  const std::size_t count = rope.nodes.size();
  for (std::size_t k = 1; k < (rope.closed ? count + 1 : count); ++k)
    all.push_back(all.back() + (place(rope.nodes[k % count]) - place(rope.nodes[k - 1])).norm());
  return all;
}

/// The place of the straight line from one place to another at x.
Vector3 at_coordinate(const Vector3& from, const Vector3& to, double x, const Vector3& along) {
  return from + (x - from.dot(along)) / (to - from).dot(along) * (to - from);
}

/// Finds every carriage's nodes again after a change of a rope's path.
void find_nodes(Model& model, int reeving) {
  const auto& nodes = model.reevings[reeving].nodes;
  const auto find = [&](int body, bool grip, int& node) {
    for (std::size_t n = nodes.size(); n-- > 0;) {
      if (nodes[n].at.body != body || nodes[n].kind == NodeKind::anchor) continue;
      if (!grip || nodes[n].kind == NodeKind::clamp) node = static_cast<int>(n);
    }
  };
  for (Carriage& car : model.carriages) {
    const bool same = car.grip && car.grip->reeving == car.reeving;
    if (car.grip && car.grip->reeving == reeving) find(car.body, true, car.grip->node);
    if (car.reeving != reeving) continue;
    if (!same) {
      find(car.body, false, car.node);
      continue;
    }
    for (std::size_t n = nodes.size(); n-- > 0;) {
      if (nodes[n].at.body == car.body && nodes[n].kind == NodeKind::contact) car.node = static_cast<int>(n);
    }
  }
}

/// Where nodes came to lie: on the straight line between their neighbours, if there is such a span.
struct Moved {
  bool found = false, passes = false;  ///< another span than before
  Vector3 from = Vector3::Zero(), to = Vector3::Zero(), place = Vector3::Zero();
};

/// Moves `count` nodes from `first` on to the span of their rope where x lies.
Moved move_nodes(Model& model, int reeving, int first, int count, double x, const Vector3& along) {
  Reeving& rope = model.reevings[reeving];
  Array<Node> nodes = rope.nodes;
  const auto begin = nodes.begin() + first;
  const Array<Node> own(begin, begin + count);
  nodes.erase(begin, begin + count);
  const auto before = span_of(model, nodes, rope.closed, x, along, static_cast<std::size_t>(first));
  if (!before) return {};
  const Vector3 from = *stands_at(model, nodes[*before]), to = *stands_at(model, nodes[(*before + 1) % nodes.size()]);
  const bool passes = static_cast<int>(*before) + 1 != first;
  const Moved moved{
      .found = true, .passes = passes, .from = from, .to = to, .place = at_coordinate(from, to, x, along)};
  if (!passes) return moved;
  nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(*before + 1), own.begin(), own.end());
  rope.nodes = std::move(nodes);
  find_nodes(model, reeving);
  return moved;
}

/// A clamp at its share of the way.
void share_out(Model& model, int reeving, int node) {
  Reeving& rope = model.reevings[reeving];
  Node& clamp = rope.nodes[node];
  if (clamp.kind != NodeKind::clamp) return;
  const Array<double> way = ways(model, rope);
  const double length = rope.given == Given::length ? rope.value : way.back();
  clamp.length_before = length * way[node] / way.back();
}

void move_carriage(Model& model, int carriage, double x, const Vector3& along) {
  Carriage& car = model.carriages[carriage];
  const Moved moved = move_nodes(model, car.reeving, car.node, car.rollers, x, along);
  if (!moved.found) return;
  Body& body = model.bodies[car.body];
  turn_along(body, moved.to - moved.from, car.rollers);
  const Vector3& above = model.reevings[car.reeving].nodes[car.node].at.at;
  body.position = moved.place - above.z() * body.orientation.col(2);
  if (moved.passes) share_out(model, car.reeving, car.node);
  if (car.grip && move_nodes(model, car.grip->reeving, car.grip->node, 1, x, along).passes)
    share_out(model, car.grip->reeving, car.grip->node);
}

}  // namespace

Model with_carriage_at(Model model, int carriage, double x, const Vector3& along) {
  const int body = model.carriages[carriage].body;
  release_guides(model, body);
  move_carriage(model, carriage, x, along);
  hold_guides(model, body, x, along);
  return model;
}

}  // namespace taut::machine
