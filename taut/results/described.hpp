#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"

namespace taut::results {

/// The tables of a machine's states and analyses, in the order of the results. Made of the same quantities as the
/// tables themselves.
std::vector<TableWords> table_words();

/// The values of a machine that are one of those quantities: "ROPE.T_start". Those of checks and verdict are besides.
std::vector<QuantityWords> value_words();

}  // namespace taut::results
