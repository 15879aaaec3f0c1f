#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study {

/// The least height of a rope above the ground, and its place.
struct RopeClearance {
  double height = std::numeric_limits<double>::quiet_NaN();  ///< m, negative below the ground; NaN: no part of the rope
                                                             ///< is over the terrain
  Vector3 place = Vector3::Zero();                           ///< place of the rope there, m
  std::optional<double> to_end;  ///< of a rope that comes along the ground to a fixed end: how far from it in plan, m
};

/// Clearance of one branch over the terrain: catenary against polyline, exact. Candidates are the places where the rope
/// is parallel to the ground below, the places over hilltops, ends that move with a body, and the ends of the terrain
/// from which the rope goes on to such an end. Fixed ends are candidates only where they are more than 3 m below the
/// ground, because a rope may begin at a buried anchor; ends of the terrain before a fixed end only where the rope is
/// in the ground there.
///
/// A rope has to come down to a fixed end. More than 6 m before that end all of it counts that is below a line down to
/// the end: the line leaves the ground 6 m before the end and rises by 1 in 2, as from an anchor 3 m deep. So a rope is
/// clear of the ground by c when each of its places there is higher than c or than that line.
///
/// NaN where the rope is nowhere lowest and only rises more steeply from a fixed end, is slack, or has no terrain
/// below.
RopeClearance rope_clearance(const machine::Model& model, const solve::BranchResult& branch);

/// Whether a rope may lie on the ground at a node: where it is fixed or winds, and at sheaves that do not move; not on
/// supports.
bool may_be_on_ground(const machine::Model& model, int reeving, int node);

/// The least clearance of all branches.
RopeClearance rope_clearance(const machine::Model& model, const solve::EquilibriumResult& result);

/// A piece of a rope as it hangs between two places: a catenary, or a parabola that is `sag` below the middle of its
/// chord, m; with neither it is straight.
struct RopePiece {
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();  ///< m
  std::optional<rope::Span> shape;                         ///< the catenary
  double sag = 0;
};

/// Clearance of a rope in pieces, one behind the other: of the curves, as above. Of one piece it is that of a branch.
/// `from`, `to`: the nodes of the rope's ends.
RopeClearance rope_clearance(const machine::Model& model, const Array<RopePiece>& pieces, int reeving, int from,
                             int to);

/// A window: the places with a coordinate along `along` between `from` and `to`, m, in either order.
struct RopeWindow {
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Clearance of one rope within a window. All its ends within the window count, fixed ones too, and so do the edges of
/// the window and of the terrain. A slack branch counts as its chord. NaN where no part of the rope is over terrain in
/// the window.
RopeClearance rope_clearance(const machine::Model& model, const Array<solve::BranchResult>& branches, int reeving,
                             const RopeWindow& window);

/// The parts of a horizontal extent without terrain, m along the terrain: before its first and after its last point.
/// Both 0: the terrain covers the extent.
struct TerrainGap {
  double before = 0, after = 0;
  double missing() const { return before + after; }
};

/// Gap of an extent between two chainages (machine::terrain_x), in either order. Without terrain the whole extent is in
/// `before`. A gap within rounding of the extent is 0.
TerrainGap terrain_gap(const machine::Model& model, double from, double to);

/// Gap of the part of one rope within a window; 0 where no part of the rope is in the window.
TerrainGap terrain_gap(const machine::Model& model, const Array<solve::BranchResult>& branches, int reeving,
                       const RopeWindow& window = {});

/// Gap of all ropes of a machine in one state.
TerrainGap terrain_gap(const machine::Model& model, const solve::EquilibriumResult& result);

}  // namespace taut::study
