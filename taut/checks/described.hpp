#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"

namespace taut::checks {

/// The tables that `checks:` of a machine or a method adds, made of the same quantities as the tables themselves.
std::vector<TableWords> table_words();

}  // namespace taut::checks
