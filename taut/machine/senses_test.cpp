#include "taut/machine/senses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"

/// The sense of the rope on which a carriage rolls.
namespace senses_test {

using namespace taut;
using namespace taut::machine;
using description::PathElement;

PathElement element(const std::string& name) {
  PathElement e;
  (name == "car" ? e.through : name == "jack1" || name == "jack2" ? e.over : e.anchor) = name;
  return e;
}

/// A skyline from x = 0 to 300 over jacks at 100 and 200; a mainline from one of its ends.
struct Line {
  std::string winch = "high";
  bool skyline_turned = false, mainline_turned = false;
  Triple towards = {1, 0, 0};  ///< of the line in plan
};

Machine line(const Line& of) {
  Machine m;
  const auto at = [&](double x, double z) { return Triple{x * of.towards[0], x * of.towards[1], z}; };
  m.points = {{.name = "low", .body = {}, .at = at(0, 10)}, {.name = "high", .body = {}, .at = at(300, 110)}};
  m.ropes.emplace_back().name = "wire";
  m.ropes.back().mass = 1;
  m.ropes.back().stiffness = 1e7;
  for (const double x : {100.0, 200.0}) {
    auto& jack = m.supports.emplace_back();
    jack.name = x < 150 ? "jack1" : "jack2";
    jack.at = at(x, 12 + x / 3);
    jack.friction = 0.1;
  }
  auto& car = m.carriages.emplace_back();
  car.name = "car";
  car.mass = 100;
  car.rides = "skyline";
  car.mainline = "mainline";
  car.friction = 0.03;
  auto& skyline = m.reevings.emplace_back();
  skyline.name = "skyline";
  skyline.rope = "wire";
  for (const char* name : {"low", "jack1", "car", "jack2", "high"}) skyline.path.push_back(element(name));
  if (of.skyline_turned) std::reverse(skyline.path.begin(), skyline.path.end());
  skyline.length = 320;
  auto& mainline = m.reevings.emplace_back();
  mainline.name = "mainline";
  mainline.rope = "wire";
  mainline.path = {element(of.winch), PathElement{}};
  mainline.path[1].anchor = "car";
  mainline.length = 160;
  if (of.mainline_turned) std::reverse(mainline.path.begin(), mainline.path.end());
  return m;
}

Model compiled(const Machine& m) {
  const auto model = compile(m);
  EXPECT_TRUE(model) << model.error().front().path << ": " << model.error().front().message;
  return *model;
}

using Flow = Array<int>;

TEST(Senses, ACarriageMovesToWhereItsMainlineIsHauled) {
  for (const Triple& towards : {Triple{1, 0, 0}, Triple{-0.6, 0.8, 0}}) {
    for (const bool mainline_turned : {false, true}) {
      for (const bool to_high : {true, false}) {
        for (const bool turned : {false, true}) {
          const Model m = compiled(line({.winch = to_high ? "high" : "low",
                                         .skyline_turned = turned,
                                         .mainline_turned = mainline_turned,
                                         .towards = towards}));
          const Senses in = hauling_in(m);
          EXPECT_EQ(in.flow[0][2], to_high == turned ? 1 : -1);
          EXPECT_EQ(in.flow[0][1], -1) << "over the jacks it creeps";
          EXPECT_EQ(in.creep[0], (Flow{0, 1, 0, -1, 0}));
          EXPECT_EQ(in.flow[1], mainline_turned ? (Flow{1, 1}) : (Flow{-1, -1})) << "off from the carriage";
        }
      }
    }
  }
}

TEST(Senses, ByThePlaceOfThePrescribedCarriage) {
  const Model m = compiled(line({}));
  const auto flow = [&](double x, const Vector3& along) {
    return hauling_in(m, Prescribed{.carriage = 0, .x = x, .along = along}).flow[0][2];
  };
  EXPECT_EQ(flow(150, Vector3::UnitX()), -1);
  EXPECT_EQ(flow(-150, -Vector3::UnitX()), -1);
  EXPECT_EQ(flow(310, Vector3::UnitX()), 1) << "beyond the block";
  // in another span both jacks are on one side
  const Model there = with_carriage_at(m, 0, 250);
  EXPECT_EQ(hauling_in(there).creep[0], (Flow{0, 1, 1, 0, 0}));
}

TEST(Senses, WhatTheDeckOrAWinchSaysGoesFirst) {
  Machine told = line({});
  told.reevings[0].haul = description::Haul::to_end;
  EXPECT_EQ(hauling_in(compiled(told)).flow[0], (Flow{1, 1, 1, 1, 1}));
  Machine held = line({});
  held.reevings[0].length.reset();
  held.reevings[0].tension_at_end = 5e4;
  const Senses in = hauling_in(compiled(held));
  EXPECT_EQ(in.flow[0], (Flow{1, 1, -1, 1, 1})) << "it runs to its tension, and the carriage on it as it moves";
  EXPECT_EQ(in.creep[0], (Flow{0, 1, 0, -1, 0})) << "and gives rope to the carriage's span, or takes it";
  Machine free = line({});
  free.carriages[0].mainline.reset();
  EXPECT_EQ(hauling_in(compiled(free)).flow[0], (Flow{-1, -1, -1, -1, -1})) << "nothing says how it moves";
  EXPECT_EQ(hauling_in(compiled(free)).creep[0], (Flow{0, 1, 0, -1, 0})) << "its weight draws rope all the same";
  Machine back = line({});
  back.carriages[0].haulback = std::exchange(back.carriages[0].mainline, std::nullopt);
  EXPECT_EQ(hauling_in(compiled(back)).flow[0][2], -1) << "a haulback alone is what hauls";
}

TEST(Senses, TheMainlineDrawsTheHaulbackOffItsWinch) {
  const auto with_haulback = [](bool turned, const char* winch) {
    Machine m = line({});
    auto& haulback = m.reevings.emplace_back();
    haulback.name = "haulback";
    haulback.rope = "wire";
    haulback.path = {element(winch), PathElement{}};
    haulback.path[1].anchor = "car";
    haulback.tension_at_start = 5e3;
    if (turned) {
      std::reverse(haulback.path.begin(), haulback.path.end());
      haulback.tension_at_end = std::exchange(haulback.tension_at_start, std::nullopt);
    }
    m.carriages[0].haulback = "haulback";
    return m;
  };
  for (const bool turned : {false, true}) {
    const Senses in = hauling_in(compiled(with_haulback(turned, "low")));
    EXPECT_EQ(in.follows, (Array<bool>{false, false, true}));
    EXPECT_EQ(in.flow[2], turned ? (Flow{1, 1}) : (Flow{-1, -1})) << "by itself it runs to its winch";
  }
  EXPECT_EQ(hauling_in(compiled(with_haulback(false, "high"))).follows, (Array<bool>{false, false, false}))
      << "both pull the same way";
  Machine told = with_haulback(false, "low");
  told.reevings[2].haul = description::Haul::to_start;
  EXPECT_EQ(hauling_in(compiled(told)).follows, (Array<bool>{false, false, false}));
}

}  // namespace senses_test
