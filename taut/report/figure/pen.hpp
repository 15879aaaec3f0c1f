#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/report/figure/placement.hpp"

namespace taut::report {

/// Of all figures, pixels.
inline constexpr double font_size = 12.5;
inline constexpr double paper_width = 660;  ///< what a page takes in its full width

/// How a role is drawn.
struct Pen {
  std::string_view stroke;
  double width = 1;
  std::string_view dashes;  ///< empty: solid
  std::string_view fill;    ///< for filled shapes
  std::string_view words;   ///< in the legend; empty: needs none
  double weight = 1;        ///< how little a label should cover it
};
const Pen& pen(Role role);

/// Metres of the machine to pixels: to scale, y turned down and stretched by `vertical`.
struct Fit {
  double scale = 1;
  double vertical = 1;
  Pixel of(Point p) const { return {.x = p.x * scale, .y = -p.y * scale * vertical}; }
};

bool is_finite(Point p);

/// "M1 2L3 4"; points nearer than a third of a pixel to the last one drawn are left out, those not finite break the
/// line.
std::string path_data(const std::vector<Pixel>& points, bool closed);

/// stroke="..." stroke-width="..." and dashes of a role.
std::string stroke_of(const Pen& p);

/// A filled triangle with its tip at `tip`, pointing along (dx, dy).
std::string arrow_head(Pixel tip, double dx, double dy, double size, std::string_view colour);

}  // namespace taut::report
