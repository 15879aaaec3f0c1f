#include "taut/report/figure/svg_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace svg_plot_test {

using namespace taut;
using namespace taut::report;

const double nan = std::numeric_limits<double>::quiet_NaN();

std::string svg(std::vector<Curve> curves, std::vector<Mark> marks = {}) {
  return plot_svg({.name = "p",
                   .title = "Title",
                   .caption = "",
                   .x = {.label = "position", .unit = si::m},
                   .y = {.label = "force", .unit = si::N},
                   .curves = std::move(curves),
                   .marks = std::move(marks)},
                  Display{});
}

bool is_clean(const std::string& text) {
  return text.find("nan") == std::string::npos && text.find("inf") == std::string::npos;
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(SvgPlot, AxesCarryUnits) {
  const std::string text = svg({{.label = "T", .x = {0, 100}, .y = {0, 50e3}}});
  EXPECT_NE(text.find(" in kN"), std::string::npos);
  EXPECT_NE(text.find(" in m<"), std::string::npos);
  EXPECT_NE(text.find(">50<"), std::string::npos);  // kN, not N
}

TEST(SvgPlot, BreaksAtNan) {
  const std::string text = svg({{.label = "T", .x = {0, 1, 2, 3, 4}, .y = {1, 2, nan, 2, 1}}});
  EXPECT_TRUE(is_clean(text));
  const std::size_t at = text.find("class=\"curve c0\"", text.find("class=\"frame\""));
  const std::size_t path = text.find("d=\"", at);
  const std::string d = text.substr(path, text.find("/>", path) - path);
  EXPECT_EQ(count(d, "M"), 2);
}

TEST(SvgPlot, ALonelyPointIsADot) {
  EXPECT_EQ(count(svg({{"T", {0, 1, 2}, {nan, 1, nan}}}), "<circle"), 1);
  EXPECT_EQ(count(svg({{"T", {5}, {1}}}), "<circle"), 1);
}

TEST(SvgPlot, EmptyAndDegenerate) {
  EXPECT_NE(svg({}).find("No values"), std::string::npos);
  EXPECT_NE(svg({{"T", {}, {}}}).find("No values"), std::string::npos);
  EXPECT_NE(svg({{"T", {nan, 1}, {1, nan}}}).find("No values"), std::string::npos);
  for (const double v : {0.0, 1.0, -3e7, 1e-12, 1e150}) EXPECT_TRUE(is_clean(svg({{"T", {0, 1}, {v, v}}}))) << v;
  EXPECT_TRUE(is_clean(svg({{"T", {0, 1, 2}, {1, std::numeric_limits<double>::infinity(), 2}}})));
  EXPECT_TRUE(is_clean(svg({{"T", {0, 1, 2}, {1}}})));
  EXPECT_TRUE(is_clean(svg({{"T", {1e9, 1e9 + 1e-8}, {1e9, 1e9 + 1e-8}}})));
}

TEST(SvgPlot, ANearLimitIsALineAFarOneIsNamed) {
  const std::string near =
      svg({{.label = "T", .x = {0, 1}, .y = {1e3, 2e3}}}, {{.x = 0, .y = 3e3, .label = "limit", .whole_line = true}});
  EXPECT_EQ(near.find("outside the range"), std::string::npos);
  const std::string far =
      svg({{.label = "T", .x = {0, 1}, .y = {1e3, 2e3}}}, {{.x = 0, .y = 1e6, .label = "limit", .whole_line = true}});
  EXPECT_NE(far.find("outside the range"), std::string::npos);
  EXPECT_NE(far.find("1000 kN"), std::string::npos);
}

/// y of the line of text that starts with these words.
double base_of(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words), y = text.rfind(" y=\"", at);
  return at == std::string::npos ? nan : std::stod(text.substr(y + 4));
}
double top_of_axes(const std::string& text) {
  const std::size_t frame = text.find("class=\"frame\"");
  return std::stod(text.substr(text.find(" y=\"", frame) + 4));
}

TEST(SvgPlot, EventsStandAboveTheCurves) {
  const std::string text =
      svg({{.label = "T", .x = {0, 100}, .y = {1, 2}}},
          {{.x = 30, .y = 0, .label = "brake closes", .upright = true}, {.x = 80, .y = 1.8, .label = "head"}});
  EXPECT_LT(base_of(text, "brake closes"), top_of_axes(text));
  EXPECT_LT(base_of(text, "head"), top_of_axes(text));
  EXPECT_EQ(count(text, "class=\"number\""), 0);
}

TEST(SvgPlot, EventsWithoutRoomAreListedByNumber) {
  std::vector<Mark> marks;
  for (int i = 0; i < 8; ++i) {
    marks.push_back({.x = 10.0 + i, .y = 0, .label = "slack of rope " + std::to_string(i), .upright = true});
  }
  const std::string text = svg({{.label = "T", .x = {0, 100}, .y = {1, 2}}}, marks);
  EXPECT_EQ(count(text, "class=\"pill\""), 8);
  for (int i = 0; i < 8; ++i) {
    EXPECT_GT(base_of(text, "m: slack of rope " + std::to_string(i)), top_of_axes(text) + 250) << i;
  }
}

TEST(SvgPlot, LimitsAreNamedBesideTheAxes) {
  const std::string text = svg({{.label = "T", .x = {0, 1}, .y = {1e3, 2e3}}},
                               {{.x = 0, .y = 2.5e3, .label = "admissible tension", .whole_line = true}});
  const std::size_t at = text.find("admissible tension"), x = text.rfind(" x=\"", at);
  const std::size_t frame = text.find("class=\"frame\""), left = text.find(" x=\"", frame),
                    wide = text.find(" width=\"", frame);
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(std::stod(text.substr(x + 4)), std::stod(text.substr(left + 4)) + std::stod(text.substr(wide + 8)));
  EXPECT_NE(text.find("2.5 kN"), std::string::npos);
}

TEST(SvgPlot, EscapesLabels) {
  const std::string text = svg({{.label = "<script>", .x = {0, 1}, .y = {1, 2}}},
                               {{.x = 0, .y = 1, .label = "<b>\x01", .whole_line = false},
                                {.x = nan, .y = nan, .label = "gone", .whole_line = false}});
  EXPECT_EQ(text.find("<script>"), std::string::npos);
  EXPECT_EQ(text.find("<b>"), std::string::npos);
  EXPECT_EQ(text.find("gone"), std::string::npos);
}

TEST(SvgPlot, TheSameEventsAreListedOnce) {
  const auto plot = [](const std::string& last) {
    std::vector<Mark> marks;
    for (const std::string& words : {std::string("the skyline breaks at the first jack"),
                                     std::string("the mainline goes slack between jack and yarder"), last}) {
      marks.push_back({.x = 1 + 0.05 * static_cast<double>(marks.size()), .label = words, .upright = true});
    }
    return Plot{.name = "p",
                .title = "",
                .caption = "",
                .x = {.label = "time", .unit = si::s},
                .y = {.label = "force", .unit = si::N},
                .curves = {{.label = "T", .x = {0, 5}, .y = {0, 50e3}}},
                .marks = std::move(marks)};
  };
  std::vector<std::string> listed;
  const std::string first = plot_svg(plot("the carriage stops at the yarder"), Display{}, listed);
  const std::string second = plot_svg(plot("the carriage stops at the yarder"), Display{}, listed);
  const std::string other = plot_svg(plot("the haulback goes slack at the tail spar"), Display{}, listed);
  EXPECT_NE(first.find("the skyline breaks"), std::string::npos);
  EXPECT_EQ(second.find("the skyline breaks"), std::string::npos);
  EXPECT_NE(second.find("1 to 3: see the plot above"), std::string::npos);
  EXPECT_NE(other.find("the haulback goes slack"), std::string::npos);
  EXPECT_EQ(other.find("see the plot above"), std::string::npos);
}

}  // namespace svg_plot_test
