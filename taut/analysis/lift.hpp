#pragma once
#include "taut/analysis/system.hpp"

namespace taut::analysis {

/// Changes one thing of what touches what, in a solved configuration already kept in `state`: the support that is
/// pulled most lets its rope go, or else the rope comes back to the support it lies deepest below. Only supports that
/// `may_lift` and have a direction. False: nothing to change.
bool change_touch(const System& system, const Configuration& c, const Evaluation& e, model::State& state);

}  // namespace taut::analysis
