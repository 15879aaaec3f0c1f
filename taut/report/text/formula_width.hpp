#pragma once
#include <string_view>

#include "taut/calc/formula.hpp"
#include "taut/report/text/mathml.hpp"

namespace taut::report {

/// Width of a formula on paper in multiples of the font size, estimated within about a fifth: enough to tell whether a
/// line has to be broken or set smaller.
double formula_width(const FormulaNode& node, Leaves leaves, std::string_view unknown = {});

}  // namespace taut::report
