#pragma once
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/calc/num.hpp"
#include "taut/calc/sheet.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/results/machine_run.hpp"

/// What a machine's elastic beams add to its result.
namespace taut::results {

/// Whether a body is listed in tables: sections within beams are not, their free tops are.
bool is_listed(const machine::Body& body);

/// Of each equilibrium: `beams` (forces, stress and deflection along each beam) and `beam_ends` (largest values,
/// reactions of what a beam stands on, critical axial force).
void add_beam_tables(const MachineRun& run, Result& r);

/// Worst cases over all analyses: NAME.M_max, N_max, stress_max, top_displacement, N_cr, alpha_cr; of the first
/// equilibrium NAME.N_base and the reactions at the base. Checks of the stress against the steel's yield stress, and of
/// the compression against the critical one. Warnings of unverified rows and imperfections on the harmless side.
void add_beam_values(const machine::Machine& machine, const MachineRun& run, Result& r);

std::vector<std::string> beam_assumptions(const machine::Machine& machine);

/// The beam's worst section, line by line.
void write_beams(Sheet<Num>& s, const MachineRun& run);

/// Along x: bending moment, axial force and deflection of each beam in each equilibrium.
void add_beam_plots(const MachineRun& run, Result& r);

/// The beams of a state, as lines of points of the machine.
std::vector<std::vector<Vector3>> beam_lines(const solve::EquilibriumResult& e);

/// The factor by which a drawing of this size shows deflections beside their true size; 0: they can be seen as they
/// are, or there are none.
double shown_times(const solve::EquilibriumResult& e, double size);

/// The same lines with the deflections so many times as large.
std::vector<std::vector<Vector3>> beam_lines(const solve::EquilibriumResult& e, double times);

}  // namespace taut::results
