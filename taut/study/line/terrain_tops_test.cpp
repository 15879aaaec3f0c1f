#include "taut/study/line/terrain_tops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace taut::study {
namespace {

machine::Model over(Array<machine::GroundPoint> ground) {
  machine::Model model;
  model.terrain = std::move(ground);
  return model;
}

WayPlace place(double x, double z, double clearance) { return {.x = x, .chainage = x, .z = z, .clearance = clearance}; }

Array<double> all(TopsBetween tops) {
  Array<double> found;
  while (const auto x = tops.next()) found.push_back(*x);
  return found;
}

// Of a slope of 1 in 10 with a knoll at 14 m and a lower one at 17 m, under a level way.
TEST(TopsBetween, TheLowestFirstAndOnlyWhereTheWayIsNearerThanAtItsEnds) {
  const machine::Model m = over({{.x = 0, .z = 0},
                                 {.x = 13, .z = 0},
                                 {.x = 14, .z = 5},
                                 {.x = 15, .z = 0},
                                 {.x = 17, .z = 3},
                                 {.x = 30, .z = 0}});
  for (const bool back : {false, true}) {
    WayPlace a = place(10, 20, 20), b = place(20, 20, 20 - 3 * 10.0 / 13);
    if (back) std::swap(a, b);
    EXPECT_EQ(all({m, a, b}), (Array<double>{14, 17})) << "nothing is known of the first";
    TopsBetween tops(m, a, b);
    EXPECT_EQ(tops.next(), 14);
    tops.take(place(14, 20, 15));
    EXPECT_EQ(tops.next(), std::nullopt) << "17 m higher than the place at 14 m";
    EXPECT_EQ(tops.places().size(), 3U);
    EXPECT_EQ(tops.places()[1].x, 14);
  }
  EXPECT_TRUE(all({m, place(10, 20, 14), place(20, 20, 18)}).empty()) << "an end is nearer";
  EXPECT_EQ(all({m, place(20, 20, 18), place(30, 20, 20)}).size(), 0U) << "no top there";
}

// A way that bends upwards is below its chords: over level ground with a top of 1 mm only that tells.
TEST(TopsBetween, TheWayIsBelowItsChordsByItsBend) {
  const machine::Model m = over({{.x = 0, .z = 0}, {.x = 5, .z = 1e-3}, {.x = 10, .z = 0}});
  EXPECT_EQ(all({m, place(0, 20, 20), place(10, 20, 20)}).size(), 1U);
  const machine::Model hollow = over({{.x = 0, .z = 0}, {.x = 4, .z = -0.01}, {.x = 5, .z = -0.01}, {.x = 10, .z = 0}});
  EXPECT_TRUE(all({hollow, place(0, 20, 20), place(10, 20, 20), 1}).empty()) << "hollow ground has no top";
  const machine::Model slope = over({{.x = 0, .z = 0}, {.x = 5, .z = 0.1}, {.x = 10, .z = -1}});
  EXPECT_TRUE(all({slope, place(0, 20, 20), place(10, 19.4, 20.4)}).size() == 1);
  EXPECT_TRUE(all({slope, place(0, 20, 20), place(10, 20.6, 21.6)}).empty());
  EXPECT_EQ(all({slope, place(0, 20, 20), place(10, 20.6, 21.6), 0.03}).size(), 1U) << "0.375 m lower in the middle";
}

// Points on one line, up to the last digit of what a survey has, are no tops.
TEST(TopsBetween, PointsOnALineAreNone) {
  Array<machine::GroundPoint> ground;
  for (int i = 0; i <= 100; ++i) ground.push_back({.x = 0.1 * i, .z = 300 + 0.1 * i / 3});
  EXPECT_TRUE(all({over(ground), place(1, 400, 99), place(9, 300, 99), 10}).empty());
}

TEST(TopsBetween, TheEndsOfTheTerrainAreTops) {
  const machine::Model m = over({{.x = 4, .z = 3}, {.x = 8, .z = 0}});
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(all({m, place(0, 20, none), place(10, 20, none)}), (Array<double>{4, 8}));
  EXPECT_EQ(all({m, place(0, 20, none), place(6, 20, 18.5)}), (Array<double>{4}));
}

TEST(BendOfStep, IsTheLargerOneOfItsEnds) {
  Array<WayPlace> way;
  for (const double z : {8.0, 4.0, 4.0, 8.0, 8.0}) way.push_back(place(2.0 * static_cast<double>(way.size()), z, 0));
  EXPECT_DOUBLE_EQ(bend_of_step(way, 0), 1);
  EXPECT_DOUBLE_EQ(bend_of_step(way, 2), 1);
  EXPECT_DOUBLE_EQ(bend_of_step(way, 3), 0) << "bends downwards";
  way.resize(2);
  EXPECT_DOUBLE_EQ(bend_of_step(way, 0), 0) << "not known of a single step";
}

}  // namespace
}  // namespace taut::study
