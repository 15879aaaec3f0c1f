#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"

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

}  // namespace taut::app
