#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A plot as one <svg>: round ticks, axis titles with the unit, curves broken at NaN. No text stands over the curves:
/// the legend is above the axes, limits (lines over the whole width) are named in the margin on the right, events and
/// marked points in a lane above the axes, by their words or, where these have no room, by numbers with a list below.
/// A limit far outside the curves' range is named in the legend instead of flattening the curves. No value at all: says
/// so.
std::string plot_svg(const Plot& plot, const Display& display);

}  // namespace taut::report
