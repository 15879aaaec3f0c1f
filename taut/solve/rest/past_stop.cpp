#include "taut/solve/rest/past_stop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/state.hpp"

namespace taut::solve {
namespace {

constexpr double past_by = 1e-9;  ///< of the machine's length: less is on the stop

/// Whether a node is neither a carriage nor a load on the free rope.
bool is_stop(const mechanics::System& s, const machine::Node& node) {
  if (node.kind == machine::NodeKind::load) return false;
  return std::none_of(s.model.carriages.begin(), s.model.carriages.end(),
                      [&](const machine::Carriage& car) { return car.body == node.at.body; });
}

/// The next node of a path in a direction that `fits`; null: none.
template <class Fits>
const machine::Node* next(const machine::Reeving& rope, int from, int step, const Fits& fits) {
  const int count = static_cast<int>(rope.nodes.size());
  for (int k = 1; k < count; ++k) {
    const int n = from + k * step;
    if (!rope.closed && (n < 0 || n >= count)) return nullptr;
    const machine::Node& node = rope.nodes[(n + count) % count];
    if (fits(node)) return &node;
  }
  return nullptr;
}

double coordinate(const mechanics::System& s, const Array<machine::Pose>& bodies, const machine::Node& node) {
  return s.layout.coordinate_along.dot(mechanics::end_at(node, bodies).centre);
}

/// Of a carriage's nodes on a rope, from `first` to `last`.
std::string past_on(const mechanics::System& s, const mechanics::Configuration& c, const machine::Carriage& car,
                    int reeving, int first, int last) {
  const machine::Reeving& rope = s.model.reevings[reeving];
  const auto stops = [&](const machine::Node& node) { return is_stop(s, node); };
  const auto elsewhere = [&](const machine::Node& node) {
    return node.at.body != car.body && node.kind != machine::NodeKind::load;
  };
  for (const int step : {-1, 1}) {
    const int own = step < 0 ? first : last;
    const machine::Node* stop = next(rope, own, step, stops);
    const machine::Node* other = next(rope, step < 0 ? last : first, -step, elsewhere);
    if (stop == nullptr || other == nullptr) continue;
    const double place = coordinate(s, c.bodies, rope.nodes[own]), there = coordinate(s, c.bodies, *stop);
    const double before = coordinate(s, c.bodies, *other);
    const double past = there > before ? place - there : there - place;
    if (there == before || past <= past_by * s.layout.length) continue;
    return fmt::format(
        "carriage '{}' would lie {:.4g} m past '{}', the next stop of its rope '{}': choose a place before it",
        car.name, past, stop->name, rope.name);
  }
  return {};
}

/// Of a carriage that is clamped to a rope which ends at the one that is put somewhere: whether the rope between them
/// is longer than the way to the next stop in a direction of the path.
std::string clamped_past(const mechanics::System& s, const Array<machine::Pose>& starts, const machine::Carriage& car,
                         int step) {
  const machine::Reeving& rope = s.model.reevings[car.reeving];
  const machine::Node& clamp = rope.nodes[car.node];
  const machine::Node* stop = next(rope, car.node, step, [&](const machine::Node& node) { return is_stop(s, node); });
  const machine::Node* put = next(rope, car.node, -step, [](const machine::Node&) { return true; });
  if (stop == nullptr || put == nullptr || put->at.body != s.layout.coordinate_body) return {};
  // the clamp of the one that is put somewhere follows from its place: only an end of the rope says a length
  const double whole = rope.given == machine::Given::length ? rope.value : 0;
  const bool at_start = put == &rope.nodes.front(), at_end = put == &rope.nodes.back() && whole > 0;
  if (rope.closed || (!at_start && !at_end)) return {};
  const double length = (at_start ? clamp.length_before : whole - clamp.length_before) * (1 + rope.thermal_strain);
  const double room = std::abs(coordinate(s, starts, *stop) - s.coordinate);
  if (length <= room) return {};
  return fmt::format(
      "carriage '{}' hangs {:.4g} m of rope '{}' beside '{}', which is put {:.4g} m before '{}': it would lie past "
      "'{}'; choose a place farther from it",
      car.name, length, rope.name, s.model.bodies[s.layout.coordinate_body].name, room, stop->name, stop->name);
}

}  // namespace

std::string past_stop(const mechanics::System& s, const mechanics::Configuration& c) {
  if (!s.layout.coordinate_row) return {};
  for (const machine::Carriage& car : s.model.carriages) {
    std::string words = past_on(s, c, car, car.reeving, car.node, car.node + car.rollers - 1);
    if (words.empty() && car.grip) words = past_on(s, c, car, car.grip->reeving, car.grip->node, car.grip->node);
    if (!words.empty()) return words;
  }
  return {};
}

std::string section_past_stop(const mechanics::System& s) {
  if (!s.layout.coordinate_row) return {};
  const auto starts = machine::initial_state(s.model).bodies;
  for (const machine::Carriage& car : s.model.carriages) {
    const machine::Reeving& rope = s.model.reevings[car.reeving];
    const machine::Node& clamp = rope.nodes[car.node];
    if (car.body == s.layout.coordinate_body || clamp.kind != machine::NodeKind::clamp) continue;
    for (const int step : {-1, 1}) {
      std::string words = clamped_past(s, starts, car, step);
      if (!words.empty()) return words;
    }
  }
  return {};
}

}  // namespace taut::solve
