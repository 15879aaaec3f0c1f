#include "taut/report/figure/svg_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace svg_drawing_test {

using namespace taut;
using namespace taut::report;

const double nan = std::numeric_limits<double>::quiet_NaN();

std::string svg(std::vector<Shape> shapes, Unit unit = si::m, double vertical = 1) {
  return drawing_svg({.name = "d",
                      .title = "Title <&>",
                      .caption = "",
                      .shapes = std::move(shapes),
                      .unit = unit,
                      .vertical_scale = vertical},
                     Display{});
}

/// Corners of the first line of this class.
std::vector<std::pair<double, double>> corners(const std::string& text, const std::string& name) {
  const std::regex path("<path d=\"([^\"]*)\" class=\"line " + name + "\"");
  std::smatch m;
  std::vector<std::pair<double, double>> all;
  if (!std::regex_search(text, m, path)) return all;
  const std::string d = m[1];
  const std::regex point("[ML](-?[0-9.]+) (-?[0-9.]+)");
  for (std::sregex_iterator it(d.begin(), d.end(), point), end; it != end; ++it) {
    all.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  return all;
}

bool is_clean(const std::string& text) {
  return text.find("nan") == std::string::npos && text.find("inf") == std::string::npos;
}

TEST(SvgDrawing, IsToScaleWithUpUp) {
  const auto p = corners(
      svg({Polyline{.points = {{.x = 0, .y = 0}, {.x = 30, .y = 0}, {.x = 30, .y = 40}}, .role = Role::structure}}),
      "structure");
  ASSERT_EQ(p.size(), 3U);
  const double x = p[1].first - p[0].first;
  const double y = p[2].second - p[1].second;
  EXPECT_GT(x, 0);
  EXPECT_LT(y, 0);
  EXPECT_NEAR(y / x, -40.0 / 30.0, 0.01);
}

// A force of 3, 4, 12 kN seen from above: an arrow of 5 kN, and the number 13 kN.
TEST(SvgDrawing, AForceThatIsSeenAslantHasItsWholeNumber) {
  ForceArrow slant{.at = {}, .fx = 3e3, .fy = 4e3, .label = "F a", .role = Role::force, .towards = false};
  const Polyline line{.points = {{.x = 0, .y = 0}, {.x = 30, .y = 0}}, .role = Role::structure};
  EXPECT_NE(svg({line, slant}).find("5 kN"), std::string::npos);
  slant.whole = 13e3;
  EXPECT_NE(svg({line, slant}).find("13 kN"), std::string::npos);
  EXPECT_EQ(svg({line, slant}).find("5 kN"), std::string::npos);
  slant.fx = slant.fy = 0;
  EXPECT_NE(svg({line, slant}).find("13 kN"), std::string::npos)
      << "along the line of sight: a number without an arrow";
}

TEST(SvgDrawing, StretchesHeightsAndSaysSo) {
  const Drawing d{.name = "d",
                  .title = "",
                  .caption = "",
                  .shapes = {Polyline{.points = {{.x = 0, .y = 0}, {.x = 300, .y = 0}, {.x = 300, .y = 4}},
                                      .role = Role::structure}},
                  .unit = si::m,
                  .vertical_scale = 5};
  const auto p = corners(drawing_svg(d, Display{}), "structure");
  EXPECT_NEAR((p[2].second - p[1].second) / (p[1].first - p[0].first), -5 * 4.0 / 300, 0.002);
  EXPECT_NE(scale_words(d).find("5 times"), std::string::npos);
  EXPECT_EQ(scale_words({}), "");
}

TEST(SvgDrawing, ArrowsAreAsLongAsTheirForces) {
  const std::string text =
      svg({Polyline{.points = {{.x = 0, .y = 0}, {.x = 10, .y = 0}}, .role = Role::structure},
           ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 2000, .label = "A"},
           ForceArrow{.at = {.x = 5, .y = 0}, .fx = 0, .fy = 1000, .label = "B", .role = Role::second_force}});
  const auto a = corners(text, "force");
  const auto b = corners(text, "second-force");
  ASSERT_EQ(a.size(), 2U);
  ASSERT_EQ(b.size(), 2U);
  const double shaft_a = a[0].second - a[1].second;  // ends inside the head, 7.2 pixels before the tip
  const double shaft_b = b[0].second - b[1].second;
  EXPECT_NEAR((shaft_a + 7.2) / (shaft_b + 7.2), 2, 0.02);
  EXPECT_NE(text.find("= 2 kN"), std::string::npos);
}

TEST(SvgDrawing, AForcePolygonCloses) {
  const std::string text =
      svg({ForceArrow{.at = {.x = 0, .y = 0}, .fx = 3000, .fy = 0, .label = "H"},
           ForceArrow{.at = {.x = 3000, .y = 0}, .fx = 0, .fy = 4000, .label = "V", .role = Role::second_force},
           ForceArrow{.at = {.x = 0, .y = 0}, .fx = 3000, .fy = 4000, .label = "R", .role = Role::highlight}},
          si::N);
  EXPECT_NE(text.find("= 5 kN"), std::string::npos);
  const auto v = corners(text, "second-force");
  const auto h = corners(text, "force");
  EXPECT_NEAR(v[0].first, h[1].first + 7.2, 0.3);  // V starts where H ends
}

TEST(SvgDrawing, ATowardsArrowEndsAtItsPoint) {
  const std::string text =
      svg({Polyline{.points = {{.x = 0, .y = 0}, {.x = 10, .y = 0}}, .role = Role::ground},
           ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 500, .label = "N", .role = Role::force, .towards = true}});
  EXPECT_GT(corners(text, "force")[0].second, 20);  // its tail is below the ground
}

TEST(SvgDrawing, NothingOfABadShapeReachesThePage) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::string text =
      svg({Polyline{.points = {{.x = nan, .y = 0}, {.x = 1, .y = inf}, {.x = 0, .y = 0}, {.x = 1, .y = 1}}},
           Circle{.center = {.x = 0, .y = 0}, .radius = nan},
           Circle{.center = {.x = 0, .y = 0}, .radius = 1, .role = Role::body, .from = inf, .to = 0},
           ForceArrow{.at = {.x = nan, .y = 0}, .fx = 1, .fy = 1, .label = "x"},
           ForceArrow{.at = {.x = 0, .y = 0}, .fx = nan, .fy = 1, .label = "x"},
           ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 0, .label = "zero"},
           DimensionLine{.from = {.x = 0, .y = 0}, .to = {.x = 0, .y = 0}, .offset = 1, .text = "none"},
           DimensionLine{.from = {.x = 0, .y = nan}, .to = {.x = 0, .y = 0}, .offset = 1, .text = "none"},
           AngleMark{.center = {.x = 0, .y = 0}, .radius = nan, .from = 0, .to = 1, .text = "a"},
           AngleMark{.center = {.x = 0, .y = 0}, .radius = 1, .from = 0, .to = 1e300, .text = "a"},
           Label{.at = {.x = inf, .y = 0}, .text = "gone"}, Label{.at = {.x = 0, .y = 0}, .text = "<script>"}});
  EXPECT_TRUE(is_clean(text));
  EXPECT_EQ(text.find("<script>"), std::string::npos);
  EXPECT_NE(text.find("zero"), std::string::npos);
}

TEST(SvgDrawing, EmptyAndDegenerateDrawings) {
  EXPECT_NE(svg({}).find("Nothing to draw"), std::string::npos);
  EXPECT_TRUE(is_clean(svg({Label{{5, 5}, "alone"}})));
  EXPECT_TRUE(is_clean(svg({Polyline{{{0, 0}, {1e-9, 0}}}})));
  EXPECT_TRUE(is_clean(svg({Polyline{{{0, 0}, {1e9, 1e-9}}}})));
  EXPECT_TRUE(is_clean(svg({Polyline{{{0, 0}, {1, 1}}}}, si::m, nan)));
}

TEST(SvgDrawing, FitsAPageWithItsLabels) {
  std::vector<Shape> shapes{Polyline{.points = {{.x = 0, .y = 0}, {.x = 100, .y = 3}}, .role = Role::rope}};
  for (int i = 0; i < 8; ++i) {
    shapes.emplace_back(Label{.at = {.x = 100, .y = 3.0 * i},
                              .text = "a rather long label at the right end, number " + std::to_string(i)});
  }
  const std::string text = svg(shapes);
  std::smatch m;
  ASSERT_TRUE(std::regex_search(text, m, std::regex("width=\"([0-9]+)\" height=\"([0-9]+)\"")));
  EXPECT_LE(std::stod(m[1]), 760);
}

TEST(SvgDrawing, RulersShowTheCoordinates) {
  Drawing d;
  d.shapes = {Polyline{.points = {{.x = 100, .y = 20}, {.x = 200, .y = 80}}, .role = Role::rope}};
  EXPECT_EQ(drawing_svg(d, Display{}).find("ruler"), std::string::npos);
  d.across = "x";
  d.upward = "z";
  const std::string text = drawing_svg(d, Display{});
  for (const char* shown : {">x, m<", ">z, m<", ">120<", ">200<", ">40<"}) {
    EXPECT_NE(text.find(shown), std::string::npos) << shown;
  }
  EXPECT_EQ(text.find("class=\"bar\""), std::string::npos) << "the ruler replaces the bar";
}

TEST(SvgDrawing, NamesCarryTheirForcesAndLengths) {
  const std::string text = svg(
      {Polyline{.points = {{.x = 0, .y = 0}, {.x = 100, .y = 30}}, .role = Role::rope},
       ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 51e3, .label = "F tower"},
       Label{.at = {.x = 50, .y = 15}, .text = "T skyline", .or_at = {}, .force = 42800},
       DimensionLine{
           .from = {.x = 0, .y = 40}, .to = {.x = 100, .y = 40}, .offset = 0, .text = "span", .with_length = true}});
  EXPECT_NE(text.find("F tower 51 kN"), std::string::npos);
  EXPECT_NE(text.find("T skyline 42.8 kN"), std::string::npos);
  EXPECT_NE(text.find("span 100 m"), std::string::npos);
}

TEST(SvgDrawing, ALongNameIsCutNotItsNumber) {
  const Polyline rope{.points = {{.x = 0, .y = 0}, {.x = 100, .y = 30}}, .role = Role::rope};
  const std::string text =
      svg({rope, ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 51e3, .label = "F " + std::string(100, 'n')}});
  EXPECT_NE(text.find("nnn... 51 kN"), std::string::npos) << text;
}

/// A hundred names in a place for ten: each is on the drawing, in the list, or counted.
TEST(SvgDrawing, NoNameIsLostInACrowd) {
  std::vector<Shape> shapes;
  for (int i = 0; i < 100; ++i) {
    shapes.emplace_back(
        ForceArrow{.at = {.x = 0.1 * i, .y = 0}, .fx = 0, .fy = 1000.0 + i, .label = "F part " + std::to_string(i)});
  }
  const std::string text = svg(shapes);
  std::smatch m;
  int left_out = 0;
  if (std::regex_search(text, m, std::regex("and ([0-9]+) more: see the tables"))) left_out = std::stoi(m[1]);
  int shown = 0;
  for (int i = 0; i < 100; ++i) {
    shown += text.find("F part " + std::to_string(i) + " ") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(shown + left_out, 100);
  EXPECT_GE(shown, 80);
}

}  // namespace svg_drawing_test
