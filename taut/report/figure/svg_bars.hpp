#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Bars as one <svg>: names at the left, the axis below with round ticks, a legend above where there are several
/// series, confidence intervals as thin lines. Bars without a number are left out; without any: says so.
std::string bars_svg(const Bars& bars, const Display& display);

}  // namespace taut::report
