#include "taut/solve/rest/hanging.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::solve {
namespace {

bool pitches(const mechanics::System& s, int body) {
  const auto& free = s.model.bodies[body].free;
  return std::any_of(free.begin(), free.end(), [](const auto& way) { return way.about != Vector3::Zero(); });
}

/// Upward force of the rope on the rollers of a carriage, N.
double lift_of(const mechanics::System& s, const mechanics::Evaluation& e, const machine::Carriage& car) {
  double up = 0;
  for (const mechanics::Layout::Turn& t : s.layout.turns) {
    if (t.reeving != car.reeving || t.node < car.node || t.node >= car.node + car.rollers) continue;
    const mechanics::Branch &in = e.branches[t.before], &out = e.branches[t.after];
    if (!in.slack) up -= in.pull_to.z();
    if (!out.slack) up += out.pull_from.z();
  }
  return up;
}

}  // namespace

Hanging hanging(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  Hanging result;
  for (const machine::Carriage& car : s.model.carriages) {
    const machine::Node& node = s.model.reevings[car.reeving].nodes[car.node];
    if (node.kind != machine::NodeKind::contact) continue;
    if (pitches(s, car.body) && c.bodies[car.body].orientation(2, 2) < 0) {
      result.outcome = infeasible(fmt::format(
          "carriage '{}' would turn over: the ropes that pull at it outweigh the load below its rollers; give "
          "them less pull, or less height of the rollers",
          car.name));
      return result;
    }
    // only of rollers that press from above
    if (node.support.z() >= 0) continue;
    const double up = lift_of(s, e, car);
    if (up >= -1e-9 * e.largest_force) continue;
    result.lifted = true;
    result.outcome =
        infeasible(fmt::format("carriage '{}' would lift off '{}', which would have to press it down with {:.6g} N",
                               car.name, s.model.reevings[car.reeving].name, -up));
  }
  return result;
}

}  // namespace taut::solve
