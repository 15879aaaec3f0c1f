#pragma once
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// Each equilibrium that was found as a machine in space, with the tension along its ropes.
void add_scenes(const MachineRun& run, Result& r);

}  // namespace taut::results
