#include "taut/results/motion/transient_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "taut/machine/compile.hpp"

namespace taut::results::transient_state_test {

machine::Model winch() {
  using machine::description::PathElement;
  machine::Machine m;
  machine::description::Rope rope;
  rope.name = "hoist";
  rope.mass = 1;
  rope.stiffness = 1e7;
  m.ropes = {rope};
  machine::description::Drum drum;
  drum.name = "winch";
  drum.at = {0, 0, 20};
  drum.core_diameter = 0.4;
  m.drums = {drum};
  machine::description::Body load;
  load.name = "load";
  load.mass = 1000;
  load.free = {"z"};
  m.bodies = {load};
  machine::description::Reeving r;
  r.rope = "hoist";
  r.path.resize(2);
  r.path[0].drum = "winch";
  r.path[1].anchor = "load";
  r.length = 19.9;
  m.reevings = {r};
  m.events.resize(1);
  m.events[0].at = 1;
  m.events[0].stop = true;
  machine::Model model = machine::compile(m).value();
  model.drums[0].drive.kind = machine::DriveKind::speed;
  model.drums[0].drive.signal = {
      .name = "v",
      .unit = si::m_per_s,
      .law = machine::Moves{.from = 0.25,
                            .moves = {{.at = 1, .to = 0.7, .over = 0.5, .change = machine::Change::half_cosine}}}};
  return model;
}

solve::DynamicState state() {
  solve::DynamicState s;
  s.t = 1.0 / 3;
  s.bodies.resize(1);
  s.bodies[0].position = {0.1, -2e-17, 1e300};
  s.bodies[0].orientation << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9;
  s.bodies[0].velocity = {M_PI, 0, -1};
  s.bodies[0].spin = {0, std::numbers::sqrt2, 0};
  s.ropes.resize(1);
  s.ropes[0].length = {0.1 + 0.2};
  s.ropes[0].whole = {1};
  s.ropes[0].angle = s.ropes[0].spin = s.ropes[0].passed = s.ropes[0].wrap = {1.1, std::nextafter(2.0, 3.0)};
  s.ropes[0].inside = s.ropes[0].inside_velocity = {{1, 2, 3}};
  s.tears = {{.reeving = 0, .part = 0, .from = 0.2, .over = 0.5}};
  s.on_drums = {{.content = 12.5, .layer = 2, .strain = {0.001, -0.0}}};
  s.force = {INFINITY, 5e-324};
  s.happened = {1};
  s.drum_drive = {winch().drums[0].drive};
  s.drum_drive[0].brake = true;
  s.drum_drive[0].brake_since = 0.3;
  s.damping_time = {0.003};
  return s;
}

machine::Event event(const std::string& words, machine::EventKind kind, double at) {
  machine::Event one;
  one.words = words;
  one.kind = kind;
  one.at = at;
  return one;
}

TEST(TransientState, ComesBackBitByBit) {
  const machine::Model m = winch();
  const std::string text = to_json(state(), m);
  const auto back = state_from_json(text, m);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(to_json(*back, m), text);
  const solve::DynamicState s = state();
  EXPECT_EQ(back->t, s.t);
  EXPECT_EQ(back->bodies[0].position, s.bodies[0].position);
  EXPECT_EQ(back->bodies[0].orientation, s.bodies[0].orientation);
  EXPECT_EQ(back->ropes[0].length, s.ropes[0].length);
  EXPECT_EQ(back->ropes[0].wrap, s.ropes[0].wrap);
  EXPECT_EQ(back->force, s.force);
  EXPECT_EQ(back->on_drums[0].layer, 2);
  ASSERT_EQ(back->tears.size(), 1U);
  EXPECT_EQ(back->tears[0].from, 0.2);
  EXPECT_EQ(back->tears[0].over, 0.5);
  for (const double t : {0.0, 1.1, 1.3, 2.0}) {
    EXPECT_EQ(machine::at(back->drum_drive[0].signal, t).value, machine::at(s.drum_drive[0].signal, t).value);
  }
  EXPECT_TRUE(back->drum_drive[0].brake) << "an event has set it";
  EXPECT_EQ(back->drum_drive[0].brake_since, 0.3);
  EXPECT_EQ(back->happened, s.happened);
  EXPECT_FALSE(back->begins_anew);
}

// Kind and signal of a drive are those of the machine that goes on, or of the event that gave them.
TEST(TransientState, DrivesAreThoseOfTheMachineThatGoesOn) {
  using testing::HasSubstr;
  machine::Model m = winch();
  solve::DynamicState s = state();
  s.drum_drive[0].brake = false;
  const auto goes_on = [&](const machine::Model& in) { return state_from_json(to_json(s, m), in); };
  machine::Model other = m;
  other.drums[0].drive.signal.law = 0.8;
  auto back = goes_on(other);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(machine::at(back->drum_drive[0].signal, 0).value, 0.8);
  EXPECT_TRUE(back->begins_anew);
  other = m;
  other.drums[0].drive.brake = true;
  back = goes_on(other);
  ASSERT_TRUE(back) << back.error();
  EXPECT_TRUE(back->drum_drive[0].brake && back->begins_anew) << "described anew";

  machine::Event pulls = event("drive of winch", machine::EventKind::drive, 0.2);
  pulls.drive.kind = machine::DriveKind::torque;
  pulls.drive.signal.law = 100.0;
  m.events.insert(m.events.begin(), pulls);
  s.happened = {1, 1};
  s.drum_drive[0] = pulls.drive;
  s.drum_drive[0].by = 0;
  other = m;
  std::swap(other.events[0], other.events[1]);
  other.events[1].drive.signal.law = 120.0;
  back = goes_on(other);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->drum_drive[0].kind, machine::DriveKind::torque);
  EXPECT_EQ(machine::at(back->drum_drive[0].signal, 0).value, 120);
  EXPECT_EQ(back->drum_drive[0].by, 1);
  other.events.pop_back();
  EXPECT_THAT(goes_on(other).error(), HasSubstr("'drive of winch at 0.2 s' has given 'winch' the drive"));
}

// A drum that stood by no drive until its brake was opened turns freely from then on, whatever opened it.
TEST(TransientState, ADrumThatWasLetGoStaysFree) {
  machine::Model m = winch();
  m.drums[0].drive = {.kind = machine::DriveKind::held, .signal = {}};
  solve::DynamicState s = state();
  s.drum_drive[0] = {.kind = machine::DriveKind::free, .signal = {}};
  const auto back = state_from_json(to_json(s, m), m);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->drum_drive[0].kind, machine::DriveKind::free);
  EXPECT_FALSE(back->begins_anew);
}

TEST(TransientState, EventsAreKnownByTheirWords) {
  using testing::HasSubstr;
  machine::Model m = winch();
  for (const double at : {0.1, 2.0}) m.events.push_back(event("break hoist", machine::EventKind::breaks, at));
  solve::DynamicState s = state();
  s.happened = {0, 1, 0};
  const std::string text = to_json(s, m);
  machine::Model other = m;
  std::swap(other.events[0], other.events[1]);
  EXPECT_EQ(state_from_json(text, other)->happened, (std::vector<std::uint8_t>{1, 0, 0}));
  other.events.erase(other.events.begin());
  EXPECT_EQ(state_from_json(text, other)->happened, (std::vector<std::uint8_t>{0, 0})) << "it has broken all the same";
  other.events[0].at = 0.3;
  EXPECT_THAT(state_from_json(text, other).error(), HasSubstr("at 0.3 s has not happened in it, and it is of 0.33333"));
}

TEST(TransientState, WhatDoesNotFitIsRefused) {
  using testing::HasSubstr;
  const machine::Model m = winch();
  const std::string text = to_json(state(), m);
  EXPECT_THAT(state_from_json("", m).error(), HasSubstr("no saved state"));
  EXPECT_THAT(state_from_json("{\"a\": 1}", m).error(), HasSubstr("no saved state"));
  EXPECT_THAT(state_from_json(text.substr(0, text.size() / 2), m).error(), HasSubstr("no saved state"));
  EXPECT_THAT(state_from_json("{\"taut_state\": 4}", m).error(), HasSubstr("damaged"));
  EXPECT_THAT(state_from_json("{\"taut_state\": 99}", m).error(), HasSubstr("another version"));
  const std::string time = "\"t\": 0.3333333333333333";
  ASSERT_NE(text.find(time), std::string::npos);
  for (const char* bad : {"-5", "1e300", "\"inf\"", "\"nan\"", "\"soon\""}) {
    std::string spoilt = text;
    spoilt.replace(spoilt.find(time), time.size(), std::string("\"t\": ") + bad);
    EXPECT_THAT(state_from_json(spoilt, m).error(), HasSubstr("out of range")) << bad;
  }
  for (const double from : {0.4, std::nan("")}) {
    solve::DynamicState later = state();
    later.tears[0].from = from;
    EXPECT_THAT(state_from_json(to_json(later, m), m).error(), HasSubstr("out of range"));
  }
  machine::Model other = m;
  other.bodies[0].name = "bucket";
  EXPECT_THAT(state_from_json(text, other).error(), HasSubstr("its bodies are others"));
  other = m;
  other.drums[0].name = "capstan";
  EXPECT_THAT(state_from_json(text, other).error(), HasSubstr("its drums are others"));
  other = m;
  other.reevings[0].segments = 3;
  EXPECT_THAT(state_from_json(text, other).error(), HasSubstr("other segments"));
}

// The state has its own copy of places and lengths: with others a motion would be one of two machines in part.
TEST(TransientState, GoesOnInTheSameMachineOnly) {
  using testing::HasSubstr;
  const machine::Model m = winch();
  const std::string text = to_json(state(), m);
  const auto with = [&](auto change) {
    machine::Model other = m;
    change(other.reevings[0], other.bodies[0]);
    const auto found = state_from_json(text, other);
    return found ? std::string("fits") : found.error();
  };
  using machine::Body, machine::Reeving;
  EXPECT_THAT(with([](Reeving& r, Body&) { r.nodes[0].radius *= 1.01; }), HasSubstr("'winch' has another diameter"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.nodes[0].at.at.x() += 1; }), HasSubstr("'winch' has another place"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.nodes[0].side = -r.nodes[0].side; }), HasSubstr("another side"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.stiffness *= 2; }), HasSubstr("rope 'hoist' has another stiffness"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.copies = 2; }), HasSubstr("another number of copies"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.value += 1; }), HasSubstr("rope 'hoist' has another length"));
  EXPECT_THAT(with([](Reeving& r, Body&) { r.given = machine::Given::tension_at_end; }), HasSubstr("another kind"));
  // masses, losses and drives may change in the course of a motion
  EXPECT_EQ(with([](Reeving&, Body& b) { b.mass *= 2; }), "fits");
  EXPECT_EQ(with([](Reeving& r, Body&) { r.nodes[0].law.efficiency = 0.9; }), "fits");
}

// A rope is damped as the deck says now: the time of a ratio is 2 zeta/omega.
TEST(TransientState, GoesOnWithAnotherDamping) {
  const auto with = [](double ratio_then, double time_then, double ratio, double time, double otherwise = 0) {
    machine::Model m = winch();
    m.reevings[0].damping_ratio = ratio_then;
    m.reevings[0].damping_time = time_then;
    const std::string text = to_json(state(), m);
    m.reevings[0].damping_ratio = ratio;
    m.reevings[0].damping_time = time;
    const auto found = state_from_json(text, m, otherwise);
    return found ? found->damping_time[0] : std::nan("");
  };
  EXPECT_EQ(with(0.1, 0, 0.1, 0), 0.003) << "to the last bit";
  EXPECT_DOUBLE_EQ(with(0.1, 0, 0.3, 0), 0.009);
  EXPECT_EQ(with(0.1, 0, 0, 0), 0);
  EXPECT_EQ(with(0.1, 0, 0.1, 0.05), 0.05) << "a time comes before a ratio";
  EXPECT_EQ(with(0, 0.003, 0, 0.02), 0.02);
  EXPECT_DOUBLE_EQ(with(0.1, 0, 0, 0, 0.2), 0.006) << "that of the analysis";
  EXPECT_TRUE(std::isnan(with(0, 0, 0.1, 0))) << "no frequency is known";
  EXPECT_TRUE(std::isnan(with(0, 0.003, 0.1, 0)));
}

}  // namespace taut::results::transient_state_test
