#pragma once
#include <vector>

#include "taut/report/figure/placement.hpp"

namespace taut::report {

/// What stands on a drawing, by place: lines that labels should keep off, boxes that they must keep off. A question
/// about a small box costs what lies near it, not what lies on the whole drawing.
class LabelGrid {
 public:
  /// Lines are kept by reference and must outlive the grid. `area`: where most things are; what is outside is found
  /// too.
  LabelGrid(const std::vector<Obstacle>& lines, const Box& area);

  /// The box gets the name `id` >= 0; each id stands at most once.
  void put(int id, const Box& box);
  void remove(int id, const Box& box);

  /// True if no box but the one named `except` touches this one.
  bool is_free(const Box& box, int except) const;
  /// How many boxes but `except` the line a-b runs through.
  int boxes_on(Pixel a, Pixel b, int except) const;
  /// Sum over the lines through the box of weight*(each + length*per_pixel); stops above `enough`.
  double cost_of_lines(const Box& box, double each, double per_pixel, double enough) const;

 private:
  struct Range {
    int left, top, right, bottom;
  };
  struct Cell {
    std::vector<int> lines;
    std::vector<int> boxes;
  };
  Range range_of(const Box& box) const;
  std::size_t place_of(int row, int column) const;
  Box cell_box(int row, int column) const;
  void put_line(int id, const Obstacle& line);
  template <class See>
  void each_cell(const Box& box, See&& see) const;

  const std::vector<Obstacle>* lines_;
  Box area_;
  double size_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<Cell> cells_;
  std::vector<Box> boxes_;  ///< by id
};

}  // namespace taut::report
