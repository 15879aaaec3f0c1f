#include "taut/report/figure/pen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace taut::report {

const Pen& pen(Role role) {
  static constexpr Pen rope{
      .stroke = "#1d5fa6", .width = 2, .dashes = "", .fill = "#d6e4f3", .words = "rope", .weight = 2.5};
  static constexpr Pen second_rope{
      .stroke = "#0f8577", .width = 2, .dashes = "7 2.5", .fill = "#d3ebe7", .words = "second rope", .weight = 2.5};
  static constexpr Pen structure{
      .stroke = "#333b44", .width = 2.4, .dashes = "", .fill = "#dde1e6", .words = "", .weight = 2};
  static constexpr Pen body{
      .stroke = "#5b6570", .width = 1.4, .dashes = "", .fill = "#eceff2", .words = "", .weight = 1.5};
  static constexpr Pen ground{
      .stroke = "#8a7a5c", .width = 1.4, .dashes = "", .fill = "#f1ece2", .words = "", .weight = 1.5};
  static constexpr Pen hidden{
      .stroke = "#8a929b", .width = 1.1, .dashes = "4 3", .fill = "none", .words = "hidden or unloaded", .weight = 1};
  static constexpr Pen force{
      .stroke = "#b3261e", .width = 1.8, .dashes = "", .fill = "#b3261e", .words = "force", .weight = 4};
  static constexpr Pen second_force{
      .stroke = "#7b3fa0", .width = 1.8, .dashes = "", .fill = "#7b3fa0", .words = "second force", .weight = 4};
  static constexpr Pen axis{
      .stroke = "#8a929b", .width = 0.8, .dashes = "9 2.5 2 2.5", .fill = "none", .words = "", .weight = 0.7};
  static constexpr Pen highlight{
      .stroke = "#d9730d", .width = 2.8, .dashes = "", .fill = "#fbe5d0", .words = "governs", .weight = 2.5};
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
