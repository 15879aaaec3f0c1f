#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/units/display.hpp"

namespace taut {

const Quantities<Comparison>& comparison_quantities();

/// The comparisons as a table `comparison` (SI, unit as text), empty when there are none.
Table comparison_table(const std::vector<Comparison>& all);
/// The same in the units of `display`: the column `unit` names them.
Table comparison_table(const std::vector<Comparison>& all, const Display& display);

}  // namespace taut
