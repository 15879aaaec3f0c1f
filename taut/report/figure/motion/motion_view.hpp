#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Metres of an animation to pixels: the whole motion fits into a rectangle, to scale.
struct MotionView {
  double scale = 1;           ///< pixels per metre
  double left = 0, top = 0;   ///< of the picture, m
  double wide = 0, high = 0;  ///< pixels that the motion takes
  Pixel of(Point p) const { return {.x = (p.x - left) * scale, .y = (top - p.y) * scale}; }
};

/// The view in which all lines and rounds of all times take at most `wide` x `high` pixels, at (0, 0) the left upper
/// corner. Points that are not finite are left out.
MotionView motion_view(const Animation& animation, double wide, double high);

/// A bar of a round length with its words, its left end at `at`; `box` grows by it.
std::string length_bar(const MotionView& view, const Display& display, Pixel at, Box& box);

}  // namespace taut::report
