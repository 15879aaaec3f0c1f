#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {

/// All that the integrator remembers at the time reached, as a list of numbers: with it a run goes on as if it had
/// never stopped, to the last bit when its steps are given.
Array<double> memory_of(Run& run);

/// Takes such a list. False, and nothing is changed, when it is of another machine, method or share of damping.
bool take_memory(Run& run, const Array<double>& memory);

}  // namespace taut::solve::dynamics
