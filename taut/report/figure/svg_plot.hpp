#pragma once
#include <string>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A plot as one <svg>: round ticks, axis titles with the unit, curves broken at NaN. No text stands over the curves:
/// the legend is above the axes, limits (lines over the whole width) are named in the margin on the right, events and
/// marked points in a lane above the axes, by their words or, where these have no room, by numbers with a list below.
/// A limit far outside the curves' range is named in the legend instead of flattening the curves. No value at all: says
/// so.
std::string plot_svg(const Plot& plot, const Display& display);

/// The same below other plots of a page. `listed`: the list of the last plot that has one; becomes this plot's. Where
/// both are the same, one line refers to the plot above instead.
std::string plot_svg(const Plot& plot, const Display& display, std::vector<std::string>& listed);

}  // namespace taut::report
