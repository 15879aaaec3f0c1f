#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A drawing to scale as one <svg>: shapes by role, force arrows at one force scale with their values, dimension lines,
/// angle arcs, ground hatching, a bar for the scale of lengths and one for forces, and a legend of the roles used.
/// Labels look for free places. In a force polygon (unit si::N) arrows have the scale of the coordinates.
/// Shapes with coordinates that are not finite are left out; a drawing without any shape says so.
std::string drawing_svg(const Drawing& drawing, const Display& display);

/// "Heights are drawn 5 times as large as lengths." or empty.
std::string scale_words(const Drawing& drawing);

}  // namespace taut::report
