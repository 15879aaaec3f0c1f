#include "taut/report/figure/pen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace taut::report {

const Pen& pen(Role role) {
  static constexpr Pen rope{"#1d5fa6", 2, "", "#d6e4f3", "rope", 2.5};
  static constexpr Pen second_rope{"#0f8577", 2, "7 2.5", "#d3ebe7", "second rope", 2.5};
  static constexpr Pen structure{"#333b44", 2.4, "", "#dde1e6", "", 2};
  static constexpr Pen body{"#5b6570", 1.4, "", "#eceff2", "", 1.5};
  static constexpr Pen ground{"#8a7a5c", 1.4, "", "#f1ece2", "", 1.5};
  static constexpr Pen hidden{"#8a929b", 1.1, "4 3", "none", "hidden or unloaded", 1};
  static constexpr Pen force{"#b3261e", 1.8, "", "#b3261e", "force", 4};
  static constexpr Pen second_force{"#7b3fa0", 1.8, "", "#7b3fa0", "second force", 4};
  static constexpr Pen axis{"#8a929b", 0.8, "9 2.5 2 2.5", "none", "", 0.7};
  static constexpr Pen highlight{"#d9730d", 2.8, "", "#fbe5d0", "governs", 2.5};
  switch (role) {
    case Role::rope:
      return rope;
    case Role::second_rope:
      return second_rope;
    case Role::structure:
      return structure;
    case Role::body:
      return body;
    case Role::ground:
      return ground;
    case Role::hidden:
      return hidden;
    case Role::force:
      return force;
    case Role::second_force:
      return second_force;
    case Role::axis:
      return axis;
    case Role::highlight:
      return highlight;
  }
  return structure;
}

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::string path_data(const std::vector<Pixel>& points, bool closed) {
  std::string d;
  Pixel last;
  bool pen_down = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Pixel p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      pen_down = false;
      continue;
    }
    const bool ends = i + 1 == points.size() || !std::isfinite(points[i + 1].x) || !std::isfinite(points[i + 1].y);
    if (pen_down && !ends && std::hypot(p.x - last.x, p.y - last.y) < 0.34) continue;
    d += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", p.x, p.y);
    last = p;
    pen_down = true;
  }
  if (closed && !d.empty()) d += "Z";
  return d;
}

std::string stroke_of(const Pen& p) {
  const std::string dashes = p.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", p.dashes);
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", p.stroke, p.width, dashes);
}

std::string arrow_head(Pixel tip, double dx, double dy, double size, std::string_view colour) {
  const double l = std::hypot(dx, dy);
  if (!(l > 0)) return {};
  const double ux = dx / l;
  const double uy = dy / l;
  const double half = 0.36 * size;
  return fmt::format("<path fill=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>", colour, tip.x, tip.y,
                     tip.x - size * ux - half * uy, tip.y - size * uy + half * ux, tip.x - size * ux + half * uy,
                     tip.y - size * uy - half * ux);
}

}  // namespace taut::report
