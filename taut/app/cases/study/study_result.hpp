#pragma once
#include <map>
#include <string>
#include <tl/expected.hpp>

#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/base/long_rows.hpp"
#include "taut/calc/result.hpp"

namespace taut::app {

/// A case without an answer.
struct FailedCase {
  std::uint64_t index = 0;
  std::string reason;
};

/// What a case is judged by beside the limits of the study.
struct FlawedCase {
  std::uint64_t index = 0;
  CaseFlaw flaw;
};

/// All cases of a study.
struct StudyData {
  Table rows;                                ///< `cases`: long rows of number, inputs, outputs, status (0: ok), SI
  std::vector<std::vector<double>> outputs;  ///< by output, in the order of the cases; NaN where one failed
  std::vector<FailedCase> failed;
  std::vector<FlawedCase> flawed;             ///< in the order of the cases; a case may be there several times
  std::map<std::string, double> weaker = {};  ///< least strengths of the cases, where below those of the model
};

/// Reads the parts in their order; the error: one is missing or broken.
tl::expected<StudyData, FileError> read_cases(const Study& study, const StudyFolder& folder);

/// What the cases say: tables, figures, checks of the allowed probabilities, answers. FORM and importance sampling
/// calculate cases of their own, on the threads of the options and with their progress; where they have no answer the
/// result has none, and where they are interrupted it has no number of them and says so.
Result study_result(const Study& study, const StudyData& data, const StudyOptions& options);

}  // namespace taut::app
