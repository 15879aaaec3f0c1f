#include "taut/checks/two_blocked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::checks {
namespace {

/// Whether it is a round that stands in the way of a block, on no carriage: a drum, a sheave, a saddle.
bool is_round(const machine::Model& m, const machine::Node& node) {
  if (!(node.radius > 0) || machine::rides(m, node)) return false;
  return node.drum || node.kind == machine::NodeKind::drive || node.kind == machine::NodeKind::contact;
}

/// A saddle, which does not turn: supports that carriages pass are such.
bool lets_pass(const machine::Model& m, const machine::Node& round, const machine::Node& end) {
  return round.kind == machine::NodeKind::contact && round.law.efficiency == 0 && machine::rides(m, end);
}

bool stands(const machine::Model& m, int body) {
  return body == machine::ground || (m.bodies[body].free.empty() && m.bodies[body].driven.empty());
}

/// Whether a rope ends at a point of another part than the one that carries the round, and one of them moves.
bool ends_beside(const machine::Model& m, const machine::Node& round, const machine::Node& end) {
  const bool a_point = end.kind == machine::NodeKind::anchor && !end.drum && end.radius == 0;
  if (!a_point || !is_round(m, round) || lets_pass(m, round, end)) return false;
  return !(stands(m, round.at.body) && stands(m, end.at.body));
}

}  // namespace

/// The free rope between a round and its end on another part touches the rim: it is a leg of a right angle, of
/// which the radius is the other one.
void TwoBlocked::take_end(const machine::Model& m, const machine::State& state, const machine::Node& round,
                          const machine::Node& end, const std::string& words) {
  if (!ends_beside(m, round, end)) return;
  const double distance = (machine::in_ground(state, round.at) - machine::in_ground(state, end.at)).norm();
  const double square = distance * distance - round.radius * round.radius;
  const double rope = square > 0 ? std::sqrt(square) : 0;
  if (rope >= round.radius) return;
  const Worst here = {.gap = rope, .distance = distance, .where = words};
  const auto [at, is_new] = ends_.try_emplace({round.name, end.name}, here);
  if (!is_new && distance < at->second.distance) at->second = here;
}

void TwoBlocked::take(const machine::Model& m, const machine::State& state, const std::set<std::string>& broken,
                      const std::string& words) {
  for (const machine::Reeving& rope : m.reevings) {
    if (broken.contains(rope.name)) continue;
    const std::size_t count = rope.nodes.size();
    for (std::size_t k = 0; k + (rope.closed ? 0 : 1) < count; ++k) {
      const machine::Node &one = rope.nodes[k], &next = rope.nodes[(k + 1) % count];
      if (one.at.body == next.at.body) continue;
      take_end(m, state, one, next, words);
      take_end(m, state, next, one, words);
      if (!is_round(m, one) || !is_round(m, next)) continue;
      const double distance = (machine::in_ground(state, one.at) - machine::in_ground(state, next.at)).norm();
      const double gap = distance - one.radius - next.radius;
      if (gap >= 0) continue;
      Worst& worst = worst_[std::minmax(one.name, next.name)];
      if (gap < worst.gap) worst = {.gap = gap, .distance = distance, .where = words};
    }
  }
}

void TwoBlocked::add_warnings(Result& r, const Display& display) const {
  const auto length = [&](double x) { return display.brief(x, si::m); };
  for (const auto& [names, worst] : worst_) {
    warn_unsafe(r, fmt::format("{}: '{}' and '{}' run into each other: centres {} apart, {} less than both radii",
                               worst.where, names.first, names.second, length(worst.distance), length(-worst.gap)));
  }
  for (const auto& [names, worst] : ends_) {
    warn_unsafe(
        r,
        fmt::format("{}: '{}' runs into '{}': the free rope between them is {} long, less than the radius; {} to its "
                    "centre",
                    worst.where, names.second, names.first, length(worst.gap), length(worst.distance)));
  }
}

}  // namespace taut::checks
