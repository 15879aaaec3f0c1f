#pragma once
#include "taut/mechanics/configuration.hpp"

namespace taut_test {

/// No loss anywhere.
inline taut::Array<taut::Array<int>> no_flow(const taut::machine::Model& m) {
  taut::Array<taut::Array<int>> flow;
  flow.reserve(m.reevings.size());
  for (const auto& r : m.reevings) flow.emplace_back(r.nodes.size(), 0);
  return flow;
}

}  // namespace taut_test
