#include "taut/machine/links/body_on.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "taut/machine/compile.hpp"

namespace taut::machine::body_on_test {

/// A boom up at 30 degrees with a section on it and a tip on that.
Machine boom() {
  Machine m;
  m.points = {{.name = "far", .body = {}, .at = {0, 0, 30}},
              {.name = "nose", .body = "tip", .at = {0, 0, 0}},
              {.name = "end", .body = "section", .at = {1, 0, 0}}};
  m.ropes.emplace_back().name = "rope";
  m.ropes[0].mass = 1;
  m.ropes[0].stiffness = 1e6;
  description::Body tip, section, base;
  tip.name = "tip";
  tip.at = {4, 0, 0.5};
  tip.on = "section";
  tip.free = {"x", "z", "ry"};  // it goes along with the section
  section.name = "section";
  section.mass = 100;
  section.at = {2, 0, 0};
  section.guide = Triple{1, 0, 0};
  section.on = "base";
  base.name = "base";
  base.at = {1, 0, 2};
  base.motion.emplace().ry = "-30 deg";
  m.bodies = {tip, section, base};
  description::Reeving r;
  r.rope = "rope";
  r.path.resize(2);
  r.path[0].anchor = "end";
  r.path[1].anchor = "far";
  r.length = 40;
  description::Reeving second = r;  // what may move hangs on a rope
  second.name = "second";
  second.path[0].anchor = "nose";
  m.reevings = {r, second};
  return m;
}

TEST(BodyOn, PlacesAxesAndGuidesAreCarriedOver) {
  const auto compiled = compile(boom());
  ASSERT_TRUE(compiled) << compiled.error().front().message;
  const double c = std::cos(M_PI / 6), s = 0.5;
  const Body &tip = compiled->bodies[0], &section = compiled->bodies[1];
  EXPECT_NEAR((section.position - Vector3(1 + 2 * c, 0, 2 + 2 * s)).norm(), 0, 1e-14);
  EXPECT_NEAR((section.free.at(0).along - Vector3(c, 0, s)).norm(), 0, 1e-14);
  EXPECT_NEAR((tip.position - Vector3(1 + 6 * c - 0.5 * s, 0, 2 + 6 * s + 0.5 * c)).norm(), 0, 1e-14);
  EXPECT_NEAR((tip.orientation * Vector3::UnitX() - Vector3(c, 0, s)).norm(), 0, 1e-14);
}

// A crane turned in plan has the same hinge: what is free is free in the axes of the body under it.
TEST(BodyOn, FreedomsAreCarriedOver) {
  Machine m = boom();
  m.bodies[1].guide.reset();
  m.bodies[1].free = {"x", "ry"};
  m.bodies[2].motion.reset();
  m.bodies[2].turned.emplace().rz = M_PI / 3;
  const auto compiled = compile(m);
  ASSERT_TRUE(compiled) << compiled.error().front().message;
  const Vector3 x(0.5, std::sqrt(0.75), 0), y(-std::sqrt(0.75), 0.5, 0);
  EXPECT_NEAR((compiled->bodies[1].free.at(0).along - x).norm(), 0, 1e-14);
  EXPECT_NEAR((compiled->bodies[1].free.at(1).about - y).norm(), 0, 1e-14);
}

/// What is said of a boom with these free ways, its foot at this place on a tower with those.
std::string on_tower(const std::vector<std::string>& tower_free, const std::vector<std::string>& boom_free,
                     const Triple& foot) {
  Machine m = boom();
  m.bodies.erase(m.bodies.begin());
  m.points[1].body = "base";
  m.bodies[0].guide.reset();
  m.bodies[0].at = foot;
  m.bodies[0].free = boom_free;
  m.bodies[1].motion.reset();
  m.bodies[1].free = tower_free;
  m.bodies[1].mass = 1000;
  const auto compiled = compile(m);
  return compiled ? std::string() : compiled.error().front().path + ": " + compiled.error().front().message;
}

// A boom hinged on a tower that is free to slew stayed behind, and passed.
TEST(BodyOn, WhatCannotFollowAFreeBodyIsRefused) {
  const Triple on_axis = {0, 0, 3}, aside = {1, 0, 0};
  EXPECT_NE(on_tower({"rz"}, {"ry"}, aside).find("bodies.section.on: 'base' is free to move, and 'section' would stay"),
            std::string::npos)
      << on_tower({"rz"}, {"ry"}, aside);
  EXPECT_NE(on_tower({"rz"}, {"ry"}, on_axis), "") << "it has to turn";
  EXPECT_NE(on_tower({"x"}, {}, aside), "");
  EXPECT_NE(on_tower({"x"}, {"z"}, aside), "");
  EXPECT_NE(on_tower({"ry"}, {"x"}, aside), "") << "it goes round";
  EXPECT_EQ(on_tower({}, {"ry"}, aside), "");
  EXPECT_EQ(on_tower({"rz"}, {"rz"}, on_axis), "");
  EXPECT_EQ(on_tower({"rz"}, {"x", "y", "z"}, aside), "") << "it hangs on ropes";
  EXPECT_EQ(on_tower({"ry"}, {"x", "z", "ry"}, aside), "");
  EXPECT_EQ(on_tower({"x"}, {"x"}, aside), "");
}

// A trolley on a guide kept to the line of the start while its boom fell (pendant 9.54 kN for 95.3 kN), and passed; so
// did a section with one way to shift on a boom that a signal luffs.
TEST(BodyOn, AGuideDoesNotTurnWithTheBodyUnderIt) {
  const auto reported = [](Machine m) {
    m.bodies.erase(m.bodies.begin());
    m.points[1].body = "base";
    const auto compiled = compile(m);
    return compiled ? std::string() : compiled.error().front().path + ": " + compiled.error().front().message;
  };
  Machine free = boom();
  free.bodies[2].mass = 1000;
  free.bodies[2].motion.reset();
  free.bodies[2].free = {"ry"};
  EXPECT_NE(reported(free).find("bodies.section.on: 'base' is free to move, and 'section' would stay"),
            std::string::npos)
      << reported(free);
  free.bodies[1].at = {0, 0, 0};
  EXPECT_NE(reported(free), "") << "from the axis it moves along the line of the start";
  free.bodies[1].at = {2, 0, 0};
  free.bodies[2].free = {"x"};
  EXPECT_EQ(reported(free), "") << "it is shifted along the guide";
  free.bodies[2].free = {"rz"};
  free.bodies[1].guide = Triple{0, 0, 1};
  EXPECT_NE(reported(free), "");
  free.bodies[1].at = {0, 0, 3};
  EXPECT_NE(reported(free), "") << "on the axis it has to turn";
  free.bodies[1].free = {"rz"};
  EXPECT_EQ(reported(free), "");

  Machine driven = boom();
  driven.signals.emplace_back().name = "luff";
  driven.signals[0].ramp.emplace().to = "1 rad";
  driven.bodies[2].motion->ry = "luff";
  EXPECT_NE(reported(driven).find("'base' has a 'motion', and 'section' would stay behind"), std::string::npos)
      << reported(driven);
  driven.bodies[1].guide.reset();
  driven.bodies[1].free = {"x"};
  EXPECT_NE(reported(driven), "");
  driven.bodies[1].free = {"x", "z"};
  EXPECT_EQ(reported(driven), "");
  driven.bodies[2].motion->ry.reset();
  driven.bodies[2].motion->x = "luff";
  driven.signals[0].ramp->to = "1 m";
  driven.bodies[1].free = {"z"};
  EXPECT_NE(reported(driven), "");
  driven.bodies[1].free = {"x", "z"};
  EXPECT_EQ(reported(driven), "");
}

TEST(BodyOn, MistakesAreToldAtTheirPlace) {
  const auto reported = [](const Machine& m) {
    const auto compiled = compile(m);
    return compiled ? std::string() : compiled.error().front().path + ": " + compiled.error().front().message;
  };
  Machine m = boom();
  m.bodies[1].on = "bass";
  EXPECT_EQ(reported(m), "bodies.section.on: there is no body 'bass'; did you mean 'base'?");
  m = boom();
  m.bodies[1].on = "tip";
  EXPECT_NE(reported(m).find("in a circle"), std::string::npos) << reported(m);
  m = boom();
  m.bodies[0].on = "tip";
  EXPECT_NE(reported(m).find("bodies.tip.on: the bodies stand on each other in a circle"), std::string::npos)
      << reported(m);
  m = boom();
  m.bodies[2].on = "far";
  EXPECT_NE(reported(m).find("there is no body 'far'"), std::string::npos) << reported(m);
  m = boom();
  m.bodies[1].guide.reset();
  m.bodies[1].motion.emplace().x = "1 m";
  EXPECT_EQ(reported(m), "bodies.section.on: a driven body has its place in the ground frame");
  m = boom();
  m.bodies[1].guide.reset();
  m.bodies[1].free = {"ry"};
  EXPECT_EQ(reported(m), "");  // it stands on a body that a constant turns
  m.signals.emplace_back().name = "slew";
  m.signals[0].ramp.emplace().to = "1 rad";
  m.bodies[2].motion->ry = "slew";
  EXPECT_NE(reported(m).find("'base' has a 'motion', and 'section' would stay behind"), std::string::npos)
      << reported(m);
}

}  // namespace taut::machine::body_on_test
