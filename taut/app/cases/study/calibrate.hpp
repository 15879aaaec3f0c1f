#pragma once
#include "taut/app/cases/read_cases.hpp"
#include "taut/app/job.hpp"
#include "taut/calc/result.hpp"

namespace taut::app {

/// Finds the numbers that a deck's `calibrate` leaves free by least squares of what was measured: values with
/// intervals, what the measurements do not tell, residuals, covariance, and as attachment `calibrated.yaml` the deck
/// with the values found and a `study` that goes on from them. Status bad_deck, or not_converged where there is no fit.
Result calibrate(const Job& job, int threads);

/// Mistakes of the block `calibrate` that show without a calculation: numbers that the deck has not, or twice, their
/// units and bounds, and the file of measurements. What outputs are called is not looked up.
Diagnostics check_calibration(const ReadCases& read);

}  // namespace taut::app
