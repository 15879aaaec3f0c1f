#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/calc/value_kind.hpp"

namespace taut::results {

/// The tables of a machine's states and analyses, in the order of the results. Made of the same quantities as the
/// tables themselves.
std::vector<TableWords> table_words();

/// The values of a machine by name, "ROPE.T_start", "payload_min", as the analyses make them. Those of checks and
/// verdict are besides (checks/described.hpp).
const std::vector<ValueKind>& value_kinds();

}  // namespace taut::results
