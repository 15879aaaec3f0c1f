#pragma once
#include <optional>

#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// The equilibrium of a machine that lies far from the origin, found in coordinates that count from its middle; none of
/// one that does not: machine::far_middle.
std::optional<EquilibriumResult> found_from_middle(const machine::Model& model, const EquilibriumOptions& options,
                                                   const std::optional<machine::State>& start);

}  // namespace taut::solve
