#include "taut/app/cases/study/study_run.hpp"

#include <cmath>
#include <mutex>
#include <optional>

#include "taut/app/cases/on_threads.hpp"
#include "taut/app/cases/study/case_counter.hpp"

namespace taut::app {
namespace {

/// The rows of a part; empty where it was ended.
std::vector<KeptCase> rows_of(const Study& study, const CaseBlock& block, CaseCounter& counter) {
  std::vector<KeptCase> rows;
  rows.reserve(block.count);
  for (std::uint64_t i = block.first; i < block.end(); ++i) {
    if (counter.ended()) return {};
    KeptCase row{.index = i, .values = study.values_at(i), .answer = {}};
    row.answer = study.model.answer(row.values);
    rows.push_back(std::move(row));
    if (!counter.go_on()) return {};
  }
  return rows;
}

}  // namespace

StudyState state_of(const StudyFolder& folder) {
  const StudyParts& parts = folder.parts();
  StudyState state{.cases = parts.cases, .cases_done = 0, .parts = parts.count(), .parts_done = 0};
  const std::vector<bool> done = folder.done();
  for (std::uint64_t p = 0; p < done.size(); ++p) {
    if (!done[p]) continue;
    ++state.parts_done;
    state.cases_done += parts.of(p).count;
  }
  return state;
}

tl::expected<StudyState, FileError> run_cases(const Study& study, const StudyFolder& folder,
                                              const StudyOptions& options) {
  const std::vector<bool> done = folder.done();
  std::vector<std::uint64_t> open;
  std::uint64_t cases = 0;
  for (std::uint64_t p = 0; p < done.size(); ++p) {
    if (done[p] || p % options.of != options.shard - 1) continue;
    open.push_back(p);
    cases += folder.parts().of(p).count;
  }
  CaseCounter counter("study", cases, true, options.progress);
  std::mutex turn;
  std::optional<FileError> trouble;
  const auto calculate = [&](std::size_t k) {
    const std::vector<KeptCase> rows = rows_of(study, folder.parts().of(open[k]), counter);
    if (rows.empty()) return;
    const auto written = folder.write(open[k], study, rows);
    if (written) return;
    const std::lock_guard lock(turn);
    trouble = written.error();
  };
  on_threads(options.threads, open.size(), calculate);
  if (trouble) return tl::unexpected(*trouble);
  StudyState state = state_of(folder);
  state.interrupted = counter.ended();
  return state;
}

chance::Evaluate parallel(const CaseModel& model, int threads, CaseCounter* counter) {
  return [&model, threads, counter](std::span<const chance::Point> points) {
    std::vector<std::vector<double>> rows(points.size());
    on_threads(threads, points.size(), [&](std::size_t i) {
      if (counter != nullptr && counter->ended()) {
        rows[i].assign(model.outputs.size(), std::nan(""));
        return;
      }
      rows[i] = model.answer(points[i]).outputs;
      if (counter != nullptr) counter->go_on();
    });
    return rows;
  };
}

}  // namespace taut::app
