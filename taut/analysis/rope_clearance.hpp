#pragma once
#include <limits>

#include "taut/analysis/equilibrium.hpp"

namespace taut::analysis {

/// The least height of a rope over the ground, and where.
struct RopeClearance {
  double height = std::numeric_limits<double>::quiet_NaN();  ///< m, negative in the ground; NaN: none over the terrain
  Vector3 place = Vector3::Zero();                           ///< of the rope there, m
};

/// Of one free rope over the terrain: the catenary against a polyline, exact. Candidates are the places where the rope
/// is parallel to the ground below it, those over hilltops of the ground, and ends that move with a body; an end that
/// is fixed is not one, since there a rope may well begin at the ground. NaN where the rope only rises from such an
/// end, is slack, or has no ground below it.
RopeClearance rope_clearance(const model::Model& model, const SpanResult& span);

/// The least of all spans.
RopeClearance rope_clearance(const model::Model& model, const EquilibriumResult& result);

}  // namespace taut::analysis
