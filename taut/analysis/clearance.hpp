#pragma once
#include <vector>

#include "taut/analysis/equilibrium.hpp"

namespace taut::analysis {

/// The place where a rope is nearest to the ground, measured straight up.
struct Lowest {
  double clearance = 0;  ///< m; infinite where there is no rope over the terrain
  double x = 0;          ///< m
};

/// The least clearance of one rope over the terrain between x = `from` and `to` (either order), m. The ground is linear
/// between its points and a catenary is convex, so it is the least of the ends of each piece and of the point where the
/// rope is parallel to the ground: exact, no grid. Spans across x (nearly vertical ones) count by their ends.
Lowest rope_clearance(const std::vector<model::GroundPoint>& terrain, const std::vector<SpanResult>& spans, int reeving,
                      double from, double to);

}  // namespace taut::analysis
