#pragma once
#include "taut/analysis/newton.hpp"

namespace taut::analysis {

/// Why there is no equilibrium, and what to change, from where the iteration stopped.
Outcome reason(const System& system, const Configuration& c, const Evaluation& e, const Iteration& iteration);

}  // namespace taut::analysis
