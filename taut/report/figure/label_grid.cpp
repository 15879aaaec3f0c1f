#include "taut/report/figure/label_grid.hpp"

#include <algorithm>
#include <cmath>

namespace taut::report {
namespace {

constexpr double smallest_cell = 24;  ///< pixels: a label is 16 high
constexpr double most_cells = 4096;

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

LabelGrid::LabelGrid(const std::vector<Obstacle>& lines, const Box& area)
    : lines_(&lines), area_(area.empty() ? Box{.left = 0, .top = 0, .right = 1, .bottom = 1} : area) {
  size_ = std::max(smallest_cell, std::sqrt(area_.width() * area_.height() / most_cells));
  columns_ = 1 + static_cast<int>(area_.width() / size_);
  rows_ = 1 + static_cast<int>(area_.height() / size_);
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < lines.size(); ++i) put_line(static_cast<int>(i), lines[i]);
}

void LabelGrid::put_line(int id, const Obstacle& line) {
  Box box;
  box.add(line.a);
  box.add(line.b);
  const Range r = range_of(box);
  const bool small = r.left == r.right || r.top == r.bottom;
  for (int row = r.top; row <= r.bottom; ++row) {
    for (int column = r.left; column <= r.right; ++column) {
      if (small || length_inside(cell_box(row, column).grown(1), line.a, line.b) > 0) {
        cells_[place_of(row, column)].lines.push_back(id);
      }
    }
  }
}

std::size_t LabelGrid::place_of(int row, int column) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
}

/// The cells of the edge reach as far as any line.
Box LabelGrid::cell_box(int row, int column) const {
  return {.left = column == 0 ? -HUGE_VAL : area_.left + column * size_,
          .top = row == 0 ? -HUGE_VAL : area_.top + row * size_,
          .right = column + 1 == columns_ ? HUGE_VAL : area_.left + (column + 1) * size_,
          .bottom = row + 1 == rows_ ? HUGE_VAL : area_.top + (row + 1) * size_};
}

LabelGrid::Range LabelGrid::range_of(const Box& box) const {
  const auto index = [&](double at, double start, int count) {
    return static_cast<int>(std::clamp(std::floor((at - start) / size_), 0.0, count - 1.0));
  };
  return {.left = index(box.left, area_.left, columns_),
          .top = index(box.top, area_.top, rows_),
          .right = index(box.right, area_.left, columns_),
          .bottom = index(box.bottom, area_.top, rows_)};
}

template <class See>
void LabelGrid::each_cell(const Box& box, See&& see) const {
  const Range r = range_of(box);
  for (int row = r.top; row <= r.bottom; ++row) {
    for (int column = r.left; column <= r.right; ++column) {
      if (!see(cells_[place_of(row, column)])) return;
    }
  }
}

void LabelGrid::put(int id, const Box& box) {
  if (boxes_.size() <= static_cast<std::size_t>(id)) boxes_.resize(static_cast<std::size_t>(id) + 1);
  boxes_[static_cast<std::size_t>(id)] = box;
  const Range r = range_of(box);
  for (int row = r.top; row <= r.bottom; ++row) {
    for (int column = r.left; column <= r.right; ++column) {
      cells_[place_of(row, column)].boxes.push_back(id);
    }
  }
}

void LabelGrid::remove(int id, const Box& box) {
  const Range r = range_of(box);
  for (int row = r.top; row <= r.bottom; ++row) {
    for (int column = r.left; column <= r.right; ++column) {
      std::erase(cells_[place_of(row, column)].boxes, id);
    }
  }
}

bool LabelGrid::is_free(const Box& box, int except) const {
  bool free = true;
  each_cell(box, [&](const Cell& cell) {
    free = std::none_of(cell.boxes.begin(), cell.boxes.end(),
                        [&](int id) { return id != except && meet(boxes_[static_cast<std::size_t>(id)], box); });
    return free;
  });
  return free;
}

int LabelGrid::boxes_on(Pixel a, Pixel b, int except) const {
  Box around;
  around.add(a);
  around.add(b);
  std::vector<int> met;
  each_cell(around, [&](const Cell& cell) {
    for (const int id : cell.boxes) {
      if (id != except && length_inside(boxes_[static_cast<std::size_t>(id)], a, b) > 0) met.push_back(id);
    }
    return true;
  });
  std::sort(met.begin(), met.end());
  return static_cast<int>(std::unique(met.begin(), met.end()) - met.begin());
}

double LabelGrid::cost_of_lines(const Box& box, double each, double per_pixel, double enough) const {
  // A line through several cells is met several times: the few that are met are remembered.
  std::vector<int> met;
  double cost = 0;
  each_cell(box, [&](const Cell& cell) {
    for (const int i : cell.lines) {
      const Obstacle& o = (*lines_)[static_cast<std::size_t>(i)];
      const double inside = length_inside(box, o.a, o.b);
      if (!(inside > 0) || std::find(met.begin(), met.end(), i) != met.end()) continue;
      met.push_back(i);
      cost += o.weight * (each + per_pixel * inside);
      if (cost > enough) return false;
    }
    return true;
  });
  return cost;
}

}  // namespace taut::report
