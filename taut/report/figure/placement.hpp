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
  bool is_number = false;  ///< of a label in the list
};

/// What a number on the drawing stands for.
struct Listed {
  int number = 0;  ///< 0: no place was left for the number either
  Runs runs;
};

struct Placement {
  std::vector<Placed> labels;
  std::vector<Listed> list;  ///< labels without a place of their own, by number; those of one anchor share a number
  std::size_t left_out = 0;  ///< the last of them, for which the list has no room either; its last line says so
};

/// Where labels may stand.
struct LabelRoom {
  Box frame;               ///< they should stay in it; empty: anywhere
  Box bounds;              ///< they must stay in it; empty: anywhere
  std::vector<Box> taken;  ///< other texts: no label may touch them
};

/// Finds places: tries directions and distances around each anchor, pays for covered lines, for distance and for
/// leaving the frame, and looks twice. No two boxes touch. Far labels get a leader line. A label that finds no place,
/// or only one across several lines, becomes a number on the drawing and a line of the list. The cost grows with the
/// number of labels and lines, not with its square. Same input, same places.
Placement place_labels(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles, const LabelRoom& room,
                       double font_size);

/// Text (in the colour of the paper behind the letters), numbers and leader lines.
std::string to_svg(const std::vector<Placed>& labels, double font_size);

/// The list in columns below `top`, from `left`, at most `wide` pixels wide; its box is added to `box`.
std::string list_svg(const std::vector<Listed>& list, Pixel left_top, double wide, double font_size, Box& box);

}  // namespace taut::report
