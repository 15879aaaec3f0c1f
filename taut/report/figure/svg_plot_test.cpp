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
  const std::size_t at = text.find("stroke-width=\"2\" stroke-linejoin");
  const std::size_t path = text.rfind("d=\"", at);
  const std::string d = text.substr(path, at - path);
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

TEST(SvgPlot, EscapesLabels) {
  const std::string text = svg({{.label = "<script>", .x = {0, 1}, .y = {1, 2}}},
                               {{.x = 0, .y = 1, .label = "<b>\x01", .whole_line = false},
                                {.x = nan, .y = nan, .label = "gone", .whole_line = false}});
  EXPECT_EQ(text.find("<script>"), std::string::npos);
  EXPECT_EQ(text.find("<b>"), std::string::npos);
  EXPECT_EQ(text.find("gone"), std::string::npos);
}

}  // namespace svg_plot_test
