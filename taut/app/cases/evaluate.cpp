#include "taut/app/cases/evaluate.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "taut/app/cases/on_threads.hpp"
#include "taut/base/expects.hpp"

namespace taut::app {

Evaluated evaluate(const CaseModel& model, std::span<const double> values, std::span<double> outputs,
                   const EvaluateOptions& options) {
  const std::size_t in = model.inputs.size(), out = model.outputs.size();
  expects(in > 0 && values.size() % in == 0, "rows of numbers, one for each input");
  const std::size_t rows = values.size() / in;
  expects(outputs.size() == rows * out, "a place for each output of each row");
  std::fill(outputs.begin(), outputs.end(), std::nan(""));
  Evaluated evaluated;
  std::mutex turn;
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> ended = false;
  const auto calculate = [&](std::size_t row) {
    if (ended) return;
    CaseAnswer answer = model.answer(values.subspan(row * in, in));
    if (answer.outcome.ok()) {
      std::copy(answer.outputs.begin(), answer.outputs.end(), outputs.begin() + static_cast<std::ptrdiff_t>(row * out));
    }
    ++done;
    if (answer.outcome.ok() && !options.go_on) return;
    const std::lock_guard lock(turn);
    if (!answer.outcome.ok()) evaluated.without.push_back({row, std::move(answer.outcome.message)});
    if (options.go_on && !ended && !options.go_on(done)) ended = true;
  };
  on_threads(options.threads, rows, calculate);
  std::sort(evaluated.without.begin(), evaluated.without.end(),
            [](const RowWithout& a, const RowWithout& b) { return a.row < b.row; });
  evaluated.interrupted = done < rows;
  return evaluated;
}

}  // namespace taut::app
