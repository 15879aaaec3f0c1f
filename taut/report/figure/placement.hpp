#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "taut/report/text/symbol.hpp"

namespace taut::report {

/// A place on paper: pixels, x to the right, y DOWN.
struct Pixel {
  double x = 0;
  double y = 0;
};

/// A rectangle on paper; empty until something is put into it.
struct Box {
  double left = HUGE_VAL;
  double top = HUGE_VAL;
  double right = -HUGE_VAL;
  double bottom = -HUGE_VAL;

  bool empty() const { return right < left; }
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  void add(Pixel p);
  void add(const Box& other);
  Box grown(double by) const {
    return {.left = left - by, .top = top - by, .right = right + by, .bottom = bottom + by};
  }
};

double overlap_area(const Box& a, const Box& b);
/// How much of the line a-b lies in the box, in pixels.
double length_inside(const Box& box, Pixel a, Pixel b);

/// A line that a label should not cover; `weight` says how much that matters.
struct Obstacle {
  Pixel a;
  Pixel b;
  double weight = 1;
};

/// A label that needs a place near `anchor`, or, a little less well, near one of `other_anchors` (along a line).
struct Wanted {
  Pixel anchor;
  std::vector<Pixel> other_anchors;
  Runs runs;
  Pixel toward;            ///< direction it would like to stand in; zero: none
  bool may_cover = false;  ///< may stand right on its anchor
};

struct Placed {
  Runs runs;
  Box box;
  bool has_leader = false;
  Pixel leader_from;
  Pixel leader_to;
};

/// Finds places: tries directions and distances around each anchor, pays for covered lines, other labels, distance and
/// for leaving `frame`, and looks twice. Far labels get a leader line. Same input, same places.
std::vector<Placed> place_labels(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles,
                                 const Box& frame, double font_size);

/// Text (white behind the letters) and leader lines.
std::string to_svg(const std::vector<Placed>& labels, double font_size);

}  // namespace taut::report
