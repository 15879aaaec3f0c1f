#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A moving drawing as HTML: an <svg> to scale that shows the first time, and, where scripts run, a button, a slider
/// over the times and the readings beside it. Nothing is loaded from elsewhere. `number`: of the animation in its
/// page, from 0. Fewer than two times: nothing.
/// Of long motions as many times are kept as fit into about 200 kB; the caption says how far apart.
std::string animation_html(const Animation& animation, const Display& display, int number);

}  // namespace taut::report
