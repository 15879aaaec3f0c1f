#pragma once
#include <string>
#include <vector>

#include "taut/report/figure/placement.hpp"

namespace taut::report {

/// Something to name at a place along an axis.
struct LaneMark {
  double at = 0;     ///< pixel along the axis
  Runs runs;         ///< its words
  std::string when;  ///< its place in words, for the list: "t = 0.52 s"
};

/// Names in a lane beside a plot, none over another.
struct Lane {
  struct Name {
    Runs runs;
    double center = 0;  ///< pixel
    double wide = 0;
    int row = 0;  ///< 0: next to the plot
    bool is_number = false;
    double mark = 0;  ///< pixel of what it names
  };
  std::vector<Name> names;
  int rows = 0;
  std::vector<Listed> list;  ///< what the numbers stand for; empty: the words themselves stand in the lane
};

/// The words of the marks in at most two rows between `low` and `high`; where they do not fit, numbers in the order of
/// the axis, and the list. Marks nearer than a pixel to each other share a number.
Lane lane_of(std::vector<LaneMark> marks, double low, double high, double font_size);

/// Boxes of `wide` along a line, moved so that they keep `gap` and stay between low and high, as little as that needs;
/// sorted by their place. Where they cannot all fit they are spread evenly.
std::vector<double> spread(const std::vector<double>& centers, const std::vector<double>& wide, double gap, double low,
                           double high);

}  // namespace taut::report
