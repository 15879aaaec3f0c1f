#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A plot as one <svg>: round ticks, axis titles with the unit, legend above the axes (so that it never covers a
/// curve), curves broken at NaN, limits as lines over the whole width, marked points with their words. A limit far
/// outside the curves' range is named in the legend instead of flattening the curves. No value at all: says so.
std::string plot_svg(const Plot& plot, const Display& display);

}  // namespace taut::report
