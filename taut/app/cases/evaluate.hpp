#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "taut/app/cases/case_model.hpp"

namespace taut::app {

/// A row of numbers without an answer.
struct RowWithout {
  std::size_t row = 0;
  std::string reason;
};

struct EvaluateOptions {
  int threads = 0;  ///< 0: all that the machine has
  /// Called after each row with the number of rows done, one thread at a time; false: no more rows are begun. May be
  /// empty.
  std::function<bool(std::size_t done)> go_on = {};
};

/// What a call of evaluate() leaves besides the numbers.
struct Evaluated {
  std::vector<RowWithout> without;  ///< in the order of the rows
  bool interrupted = false;         ///< rows that were not calculated are NaN
};

/// Calculates many rows of numbers on several threads. `values`: one row of the model's inputs after another, SI;
/// `outputs`: place for as many rows of its outputs, NaN where a row has no answer. The numbers do not depend on the
/// number of threads. Throws ContractViolation where the sizes do not fit.
Evaluated evaluate(const CaseModel& model, std::span<const double> values, std::span<double> outputs,
                   const EvaluateOptions& options = {});

}  // namespace taut::app
