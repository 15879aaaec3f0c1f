#pragma once
#include "taut/calc/field.hpp"

namespace taut::machine::description {

/// A place of the ground frame by its height over the ground: a support of the length `over_ground` stands on the
/// terrain's line at `chainage` and leans towards growing chainage. With the terrain's heights z_ground the place is at
/// the chainage `chainage + over_ground sin(lean)` and the height `z_ground(chainage) + over_ground cos(lean)`.
struct OverGround {
  double chainage = 0;     ///< of the foot along the terrain's line, m
  double offset = 0;       ///< to the left of the line, seen towards growing chainage, m; the height of the ground is
                           ///< that of the line
  double over_ground = 0;  ///< from the foot, along the support, m
  double lean = 0;         ///< from the vertical towards growing chainage, rad
  static const Description& describe();
};

}  // namespace taut::machine::description
