#pragma once
#include "taut/solve/equilibrium.hpp"

namespace taut::results {

/// The machine as its deck describes it, as a state that can be drawn: bodies at their given places (or their first
/// guess), ropes straight from node to node, beams as built. It is no answer: its outcome is not ok, and no rope,
/// contact or beam has a force.
solve::EquilibriumResult described_state(const machine::Model& m);

}  // namespace taut::results
