#include "taut/report/figure/label_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace label_grid_test {

using namespace taut::report;

Box some_box() {
  const double x = *rc::gen::inRange(-100, 600), y = *rc::gen::inRange(-100, 400);
  return {.left = x, .top = y, .right = x + *rc::gen::inRange(1, 90), .bottom = y + *rc::gen::inRange(1, 30)};
}

RC_GTEST_PROP(LabelGrid, FindsWhatATestOfAllFinds, ()) {
  std::vector<Obstacle> lines;
  for (int i = 0; i < 20; ++i) {
    const Box box = some_box();
    lines.push_back({.a = {.x = box.left, .y = box.top}, .b = {.x = 3 * box.right, .y = box.bottom}, .weight = 2});
  }
  LabelGrid grid(lines, {.left = 0, .top = 0, .right = 500, .bottom = 300});
  std::vector<Box> boxes;
  for (int i = 0; i < 20; ++i) {
    boxes.push_back(some_box());
    grid.put(i, boxes.back());
  }
  grid.remove(0, boxes[0]);
  const Box asked = some_box();
  bool free = true;
  for (std::size_t i = 2; i < boxes.size(); ++i) free = free && !(overlap_area(boxes[i], asked) > 0);
  RC_ASSERT(grid.is_free(asked, 1) == free);
  double cost = 0;
  for (const Obstacle& o : lines) {
    const double inside = length_inside(asked, o.a, o.b);
    cost += inside > 0 ? 2 * (25 + 3 * inside) : 0;
  }
  RC_ASSERT(std::abs(grid.cost_of_lines(asked, 25, 3, HUGE_VAL) - cost) <= 1e-9 * (1 + cost));
}

}  // namespace label_grid_test
