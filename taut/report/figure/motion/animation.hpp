#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A moving drawing as HTML. In print, and where no scripts run, it is the strip of moments (`strip_svg`); where they
/// run, the strip gives way to an <svg> to scale that plays: a button, a slider over the times, the readings beside it,
/// ropes in the colour of their tension, names that never cover each other. Nothing is loaded from elsewhere. `number`:
/// of the animation in its page, from 0. Fewer than two times: nothing.
/// Of long motions as many times are kept as fit into about 200 kB.
std::string animation_html(const Animation& animation, const Display& display, int number);

}  // namespace taut::report
