#pragma once
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Whether any place of the machine is given by its height over the ground.
bool has_places_over_ground(const Machine& machine);

/// Puts x, y, z of every such place into its `at`, and returns these places in the order of the lists. Complains, at
/// the place, where it belongs to a body, and where there is no terrain at its chainage; at `terrain` as add_terrain
/// does. A point of the terrain's `between` must not stand over the ground that it lays out.
Array<PlaceOverGround> stand_on_ground(Machine& machine, std::vector<Complaint>& complaints);

}  // namespace taut::machine
