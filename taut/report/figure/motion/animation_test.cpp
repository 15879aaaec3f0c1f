#include "taut/report/figure/motion/animation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::report::animation_test {

using testing::HasSubstr;
using testing::Not;

/// A load that sinks on its rope, a sheave that turns, a fixed line.
Animation sinking(std::size_t times) {
  Animation a;
  a.title = "sinking <fast>";
  Animation::Line rope, mast;
  mast.role = Role::structure;
  Animation::Round head{.label = "head", .role = Role::body, .radius = 0.5, .at = {}, .angle = {}};
  Animation::Readout T{.label = "T", .unit = si::N, .value = {}};
  for (std::size_t i = 0; i < times; ++i) {
    const double s = static_cast<double>(i) / 10;
    a.t.push_back(s);
    rope.points.push_back({{.x = 0, .y = 10}, {.x = 0, .y = 10 - s}});
    mast.points.push_back({{.x = -5, .y = 0}, {.x = -5, .y = 12}});
    head.at.push_back({0, 10});
    head.angle.push_back(s);
    T.value.push_back(1000 + s);
  }
  a.lines = {rope, mast};
  a.rounds = {head};
  a.readouts = {T};
  a.events = {{0.3, "slack \"hoist\" </script>"}};
  return a;
}

TEST(Animation, IsAStripWithoutScripts) {
  const std::string html = animation_html(sinking(11), Display(), 0);
  EXPECT_THAT(html, HasSubstr("<div class=\"plays\" id=\"motion0\"><svg class=\"strip"));
  EXPECT_THAT(html, HasSubstr("<svg class=\"moving\""));
  EXPECT_THAT(html, HasSubstr("<polyline class="));
  EXPECT_THAT(html, HasSubstr(">head</text>"));
  EXPECT_THAT(html, HasSubstr("sinking &lt;fast&gt;"));
}

TEST(Animation, WhatRestsIsWrittenOnce) {
  const std::string html = animation_html(sinking(11), Display(), 0);
  // the rope has eleven frames, the mast one
  const std::size_t lines = html.find("l:[[[");
  ASSERT_NE(lines, std::string::npos);
  const std::string data = html.substr(lines + 2, html.find(",k:") - lines - 2);
  EXPECT_EQ(std::count(data.begin(), data.end(), '['), 1 + (1 + 11) + (1 + 1));
}

TEST(Animation, TextOfTheDeckCannotEndTheScript) {
  const std::string html = animation_html(sinking(11), Display(), 0);
  EXPECT_EQ(html.find("</script>"), html.rfind("</script>"));
  EXPECT_THAT(html, HasSubstr("slack \\\"hoist\\\" \\u003c/script>"));
}

TEST(Animation, LoadsNothingAndStaysSmall) {
  const std::string html = animation_html(sinking(100000), Display(), 1);
  EXPECT_LT(html.size(), 250000U);
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, HasSubstr("9999.9")) << "the last time is kept";
}

TEST(Animation, NothingToPlay) {
  EXPECT_EQ(animation_html(sinking(1), Display(), 0), "");
  EXPECT_EQ(animation_html(Animation{}, Display(), 0), "");
}

/// Two rounds at one place, one of which runs over the other: its name stands in the margin, with a line to it.
TEST(Animation, NamesThatWouldMeetStandInTheMargin) {
  Animation a = sinking(4);
  EXPECT_THAT(animation_html(a, Display(), 0), Not(HasSubstr("<path class=\"leader\" d=\"M")));
  for (const char* name : {"hook", "block", "bolt", "nut"}) {
    a.rounds.push_back(a.rounds[0]);
    a.rounds.back().label = name;
  }
  const std::string html = animation_html(a, Display(), 0);
  EXPECT_THAT(html, HasSubstr("<path class=\"leader\" d=\"M"));
  for (const char* name : {"head", "hook", "block", "bolt", "nut"}) {
    EXPECT_THAT(html.substr(html.find("class=\"moving\"")), HasSubstr(fmt::format(">{}</text>", name)));
  }
}

TEST(Animation, RopesHaveTheColourOfTheirTension) {
  Animation a = sinking(4);
  a.lines[0].tension = {0, 1000, 4000, 8000};
  const std::string html = animation_html(a, Display(), 0);
  EXPECT_THAT(html, HasSubstr("k:[\"s147\",0]"));
  EXPECT_THAT(html, HasSubstr("class=\"line slack\""));
  EXPECT_THAT(html, HasSubstr("tension 0"));
}

TEST(Animation, WhatIsNotFiniteIsLeftOut) {
  Animation a = sinking(4);
  a.lines[0].points[1][1].y = NAN;
  a.rounds[0].angle[2] = NAN;
  EXPECT_THAT(animation_html(a, Display(), 0), Not(HasSubstr("nan")));
}

}  // namespace taut::report::animation_test
