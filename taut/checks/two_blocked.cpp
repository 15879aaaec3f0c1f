#include "taut/checks/two_blocked.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/machine/state.hpp"

namespace taut::checks {
namespace {

bool on_carriage(const machine::Model& m, const machine::Node& node) {
  return std::any_of(m.carriages.begin(), m.carriages.end(),
                     [&](const machine::Carriage& car) { return car.body == node.at.body; });
}

/// Whether it turns, and stands in the way of a block: a drum, a driven sheave, or one with an efficiency.
bool is_wheel(const machine::Model& m, const machine::Node& node) {
  if (!(node.radius > 0) || on_carriage(m, node)) return false;
  return node.drum || node.kind == machine::NodeKind::drive ||
         (node.kind == machine::NodeKind::contact && node.law.efficiency > 0);
}

}  // namespace

template <class Places>
void TwoBlocked::take_all(const machine::Model& m, const Places& place_of, const std::string& words) {
  for (const machine::Reeving& rope : m.reevings) {
    const std::size_t count = rope.nodes.size();
    for (std::size_t k = 0; k + (rope.closed ? 0 : 1) < count; ++k) {
      const machine::Node &one = rope.nodes[k], &next = rope.nodes[(k + 1) % count];
      if (one.at.body == next.at.body || !is_wheel(m, one) || !is_wheel(m, next)) continue;
      const double distance = (place_of(one) - place_of(next)).norm();
      const double gap = distance - one.radius - next.radius;
      if (gap >= 0) continue;
      Worst& worst = worst_[std::minmax(one.name, next.name)];
      if (gap < worst.gap) worst = {.gap = gap, .distance = distance, .where = words};
    }
  }
}

void TwoBlocked::take(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  take_all(
      m, [&](const machine::Node& node) { return machine::in_ground(e.state, node.at); }, words);
}

void TwoBlocked::take(const machine::Model& m, const solve::TransientFrame& frame, const std::string& words) {
  const auto place_of = [&](const machine::Node& node) -> Vector3 {
    if (node.at.body == machine::ground) return node.at.at;
    const auto& body = frame.bodies[node.at.body];
    return body.position + body.orientation * node.at.at;
  };
  take_all(m, place_of, words);
}

void TwoBlocked::add_warnings(Result& r) const {
  for (const auto& [names, worst] : worst_) {
    warn_unsafe(
        r, fmt::format("{}: '{}' and '{}' run into each other: centres {:.3g} m apart, {:.3g} m less than both radii",
                       worst.where, names.first, names.second, worst.distance, -worst.gap));
  }
}

}  // namespace taut::checks
