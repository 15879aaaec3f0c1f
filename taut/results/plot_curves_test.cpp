#include "taut/results/plot_curves.hpp"

#include <gtest/gtest.h>

#include "taut/calc/none.hpp"

namespace plot_curves_test {

using namespace taut;
using namespace taut::results;

Plot with(const std::vector<double>& sizes) {
  Plot p;
  for (const double size : sizes) {
    p.curves.push_back({.label = std::to_string(static_cast<int>(size)), .x = {0, 1, 2}, .y = {0, -size, none}});
  }
  return p;
}

TEST(PlotCurves, KeepsTheLargestInTheirOrder) {
  Plot p = with({3, 9, 1, 7});
  keep_largest(p, 2);
  ASSERT_EQ(p.curves.size(), 2U);
  EXPECT_EQ(p.curves[0].label, "9");
  EXPECT_EQ(p.curves[1].label, "7");
  EXPECT_EQ(p.caption, "The 2 curves with the largest values of 4.");
}

TEST(PlotCurves, FewCurvesStayAsTheyAre) {
  Plot p = with({3, 9});
  keep_largest(p, 2);
  EXPECT_EQ(p.curves.size(), 2U);
  EXPECT_EQ(p.caption, "");
}

}  // namespace plot_curves_test
