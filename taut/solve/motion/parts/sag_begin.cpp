#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/branch.hpp"
#include "taut/solve/motion/parts/sag.hpp"

// How sagging lines begin.
namespace taut::solve::dynamics {
namespace {

Matrix3 turned_at_start(const DynamicState& start, int body) {
  const auto b = static_cast<std::size_t>(body);
  return body < 0 || b >= start.bodies.size() ? Matrix3(Matrix3::Identity()) : start.bodies[b].orientation;
}

Vector3 centre_at_start(const Line& line, const DynamicState& start, std::size_t end) {
  if (line.body[end] < 0) return line.place[end];
  return start.bodies[line.body[end]].position + turned_at_start(start, line.body[end]) * line.place[end];
}

mechanics::BranchEnd end_at_start(const Line& line, const DynamicState& start, const std::array<double, 2>& radius,
                                  std::size_t end) {
  return {centre_at_start(line, start, end), turned_at_start(start, line.body[end]) * line.axis[end],
          line.side[end] * radius[end]};
}

/// Directions of a rope at its ends as a state has them.
struct DirectionsAtStart {
  bool any = false;
  Vector3 leaves = Vector3::Zero(), arrives = Vector3::Zero();
};

DirectionsAtStart known_directions(const DynamicState& start, int reeving, int branch) {
  const DynamicState::Rope& rope = start.ropes[reeving];
  DirectionsAtStart known;
  if (as_size(branch) < rope.leaves.size() && as_size(branch) < rope.arrives.size()) {
    known.leaves = rope.leaves[branch];
    known.arrives = rope.arrives[branch];
  }
  known.any = known.leaves != Vector3::Zero() && known.arrives != Vector3::Zero();
  return known;
}

}  // namespace

bool begin_to_hang(const Line& line, const Array<Motion3>& bodies, const DynamicState& start, int branch,
                   LineValues& now, SagValues& is) {
  const DirectionsAtStart known = known_directions(start, line.reeving, branch);
  std::array<Vector3, 2> direction{known.leaves, known.arrives};
  double length = now.L;
  SagValues before;
  if (!(length > 0)) return false;
  if (!known.any) {
    machine::BranchState near;
    near.length = length;
    const auto found =
        mechanics::solve_branch({length, line.weight, line.stiffness}, end_at_start(line, start, now.radius, 0),
                                end_at_start(line, start, now.radius, 1), near);
    if (!found) return false;
    direction = {found->leaves, found->arrives};
    length = found->length;
    before.H = found->span.force.H;
    before.V = found->span.force.V;
  }
  for (const std::size_t e : {0U, 1U}) before.seat[e] = turned_at_start(start, line.body[e]).transpose() * direction[e];
  return hang(line, bodies, {1, 1}, before, length, {0, 0}, now, is);
}

bool sags_by_weight(const Line& line, const DynamicState& start, int branch, double length, double light) {
  const bool goes_on = !start.ropes[line.reeving].passed.empty();
  const DirectionsAtStart known = known_directions(start, line.reeving, branch);
  if (goes_on) return known.any;
  if (!(length > 0)) return false;
  const auto found =
      mechanics::solve_branch({length, line.weight, line.stiffness}, end_at_start(line, start, line.radius, 0),
                              end_at_start(line, start, line.radius, 1), {length, known.leaves, known.arrives, {}});
  return found && line.weight * length > light * (found->T_from + found->T_to) / 2;
}

}  // namespace taut::solve::dynamics
