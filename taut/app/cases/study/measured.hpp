#pragma once
#include <string>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/base/diagnostic.hpp"
#include "taut/units/unit.hpp"

namespace taut::app {

/// A table of measurements before its units are known.
struct MeasuredTable {
  std::string file, text;
  std::vector<std::string> outputs;  ///< that are measured, each once
  std::vector<std::string> paths;    ///< numbers of the deck that differ from row to row
};

/// Reads the heads of a CSV with the columns `output`, `value`, `sd` (may be missing) and one for each path. Notes
/// every mistake with file, line and column.
MeasuredTable read_measured(std::string text, std::string file, Diagnostics& mistakes);

/// The measurements in SI, once the units are known.
struct Measurements {
  std::vector<std::size_t> output;          ///< of each measurement
  std::vector<double> values;               ///< SI
  std::vector<double> sd;                   ///< SI; empty: no row has one
  std::vector<std::size_t> state;           ///< of each measurement: index into `states`
  std::vector<std::vector<double>> states;  ///< different settings, one number for each path, SI
};

/// Reads the numbers. The model's outputs are those of the table; `first_setting`: which of its inputs is the first
/// path.
Measurements in_si(const MeasuredTable& table, const CaseModel& model, std::size_t first_setting,
                   Diagnostics& mistakes);

}  // namespace taut::app
