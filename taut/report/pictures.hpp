#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/report/figure/any_figure.hpp"

namespace taut::report {

/// The figure of page 1: the one that the result names, else the first; nullptr when there is none that can be drawn.
const Figure* key_figure(const Result& r);

/// Figures with their captions: drawings, then what moves, then plots. Each group lists the
/// events of its plots once.
std::string pictures_html(const std::vector<const Figure*>& figures, const Result& r, FiguresAbove& above);

/// All figures in that order.
std::vector<const Figure*> figures_in_order(const Result& r);

}  // namespace taut::report
