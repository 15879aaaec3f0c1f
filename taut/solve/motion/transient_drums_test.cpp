#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "taut/solve/drives.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Several ends of ropes on one drum: each has its own part of it, and all share its torque.
namespace taut_test::transient_drums_test {
namespace {

using taut::solve::Start;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double radius = 0.2, mass = 1000, inertia = 20, g = 9.81;

/// Two masses on ropes from one drum; `against`: the second one is wound the other way. `swapped`: it comes first.
machine::Model two_ropes(const machine::Drive& drive, bool against, bool swapped = false) {
  machine::Model m;
  m.gravity = g;
  const double second = against ? -radius : radius;
  m.bodies = {body("a", {radius, 0, -20}, mass, "z"), body("b", {second, 0, -20}, mass, "z")};
  machine::Node first_end = add_drum(m, "winch", origin, radius, 1), second_end = first_end;
  if (against) second_end.side = -1;
  m.drums[0].drive = drive;
  m.reevings = {reeve("first", {first_end, anchor_on("a", 0)}, 20, 0, 5e6),
                reeve("second", {second_end, anchor_on("b", 1)}, 20, 0, 5e6)};
  for (machine::Reeving& rope : m.reevings) rope.damping_time = 0.02;
  if (swapped) std::swap(m.reevings[0], m.reevings[1]);
  return m;
}

machine::Drive turning(double speed) { return {machine::DriveKind::speed, smooth_move(0, speed, 0, 1)}; }
machine::Drive by_torque(double torque) { return {machine::DriveKind::torque, smooth_move(torque, torque, 0, 1)}; }

TransientOptions from_description(double duration) {
  TransientOptions options = lasting(duration, 1e-6);
  options.start = Start::assembled;
  return options;
}

TEST(TransientDrums, EachRopeHasItsOwnPart) {
  for (const bool swapped : {false, true}) {
    machine::Model m = two_ropes(turning(swapped ? -1 : 1), true, swapped);
    m.drums[0].length_on_drum = 3;
    const TransientResult r = run_to_end(m, from_description(2));
    const TransientFrame &first = r.frames.front(), &last = r.frames.back();
    ASSERT_EQ(last.on_drums.size(), 2U);
    for (const std::size_t k : {0U, 1U}) {
      const double whole = first.branches[k].unstretched + first.on_drums[k].content;
      EXPECT_EQ(first.on_drums[k].content, 3);
      EXPECT_NEAR(last.branches[k].unstretched + last.on_drums[k].content, whole, 1e-9) << k;
    }
    const std::size_t taken = swapped ? 1 : 0;  // 1 m/s, begun within 1 s
    EXPECT_NEAR(last.on_drums[taken].content, 4.5, 5e-3);
    EXPECT_NEAR(last.on_drums[1 - taken].content, 1.5, 5e-3);
    const auto ends = taut::solve::drums(m, last);
    EXPECT_NEAR(ends[1 - taken].length.value(), 1.5, 5e-3);
  }
}

TEST(TransientDrums, TheRopeThatRunsOutEndsTheMotionWhateverTheirOrder) {
  for (const bool swapped : {false, true}) {
    machine::Model m = two_ropes(turning(swapped ? -1 : 1), true, swapped);
    m.drums[0].length_on_drum = 3;
    const TransientResult r = transient(m, from_description(6));
    EXPECT_NE(r.outcome.message.find("'second'"), std::string::npos) << r.outcome.message;
    EXPECT_NEAR(r.t_end, 3.5, 6e-3);
  }
}

/// Three turns make a layer. Two ropes with 1.2 turns each reach the second one together when 0.3 turns more are taken.
TEST(TransientDrums, RopesOfADrumClimbTogether) {
  machine::Model m = two_ropes(turning(1), false);
  machine::Drum& drum = m.drums[0];
  const double d = 0.01, turn = 2 * M_PI * (radius + d / 2);
  for (machine::Reeving& rope : m.reevings) {
    rope.diameter = d;
    rope.nodes.front().radius = radius + d / 2;
  }
  m.bodies[0].position.x() += d / 2;
  m.bodies[1].position.x() += d / 2;
  drum.width = 3 * d;
  drum.automatic_layers = true;
  drum.length_on_drum = 1.2 * turn;
  const TransientResult r = run_to_end(m, from_description(1.6));
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(r.frames.front().on_drums[k].layer, 1);
    EXPECT_EQ(r.frames.back().on_drums[k].layer, 2);
  }
}

/// The moment at which a motion of 6 s stops by a condition, s.
double stops_at(machine::Model m, const machine::Observable& of, double threshold, bool slowly, int outputs) {
  machine::Event stop;
  stop.kind = machine::EventKind::stop;
  stop.when = machine::Condition{.of = of, .above = true, .threshold = threshold};
  m.events = {stop};
  TransientOptions options = lasting(6, 1e-6, outputs);
  options.quasi_static = slowly;
  options.start = Start::settled;
  return run_to_end(m, options).t_end;
}

// From 0 to 1 m/s within 1 s: (t - 0.5 s) 1 m/s/(1 + m g/EA) of unstretched rope are taken in at t. The drum gives the
// weight its height, and its speed.
TEST(TransientDrums, AConditionOfWhatTheyHoldOrGiveIsMetWhateverTheOutputs) {
  machine::Model m = two_ropes(turning(1), false);
  m.bodies.pop_back();
  m.reevings.pop_back();
  m.drums[0].length_on_drum = 3;
  const machine::Observable content{"length", machine::Observed::drum_length, taut::si::m, 0, {}, origin};
  const machine::Observable given{"supplied", machine::Observed::supplied, taut::si::J, 0, {}, origin};
  for (const int outputs : {2, 500}) {
    for (const bool slowly : {false, true}) {
      const double step = slowly ? 6.0 / outputs : 0;  // a slow one is that of the outputs; it is halved to the moment
      EXPECT_NEAR(stops_at(m, content, 5.25, slowly, outputs), 0.5 + 2.25 * (1 + mass * g / 5e6), 3e-4) << step;
      EXPECT_NEAR(stops_at(m, given, mass * g * 2.25 + (slowly ? 0 : mass / 2), slowly, outputs), 2.75, 1e-2) << step;
    }
  }
}

// On a body that turns about the axis of the drum by two turns, to either side: rope is wound on or off as by the drum.
TEST(TransientDrums, HoldWhatTheTurningOfTheirBodyLeaves) {
  const double turns = 2, whole = 2 * M_PI * radius * turns;
  for (const double sense : {-1.0, 1.0}) {
    machine::Model m = two_ropes(turning(0), false);
    m.bodies.pop_back();
    m.reevings.pop_back();
    m.drums[0].length_on_drum = 5;
    m.bodies.push_back(body("turret", origin, 100, ""));
    m.bodies[1].driven.push_back({.about = {0, 1, 0}, .signal = smooth_move(0, sense * 2 * M_PI * turns, 0, 4)});
    m.reevings[0].nodes[0].at.body = 1;
    const TransientResult r = run_to_end(m, from_description(4));
    const TransientFrame &first = r.frames.front(), &last = r.frames.back();
    const double laid = last.on_drums[0].content - first.on_drums[0].content;
    EXPECT_NEAR(std::abs(laid), whole, 2e-3 * whole);
    EXPECT_NEAR(first.branches[0].unstretched - last.branches[0].unstretched, laid, 1e-9);
  }
}

// What swings onto a drum that stands comes off as it was laid on, whatever the tension in which the drum's rope lies
// and the end from which the path is written. With the drum's strain on one way only the load rose by 6 mm a minute.
TEST(TransientDrums, WhatSwingsOntoThemComesOffAgain) {
  std::vector<double> lowest;
  for (const bool from_load : {false, true}) {
    for (const double wound_at : {1e3, 40e3}) {
      machine::Model m;
      m.gravity = g;
      m.bodies = {body("load", {8, 0, -18}, mass, "xz")};
      machine::Node drum = add_drum(m, "winch", origin, 0.3, 1);
      m.drums[0].wound_at = wound_at;
      m.drums[0].drive = turning(0);
      std::vector<machine::Node> path{drum, anchor_on("load", 0)};
      if (from_load) std::reverse(path.begin(), path.end());
      if (from_load) path.back().side = -1;
      m.reevings = {reeve("hoist", path, 19.68, 0, 8e6)};
      m.reevings[0].damping_time = 0.002;
      TransientOptions options = from_description(50);
      options.tolerance = 1e-5;
      options.output_step = 0.01;
      const TransientResult r = run_to_end(m, options);
      const auto lowest_within = [&](double from, double to) {
        double z = 0;
        for (const TransientFrame& frame : r.frames)
          if (frame.t >= from && frame.t < to) z = std::min(z, frame.bodies[0].position.z());
        return z;
      };
      lowest.push_back(lowest_within(0, 10));
      EXPECT_NEAR(lowest_within(40, 50), lowest.back(), 1e-3);
    }
  }
  for (const double one : lowest) EXPECT_NEAR(one, lowest.front(), 1e-5);
}

// Its height is none of the energy of what stretches, which was less than none.
TEST(TransientDrums, TheWeightThatTheyTakeInIsLifted) {
  machine::Model m = two_ropes(turning(1), false);
  m.bodies.pop_back();
  m.reevings.pop_back();
  const double weight = 60;
  m.reevings[0].weight = weight;
  m.reevings[0].mass = weight / g;
  TransientOptions options = lasting(12, 1e-5);
  options.start = Start::settled;
  const TransientResult r = run_to_end(m, options);
  const TransientFrame &first = r.frames.front(), &last = r.frames.back();
  for (const TransientFrame& frame : r.frames) EXPECT_GT(frame.energy.elastic, 0);
  const double from = first.branches[0].stretched, to = last.branches[0].stretched;
  EXPECT_NEAR(to, from - 11.5, 0.05);
  const double lifted = (mass * g * (from - to)) + weight * (from * from - to * to) / 2;
  EXPECT_NEAR(last.energy.potential - first.energy.potential, lifted, 2e-3 * lifted);
}

TEST(TransientDrums, BothEndsOfARopeHaveTheirPart) {
  machine::Model m;
  m.gravity = g;
  m.bodies = {body("a", {0, 0, -20}, mass, "z")};
  machine::Node left = add_drum(m, "winch", origin, radius, 1), right = left;
  right.side = 1;
  machine::Node pulley = sheave("pulley", origin, radius, -1);
  pulley.at.body = 0;
  m.drums[0].drive = turning(0.5);
  m.drums[0].length_on_drum = 2;
  m.reevings = {reeve("rope", {left, pulley, right}, 40 + M_PI * radius, 0, 5e6)};
  m.reevings[0].damping_time = 0.02;
  const TransientResult r = run_to_end(m, from_description(2));
  const auto& ends = r.frames.back().on_drums;
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_FALSE(ends[0].at_end);
  EXPECT_TRUE(ends[1].at_end);
  // what one end takes in, the other lets out, or takes in too, as it is wound
  EXPECT_NEAR(std::abs(ends[0].content - 2), 0.75, 0.02);
  EXPECT_NEAR(std::abs(ends[1].content - 2), 0.75, 0.02);
}

TEST(TransientDrums, GoOnFromASavedStateWithAllTheirEnds) {
  machine::Model m = two_ropes(turning(1), true);
  m.drums[0].length_on_drum = 3;
  TransientOptions options = from_description(1.5);
  const TransientResult first = run_to_end(m, options);
  options.from = first.state;
  options.duration = 0.5;
  const TransientResult second = run_to_end(m, options);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(second.frames.front().on_drums[k].content, first.frames.back().on_drums[k].content);
  }
}

/// M = 2 T R + J a/R, T = m (g + a), of two equal masses.
TEST(TransientDrums, ShareTheTorque) {
  const double M = 2.2 * mass * g * radius;
  machine::Model m = two_ropes(by_torque(M), false);
  m.drums[0].inertia = inertia;
  const TransientResult r = run_to_end(m, from_description(1));
  const double a = (M / radius - 2 * mass * g) / (2 * mass + inertia / (radius * radius));
  EXPECT_NEAR(r.frames.back().bodies[0].acceleration.z(), a, 2e-3 * a);
  EXPECT_NEAR(r.frames.back().bodies[1].acceleration.z(), a, 2e-3 * a);
}

TEST(TransientDrums, WithoutInertiaNoneKnowsItsShare) {
  const auto refused = [](const machine::Model& m) {
    const TransientResult r = transient(m, from_description(0.1));
    return r.outcome.message.find("'inertia'") != std::string::npos && r.frames.empty();
  };
  EXPECT_TRUE(refused(two_ropes(by_torque(3000), false)));
  EXPECT_TRUE(refused(two_ropes({machine::DriveKind::free, {}}, false)));
  EXPECT_FALSE(refused(two_ropes(turning(1), false)));
  machine::Model one = two_ropes(by_torque(3000), false);
  one.reevings.pop_back();
  one.bodies.pop_back();
  EXPECT_FALSE(refused(one));
  // by an event to come
  machine::Model later = two_ropes(turning(0.1), false);
  machine::Event event;
  event.kind = machine::EventKind::drive;
  event.at = 0.05;
  event.drive = by_torque(3000);
  later.events = {event};
  EXPECT_TRUE(refused(later));
  machine::Model opened = two_ropes({machine::DriveKind::held, {}}, false);
  event.kind = machine::EventKind::brake;
  event.brake_set = false;
  opened.events = {event};
  EXPECT_TRUE(refused(opened));
}

}  // namespace
}  // namespace taut_test::transient_drums_test
