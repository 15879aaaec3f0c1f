#include "taut/checks/two_blocked.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::checks {
namespace {

/// Whether it turns, and stands in the way of a block: a drum, a driven sheave, or one with an efficiency.
bool is_wheel(const machine::Model& m, const machine::Node& node) {
  if (!(node.radius > 0) || machine::rides(m, node)) return false;
  return node.drum || node.kind == machine::NodeKind::drive ||
         (node.kind == machine::NodeKind::contact && node.law.efficiency > 0);
}

}  // namespace

void TwoBlocked::take(const machine::Model& m, const machine::State& state, const std::set<std::string>& broken,
                      const std::string& words) {
  for (const machine::Reeving& rope : m.reevings) {
    if (broken.contains(rope.name)) continue;
    const std::size_t count = rope.nodes.size();
    for (std::size_t k = 0; k + (rope.closed ? 0 : 1) < count; ++k) {
      const machine::Node &one = rope.nodes[k], &next = rope.nodes[(k + 1) % count];
      if (one.at.body == next.at.body || !is_wheel(m, one) || !is_wheel(m, next)) continue;
      const double distance = (machine::in_ground(state, one.at) - machine::in_ground(state, next.at)).norm();
      const double gap = distance - one.radius - next.radius;
      if (gap >= 0) continue;
      Worst& worst = worst_[std::minmax(one.name, next.name)];
      if (gap < worst.gap) worst = {.gap = gap, .distance = distance, .where = words};
    }
  }
}

void TwoBlocked::add_warnings(Result& r) const {
  for (const auto& [names, worst] : worst_) {
    warn_unsafe(
        r, fmt::format("{}: '{}' and '{}' run into each other: centres {:.3g} m apart, {:.3g} m less than both radii",
                       worst.where, names.first, names.second, worst.distance, -worst.gap));
  }
}

}  // namespace taut::checks
