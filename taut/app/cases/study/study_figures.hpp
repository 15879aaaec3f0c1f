#pragma once
#include "taut/app/cases/study/study_chance.hpp"

namespace taut::app {

/// Histogram of each output with its limits; bars of the Sobol indices and of the tornado; how each probability has
/// settled with the number of cases; each output over the input that matters most to it. Of a grid with one input: each
/// output over it.
void add_study_figures(const Study& study, const StudyData& data, const ChanceSummary& chance, Result& r);

}  // namespace taut::app
