#include "taut/machine/compile/guides.hpp"

#include <gtest/gtest.h>

#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"

namespace guides_test {

using namespace taut;
using namespace taut::machine;
using description::PathElement;

PathElement anchor(const std::string& name) {
  PathElement e;
  e.anchor = name;
  return e;
}
PathElement over(const std::string& name) {
  PathElement e;
  e.over = name;
  return e;
}
PathElement through(const std::string& name) {
  PathElement e;
  e.through = name;
  return e;
}

/// A skyline from x = 0 to 300 over jacks at 100 and 200; the mainline comes from the top at 300 over two guides.
Machine line(bool reversed = false) {
  Machine m;
  m.points = {{.name = "low", .body = {}, .at = {0, 0, 10}}, {.name = "high", .body = {}, .at = {300, 0, 110}}};
  m.ropes.emplace_back().name = "wire";
  m.ropes.back().mass = 1;
  m.ropes.back().stiffness = 1e7;
  for (const double x : {100.0, 200.0}) {
    auto& jack = m.supports.emplace_back();
    jack.name = x < 150 ? "jack1" : "jack2";
    jack.at = {x, 0, 12 + x / 3};
    auto& guide = m.sheaves.emplace_back();
    guide.name = x < 150 ? "guide1" : "guide2";
    guide.at = {x, 0, 10 + x / 3};
    guide.diameter = 0.3;
    guide.holds = "ahead_of car";
  }
  auto& car = m.carriages.emplace_back();
  car.name = "car";
  car.mass = 100;
  car.rides = "skyline";
  car.mainline = "mainline";
  auto& skyline = m.reevings.emplace_back();
  skyline.name = "skyline";
  skyline.rope = "wire";
  skyline.path = {anchor("low"), over("jack1"), through("car"), over("jack2"), anchor("high")};
  skyline.length = 320;
  auto& mainline = m.reevings.emplace_back();
  mainline.name = "mainline";
  mainline.rope = "wire";
  mainline.path = {anchor("high"), over("guide2"), over("guide1"), anchor("car")};
  mainline.length = 160;
  if (reversed) std::reverse(mainline.path.begin(), mainline.path.end());
  return m;
}

std::vector<std::string> path_of(const Model& m) {
  std::vector<std::string> names;
  for (const Node& node : m.reevings[1].nodes) names.push_back(node.name);
  return names;
}

Model compiled(const Machine& m) {
  auto model = compile(m);
  EXPECT_TRUE(model) << model.error().front().path << ": " << model.error().front().message;
  return *model;
}

std::string mistake(const Machine& m) {
  const auto model = compile(m);
  EXPECT_FALSE(model);
  return model ? std::string{} : model.error().front().path + ": " + model.error().front().message;
}

TEST(Guides, AreInThePathAheadOfTheCarriage) {
  using Names = std::vector<std::string>;
  for (const bool reversed : {false, true}) {
    const Model m = compiled(line(reversed));
    EXPECT_EQ(path_of(m).size(), 4U);  // all of them, for names
    const auto at = [&](double x, const Vector3& along = Vector3::UnitX()) {
      Names names = path_of(with_carriage_at(m, 0, x, along));
      if (reversed) std::reverse(names.begin(), names.end());
      return names;
    };
    EXPECT_EQ(at(250), (Names{"high", "car"}));
    EXPECT_EQ(at(150), (Names{"high", "guide2", "car"}));
    EXPECT_EQ(at(50), (Names{"high", "guide2", "guide1", "car"}));
    // the coordinate may run the other way
    EXPECT_EQ(at(-150, -Vector3::UnitX()), (Names{"high", "guide2", "car"}));
    EXPECT_EQ(at(-250, -Vector3::UnitX()), (Names{"high", "car"}));
    // from any configuration to any other one
    EXPECT_EQ(path_of(with_carriage_at(with_carriage_at(m, 0, 250), 0, 50)), path_of(with_carriage_at(m, 0, 50)));
  }
}

TEST(Guides, AtTheStartByThePlaceOfTheCarriage) {
  Machine m = line();
  EXPECT_EQ(path_of(with_guides_at_start(compiled(m))).size(), 3U);  // between the jacks
  m.carriages[0].at = Triple{50, 0, 20};
  EXPECT_EQ(path_of(with_guides_at_start(compiled(m))).size(), 4U);
}

TEST(Guides, OfACarriageAreAllOfThemWhereverItIs) {
  for (const double x : {50., 150., 250.}) {
    const Model m = with_carriage_at(compiled(line()), 0, x);
    const Array<PlacedGuide> all = guides_ahead_of(m, 0);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].node->name, "guide2");
    EXPECT_EQ(all[1].node->name, "guide1");
    EXPECT_EQ(all[1].place.x(), 100);
  }
}

TEST(Guides, AMisplacedCarriageIsNamed) {
  const Model m = with_carriage_at(compiled(line()), 0, 150);
  State state = initial_state(m);
  EXPECT_EQ(misplaced_guide(m, state.bodies), "");
  state.bodies[0].position.x() = 90;
  EXPECT_NE(misplaced_guide(m, state.bodies).find("beyond 'guide1', which was taken to be passed"), std::string::npos)
      << misplaced_guide(m, state.bodies);
  state.bodies[0].position.x() = 210;
  EXPECT_NE(misplaced_guide(m, state.bodies).find("before 'guide2', which was taken to hold 'mainline'"),
            std::string::npos)
      << misplaced_guide(m, state.bodies);
}

TEST(Guides, WhatCanNotBeReadOrDoesNotStandBesideItsCarriage) {
  const auto holds = [](const std::string& text) {
    Machine m = line();
    m.sheaves[0].holds = text;
    return mistake(m);
  };
  EXPECT_EQ(holds("ahead_of cat"), "sheaves.guide1.holds: there is no carriage 'cat'; did you mean 'car'?");
  EXPECT_NE(holds("before car").find("write 'ahead_of CARRIAGE'"), std::string::npos);
  EXPECT_NE(holds("ahead_of").find("write 'ahead_of CARRIAGE'"), std::string::npos);
  EXPECT_NE(holds("behind car").find("ahead is towards where the rope comes from"), std::string::npos);
  Machine order = line();
  std::swap(order.reevings[1].path[1], order.reevings[1].path[2]);
  EXPECT_NE(mistake(order).find("in the order in which it passes them"), std::string::npos) << mistake(order);
  Machine between = line();
  between.sheaves[0].holds.reset();
  EXPECT_EQ(mistake(between).find("reevings[1].path[1].over: 'guide2' holds a rope that ends at its carriage"), 0U)
      << mistake(between);
  Machine other = line();
  other.reevings[0].path.insert(other.reevings[0].path.begin() + 1, over("guide1"));
  EXPECT_NE(mistake(other).find("reevings[0].path[1].over"), std::string::npos) << mistake(other);
}

}  // namespace guides_test
