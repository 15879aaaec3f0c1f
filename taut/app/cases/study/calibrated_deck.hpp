#pragma once
#include <string>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/job.hpp"
#include "taut/chance/calibration.hpp"

namespace taut::app {

/// The deck with the values found, all of them estimated, included decks in it, files by their whole paths, and with a
/// `study` whose inputs have the normal laws and the correlation of the fit, within its bounds. What it had in `study`
/// besides stays.
std::string calibrated_deck(const Job& job, const CaseModel& model, const std::vector<chance::FreeParameter>& free,
                            const chance::Calibration& found);

}  // namespace taut::app
