#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/slip.hpp"
#include "taut/units/display.hpp"

/// The tables of the result, each of one list of quantities.
namespace taut::boom_ropes {

/// "lift", "retract", "extend".
std::string name_of(Operation operation);

Table cases_table(const Input& in, const Output& out, const Display& display);
/// Tensioning in turn until section 3, held by `friction` (N), begins to slip.
Table tensioning_table(std::string name, std::string title, double friction, int steps);
Table extension_table(const Output& out);
/// `found`: for each of `sliding.slip_angles`.
Table slip_table(const Sliding& sliding, const std::vector<SlipAngle>& found);

/// These tables as described.
std::vector<TableWords> table_words();

}  // namespace taut::boom_ropes
