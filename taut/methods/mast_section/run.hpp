#pragma once
#include <optional>
#include <vector>

#include "taut/methods/mast_section/position.hpp"
#include "taut/methods/mast_section/sizing.hpp"
#include "taut/units/display.hpp"

namespace taut::mast_section {

/// What one run of the method has found, for whoever goes on from there.
struct Solved {
  std::vector<Position> positions;  ///< every one of the deck, in its order; one where the branch angle is given
  Governing governing;
  std::vector<ClampForces> forces;    ///< what the section must carry; none where no position is feasible
  std::optional<Assessment> section;  ///< the one in use: given, chosen, or nearest to passing
};

/// The calculation note, as run(in), by second order where `second` is not empty. Each carriage position is computed
/// once; of several the governing ones are then written out. `display`: the units of its warnings.
Result run(const Input& in, const SecondOrder& second, Solved& found, const Display& display = Display());

}  // namespace taut::mast_section
