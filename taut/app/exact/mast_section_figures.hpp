#pragma once
#include "taut/calc/result.hpp"
#include "taut/solve/exact/guyed_mast.hpp"

namespace taut::app {

/// Moment, stress and deflection over the height, and for a guyed mast the plan with the forces of its guys.
void add_mast_figures(const solve::GuyedMast& mast, const solve::GuyedMastResult& m, double allowable, Result& r);

}  // namespace taut::app
