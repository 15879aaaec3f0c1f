#pragma once
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// Drawings of the machine, side view and, where it has a width, plan, at its first equilibrium (else where a load path
/// has its largest tension), with the forces of the ropes on what holds them; for each load path the profile of the
/// line, the tensions and the clearance. Offers profile and drawing for page 1.
void add_figures(MachineRun& run, Result& r);

/// Of a machine without a load path: the tension along each rope's way, arcs counted; of one rope all equilibria in one
/// plot, with the names of its path.
void add_path_plots(const MachineRun& run, Result& r);

}  // namespace taut::results
