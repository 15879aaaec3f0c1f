#include "taut/machine/description/over_ground.hpp"

#include <numbers>

#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {

const Description& OverGround::describe() {
  static const Description d =
      Describe<OverGround>()
          .field(&OverGround::chainage, "chainage", "", si::m, "place of the foot along the line of the terrain")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&OverGround::offset, "offset", "", si::m,
                 "of the foot to the left of the line, seen towards growing chainage")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&OverGround::over_ground, "over_ground", "h", si::m,
                 "height over the ground at the foot, measured along the support")
          .at_least(0)
          .at_most(farthest)
          .required()
          .field(&OverGround::lean, "lean", "", si::rad.in("deg"),
                 "of the support from the vertical, towards growing chainage")
          .above(-std::numbers::pi / 2)
          .below(std::numbers::pi / 2);
  return d;
}

}  // namespace taut::machine::description
