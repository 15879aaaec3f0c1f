#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/read_cases.hpp"
#include "taut/app/cases/study/study_inputs.hpp"
#include "taut/app/cases/study_deck.hpp"
#include "taut/app/job.hpp"
#include "taut/chance/point_set.hpp"
#include "taut/chance/sensitivity.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// Cases with consecutive numbers that serve one answer.
struct CaseBlock {
  std::uint64_t first = 0, count = 0;
  std::uint64_t end() const { return first + count; }
};

/// A deck with `study:`, ready to be calculated. Immutable; a case is a function of its number alone.
struct Study {
  StudyRequest request;
  CaseModel model;
  chance::Inputs inputs;
  std::vector<StudyLimit> limits;
  std::optional<chance::PointSet> points;       ///< of the sample; none of a grid
  std::optional<chance::SaltelliPlan> indices;  ///< where Sobol indices are asked for
  chance::Points tornado;
  CaseBlock sample, saltelli, bars;  ///< the numbers of their cases

  std::string title, method;
  Project project;
  Display display;
  std::string deck_name;
  std::vector<std::string> overrides;  ///< values set over the deck
  std::string hash;                    ///< of the deck, all that it names and what was set

  std::uint64_t size() const { return bars.end(); }
  /// The numbers of a case, SI; index < size().
  chance::Point values_at(std::uint64_t index) const;
  bool asks(const std::string& answer) const;
};

/// Reads the deck of a job and runs it once as it is. Else a result that says why there is no study: status bad_deck
/// with mistakes, or no answer of the deck itself.
tl::expected<Study, Result> read_study(const Job& job);

/// Mistakes of the block `study` that show without a calculation: numbers that the deck has not, or twice, their units,
/// laws and bounds. What outputs are called is not looked up.
Diagnostics check_study(const ReadCases& read);

}  // namespace taut::app
