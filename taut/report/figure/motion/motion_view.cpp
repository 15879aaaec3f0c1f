#include "taut/report/figure/motion/motion_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {

MotionView motion_view(const Animation& a, double wide, double high) {
  Box box;
  const auto add = [&](const Point& p, double radius) {
    if (!is_finite(p)) return;
    box.add(Box{.left = p.x - radius, .top = p.y - radius, .right = p.x + radius, .bottom = p.y + radius});
  };
  for (const auto& line : a.lines) {
    for (const auto& frame : line.points) {
      for (const Point& p : frame) add(p, 0);
    }
  }
  for (const auto& round : a.rounds) {
    for (const Point& p : round.at) add(p, round.radius);
  }
  MotionView v;
  if (box.empty()) return v;
  const double w = std::max(box.width(), 1e-9), h = std::max(box.height(), 1e-9);
  v.scale = std::min(wide / w, high / h);
  v.left = box.left;
  v.top = box.bottom;  // heights grow upwards: the largest one is the box's bottom
  v.wide = w * v.scale;
  v.high = h * v.scale;
  return v;
}

std::string length_bar(const MotionView& view, const Display& display, Pixel at, Box& box) {
  const ShownUnit unit = shown_unit(si::m, display);
  const double length = nice_below(90 / view.scale * unit.of(1)) / unit.of(1);
  const double pixels = length * view.scale;
  const std::string text = quantity_shown(length, si::m, display);
  box.add(Box{.left = at.x,
              .top = at.y - 10,
              .right = at.x + pixels + 7 + text_width(text, font_size),
              .bottom = at.y + 4 + descent(font_size)});
  return fmt::format(
      "<path class=\"bar\" d=\"M{0:.1f} {1:.1f}v8M{0:.1f} {2:.1f}h{3:.1f}v-4v8\"/><text class=\"label\" x=\"{4:.1f}\" "
      "y=\"{5:.1f}\">{6}</text>\n",
      at.x, at.y - 4, at.y, pixels, at.x + pixels + 7, at.y + 4, escape(text));
}

}  // namespace taut::report
