#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Colours of tensions in a motion: eight steps from zero to the largest tension of all times.
struct TensionScale {
  double most = 0;  ///< N; 0: the animation has no tensions
};
TensionScale tension_scale(const Animation& animation);

/// Classes of a line at a time: "line t3", "line slack", or those of its role where it has no tension.
std::string line_classes(const Animation::Line& line, std::size_t time, const TensionScale& scale);
/// One character for a script: '0' to '7', 's' for slack, '-' for none.
char tension_letter(const Animation::Line& line, std::size_t time, const TensionScale& scale);

/// The row that says what the colours mean, its left end at `at`; `box` grows by it. Nothing without tensions.
std::string tension_legend(const TensionScale& scale, const Display& display, Pixel at, Box& box);

}  // namespace taut::report
