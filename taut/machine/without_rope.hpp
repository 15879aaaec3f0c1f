#pragma once
#include <optional>

#include "taut/machine/model.hpp"
#include "taut/machine/state.hpp"

namespace taut::machine {

/// The machine without one of its ropes, for an analysis at rest: the indices of the other ropes follow, carriages that
/// it pulled have no such rope any more, and what belongs to motion alone (events, tensioners, observed quantities) is
/// gone. Empty where a carriage rides on that rope or is fixed to it.
std::optional<Model> without_rope(Model model, int reeving);

/// A state of the machine without that rope, with its branches put in again as number `reeving`: straight under a
/// tension (N), as long as their lines where that is 0.
State with_rope(State state, const Reeving& rope, int reeving, double tension);

}  // namespace taut::machine
