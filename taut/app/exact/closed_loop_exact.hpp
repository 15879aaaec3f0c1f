#pragma once
#include "taut/methods/closed_loop/engine.hpp"
#include "taut/solve/exact/running_loop.hpp"
#include "taut/units/display.hpp"

/// Where the published closed loop meets the engine: its deck as a running loop of catenaries.
namespace taut::app {

/// The loop of a deck, for a position's weights, efficiency and load. `c.x` and `c.f` are its place.
solve::RunningLoop running_loop(const closed_loop::Input& in, const closed_loop::Case<double>& c);

/// Exact sag and exact values for closed_loop.
const closed_loop::Engine& loop_engine();

/// closed_loop::run with the exact column: every mode, and chosen ropes verified by catenaries.
Result run_closed_loop(const closed_loop::Input& in, const Display& display = Display());

}  // namespace taut::app
