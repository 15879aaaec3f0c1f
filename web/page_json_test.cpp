#include "web/page_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace taut::web::page_json_test {

using Json = nlohmann::json;

Json page_of(const Scene& scene) {
  Result r;
  r.scenes.push_back(scene);
  return Json::parse(to_page(r));
}

TEST(PageJson, SceneIsFlatFramesOfPlacesAndTensions) {
  Scene s;
  s.name = "machine";
  s.t = {0, 0.5};
  s.lines.push_back(
      {.name = "sky\"line", .points = {{{1, -2.00004, 3.5}, {0, 0, 12}}, {{1, 2, 3}}}, .tension = {{1e3, 7.6}, {}}});
  s.points.push_back({.name = "P", .radius = 0.25, .at = {{1, 2, 3}, {-1e-5, 0.1234, 1e6}}, .velocity = {}});
  const Json page = page_of(s), scene = page.at("scenes").at(0);
  EXPECT_EQ(scene.at("t"), Json::parse("[0.0, 0.5]"));
  EXPECT_EQ(scene.at("times").size(), 2U);
  const Json& line = scene.at("lines").at(0);
  EXPECT_EQ(line.at("name"), "sky\"line");
  EXPECT_EQ(line.at("points"), Json::parse("[[1, -2, 3.5, 0, 0, 12], [1, 2, 3]]"));
  EXPECT_EQ(line.at("tension"), Json::parse("[[1000, 8], []]"));
  EXPECT_EQ(scene.at("points").at(0).at("at"), Json::parse("[[1, 2, 3], [0, 0.1234, 1000000]]"));
  EXPECT_EQ(scene.at("points").at(0).at("radius"), 0.25);
  EXPECT_EQ(scene.at("tension").at("most"), 1e3);
}

TEST(PageJson, WhatIsNoNumberOrNoTextIsShownAsSuch) {
  Scene s;
  s.name = "bad \xff bytes";
  const double infinite = std::numeric_limits<double>::infinity();
  s.lines.push_back(
      {.name = "</script>\x80", .points = {{{std::nan(""), infinite, -1e300}}}, .tension = {{-infinite}}});
  const Json scene = page_of(s).at("scenes").at(0);
  EXPECT_EQ(scene.at("lines").at(0).at("points"), Json::parse("[[null, null, -1e300]]"));
  EXPECT_EQ(scene.at("lines").at(0).at("tension"), Json::parse("[[null]]"));
  EXPECT_TRUE(scene.at("tension").is_null());
  EXPECT_EQ(page_of({}).at("scenes").at(0).at("lines"), Json::array());
  EXPECT_EQ(Json::parse(to_page({})).at("scenes"), Json::array());
  EXPECT_EQ(Json::parse(to_page({})).at("ground"), Json::array());
}

TEST(PageJson, AMotionHasItsOwnEventsAndPlots) {
  Result r;
  for (const char* name : {"motion_quick", "motion_long"}) {
    Scene s;
    s.name = name;
    s.t = {0, 1};
    r.scenes.push_back(s);
    for (const char* view : {"", "_plan"}) {
      Animation a;
      a.name = std::string(name) + view;
      a.scene = name;
      a.events = {{0.5, std::string("break in ") + name}};
      r.figures.emplace_back(a);
    }
    Plot p;
    p.x = {.label = "time", .unit = si::s};
    p.scene = name;
    r.figures.emplace_back(p);
  }
  r.figures.emplace_back(Plot{});
  r.display = {{"time", "min"}};
  const Json page = Json::parse(to_page(r));
  for (std::size_t i = 0; i < 2; ++i) {
    const Json &scene = page.at("scenes").at(i), &over = page.at("plots").at(i).at("over");
    ASSERT_EQ(scene.at("events").size(), 1U);
    EXPECT_EQ(scene.at("events").at(0).at("text"), "break in " + scene.at("name").get<std::string>());
    EXPECT_EQ(over.at("scene"), scene.at("name"));
    EXPECT_DOUBLE_EQ(over.at("second").get<double>(), 1 / 60.0);
  }
  EXPECT_TRUE(page.at("plots").at(2).at("over").is_null());
}

TEST(PageJson, APictureStandsAloneAsOnPaper) {
  Result r;
  Drawing d;
  d.shapes.emplace_back(Polyline{.points = {{0, 0}, {10, 0}}, .role = Role::rope});
  r.figures.emplace_back(d);
  const Json pictures = Json::parse(pictures_of(r));
  const auto svg = pictures.at(0).at("svg").get<std::string>();
  // every colour that its style names is given there, and none by the theme of the reader's screen
  for (std::size_t at = svg.find("var(--"); at != std::string::npos; at = svg.find("var(--", at + 1)) {
    const std::string name = svg.substr(at + 4, svg.find(')', at) - at - 4);
    EXPECT_NE(svg.find("  " + name + ": "), std::string::npos) << name;
  }
  EXPECT_EQ(svg.find("prefers-color-scheme"), std::string::npos);
}

TEST(PageJson, PlacesAreGoodToATenthOfAMillimetre) {
  std::mt19937_64 source(5);
  Scene s;
  s.lines.emplace_back().name = "rope";
  std::vector<std::array<double, 3>> frame;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10, std::uniform_real_distribution<>(-6, 12)(source));
    frame.push_back({size, -size, std::round(size)});
  }
  s.lines[0].points = {frame};
  const Json page = page_of(s);
  const Json& written = page.at("scenes").at(0).at("lines").at(0).at("points").at(0);
  ASSERT_EQ(written.size(), 3 * frame.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const double x = frame[i / 3][i % 3];
    EXPECT_NEAR(written[i].get<double>(), x, 0.5e-4 * (1 + 1e-9) + 1e-15 * std::abs(x));
  }
}

}  // namespace taut::web::page_json_test
