#include "taut/report/figure/motion/motion_strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace motion_strip_test {

using namespace taut;
using namespace taut::report;

/// A load that sinks for ten seconds; the tension is largest at 7 s.
Animation sinking() {
  Animation a;
  Animation::Line rope;
  Animation::Round hook{.label = "hook", .role = Role::body, .radius = 0, .at = {}, .angle = {}};
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    a.t.push_back(t);
    rope.points.push_back({{.x = 0, .y = 10}, {.x = 0, .y = 10 - 0.5 * t}});
    rope.tension.push_back(10e3 - 100 * std::abs(t - 7));
    hook.at.push_back({.x = 0, .y = 10 - 0.5 * t});
  }
  a.lines = {rope};
  a.rounds = {hook};
  a.events = {{2.0, "brake"}};
  return a;
}

TEST(MotionStrip, HasTheEndsThePeakAndTheEvents) {
  const auto moments = moments_of(sinking());
  ASSERT_EQ(moments.size(), 6U);
  EXPECT_EQ(moments.front().words, "start");
  EXPECT_EQ(moments.back().words, "end");
  bool peak = false, brake = false;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (i > 0) {
      EXPECT_GT(moments[i].frame, moments[i - 1].frame);
    }
    peak = peak || (moments[i].words == "largest tension" && moments[i].frame == 70);
    brake = brake || (moments[i].words == "brake" && moments[i].frame == 20);
  }
  EXPECT_TRUE(peak);
  EXPECT_TRUE(brake);
}

TEST(MotionStrip, ShowsTimesAndTensions) {
  const std::string text = strip_svg(sinking(), Display{});
  for (const char* shown : {" = 0 s", " = 7 s", "10 kN", "largest tension", ">hook<", "class=\"line t7\""}) {
    EXPECT_NE(text.find(shown), std::string::npos) << shown;
  }
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(MotionStrip, FewTimesAreAllShown) {
  Animation a = sinking();
  a.t.resize(3);
  EXPECT_EQ(moments_of(a).size(), 3U);
  a.t.resize(1);
  EXPECT_NE(strip_svg(a, Display{}).find("No motion"), std::string::npos);
  EXPECT_NE(strip_svg(Animation{}, Display{}).find("No motion"), std::string::npos);
}

TEST(MotionStrip, WhatIsNotFiniteIsLeftOut) {
  Animation a = sinking();
  a.lines[0].points[0][1].y = NAN;
  a.lines[0].tension[0] = NAN;
  a.rounds[0].at[0].x = INFINITY;
  const std::string text = strip_svg(a, Display{});
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

}  // namespace motion_strip_test
