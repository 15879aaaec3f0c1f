#pragma once
#include "taut/calc/result.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::app {

/// Moment, stress and deflection over the height, and for a guyed mast the plan with the forces of its guys.
void add_mast_figures(const machine::Model& model, const solve::EquilibriumResult& found, double allowable, Result& r);

}  // namespace taut::app
