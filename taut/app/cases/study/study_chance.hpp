#pragma once
#include <string>
#include <vector>

#include "taut/app/cases/study/study_result.hpp"
#include "taut/chance/reliability/form.hpp"
#include "taut/chance/sensitivity.hpp"
#include "taut/chance/statistics.hpp"

namespace taut::app {

/// What the figures of a study need, and the estimates for its summary.
struct ChanceSummary {
  struct Line {
    std::string of, what;
    Unit unit;
    chance::Estimate estimate;
  };
  std::vector<Line> lines;
  std::vector<chance::LimitProbability> probabilities;  ///< by limit, of the sample
  std::vector<chance::Sensitivity> indices;             ///< by output; empty: not asked for
};

/// The sample of an output; `data` outlives it.
chance::Sample sample_of(const Study& study, const StudyData& data, std::size_t output);

/// Probabilities of the limits with their verdicts, Sobol indices, tornado, FORM, SORM, importance sampling.
void add_chance(const Study& study, const StudyData& data, const StudyOptions& options, ChanceSummary& summary,
                Result& r);

}  // namespace taut::app
