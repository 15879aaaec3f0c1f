#pragma once
#include <array>

#include "taut/analysis/running_loop.hpp"

namespace taut::analysis {

/// What the Newton iteration of a running loop solves for.
struct LoopUnknowns {
  /// Horizontal tensions: lower branch at A, between the sections, lower branch at B, upper branch at A and at B. N
  std::array<double, 5> H{};
  double lean = 0;
  LoopNode first, second;  ///< without a second section only `first` counts
};

/// Damped Newton from `start`: balance of the nodes, the roller's law, the sheave, and the given place. True when it
/// has converged to rounding; `state` is then that equilibrium, whatever the sign of the roller force.
bool newton(const RunningLoop& loop, const LoopPlace& place, const LoopUnknowns& start, LoopState& state);

}  // namespace taut::analysis
