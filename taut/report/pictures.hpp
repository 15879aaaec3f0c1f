#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// The figure of page 1: the one that the result names, else the first; nullptr when there is none that can be drawn.
const Figure* key_figure(const Result& r);

/// Figures with their captions: drawings, then what moves, then plots. `number`: of the animations in the page so far.
std::string pictures_html(const std::vector<const Figure*>& figures, const Result& r, int& number);

/// All figures in that order.
std::vector<const Figure*> figures_in_order(const Result& r);

}  // namespace taut::report
