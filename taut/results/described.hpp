#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"

namespace taut::results {

/// A table of a result as a reader looks it up: its name without an analysis' ending, what its rows are, its columns.
struct TableWords {
  std::string name;
  std::string rows;
  std::vector<QuantityWords> columns;
};

/// The tables of a machine's states and analyses, in the order of the results. Made of the same quantities as the
/// tables themselves.
std::vector<TableWords> table_words();

/// The values of a machine that are one of those quantities: "ROPE.T_start". Those of checks and verdict are besides.
std::vector<QuantityWords> value_words();

}  // namespace taut::results
