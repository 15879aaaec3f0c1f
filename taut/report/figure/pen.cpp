#include "taut/report/figure/pen.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/report/text/text.hpp"

namespace taut::report {

std::string svg_element(std::string_view classes, std::string_view title, const Box& box, const std::string& body) {
  const double left = std::floor(box.left), top = std::floor(box.top);
  const double wide = std::ceil(box.right - left), high = std::ceil(box.bottom - top);
  return fmt::format(
      "<svg class=\"{}\" role=\"img\" aria-label=\"{}\" viewBox=\"{:.0f} {:.0f} {:.0f} {:.0f}\" width=\"{:.0f}\" "
      "height=\"{:.0f}\">\n{}</svg>\n",
      classes, escape(title), left, top, wide, high, wide, high, body);
}

const Pen& pen(Role role) {
  static constexpr Pen rope{.name = "rope", .words = "rope", .weight = 2.5};
  static constexpr Pen second_rope{.name = "second-rope", .words = "second rope", .weight = 2.5};
  static constexpr Pen structure{.name = "structure", .words = "", .weight = 2};
  static constexpr Pen body{.name = "body", .words = "", .weight = 1.5};
  static constexpr Pen ground{.name = "ground", .words = "", .weight = 1.5};
  static constexpr Pen hidden{.name = "hidden", .words = "hidden or unloaded", .weight = 1};
  static constexpr Pen force{.name = "force", .words = "force", .weight = 4};
  static constexpr Pen second_force{.name = "second-force", .words = "second force", .weight = 4};
  static constexpr Pen axis{.name = "axis", .words = "", .weight = 0.7};
  static constexpr Pen highlight{.name = "highlight", .words = "governs", .weight = 2.5};
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

std::string line_class(Role role) { return fmt::format("class=\"line {}\"", pen(role).name); }
std::string area_class(Role role) { return fmt::format("class=\"area {}\"", pen(role).name); }

std::string arrow_head(Pixel tip, double dx, double dy, double size, std::string_view name) {
  const double l = std::hypot(dx, dy);
  if (!(l > 0)) return {};
  const double ux = dx / l;
  const double uy = dy / l;
  const double half = 0.36 * size;
  return fmt::format("<path class=\"head {}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>", name, tip.x, tip.y,
                     tip.x - size * ux - half * uy, tip.y - size * uy + half * ux, tip.x - size * ux + half * uy,
                     tip.y - size * uy - half * ux);
}

}  // namespace taut::report
