#include "taut/report/figure/placement.hpp"

#include <gtest/gtest.h>

#include <ctime>

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

std::vector<Placed> places(const std::vector<Wanted>& all, const std::vector<Obstacle>& lines) {
  return place_labels(all, lines, {}, 12).labels;
}

TEST(Placement, LabelsOfOnePointDoNotCoverEachOther) {
  const std::vector<Wanted> all(6, wanted({.x = 0, .y = 0}, "R_sky = 138.9 kN"));
  const auto placed = places(all, {});
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = i + 1; k < placed.size(); ++k) EXPECT_EQ(overlap_area(placed[i].box, placed[k].box), 0);
  }
}

TEST(Placement, LabelsKeepOffLines) {
  const std::vector<Obstacle> cross{{.a = {.x = -200, .y = 0}, .b = {.x = 200, .y = 0}, .weight = 3},
                                    {.a = {.x = 0, .y = -200}, .b = {.x = 0, .y = 200}, .weight = 3}};
  const auto placed = places({wanted({.x = 0, .y = 0}, "carriage")}, cross);
  for (const Obstacle& o : cross) EXPECT_EQ(length_inside(placed[0].box, o.a, o.b), 0);
}

TEST(Placement, StandsWhereItIsAskedWhenThereIsRoom) {
  Wanted w = wanted({.x = 0, .y = 0}, "N");
  w.toward = {.x = 0, .y = 1};
  EXPECT_GT(places({w}, {})[0].box.top, 0);
  w.toward = {.x = -1, .y = 0};
  EXPECT_LT(places({w}, {})[0].box.right, 0);
  std::vector<Obstacle> around;
  for (const double y : {12, 24, 36, 48, 60, 90}) {
    for (const double side : {-y, y}) around.push_back({{.x = -200, .y = side}, {.x = 200, .y = side}, 5});
  }
  for (const double x : {-150, 150}) around.push_back({{.x = x, .y = -9}, {.x = x, .y = 9}, 5});
  w.may_cover = true;
  w.toward = {};
  w.runs[0].text = "a text across its place, as wide as the lines";
  EXPECT_LT(places({w}, around)[0].box.left, 0);
  EXPECT_GT(places({w}, around)[0].box.right, 0);
}

TEST(Placement, ACrowdedPlaceGetsALeader) {
  std::vector<Obstacle> crowd;
  for (int i = -40; i <= 40; i += 4) crowd.push_back({{.x = -45.0, .y = i * 1.0}, {.x = 45.0, .y = i * 1.0}, 5});
  const auto placed = places({wanted({.x = 0, .y = 0}, "N")}, crowd);
  EXPECT_TRUE(placed[0].has_leader);
  EXPECT_NE(to_svg(placed, 12).find("leader"), std::string::npos);
}

TEST(Placement, WhatFindsNoPlaceBecomesANumber) {
  const Box bounds{.left = -70, .top = -40, .right = 70, .bottom = 40};
  const std::vector<Wanted> all(30, wanted({.x = 0, .y = 0}, "R_sky = 138.9 kN"));
  const Placement placed = place_labels(all, {}, {.frame = bounds, .bounds = bounds, .taken = {}}, 12);
  std::size_t named = 0, numbers = 0;
  for (const Placed& p : placed.labels) (p.is_number ? numbers : named) += 1;
  ASSERT_EQ(placed.list.size(), 1U) << "they have one anchor";
  EXPECT_GT(named, 0U);
  EXPECT_EQ(numbers, placed.list[0].number > 0 ? 1U : 0U) << "a number, if that has room";
  std::size_t listed = 0;
  for (const taut::report::Run& r : placed.list[0].runs) listed += r.text == "R_sky = 138.9 kN" ? 1 : 0;
  EXPECT_EQ(named + listed, all.size());
  for (const Placed& p : placed.labels) {
    EXPECT_GE(p.box.left, bounds.left);
    EXPECT_LE(p.box.right, bounds.right);
  }
}

TEST(Placement, LongLinesOfTheListAreBroken) {
  std::string words;
  for (int i = 0; i < 40; ++i) words += "slack of rope " + std::to_string(i) + ", ";
  Box box;
  const std::string text =
      list_svg({{.number = 1, .runs = {{.text = words, .style = Run::Style::plain}}}}, {}, 300, 12, box);
  EXPECT_LE(box.right, 301);
  EXPECT_GT(box.bottom, 10 * 12);
  for (int i = 0; i < 40; ++i) EXPECT_NE(text.find(std::to_string(i) + ","), std::string::npos) << i;
}

TEST(Placement, KeepsOffOtherTexts) {
  const Box taken{.left = 0, .top = -40, .right = 80, .bottom = 40};
  const auto placed =
      place_labels({wanted({.x = 0, .y = 0}, "N")}, {}, {.frame = {}, .bounds = {}, .taken = {taken}}, 12);
  EXPECT_EQ(overlap_area(placed.labels[0].box, taken), 0);
}

/// Four times the labels at the same distance from each other take about four times as many steps, not sixteen.
TEST(Placement, CostGrowsWithTheNumberOfLabels) {
  const auto seconds = [](int n) {
    std::vector<Wanted> all;
    std::vector<Obstacle> lines;
    for (int i = 0; i < n; ++i) {
      const Pixel at{.x = 30.0 * (i % 40), .y = 30.0 * (i / 40)};
      all.push_back(wanted(at, "F head"));
      lines.push_back({at, {.x = at.x + 20, .y = at.y + 20}, 2});
    }
    const std::clock_t start = std::clock();
    for (int k = 0; k < 4; ++k) place_labels(all, lines, {}, 12);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  seconds(400);
  EXPECT_LT(seconds(1600), 10 * seconds(400));
}

}  // namespace placement_test
