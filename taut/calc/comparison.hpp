#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"

namespace taut {

const Quantities<Comparison>& comparison_quantities();

/// The comparisons as a table `comparison` (SI, unit as text), empty when there are none.
Table comparison_table(const std::vector<Comparison>& all);

}  // namespace taut
