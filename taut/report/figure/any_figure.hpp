#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Any figure as one static <svg> (a paragraph that says so when there is nothing to show): a drawing, a plot, a
/// profile, or of an animation a strip of four to six moments. No script, no id: the same figure may stand twice in a
/// page.
std::string figure_svg(const Figure& figure, const Display& display);

}  // namespace taut::report
