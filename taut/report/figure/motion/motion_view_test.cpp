#include "taut/report/figure/motion/motion_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace motion_view_test {

using namespace taut;
using namespace taut::report;

TEST(MotionView, TheWholeMotionFitsToScale) {
  Animation a;
  a.lines.resize(1);
  a.lines[0].points = {{{.x = -5, .y = 0}, {.x = 15, .y = 0}}, {{.x = 0, .y = 10}, {.x = NAN, .y = 99}}};
  const MotionView v = motion_view(a, 200, 200);
  EXPECT_DOUBLE_EQ(v.scale, 10);
  EXPECT_DOUBLE_EQ(v.of({.x = -5, .y = 10}).x, 0);
  EXPECT_DOUBLE_EQ(v.of({.x = -5, .y = 10}).y, 0);
  EXPECT_DOUBLE_EQ(v.of({.x = 15, .y = 0}).x, 200);
  EXPECT_DOUBLE_EQ(v.high, 100);
}

}  // namespace motion_view_test
