#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// One position of a carriage with the model it was solved with. `all`: the model whose ropes and contacts are columns;
/// `model` has the carriage in the span where it is, so that its contacts have other numbers.
struct LoadPathRow {
  const machine::Model& all;
  const machine::Model& model;
  const study::LoadPathPoint& point;
};

/// The columns of a carriage's positions: x, z, clearance; of each rope the tensions at both ends, the largest one and
/// its length; of each contact its tensions, wrap and force; of each drum with a known length what is on it; closure.
std::vector<Column> load_path_columns(const machine::Model& all);
std::vector<Cell> load_path_cells(const LoadPathRow& row);

/// A line for each position with an equilibrium.
Table load_path_table(const machine::Model& all, const study::LoadPathRun& run);

/// The same columns as they are described: ROPE, ANCHOR, NAME stand for names of the deck.
std::vector<QuantityWords> load_path_words();

}  // namespace taut::results
