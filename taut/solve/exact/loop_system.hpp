#pragma once
#include <array>

#include "taut/solve/exact/running_loop.hpp"

namespace taut::solve {

/// What the Newton iteration of a running loop solves for.
struct LoopUnknowns {
  /// Horizontal tensions: lower branch at A, between the sections, lower branch at B, upper branch at A and at B. N
  std::array<double, 5> H{};
  double lean = 0;
  LoopNode first, second;  ///< without a second section only `first` counts
};

/// The upper supports less the lower ones.
LoopNode upper_offset(const RunningLoop& loop);

/// Whether the roller presses on the upper branch, and no branch of the return rope hangs so deep that it would pull
/// harder if it were longer: the tension around a sheave or roller sets its length, and the taut one is meant.
bool is_feasible(const LoopState& state);

/// The equilibrium at a place whatever the sign of the roller force: from `near`, else or if that fails from straight
/// ropes. False when Newton does not converge from either.
bool reach_loop(const RunningLoop& loop, const LoopPlace& place, LoopState& state, const LoopState* near);

/// Damped Newton from `start`: balance of the nodes, the roller's law, the sheave, and the given place. True when it
/// has converged to rounding; `state` is then that equilibrium, whatever the sign of the roller force. False too for
/// the unstable answers of the same equations: a link on its head, ropes that hang so deep that a longer one pulls
/// harder.
bool newton(const RunningLoop& loop, const LoopPlace& place, const LoopUnknowns& start, LoopState& state);

}  // namespace taut::solve
