#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "taut/results/machine_run.hpp"

namespace taut::results {

/// For the captions of drawings with forces.
inline constexpr const char* whole_forces = "A number is the whole force, an arrow its part in this view.";

/// Drawings of the machine, side view and, where it has a width, plan, at its first equilibrium (else where a load path
/// has its largest tension), with the forces of the ropes on what holds them; for each load path the profile of the
/// line, the tensions and the clearance. Offers profile and drawing for page 1. Of a result that is not ok, of a run
/// that has neither a state nor a picture: the machine as described.
void add_figures(MachineRun& run, Result& r);

/// The machine as described, ropes straight and without tensions, from the same sides; for a result without any state.
/// `why`: "no equilibrium was found". It is the picture of page 1.
void add_described_figures(MachineRun& run, const std::string& why, Result& r);

/// Lines from the origin of each body to what sits on it, faces and cylinders. `in_ground`: where a place is.
std::vector<std::array<Vector3, 2>> body_lines(const machine::Model& m,
                                               const std::function<Vector3(const machine::Place&)>& in_ground);

/// Of a machine without a load path: the tension along each rope's way, arcs counted; of one rope all equilibria in one
/// plot, with the names of its path.
void add_path_plots(const MachineRun& run, Result& r);

}  // namespace taut::results
