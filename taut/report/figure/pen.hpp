#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/report/figure/placement.hpp"

namespace taut::report {

/// Of all figures, pixels.
inline constexpr double font_size = 12.5;
inline constexpr double paper_width = 660;    ///< what a page takes in its full width, 176 mm: 12.5 pixels are 9.4 pt
inline constexpr double figure_height = 470;  ///< a higher figure is of the class "tall"

/// The element <svg> of a figure: its classes, its title for those who do not see it, the box shown at its own size.
std::string svg_element(std::string_view classes, std::string_view title, const Box& box, const std::string& body);

/// How a role is drawn. Colours, widths and dashes are those of its class in assets/figure.css, so that a page may
/// change them (a dark screen).
struct Pen {
  std::string_view name;   ///< class of its lines and areas
  std::string_view words;  ///< in the legend; empty: needs none
  double weight = 1;       ///< how little a label should cover it
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

/// class="..." of a line of this role, and of one whose inside is painted.
std::string line_class(Role role);
std::string area_class(Role role);

/// A filled triangle with its tip at `tip`, pointing along (dx, dy), in the colour of the class `name`.
std::string arrow_head(Pixel tip, double dx, double dy, double size, std::string_view name);

}  // namespace taut::report
