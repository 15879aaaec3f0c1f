#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/calc/value_kind.hpp"

namespace taut::app {

/// Tables of results that belong together, as the reference lists them.
struct TableGroup {
  std::string title;  ///< "Tables of checks"
  std::string words;  ///< when they are there
  std::vector<TableWords> tables;
};

/// The tables of all rooms besides those of a machine's states and analyses: of checks, of a design, of the methods, of
/// comparing.
std::vector<TableGroup> table_groups();

/// Values of results by name that belong together, as the reference lists them.
struct ValueGroup {
  std::string title;  ///< "Values of the verdict and of checks"
  std::vector<ValueKind> values;
};

/// Those of machines and their analyses, of the verdict and checks, of designs. Those of the methods are besides.
std::vector<ValueGroup> value_groups();

}  // namespace taut::app
