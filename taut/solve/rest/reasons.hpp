#pragma once
#include <optional>

#include "taut/calc/outcome.hpp"
#include "taut/solve/rest/newton.hpp"

namespace taut::solve {

/// Why there is no equilibrium, and what to change, from where the iteration stopped.
Outcome reason(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e,
               const Iteration& iteration);

/// The rope whose own weight keeps it above its given tension where the iteration stopped, beside a deep loop.
std::optional<int> too_heavy(const mechanics::System& system, const mechanics::Evaluation& e,
                             const Iteration& iteration);

/// That as an outcome. `least`: the tension that it can have, N; 0: not known.
Outcome too_heavy_outcome(const mechanics::System& system, int reeving, double least);

}  // namespace taut::solve
