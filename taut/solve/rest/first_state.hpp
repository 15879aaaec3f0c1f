#pragma once
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Where an equilibrium is looked for first: the machine as described, but a prescribed carriage at its x, on the
/// straight line between the fixed neighbours on its rope, and its mainline, whose length follows from that, neither
/// slack nor stretched beyond what the carriage may ask of it. (From a length that does not fit, Newton may find the
/// mainline as kilometres of rope that hang into the valley.)
machine::State first_state(const machine::Model& model, const EquilibriumOptions& options);

}  // namespace taut::solve
