#pragma once
#include <limits>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study {

/// The least height of a rope over the ground, and where.
struct RopeClearance {
  double height = std::numeric_limits<double>::quiet_NaN();  ///< m, negative in the ground; NaN: none over the terrain
  Vector3 place = Vector3::Zero();                           ///< of the rope there, m
};

/// Of one free rope over the terrain: the catenary against a polyline, exact. Candidates are the places where the rope
/// is parallel to the ground below it, those over hilltops of the ground, and ends that move with a body; an end that
/// is fixed is not one, since there a rope may well begin at the ground. NaN where the rope only rises from such an
/// end, is slack, or has no ground below it.
RopeClearance rope_clearance(const machine::Model& model, const solve::SpanResult& span);

/// The least of all spans.
RopeClearance rope_clearance(const machine::Model& model, const solve::EquilibriumResult& result);

/// Of a rope that follows a polyline, piece by piece, m. Chords of a sagging rope lie above it: n equal pieces of the
/// sag f hide f/n^2 (of a branch in motion, in 17 pieces, 0.4 % of its sag). `begins`, `ends`: whether its first and
/// last place count, as where they move with a body.
RopeClearance rope_clearance(const machine::Model& model, const Array<Vector3>& rope, bool begins, bool ends);

/// A strip across the line: the places whose distance from the origin along `along` lies between `from` and `to`
/// (either order), m.
struct RopeWindow {
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Of one rope within a window, whatever holds its ends there: who asks for a window says where the rope has to be
/// clear. Where the rope passes the edges of the window or of the terrain counts too. A slack span counts by its chord.
/// NaN where no rope is over terrain in the window.
RopeClearance rope_clearance(const machine::Model& model, const Array<solve::SpanResult>& spans, int reeving,
                             const RopeWindow& window);

/// The parts of a plan extent that the terrain does not reach, m along the terrain: before its first and behind its
/// last point. Both 0: the terrain covers the extent.
struct TerrainGap {
  double before = 0, after = 0;
  double missing() const { return before + after; }
};

/// Of an extent between two places, in the terrain's x (machine::terrain_x), either order. Without terrain all of it is
/// missing before. A gap within rounding of the extent counts as none.
TerrainGap terrain_gap(const machine::Model& model, double from, double to);

/// Of one rope within a window, in plan, from the first to the last place of it there; none where no part of the rope
/// is in the window.
TerrainGap terrain_gap(const machine::Model& model, const Array<solve::SpanResult>& spans, int reeving,
                       const RopeWindow& window = {});

/// Of all ropes of a machine in one state.
TerrainGap terrain_gap(const machine::Model& model, const solve::EquilibriumResult& result);

}  // namespace taut::study
