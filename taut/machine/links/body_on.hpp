#pragma once
#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Bodies that say `on` have their place, their axes and their guide in the frame of another body, as it is at the
/// start; here they are carried over into the ground frame, in any order, also one on another. Later the two move
/// apart as their freedoms let them. Complaints: an unknown body, a circle, a driven body (its place belongs to the
/// ground), a beam that is joined to it, a body that moves and takes away what has not the ways to go along.
void place_bodies_on_others(const Machine& machine, Model& model, std::vector<Complaint>& complaints);

}  // namespace taut::machine
