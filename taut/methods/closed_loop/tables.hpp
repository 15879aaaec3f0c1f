#pragma once
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/methods/closed_loop/sizing.hpp"

/// The tables of the result, each of one list of quantities.
namespace taut::closed_loop {

/// Whether some position is solved with catenaries too.
bool has_exact(const std::vector<Row>& rows);

Table positions_table(const std::vector<Row>& rows);
Table ropes_table(const Ropes& ropes, const Peaks& peaks, const Display& display);

/// These tables as described.
std::vector<TableWords> table_words();

}  // namespace taut::closed_loop
