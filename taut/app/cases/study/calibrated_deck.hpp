#pragma once
#include <string>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/read_cases.hpp"
#include "taut/chance/calibration.hpp"

namespace taut::app {

/// The deck with the values found, all of them estimated, included decks in it, files by their whole paths, and with a
/// `study` whose inputs have the normal laws and the correlation of the fit, within its bounds. With another
/// temperature its ropes and beams name that at which their lengths hold. What it had in `study` besides stays. Where
/// the deck as it was cannot stand beside the fit it gives way, so that the new one can be read: laws and correlations
/// of the numbers found, correlations that contradict those of the fit, a grid, indices of correlated inputs,
/// parameters that nothing uses any more. Comments at its top say what.
std::string calibrated_deck(const ReadCases& read, const CaseModel& model,
                            const std::vector<chance::FreeParameter>& free, const chance::Calibration& found);

}  // namespace taut::app
