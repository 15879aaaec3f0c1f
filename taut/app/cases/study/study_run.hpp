#pragma once
#include <functional>
#include <tl/expected.hpp>

#include "taut/app/cases/study/case_counter.hpp"
#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"
#include "taut/calc/progress.hpp"

namespace taut::app {

struct StudyOptions {
  int threads = 0;                  ///< 0: all that the machine has
  std::uint64_t shard = 1, of = 1;  ///< calculates the parts p with p mod `of` = shard - 1
  std::function<bool(const Progress&)> progress = {};
};

/// How far the cases of a study are.
struct StudyState {
  std::uint64_t cases = 0, cases_done = 0;
  std::uint64_t parts = 0, parts_done = 0;
  bool interrupted = false;
  bool whole() const { return parts_done == parts; }
};

StudyState state_of(const StudyFolder& folder);

/// Calculates the parts of a shard that are not there yet, on several threads. A part that was begun when it is
/// interrupted is not kept. The error: a part could not be written.
tl::expected<StudyState, FileError> run_cases(const Study& study, const StudyFolder& folder,
                                              const StudyOptions& options);

/// The study's model on several points at once, for what asks for cases of its own. `counter`: counts them; once it has
/// ended no case is calculated any more, and its outputs are NaN. May be null.
chance::Evaluate parallel(const CaseModel& model, int threads, CaseCounter* counter = nullptr);

}  // namespace taut::app
