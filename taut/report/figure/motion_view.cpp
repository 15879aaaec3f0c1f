#include "taut/report/figure/motion_view.hpp"

#include <algorithm>

#include "taut/report/figure/pen.hpp"

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

}  // namespace taut::report
