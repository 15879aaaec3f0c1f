#include "taut/machine/compile/room.hpp"

#include <gtest/gtest.h>

#include "test/support/complaints.hpp"
#include "test/support/described.hpp"

namespace taut::machine::room_test {

using namespace described;
using taut_test::complaints_of;

description::Round sheave(const std::string& name, const Triple& at, double diameter) {
  description::Round round;
  round.name = name;
  round.at = at;
  round.diameter = diameter;
  return round;
}

/// An endless rope over a drive and two sheaves.
Machine loop() {
  Machine m;
  m.ropes = {steel("saw")};
  m.ropes[0].stiffness = 1e6;
  m.sheaves = {sheave("drive", {0, 0, 1}, 0.7), sheave("idler", {7, 0, 1.3}, 0.5), sheave("tail", {3, 0, 1}, 0.4)};
  m.sheaves[0].motor.emplace();
  description::Reeving rope;
  rope.rope = "saw";
  rope.path = {over("drive"), over("idler"), over("tail")};
  rope.closed = true;
  rope.length = 16;
  m.reevings = {rope};
  return m;
}

/// From a point over a sheave to another point.
Machine line_over(const Triple& from, const Triple& sheave_at, const Triple& to) {
  Machine m;
  m.points = {{.name = "a", .body = {}, .at = from}, {.name = "b", .body = {}, .at = to}};
  m.ropes = {steel("rope")};
  m.sheaves = {sheave("s", sheave_at, 0.5)};
  description::Reeving rope;
  rope.rope = "rope";
  rope.path = {anchor("a"), over("s"), anchor("b")};
  rope.length = 20;
  m.reevings = {rope};
  return m;
}

TEST(Room, AnEndlessRopeComesBackToItsDriveFromElsewhere) {
  EXPECT_EQ(complaints_of(loop()), "");
  Machine m = loop();
  m.sheaves[2].at = m.sheaves[0].at;
  EXPECT_EQ(complaints_of(m), "reevings[0].path: 'tail' and 'drive' are at the same place\n");
}

TEST(Room, ATackleTellsAPairOnce) {
  Machine m = tackle(6, {anchor("lead"), falls(6, "head", "block"), anchor("pin")});
  m.bodies[0].at = m.sheaves[0].at;
  const std::string reported = complaints_of(m);
  const std::string same = "are at the same place";
  EXPECT_NE(reported.find(same), std::string::npos) << reported;
  EXPECT_EQ(reported.find(same), reported.rfind(same)) << reported;
}

TEST(Room, CirclesInsideEachOther) {
  Machine m = loop();
  m.sheaves[2].at = {0.1, 0, 1};  // radii 0.2 m and 0.35 m, turned the same way
  const std::string reported = complaints_of(m);
  EXPECT_NE(reported.find("reevings[0].path: no rope runs from 'tail' to 'drive': their axes are 0.1 m apart"),
            std::string::npos)
      << reported;
  EXPECT_NE(reported.find("differ by 0.15 m"), std::string::npos) << reported;
  m.sheaves[2].at = {0.16, 0, 1};
  EXPECT_EQ(complaints_of(m), "") << "tangent outside";
  // crossed, the circles may not touch
  for (const double x : {0.5, 0.6}) {
    m = loop();
    m.sheaves[2].at = {x, 0, 1};
    m.reevings[0].path[0].side = description::Side::left;
    m.reevings[0].path[2].side = description::Side::right;
    const bool fits = x > 0.55;
    EXPECT_EQ(complaints_of(m).empty(), fits) << complaints_of(m);
    if (!fits) {
      EXPECT_NE(complaints_of(m).find("add up to 0.55 m"), std::string::npos) << complaints_of(m);
    }
  }
}

TEST(Room, SidesCountAboutOneAxis) {
  Machine m = loop();
  m.sheaves[2].at = {0.16, 0, 1};
  m.reevings[0].path[0].side = m.reevings[0].path[2].side = description::Side::left;
  EXPECT_EQ(complaints_of(m), "");
  m.sheaves[2].axis = {0, -1, 0};  // looking along it, the same side is the other one
  EXPECT_NE(complaints_of(m).find("add up to 0.55 m"), std::string::npos) << complaints_of(m);
}

TEST(Room, AnEndInsideASheave) {
  EXPECT_EQ(complaints_of(line_over({-9, 0, 0}, {0, 0, 3}, {9, 0, 0})), "");
  const std::string reported = complaints_of(line_over({-0.1, 0, 3}, {0, 0, 3}, {9, 0, 0}));
  EXPECT_NE(reported.find("reevings[0].path: 'a' lies inside 's': 0.1 m from its axis"), std::string::npos) << reported;
  // beside the sheave, but within its circle as the rope sees it
  EXPECT_NE(complaints_of(line_over({-9, 0, 0}, {0, 0, 3}, {0.1, 2, 3})).find("'b' lies inside 's'"),
            std::string::npos);
}

TEST(Room, WhatMovesMayBeginAnywhere) {
  Machine m = line_over({-9, 0, 0}, {0, 0, 3}, {9, 0, 0});
  description::Body hook;
  hook.name = "hook";
  hook.mass = 100;
  hook.at = {0.1, 0, 3};
  hook.free = {"x", "z"};
  m.bodies = {hook};
  m.reevings[0].path[2] = anchor("hook");
  EXPECT_EQ(complaints_of(m), "");
  m.bodies[0].free = {};
  EXPECT_NE(complaints_of(m).find("'hook' lies inside 's'"), std::string::npos) << complaints_of(m);
}

}  // namespace taut::machine::room_test
