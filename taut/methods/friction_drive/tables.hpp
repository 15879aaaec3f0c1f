#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"

namespace taut::friction_drive {

/// The two readings of k that are found, none, and the one at hand, which `as_given` is of.
Table readings_table(const Input& in, const Output& as_given);

/// This table as described.
std::vector<TableWords> table_words();

}  // namespace taut::friction_drive
