#include "taut/catalogue/forestry/tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace taut::catalogue::tree_test {

constexpr double deg = std::numbers::pi / 180;

TEST(AnchorTree, RowsAsPrinted) {
  EXPECT_EQ(anchor_trees().size(), 27U);
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(80e3, 0), 0.40);
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(53e3, 10 * deg), 0.40) << "below 10 degrees, not at them";
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(53e3, 24.9 * deg), 0.40);
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(40e3, 25 * deg), 0.40);
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(215e3, -20 * deg), 0.65) << "downwards counts as level";
  EXPECT_DOUBLE_EQ(*anchor_tree_diameter(1e3, 0), 0.24) << "the table begins there";
  EXPECT_FALSE(anchor_tree_diameter(216e3, 0));
  EXPECT_FALSE(anchor_tree_diameter(10e3, 45 * deg));
  EXPECT_TRUE(anchor_trees_at(45 * deg).empty());
}

// The table is a square law, in kN and cm: D^2/20 to 10 degrees, D^2/30 to 25, D^2/40 to 45; its numbers are rounded to
// whole kN, and the rows from 60 cm on hold up to 8 % more. An Austrian rule of thumb beside it: 80 kN at 50 cm.
TEST(AnchorTree, SquareLawAndRuleOfThumb) {
  for (const AnchorTreeRow& row : anchor_trees()) {
    const double divisor = row.angle_below < 15 * deg ? 20 : row.angle_below < 30 * deg ? 30 : 40;
    const double law = std::pow(100 * row.diameter, 2) / divisor * 1e3;
    EXPECT_NEAR(row.force, law, 0.08 * law) << row.force << " N, " << row.diameter << " m";
  }
  EXPECT_NEAR(*anchor_tree_diameter(80e3, 20 * deg), 0.50, 0.015);
}

// By hand: between 40 cm (80 kN) and 48 cm (115 kN), at 97.5 kN: sqrt((40^2 + 48^2)/2) = 44.18 cm.
TEST(AnchorTree, BetweenTwoRowsTheSquareGrowsEvenly) {
  EXPECT_NEAR(*anchor_tree_diameter(97.5e3, 5 * deg), 0.441814, 1e-6);
  double last = 0;
  for (double F = 1e3; F < 215e3; F += 1e3) {
    const double d = *anchor_tree_diameter(F, 0);
    EXPECT_GE(d, last);
    last = d;
  }
}

TEST(SupportTree, TheNextForceAndTheNextHeight) {
  EXPECT_EQ(support_trees().size(), 290U);
  EXPECT_DOUBLE_EQ(*support_tree_diameter(50e3, 12), 0.25);
  EXPECT_DOUBLE_EQ(*support_tree_diameter(41e3, 11.2), 0.25);
  EXPECT_DOUBLE_EQ(*support_tree_diameter(60e3, 3), 0.20) << "the table has no 5 m at 60 kN: the next height";
  EXPECT_DOUBLE_EQ(*support_tree_diameter(150e3, 21), 0.45);
  EXPECT_FALSE(support_tree_diameter(151e3, 10));
  EXPECT_FALSE(support_tree_diameter(10e3, 31));
}

TEST(SupportTree, DiametersGrowWithForceAndHeight) {
  for (const SupportTreeRow& a : support_trees()) {
    for (const SupportTreeRow& b : support_trees()) {
      if (a.force > b.force || a.height > b.height) continue;
      EXPECT_LE(a.diameter, b.diameter) << a.force << " " << a.height;
    }
  }
}

// By hand: 25 cm at 12 m and 1 cm a metre down to 1.5 m: 35.5 cm.
TEST(SupportTree, ThickerAtBreastHeight) {
  EXPECT_NEAR(breast_height_diameter(0.25, 12), 0.355, 1e-12);
  EXPECT_NEAR(breast_height_diameter(0.25, 1), 0.25, 1e-12);
}

}  // namespace taut::catalogue::tree_test
