#include "taut/report/figure/event_lane.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace event_lane_test {

using namespace taut::report;

LaneMark mark(double at, const std::string& words) {
  return {.at = at, .runs = {{.text = words, .style = Run::Style::plain}}, .when = "t = 1 s"};
}

void expect_apart(const Lane& lane) {
  for (const auto& a : lane.names) {
    for (const auto& b : lane.names) {
      if (&a == &b || a.row != b.row) continue;
      EXPECT_GE(std::abs(a.center - b.center), (a.wide + b.wide) / 2);
    }
  }
}

TEST(EventLane, FewWordsStandAtTheirPlaces) {
  const Lane lane = lane_of({mark(300, "stop"), mark(100, "start")}, 0, 600, 12);
  ASSERT_EQ(lane.names.size(), 2U);
  EXPECT_EQ(lane.names[0].center, 100);
  EXPECT_EQ(lane.names[1].center, 300);
  EXPECT_EQ(lane.rows, 1);
  EXPECT_TRUE(lane.list.empty());
}

TEST(EventLane, WordsAtTheEdgeStayInside) {
  const Lane lane = lane_of({mark(2, "a long name"), mark(599, "another one")}, 0, 600, 12);
  EXPECT_GE(lane.names[0].center - lane.names[0].wide / 2, 0);
  EXPECT_LE(lane.names[1].center + lane.names[1].wide / 2, 600);
}

TEST(EventLane, PartsOfOneMomentAreNamedByTheirFirstAndLast) {
  std::vector<LaneMark> marks = {mark(100, "break line (40)")};
  for (int i = 39; i > 30; --i) marks.push_back(mark(100, fmt::format("slack line ({})", i)));
  marks.push_back(mark(100, "slack line (20)"));
  for (int i = 0; i < 30; ++i) marks.push_back(mark(110 + 10 * i, "slack of the rope"));
  const Lane lane = lane_of(marks, 0, 600, 12);
  ASSERT_FALSE(lane.list.empty());
  std::string text;
  for (const auto& run : lane.list[0].runs) text += run.text;
  EXPECT_EQ(text, "t = 1 s: break line (40), slack line (31 to 39), slack line (20)");
}

TEST(EventLane, ManyBecomeNumbersWithAList) {
  std::vector<LaneMark> marks;
  for (int i = 0; i < 60; ++i) marks.push_back(mark(290 + 2 * i, "slack of the rope"));
  const Lane lane = lane_of(marks, 0, 600, 12);
  EXPECT_EQ(lane.list.size(), 60U);
  EXPECT_EQ(lane.names.size(), 60U);
  EXPECT_GT(lane.rows, 1);
  expect_apart(lane);
}

TEST(EventLane, MarksOfOneMomentShareANumber) {
  const Lane lane = lane_of({mark(100, "the brake of the winch closes"), mark(100.2, "the skyline becomes slack"),
                             mark(110, "the carriage stops at the support")},
                            0, 300, 12);
  EXPECT_EQ(lane.list.size(), 2U);
}

TEST(EventLane, SpreadMovesOnlyWhatIsTooNear) {
  const std::vector<double> at = spread({10, 12, 80}, {10, 10, 10}, 2, 0, 100);
  EXPECT_EQ(at[2], 80);
  EXPECT_GE(at[1] - at[0], 12);
  EXPECT_GE(at[0], 5);
}

}  // namespace event_lane_test
