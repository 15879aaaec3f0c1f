#pragma once
#include "taut/mechanics/layout.hpp"
#include "taut/mechanics/system.hpp"

namespace taut_test {

/// The unknowns' values in a state.
inline taut::mechanics::Configuration configuration_of(const taut::mechanics::Layout& layout,
                                                       const taut::machine::State& state) {
  taut::mechanics::Configuration c;
  c.bodies = state.bodies;
  for (const auto& k : layout.branches) {
    c.branches.push_back(state.branches[static_cast<std::size_t>(k.reeving)][static_cast<std::size_t>(k.from)]);
  }
  for (const auto& p : layout.pieces) {
    c.pieces.push_back(state.beams[static_cast<std::size_t>(p.beam)][static_cast<std::size_t>(p.piece)]);
  }
  return c;
}

/// No loss anywhere.
inline taut::Array<taut::Array<int>> no_flow(const taut::machine::Model& m) {
  taut::Array<taut::Array<int>> flow;
  flow.reserve(m.reevings.size());
  for (const auto& r : m.reevings) flow.emplace_back(r.nodes.size(), 0);
  return flow;
}

}  // namespace taut_test
