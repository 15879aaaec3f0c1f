#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/results/machine_run.hpp"
#include "taut/solve/quantities.hpp"

namespace taut::results {

/// The tables of a static answer: spans, sheaves, bodies, anchors, ropes, closure for each equilibrium, and load_path
/// for each load path. Tensions by the order of the path; forces are those of the ropes on what holds them, one copy.
void add_tables(const MachineRun& run, Result& r);

/// Of the first equilibrium the places of free bodies and the unstretched lengths; of each one the tensions at the
/// ropes' ends; drives. The worst cases over all states are the judge's.
void add_values(const MachineRun& run, Result& r);

/// The table `places`.
const Quantities<machine::PlaceOverGround>& over_ground_quantities();

/// What `spans` has besides, where there is terrain.
const Quantities<solve::BranchRow>& branch_terrain_quantities();

/// Of one equilibrium, where the machine has them: rope_loads, drives, drums.
void add_drive_tables(const study::EquilibriumRun& one, const std::function<void(Table)>& add);

/// Torque and power of the driven sheaves in each equilibrium.
void add_drive_values(const MachineRun& run, Result& r);
/// A friction that no wet, oily or sap-covered rope has.
void warn_of_friction(const machine::Model& model, Result& r);

/// What the calculation takes for granted, the carriages' models by name.
std::vector<std::string> assumptions_of(const machine::Machine& machine, const Display& display = {});

}  // namespace taut::results
