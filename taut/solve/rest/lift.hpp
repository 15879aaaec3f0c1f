#pragma once
#include <vector>

#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// Changes one thing of what touches what, in a solved configuration already kept in `state`: the support that is
/// pulled most lets its rope go, or else the rope comes back to the support it lies deepest below. Only supports that
/// `may_lift` and have a direction. `let_go`: [reeving][node], how often a node has let go, counted here; one that did
/// so three times and got its rope back each time keeps it, and is reported as pulled. False: nothing to change.
bool change_touch(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                  machine::State& state, Array<Array<int>>& let_go);

}  // namespace taut::solve
