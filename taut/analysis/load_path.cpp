#include "taut/analysis/load_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"

namespace taut::analysis {

double ground_height(const std::vector<model::GroundPoint>& terrain, double x) {
  const auto right =
      std::lower_bound(terrain.begin(), terrain.end(), x, [](const auto& point, double at) { return point.x < at; });
  if (right == terrain.end()) return std::numeric_limits<double>::quiet_NaN();
  if (right->x == x) return right->z;
  if (right == terrain.begin()) return std::numeric_limits<double>::quiet_NaN();
  const auto left = right - 1;
  return left->z + (right->z - left->z) * (x - left->x) / (right->x - left->x);
}

LoadPath load_path(const model::Model& model, const LoadPathOptions& options) {
  expects(options.steps >= 1, "a load path has a step");
  const model::Carriage& carriage = model.carriages.at(static_cast<std::size_t>(options.carriage));
  LoadPath path;
  path.points.reserve(static_cast<std::size_t>(options.steps) + 1);
  std::optional<model::State> start;
  for (int i = 0; i <= options.steps; ++i) {
    LoadPathPoint point;
    point.x = options.from + (options.to - options.from) * i / options.steps;
    EquilibriumOptions here = options.equilibrium;
    here.prescribed = Prescribed{options.carriage, point.x};
    point.at = equilibrium(model, here, start);
    if (point.at.outcome.ok()) {
      start = point.at.state;
      point.z = point.at.state.bodies[static_cast<std::size_t>(carriage.body)].position.z();
      point.clearance = point.z - ground_height(model.terrain, point.x);
    } else if (path.outcome.ok()) {
      path.outcome = {point.at.outcome.status,
                      fmt::format("'{}' at x = {:.6g} m: {}", carriage.name, point.x, point.at.outcome.message)};
    }
    path.points.push_back(std::move(point));
  }
  return path;
}

}  // namespace taut::analysis
