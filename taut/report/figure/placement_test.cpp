#include "taut/report/figure/placement.hpp"

#include <gtest/gtest.h>

namespace placement_test {

using namespace taut::report;

Wanted wanted(Pixel at, const std::string& text) {
  return {.anchor = at,
          .other_anchors = {},
          .runs = {{.text = text, .style = Run::Style::plain}},
          .toward = {},
          .may_cover = false};
}

TEST(Placement, LengthInsideABox) {
  const Box box{.left = 0, .top = 0, .right = 10, .bottom = 10};
  EXPECT_DOUBLE_EQ(length_inside(box, {-5, 5}, {15, 5}), 10);
  EXPECT_DOUBLE_EQ(length_inside(box, {15, 5}, {-5, 5}), 10);
  EXPECT_DOUBLE_EQ(length_inside(box, {2, 2}, {2, 5}), 3);
  EXPECT_DOUBLE_EQ(length_inside(box, {-5, -5}, {-1, 20}), 0);
  EXPECT_DOUBLE_EQ(length_inside(box, {3, 3}, {3, 3}), 0);
}

TEST(Placement, LabelsOfOnePointDoNotCoverEachOther) {
  const std::vector<Wanted> all(6, wanted({.x = 0, .y = 0}, "R_sky = 138.9 kN"));
  const auto placed = place_labels(all, {}, {}, 12);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = i + 1; k < placed.size(); ++k) EXPECT_EQ(overlap_area(placed[i].box, placed[k].box), 0);
  }
}

TEST(Placement, LabelsKeepOffLines) {
  const std::vector<Obstacle> cross{{.a = {.x = -200, .y = 0}, .b = {.x = 200, .y = 0}, .weight = 3},
                                    {.a = {.x = 0, .y = -200}, .b = {.x = 0, .y = 200}, .weight = 3}};
  const auto placed = place_labels({wanted({.x = 0, .y = 0}, "carriage")}, cross, {}, 12);
  for (const Obstacle& o : cross) EXPECT_EQ(length_inside(placed[0].box, o.a, o.b), 0);
}

TEST(Placement, StandsWhereItIsAskedWhenThereIsRoom) {
  Wanted w = wanted({.x = 0, .y = 0}, "N");
  w.toward = {.x = 0, .y = 1};
  EXPECT_GT(place_labels({w}, {}, {}, 12)[0].box.top, 0);
  w.toward = {.x = -1, .y = 0};
  EXPECT_LT(place_labels({w}, {}, {}, 12)[0].box.right, 0);
  w.may_cover = true;
  EXPECT_LT(place_labels({w}, {}, {}, 12)[0].box.left, 0);
  EXPECT_GT(place_labels({w}, {}, {}, 12)[0].box.right, 0);
}

TEST(Placement, ACrowdedPlaceGetsALeader) {
  std::vector<Obstacle> crowd;
  for (int i = -40; i <= 40; i += 4) crowd.push_back({{.x = -45.0, .y = i * 1.0}, {.x = 45.0, .y = i * 1.0}, 5});
  const auto placed = place_labels({wanted({.x = 0, .y = 0}, "N")}, crowd, {}, 12);
  EXPECT_TRUE(placed[0].has_leader);
  EXPECT_NE(to_svg(placed, 12).find("leader"), std::string::npos);
}

}  // namespace placement_test
