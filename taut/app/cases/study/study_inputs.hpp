#pragma once
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/study_deck.hpp"
#include "taut/chance/inputs.hpp"
#include "taut/chance/statistics.hpp"

namespace taut::app {

/// A limit of one output, SI.
struct StudyLimit {
  std::size_t output = 0;
  chance::Limit limit;
  std::optional<double> allowed;  ///< probability beyond it
};

/// The laws of the inputs, SI, and how they are correlated. Complaints below "study".
chance::Inputs study_inputs(const StudyRequest& request, const std::vector<CaseInput>& inputs,
                            std::vector<Complaint>& complaints);

/// The limits, SI. Complaints below "study".
std::vector<StudyLimit> study_limits(const StudyRequest& request, const std::vector<CaseOutput>& outputs,
                                     std::vector<Complaint>& complaints);

}  // namespace taut::app
