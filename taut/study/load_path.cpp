#include "taut/study/load_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"

namespace taut::study {

double ground_height(const Array<machine::GroundPoint>& terrain, double x) {
  const auto right =
      std::lower_bound(terrain.begin(), terrain.end(), x, [](const auto& point, double at) { return point.x < at; });
  if (right == terrain.end()) return std::numeric_limits<double>::quiet_NaN();
  if (right->x == x) return right->z;
  if (right == terrain.begin()) return std::numeric_limits<double>::quiet_NaN();
  const auto left = right - 1;
  return left->z + (right->z - left->z) * (x - left->x) / (right->x - left->x);
}

namespace {

/// A start for the next of equal steps: the parabola through the last three states, or what there is of it. Branch
/// lengths stay positive; what touches and how bodies are turned stays as it was last.
std::optional<machine::State> ahead(const Array<LoadPathPoint>& points) {
  const std::size_t n = points.size();
  if (n == 0 || !points[n - 1].at.outcome.ok()) return std::nullopt;
  machine::State next = points[n - 1].at.state;
  if (n < 2 || !points[n - 2].at.outcome.ok()) return next;
  const bool curved = n >= 3 && points[n - 3].at.outcome.ok();
  const machine::State &last = points[n - 1].at.state, &before = points[n - 2].at.state;
  const machine::State& first = curved ? points[n - 3].at.state : before;
  if (last.touched != before.touched || last.touched != first.touched) return next;
  const auto extrapolate = [&](const auto& a, const auto& b, const auto& c) {
    return curved ? 3 * a - 3 * b + c : 2 * a - b;
  };
  for (std::size_t b = 0; b < next.bodies.size(); ++b) {
    next.bodies[b].position =
        curved ? Vector3(3 * (last.bodies[b].position - before.bodies[b].position) + first.bodies[b].position)
               : Vector3(2 * last.bodies[b].position - before.bodies[b].position);
  }
  for (std::size_t r = 0; r < next.branches.size(); ++r) {
    for (std::size_t k = 0; k < next.branches[r].size(); ++k) {
      const machine::BranchState &a = last.branches[r][k], &b = before.branches[r][k], &c = first.branches[r][k];
      machine::BranchState& branch = next.branches[r][k];
      branch.length = extrapolate(a.length, b.length, c.length);
      if (branch.length < a.length / 4) return last;
      if (!a.force || !b.force || !c.force) continue;
      branch.force = rope::CatenaryForce{.H = extrapolate(a.force->H, b.force->H, c.force->H),
                                         .V = extrapolate(a.force->V, b.force->V, c.force->V)};
      if (branch.force->H <= 0) branch.force = a.force;
    }
  }
  return next;
}

}  // namespace

LoadPath load_path(const machine::Model& model, const LoadPathOptions& options) {
  expects(options.steps >= 1, "a load path has a step");
  const machine::Carriage& carriage = model.carriages.at(static_cast<std::size_t>(options.carriage));
  LoadPath path;
  machine::Model varied = options.condition ? model : machine::Model{};
  path.points.reserve(static_cast<std::size_t>(options.steps) + 1);
  for (int i = 0; i <= options.steps; ++i) {
    LoadPathPoint point;
    point.x = options.from + (options.to - options.from) * i / options.steps;
    if (options.go_on && !options.go_on(point.x)) break;
    solve::EquilibriumOptions here = options.equilibrium;
    here.prescribed = machine::Prescribed{.carriage = options.carriage, .x = point.x, .along = options.along};
    if (options.condition) {
      solve::Conditioned found = solve::equilibrium_under(varied, *options.condition, here, ahead(path.points));
      point.at = std::move(found.result);
      if (point.at.outcome.ok()) varied = std::move(found.model);
    } else {
      point.at = solve::equilibrium(model, here, ahead(path.points));
    }
    if (point.at.outcome.ok()) {
      const Vector3& place = point.at.state.bodies[carriage.body].position;
      point.z = place.z();
      point.clearance = point.z - ground_height(model.terrain, terrain_x(model, place));
    } else if (path.outcome.ok()) {
      path.outcome = {
          .status = point.at.outcome.status,
          .message = fmt::format("'{}' at x = {:.6g} m: {}", carriage.name, point.x, point.at.outcome.message)};
    }
    path.points.push_back(std::move(point));
  }
  return path;
}

}  // namespace taut::study
