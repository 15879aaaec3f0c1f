#pragma once
#include <string>

#include "taut/report/figure/placement.hpp"

namespace taut::report {

inline constexpr double tick_size = 12;  ///< pixels, of the numbers along axes and rulers

/// A scale with round numbers beside a drawing.
struct EdgeRuler {
  std::string title;                    ///< "x, m"
  double from = 0, to = 0;              ///< shown units, from < to
  double from_pixel = 0, to_pixel = 0;  ///< where they stand
};

/// A part of a figure and what it covers, texts included.
struct Drawn {
  std::string svg;
  Box box;
};

/// Along the lower side, its line at `y`, numbers below it; along the left side, its line at `x`, numbers left of it.
/// Without room for two numbers: nothing.
Drawn ruler_level(const EdgeRuler& ruler, double y);
Drawn ruler_upright(const EdgeRuler& ruler, double x);

/// "−12.5": a number of an axis with as many decimals as its ticks need.
std::string tick_text(double v, const std::vector<double>& ticks);

}  // namespace taut::report
