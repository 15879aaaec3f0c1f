#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/compile/path.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Complains of neighbours on a path between which no rope can run, with the names of both. All: two at one place.
/// Where they can't move against each other: a point inside the rope's circle on a sheave or drum, and two circles with
/// parallel axes of which one lies inside the other, or, where the rope crosses over, reaches into the other.
/// `stops`: with their sides; `path`: of the rope in the deck.
void check_room(const Model& model, const Array<Stop>& stops, bool closed, const DeckPlace& path,
                std::vector<Complaint>& complaints);

/// Complains of neighbours at one place; false where there are any. `places`: of the stops, in the ground frame.
bool check_apart(const Array<Stop>& stops, const Array<Vector3>& places, bool closed, const DeckPlace& path,
                 std::vector<Complaint>& complaints);

}  // namespace taut::machine
