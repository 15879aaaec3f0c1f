#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// The answers of a deck's analyses besides equilibria and load paths, on the machine with its guys put up. Each adds
/// its tables, values, figures, checks and warnings to the result.
void add_answer(const study::PayloadRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::InstallationRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::CycleRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::EnvelopeRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::SweepRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::TransientRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::PretensionRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::LeastTensionRun& asked, MachineRun& machine, Result& r);
void add_answer(const study::ModesRun& asked, MachineRun& machine, Result& r);

/// The columns of these tables, as described: several kinds of things are in one of them, or columns by names of the
/// deck.
std::vector<QuantityWords> installation_words();
std::vector<QuantityWords> lengths_words();
std::vector<QuantityWords> cycle_words();
std::vector<QuantityWords> tensioning_words();
std::vector<QuantityWords> least_tension_words();
std::vector<QuantityWords> sweep_words();
/// The column of a payload's table behind `payload` and `governing`, one for each support at which it counts.
QuantityWords held_angle_words();

}  // namespace taut::results
