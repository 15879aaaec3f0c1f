#pragma once
#include "taut/analysis/guyed_mast.hpp"
#include "taut/calc/result.hpp"

namespace taut::app {

/// Moment, stress and deflection over the height, and for a guyed mast the plan with the forces of its guys.
void add_mast_figures(const analysis::GuyedMast& mast, const analysis::GuyedMastResult& m, double allowable, Result& r);

}  // namespace taut::app
