#pragma once
#include "taut/machine/model.hpp"
#include "taut/machine/state.hpp"
#include "taut/rope/tangent.hpp"

namespace taut::machine {

/// Of the machine as it is described: a body's frame to the ground's, a place in the ground frame (m), a round in it.
Matrix3 turned(const Model& model, int body);
Vector3 in_ground(const Model& model, const Place& place);
rope::Round round_at(const Model& model, const Node& node);

/// A round in the ground frame, where its body stands in a state.
rope::Round round_at(const State& state, const Node& node);

}  // namespace taut::machine
