#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/machine/compile.hpp"
#include "taut/machine/state.hpp"
#include "test/support/complaints.hpp"

namespace taut::machine::compile_motion_test {

using taut_test::complaints_of;
using testing::HasSubstr;

description::PathElement element(std::optional<std::string> description::PathElement::*key, const std::string& name) {
  description::PathElement e;
  e.*key = name;
  return e;
}

description::Signal ramp(const std::string& name, const std::string& to) {
  description::Signal s;
  s.name = name;
  s.ramp = description::Ramp{.from = {}, .to = to, .start = 0, .duration = 0.5, .smooth = false};
  return s;
}

/// A hook on a rope that runs from a drum over a sheave on a boom that is luffed.
Machine crane() {
  using description::PathElement;
  Machine m;
  m.signals = {ramp("hoist_speed", "0.5 m/s"), ramp("luffing", "-30 deg")};
  description::Rope rope;
  rope.name = "hoist";
  rope.mass = 1;
  rope.stiffness = 1e7;
  rope.damping_ratio = 0.02;
  m.ropes = {rope};
  description::Body boom, hook;
  boom.name = "boom";
  boom.at = {0, 0, 1};
  boom.inertia = {7000};
  boom.motion = description::BodyMotion{};
  boom.motion->ry = "luffing";
  hook.name = "hook";
  hook.mass = 300;
  hook.at = {10, 0, -4};
  hook.free = {"x", "z"};
  m.bodies = {boom, hook};
  description::Round head;
  head.name = "head";
  head.body = "boom";
  head.at = {10, 0, 0};
  head.diameter = 0.4;
  head.inertia = 0.3;
  m.sheaves = {head};
  description::Drum winch;
  winch.name = "winch";
  winch.at = {-2, 0, 0};
  winch.core_diameter = 0.4;
  winch.inertia = 12;
  winch.drive = description::Drive{};
  winch.drive->speed = "hoist_speed";
  m.drums = {winch};
  description::Reeving r;
  r.rope = "hoist";
  r.path = {element(&PathElement::drum, "winch"), element(&PathElement::over, "head"),
            element(&PathElement::anchor, "hook")};
  r.length = 17;
  m.reevings = {r};
  return m;
}

TEST(CompileMotion, DrivesAndInertias) {
  const auto model = compile(crane());
  ASSERT_TRUE(model) << complaints_of(crane());
  ASSERT_EQ(model->drums.size(), 1U);
  EXPECT_EQ(model->drums[0].drive.kind, DriveKind::speed);
  EXPECT_EQ(at(model->drums[0].drive.signal, 0.25).value, 0.25);
  EXPECT_EQ(model->drums[0].inertia, 12);
  const Reeving& rope = model->reevings[0];
  EXPECT_EQ(rope.nodes[0].drum, 0);
  EXPECT_EQ(rope.nodes[1].inertia, 0.3);
  EXPECT_FALSE(rope.nodes[1].drum);
  EXPECT_EQ(rope.damping_ratio, 0.02);
  EXPECT_EQ(model->bodies[0].inertia, Vector3::Constant(7000));
}

TEST(CompileMotion, ADrivenBodyStandsWhereItsSignalHasItAtTheStart) {
  Machine m = crane();
  m.bodies[0].motion->ry = "-90 deg";  // right-handed about y: x comes to z
  m.bodies[0].motion->z = "2 m";
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  const State state = initial_state(*model);
  EXPECT_LT((in_ground(state, model->reevings[0].nodes[1].at) - Vector3(0, 0, 13)).norm(), 1e-12);
  EXPECT_EQ(model->bodies[0].driven.size(), 2U);
}

TEST(CompileMotion, WhatDrivesADrum) {
  Machine m = crane();
  const auto kind = [&](const description::Drive& drive) {
    m.drums[0].drive = drive;
    if (drive.pull) m.reevings[0].length.reset();
    return compile(m)->drums[0].drive.kind;
  };
  using description::Brake;
  EXPECT_EQ(kind({{}, {}, {}, Brake::unsaid}), DriveKind::held);
  EXPECT_EQ(kind({{}, {}, {}, Brake::open}), DriveKind::free);
  EXPECT_EQ(kind({{}, "2 kN m", {}, Brake::unsaid}), DriveKind::torque);
  EXPECT_EQ(kind({{}, {}, "5 kN", Brake::unsaid}), DriveKind::pull);
  EXPECT_EQ(compile(m)->reevings[0].given, Given::tension_at_start);
  EXPECT_EQ(compile(m)->reevings[0].value, 5e3);
}

TEST(CompileMotion, MistakesOfSignals) {
  Machine m = crane();
  m.signals[0].ramp->to = "0.5 kN";
  EXPECT_THAT(complaints_of(m), HasSubstr("drums.winch.drive.speed: signal 'hoist_speed' is a force"));
  m.signals[0].ramp->to = "fast";
  EXPECT_THAT(complaints_of(m), HasSubstr("signals.hoist_speed.ramp.to: "));
  m = crane();
  m.drums[0].drive->speed = "hoist_sped";
  EXPECT_THAT(complaints_of(m), HasSubstr("did you mean 'hoist_speed'"));
  m.drums[0].drive->speed = "3";
  EXPECT_THAT(complaints_of(m), HasSubstr("a speed needs its unit"));
  m.signals.clear();
  m.bodies[0].motion.reset();
  m.drums[0].drive->speed = "later";
  ASSERT_TRUE(compile(m)) << complaints_of(m);
  EXPECT_TRUE(std::isnan(at(compile(m)->drums[0].drive.signal, 0).value)) << "statics does not need it";
  m = crane();
  m.signals[0].ramp->from = "3 N";
  EXPECT_THAT(complaints_of(m), HasSubstr("signals.hoist_speed.ramp.from"));
  m = crane();
  m.signals[0].ramp.reset();
  m.signals[0].sequence = {{.at = 0, .to = "1 m/s", .over = 2, .smooth = false},
                           {.at = 1, .to = "0 m/s", .over = 1, .smooth = false}};
  EXPECT_THAT(complaints_of(m), HasSubstr("signals.hoist_speed.sequence[1]: begins at 1 s"));
  m.signals[0].sequence.clear();
  m.signals[0].table =
      description::SignalTable{.t = {0, 1, 1}, .value = {"0 m/s", "1 m/s", "2 m/s"}, .interpolation = {}};
  EXPECT_THAT(complaints_of(m), HasSubstr("signals.hoist_speed.table.t[2]: times have to grow"));
  m.signals[0].table->t.pop_back();
  EXPECT_THAT(complaints_of(m), HasSubstr("3 values for 2 times"));
}

TEST(CompileMotion, MistakesOfBodiesAndDrives) {
  Machine m = crane();
  m.bodies[0].free = {"ry"};
  EXPECT_THAT(complaints_of(m), HasSubstr("bodies.boom.motion.ry: is 'free' too"));
  m = crane();
  m.bodies[0].motion->rx = "3 deg";
  EXPECT_THAT(complaints_of(m), HasSubstr("one driven rotation alone"));
  m = crane();
  m.bodies[0].inertia = {1, 1, 5};
  EXPECT_THAT(complaints_of(m), HasSubstr("larger than the sum of the other two"));
  m.bodies[0].inertia = {1, 1};
  EXPECT_THAT(complaints_of(m), HasSubstr("Ixx, Iyy, Izz"));
  m = crane();
  m.drums[0].drive->pull = "3 kN";
  EXPECT_THAT(complaints_of(m), HasSubstr("one of speed, torque and pull"));
}

TEST(CompileMotion, Observables) {
  Machine m = crane();
  m.points = {{.name = "eye", .body = {"hook"}, .at = {0, 0, 0.3}}};
  m.observe = {"hook.z",         "hoist.T_max", "hoist[2].T", "head.speed", "winch.torque",
               "energy.kinetic", "hoist_speed", "eye.vz",     "boom.ry"};
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  const auto& o = model->observed;
  ASSERT_EQ(o.size(), m.observe.size());
  EXPECT_EQ(o[0].quantity, Observed::z);
  EXPECT_EQ(o[0].index, 1);
  EXPECT_EQ(o[2].quantity, Observed::branch_T);
  EXPECT_EQ(o[2].part, 1);
  EXPECT_EQ(o[3].part, 1) << "the sheave's node";
  EXPECT_EQ(o[4].unit.symbol, "N m");
  EXPECT_EQ(o[6].quantity, Observed::signal);
  EXPECT_EQ(o[6].unit.symbol, "m/s");
  EXPECT_EQ(o[7].index, 1);
  EXPECT_EQ(o[7].at, Vector3(0, 0, 0.3));
  m.observe = {"hok.z"};
  EXPECT_THAT(complaints_of(m), HasSubstr("observe[0]: 'hok' names no body"));
  EXPECT_THAT(complaints_of(m), HasSubstr("did you mean 'hook'"));
  m.observe = {"hook.height"};
  EXPECT_THAT(complaints_of(m), HasSubstr("'hook' has x, y, z"));
  m.observe = {"head.power"};
  EXPECT_THAT(complaints_of(m), HasSubstr("'head' has no motor, so no power"));
  m.observe = {"hoist[3].T"};
  EXPECT_THAT(complaints_of(m), HasSubstr("the branches 1 to 2"));
}

TEST(CompileMotion, UsualObservables) {
  std::vector<std::string> names;
  const auto model = compile(crane());
  for (const Observable& o : model->observed) names.push_back(o.name);
  EXPECT_THAT(names, testing::ElementsAre("hoist.T_start", "hoist.T_end", "hoist.T_max", "boom.ry", "hook.x", "hook.z",
                                          "winch.speed"));
}

TEST(CompileMotion, AtRestOnlyWhatTheDeckNamesIsObserved) {
  Machine m = crane();
  EXPECT_TRUE(compile(m, ModelFor::rest)->observed.empty());
  m.observe = {"hook.z"};
  EXPECT_EQ(compile(m, ModelFor::rest)->observed.size(), 1U);
}

TEST(CompileMotion, Events) {
  Machine m = crane();
  m.events.resize(5);
  m.events[0].at = 2;
  m.events[0].breaks = "hoist[1]";
  m.events[0].over = 0.1;
  m.events[1].when = "hook.z > 3 m";
  m.events[1].stop = true;
  m.events[2].at = 1;
  m.events[2].brake = "winch";
  m.events[3].when = "hoist.T_max<200 N";
  m.events[3].drive = "winch";
  m.events[3].torque = "-3 kN m";
  m.events[4].at = 0;
  m.events[4].breaks = "hoist";
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  const auto& e = model->events;
  EXPECT_EQ(e[0].kind, EventKind::breaks);
  EXPECT_EQ(e[0].part, 0);
  EXPECT_EQ(e[1].kind, EventKind::stop);
  EXPECT_TRUE(e[1].when->above);
  EXPECT_EQ(e[1].when->threshold, 3);
  EXPECT_TRUE(e[2].brake_set);
  EXPECT_FALSE(e[3].when->above);
  EXPECT_EQ(at(e[3].drive.signal, 0).value, -3e3);
  EXPECT_FALSE(e[4].part);
}

TEST(CompileMotion, MistakesOfEvents) {
  Machine m = crane();
  m.events.resize(1);
  const auto reported = [&](auto&& change) {
    m.events[0] = {};
    m.events[0].at = 1;
    change(m.events[0]);
    return complaints_of(m);
  };
  EXPECT_THAT(reported([](auto& e) { e.breaks = "hoisd"; }), HasSubstr("events[0].break: there is no reeving 'hoisd'"));
  EXPECT_THAT(reported([](auto& e) { e.breaks = "hoist", e.brake = "winch"; }),
              HasSubstr("events[0]: give one of break, brake, not several"));
  EXPECT_THAT(reported([](auto& e) { e.breaks = "hoist[4]"; }), HasSubstr("branches 1 to 2"));
  EXPECT_THAT(reported([](auto&) {}), HasSubstr("events[0].stop"));
  EXPECT_THAT(reported([](auto& e) { e.actuator = "ram"; }), HasSubstr("there is no actuator 'ram'"));
  EXPECT_THAT(reported([](auto& e) { e.brake = "winch", e.mode = "on"; }), HasSubstr("of a brake is set or open"));
  EXPECT_THAT(reported([](auto& e) { e.drive = "winch"; }), HasSubstr("says no speed, torque or pull"));
  EXPECT_THAT(reported([](auto& e) { e.stop = true, e.over = 1; }), HasSubstr("belongs to a 'break'"));
  EXPECT_THAT(reported([](auto& e) { e.stop = true, e.at.reset(), e.when = "hook.z = 3 m"; }),
              HasSubstr("is no condition"));
  EXPECT_THAT(reported([](auto& e) { e.stop = true, e.at.reset(), e.when = "hook.z > 3"; }),
              HasSubstr("a length needs its unit"));
}

TEST(CompileMotion, ContactsActuatorsAndTensioners) {
  Machine m = crane();
  m.markers = {{.name = "hook.foot", .body = {"hook"}, .at = {0, 0, -0.2}},
               {.name = "boom.foot", .body = {"boom"}, .at = {0, 0, 0}}};
  m.faces = {{.name = "floor", .body = {}, .from = {0, 0, -6}, .to = {20, 0, -6}, .normal = {0, 0, 2}}};
  description::FaceContact c;
  c.point = "hook.foot";
  c.face = "floor";
  c.stiffness = 1e8;
  c.static_friction = 0.155;
  c.kinetic_friction = 0.15;
  m.contacts = {c};
  description::Actuator ram;
  ram.name = "ram";
  ram.from = "boom.foot";
  ram.to = "hook.foot";
  ram.law = description::ActuatorLaw{.F0 = 1e5, .gain = 2e6, .reference = "hoist_speed"};
  m.actuators = {ram};
  m.signals.push_back(ramp("pull_in", "-3 mm"));
  m.tensioners = {{.reeving = "1", .end = description::RopeEnd::end, .change = "pull_in"}};
  m.observe = {"hook.foot.N", "ram.F"};
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_EQ(model->contacts[0].body, 1);
  EXPECT_EQ(model->faces[0].normal, Vector3::UnitZ());
  EXPECT_EQ(model->actuators[0].kind, ActuatorKind::law);
  EXPECT_EQ(model->tensioners[0].reeving, 0);
  EXPECT_FALSE(model->tensioners[0].at_start);
  EXPECT_NEAR(at(model->tensioners[0].change, 1).value, -3e-3, 1e-18);
  EXPECT_EQ(model->observed[0].quantity, Observed::contact_N);
  m.faces[0].normal = {1, 0, 1};
  EXPECT_THAT(complaints_of(m),
              HasSubstr("faces.floor.normal: is not square to the line from 'from' to 'to'; [0, 0, 1] is"));
  // a slope of 20 deg with three digits
  const Machine level = m;
  m.faces[0].to = {20, 0, -6 + 20 * std::tan(M_PI / 9)};
  m.faces[0].normal = {-0.342, 0, 0.940};
  const auto sloping = compile(m);
  ASSERT_TRUE(sloping) << complaints_of(m);
  EXPECT_NEAR(sloping->faces[0].normal.dot(Vector3(1, 0, std::tan(M_PI / 9))), 0, 1e-15);
  EXPECT_NEAR(sloping->faces[0].normal.norm(), 1, 1e-15);
  m = level;
  m.faces[0].normal = {0, 0, 1};
  m.contacts[0].kinetic_friction = 0.2;
  EXPECT_THAT(complaints_of(m), HasSubstr("must not be larger than the static"));
  m.contacts[0].kinetic_friction = 0.1;
  m.tensioners[0].change = "1 mm";
  EXPECT_THAT(complaints_of(m), HasSubstr("tensioners[0].change: begins at 0 m"));
  m.tensioners[0].change = "pull_in";
  m.tensioners[0].reeving = "2";
  EXPECT_THAT(complaints_of(m), HasSubstr("the reevings have the numbers 1 to 1"));
}

}  // namespace taut::machine::compile_motion_test
