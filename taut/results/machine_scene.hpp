#pragma once
#include <functional>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// Each equilibrium that was found as a machine in space, with the tension along its ropes.
void add_scenes(const MachineRun& run, Result& r);

/// Lines from the origin of each body to what sits on it, faces and cylinders, as lines of a scene without tension.
/// `in_ground`: where a place is in a frame.
std::vector<SceneLine> body_scene_lines(const machine::Model& m, std::size_t frames,
                                        const std::function<Vector3(std::size_t, const machine::Place&)>& in_ground);

}  // namespace taut::results
