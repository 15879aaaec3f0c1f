#pragma once
#include <vector>

#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::checks {

/// By drum: whether other drives may be what draws its rope out at this moment. Looked at are the drives of all parts
/// that move together with the drum: its ropes, the bodies on them, their other ropes. They draw where one that has a
/// speed gives power (a mainline against its haulback, also downhill), where a signal moves a body, and where all of
/// them together give more than they take. Else loads or inertia give it.
std::vector<bool> drawn_out(const machine::Model& model, const solve::TransientFrame& moment);

}  // namespace taut::checks
