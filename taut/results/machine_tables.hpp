#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// The tables of a static answer: spans, sheaves, bodies, anchors, ropes, closure for each equilibrium, and load_path
/// for each load path. Tensions by the order of the path; forces are those of the ropes on what holds them, one copy.
void add_tables(const MachineRun& run, Result& r);

/// The columns of a carriage's positions: x, z, clearance, tensions at both ends of each rope and its largest one, what
/// each contact gets, closure; and the row of one position, in the columns of the model `all`.
std::vector<Column> load_path_columns(const machine::Model& all);
std::vector<Cell> load_path_row(const machine::Model& all, const machine::Model& m, const study::LoadPathPoint& point);

/// Of the first equilibrium the places of free bodies and the unstretched lengths; of each one the tensions at the
/// ropes' ends; drives. The worst cases over all states are the judge's.
void add_values(const MachineRun& run, Result& r);

/// Of one equilibrium, where the machine has them: rope_loads, drives, drums.
void add_drive_tables(const EquilibriumRun& one, const std::function<void(Table)>& add);

/// Columns of a load path for the drums whose rope on them is known, and the cells of one answer: rope on it, layer,
/// torque.
void add_drum_columns(const machine::Model& model, std::vector<Column>& columns);
void add_drum_cells(const machine::Model& model, const solve::EquilibriumResult& e, std::vector<Cell>& row);

/// Torque and power of the driven sheaves in each equilibrium.
void add_drive_values(const MachineRun& run, Result& r);
/// A friction that no wet, oily or sap-covered rope has.
void warn_of_friction(const machine::Model& model, Result& r);

/// What the calculation takes for granted, the carriages' models by name.
std::vector<std::string> assumptions_of(const machine::Machine& machine);

/// Force of a span's rope on what holds its start and its end, N.
Vector3 pull_on_start(const solve::SpanResult& span);
Vector3 pull_on_end(const solve::SpanResult& span);

std::string_view to_text(solve::ContactState state);

}  // namespace taut::results
