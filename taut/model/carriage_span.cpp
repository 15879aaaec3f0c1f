#include "taut/model/carriage_span.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace taut::model {
namespace {

/// The index in `nodes` (without the carriage) behind which x lies; nearest to `old`.
std::optional<std::size_t> span_of(const std::vector<Node>& nodes, double x, std::size_t old) {
  std::optional<std::size_t> best;
  const auto far = [&](std::size_t k) { return k + 1 > old ? k + 1 - old : old - (k + 1); };
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    if (nodes[k].at.body != ground || nodes[k + 1].at.body != ground) continue;
    const auto [low, high] = std::minmax(nodes[k].at.at.x(), nodes[k + 1].at.at.x());
    if (x < low || x > high || low == high) continue;
    if (!best || far(k) < far(*best)) best = k;
  }
  return best;
}

/// Straight way along the nodes to each of them, m; nodes on bodies where the bodies start.
std::vector<double> ways(const Model& model, const std::vector<Node>& nodes) {
  const auto place = [&](const Node& n) {
    return n.at.body == ground ? n.at.at
                               : Vector3(model.bodies[static_cast<std::size_t>(n.at.body)].position + n.at.at);
  };
  std::vector<double> all = {0};
  for (std::size_t k = 1; k < nodes.size(); ++k)
    all.push_back(all.back() + (place(nodes[k]) - place(nodes[k - 1])).norm());
  return all;
}

}  // namespace

Model with_carriage_at(Model model, int carriage, double x) {
  Carriage& car = model.carriages[static_cast<std::size_t>(carriage)];
  Reeving& rope = model.reevings[static_cast<std::size_t>(car.reeving)];
  if (rope.closed) return model;
  const auto old = static_cast<std::size_t>(car.node);
  std::vector<Node> nodes = rope.nodes;
  Node own = nodes[old];
  nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(old));
  const auto before = span_of(nodes, x, old);
  if (!before) return model;
  const Vector3& from = nodes[*before].at.at;
  const Vector3& to = nodes[*before + 1].at.at;
  model.bodies[static_cast<std::size_t>(car.body)].position = from + (x - from.x()) / (to.x() - from.x()) * (to - from);
  if (*before + 1 == old) return model;
  nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(*before + 1), own);
  rope.nodes = std::move(nodes);
  for (Carriage& other : model.carriages) {
    if (&other == &car || other.reeving != car.reeving) continue;
    const auto at = std::find_if(rope.nodes.begin(), rope.nodes.end(),
                                 [&](const Node& n) { return n.kind != NodeKind::anchor && n.at.body == other.body; });
    other.node = static_cast<int>(at - rope.nodes.begin());
  }
  car.node = static_cast<int>(*before + 1);
  Node& moved = rope.nodes[*before + 1];
  if (moved.kind == NodeKind::clamp) {
    const std::vector<double> way = ways(model, rope.nodes);
    const double length = rope.given == Given::length ? rope.value : way.back();
    moved.length_before = length * way[*before + 1] / way.back();
  }
  return model;
}

}  // namespace taut::model
