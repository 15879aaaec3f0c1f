#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Ropes that slip where a run goes on from a saved state, and where one begins anew.
namespace taut_test::transient_restart_test {
namespace {

using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// Two masses on a rope with dampers over a driven sheave that is faster than its grip can take along; a force against
/// the motion along the rising branch, part of it by the metre.
machine::Model slipping(double weight) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("a", {0.2, 0, -6}, 100, "z"), body("b", {-0.2, 0, -5}, 104, "z")};
  const auto brake = [&](const char* name, double share) {
    machine::Body place = body(name, {0.2, 0, -6 + 6 * share}, 0, "xyz");
    place.of_rope = true;
    machine::Node node = anchor_on(name, static_cast<int>(m.bodies.size()));
    node.kind = machine::NodeKind::load;
    node.load.share = share;
    node.load.by_motion = true;
    node.load.sense = -1;
    m.bodies.push_back(place);
    return node;
  };
  machine::Node point = brake("point", 0.3), spread = brake("spread", 0.6);
  point.load.force = 30;
  spread.load.rate = 15;
  spread.load.part = 0.4;
  machine::Node wheel = sheave("wheel", {0, 0, 0}, 0.2, 1);
  wheel.kind = machine::NodeKind::drive;
  wheel.motor = 0;
  wheel.inertia = 0.5;
  wheel.law.friction = 0.05;
  m.motors.resize(1);
  m.motors[0].drive = {machine::DriveKind::speed, smooth_move(0, 3, 0, 0.2)};
  m.reevings.push_back(reeve("rope", {anchor_on("a", 0), point, spread, wheel, anchor_on("b", 1)},
                             (11 + 0.2 * M_PI) / (1 + 1000 / 2e5), weight, 2e5));
  m.reevings[0].damping_time = 1e-3;
  return m;
}

TransientOptions by_steps(double duration, double step, TimeMethod method) {
  TransientOptions options;
  options.duration = duration;
  options.output_step = 0.05;
  options.step = step;
  options.method = method;
  options.start = Start::assembled;
  return options;
}

TEST(TransientRestart, ARopeThatSlipsGoesOnToTheLastBit) {
  const machine::Model m = slipping(4);
  for (const auto method : {TimeMethod::implicit, TimeMethod::verlet}) {
    const auto until = [&](double duration) { return by_steps(duration, 1e-4, method); };
    const TransientResult whole = run_to_end(m, until(0.8));
    // 0.3 s is no sum of sixths of it but for its rounding, 0.2 s a moment at which the drive's signal has its end
    for (const int outputs : {4, 6, 10}) {
      TransientOptions options = until(0.05 * outputs);
      const TransientResult first = run_to_end(m, options);
      EXPECT_GT(std::abs(first.frames.back().contacts[2].slip), 0.5) << "it has to slip";
      options = until(0.8 - 0.05 * outputs);
      options.from = first.state;
      const TransientResult second = run_to_end(m, options);
      const auto n = static_cast<std::size_t>(outputs);
      ASSERT_EQ(second.frames.size() + n, whole.frames.size());
      for (std::size_t f = 1; f < second.frames.size(); ++f) {
        const auto &a = whole.frames[f + n], &b = second.frames[f];
        EXPECT_EQ(a.t, b.t);
        for (std::size_t k = 0; k < a.branches.size(); ++k) {
          EXPECT_EQ(a.branches[k].T_from, b.branches[k].T_from);
          EXPECT_EQ(a.branches[k].unstretched, b.branches[k].unstretched);
        }
        for (std::size_t k = 0; k < a.contacts.size(); ++k) EXPECT_EQ(a.contacts[k].slip, b.contacts[k].slip);
        EXPECT_EQ(a.bodies[0].position, b.bodies[0].position);
        EXPECT_EQ(a.bodies[0].velocity, b.bodies[0].velocity);
      }
    }
  }
}

/// Without the integrator's memory a run goes on with the same rope between the rounds and on them; and as well where
/// the rope on them is rigid from there on, or begins to stretch.
TEST(TransientRestart, RopeOnRoundsIsTakenOver) {
  using taut::solve::Arcs;
  const machine::Model m = tackle(4, 0.95, 3000);
  for (const Arcs first : {Arcs::stretch, Arcs::rigid}) {
    TransientOptions options = by_steps(0.3, 0, TimeMethod::implicit);
    options.arcs = first;
    const TransientResult before = run_to_end(m, options);
    options.from = before.state;
    options.from->memory.clear();
    for (const Arcs second : {Arcs::stretch, Arcs::rigid}) {
      options.arcs = second;
      const TransientResult after = run_to_end(m, options);
      const auto &end = before.frames.back().branches, &begin = after.frames.front().branches;
      for (std::size_t b = 0; b < end.size(); ++b) {
        EXPECT_NEAR(begin[b].unstretched, end[b].unstretched, 1e-12);
        EXPECT_NEAR(begin[b].stretched, end[b].stretched, 1e-12);
        EXPECT_NEAR(begin[b].T_from, end[b].T_from, 1e-6 * before.ropes[0].T.max);
      }
    }
  }
}

/// 100 kg on a rope that parts from 0.2 s on, within 0.4 s.
machine::Model parting() {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("load", {0, 0, -10}, 100, "z")};
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("load", 0)}, 9.99, 4, 1e6));
  m.reevings[0].damping_time = 1e-3;
  machine::Event breaks;
  breaks.kind = machine::EventKind::breaks;
  breaks.index = 0;
  breaks.at = 0.2;
  breaks.over = 0.4;
  m.events.push_back(breaks);
  return m;
}

/// A break under way goes on where the integrator's memory is of no use: without it, and by another method.
TEST(TransientRestart, WhatBreaksGoesOnToBreak) {
  const machine::Model m = parting();
  TransientOptions options = by_steps(0.4, 0, TimeMethod::implicit);
  const TransientResult first = run_to_end(m, options);
  ASSERT_EQ(first.state.tears.size(), 1U);
  const double T = first.frames.back().branches[0].T_from;
  ASSERT_GT(T, 100);
  const auto go_on = [&](TransientOptions second) {
    second.from = first.state;
    if (second.method == TimeMethod::implicit) second.from->memory.clear();
    const TransientResult r = run_to_end(m, second);
    EXPECT_NEAR(r.frames.front().branches[0].T_from, T, 0.01 * T);
    EXPECT_FALSE(r.frames.back().branches[0].whole);
    EXPECT_TRUE(r.state.tears.empty());
    return r.frames.back().bodies[0].position.z();
  };
  options = by_steps(0.5, 0, TimeMethod::implicit);
  const double z = go_on(options);
  options.tolerance = 1e-4;
  options.method = TimeMethod::verlet;
  EXPECT_NEAR(go_on(options), z, 1e-4);
  options = by_steps(0.9, 0, TimeMethod::implicit);
  EXPECT_NEAR(run_to_end(m, options).frames.back().bodies[0].position.z(), z, 1e-4);
  options.from = first.state;
  options.from->memory.clear();
  options.from->tears[0].part = 1;
  EXPECT_FALSE(transient(m, options).outcome.ok());
}

TEST(TransientRestart, ADamagedMemoryIsRefused) {
  const machine::Model m = slipping(0);
  TransientOptions options = by_steps(0.01, 1e-3, TimeMethod::implicit);
  const TransientResult first = run_to_end(m, options);
  const auto goes_on = [&](const auto& spoil) {
    options.from = first.state;
    spoil(options.from->memory);
    return transient(m, options).outcome;
  };
  EXPECT_TRUE(goes_on([](auto& /*memory*/) {}).ok());
  EXPECT_NE(goes_on([](auto& memory) { memory.pop_back(); }).message.find("'memory'"), std::string::npos);
  EXPECT_FALSE(goes_on([](auto& memory) { memory.resize(3); }).ok());
  EXPECT_FALSE(goes_on([](auto& memory) { memory.resize(memory.size() / 2); }).ok());
}

/// Without the integrator's memory rates are found anew at an unchanged time: the slip that goes on has its speed from
/// there, but no rope has passed, and no tension has changed. (What counts for a rope's momentum is part of the memory:
/// without weight here.)
TEST(TransientRestart, NoRopeSlipsWhileNoTimePasses) {
  const machine::Model m = slipping(0);
  const TransientResult first = run_to_end(m, by_steps(0.5, 2e-5, TimeMethod::implicit));
  TransientOptions options = by_steps(1e-3, 2e-5, TimeMethod::implicit);
  options.from = first.state;
  options.from->memory.clear();
  const TransientResult anew = run_to_end(m, options);
  const auto &was = first.frames.back(), &is = anew.frames.front();
  ASSERT_GT(std::abs(was.contacts[2].slip), 0.5);
  for (std::size_t k = 0; k < was.branches.size(); ++k) {
    EXPECT_NEAR(is.branches[k].unstretched, was.branches[k].unstretched, 1e-14);
    EXPECT_NEAR(is.branches[k].T_from, was.branches[k].T_from, 1e-9 * was.branches[k].T_from);
  }
  for (std::size_t k = 0; k < was.contacts.size(); ++k) EXPECT_NEAR(is.contacts[k].slip, was.contacts[k].slip, 1e-6);
}

/// The tension at rest is that of the first part, with the integrator's memory and without; a state that does not say
/// it leaves it open.
TEST(TransientRestart, KeepsTheTensionAtRest) {
  const machine::Model m = slipping(0);
  const TransientResult first = run_to_end(m, by_steps(0.5, 1e-3, TimeMethod::implicit));
  ASSERT_GT(std::abs(first.ropes[0].T.end / first.ropes[0].T_static - 1), 0.02);
  TransientOptions options = by_steps(0.1, 1e-3, TimeMethod::implicit);
  options.from = first.state;
  EXPECT_EQ(run_to_end(m, options).ropes[0].T_static, first.ropes[0].T_static);
  options.from->memory.clear();
  EXPECT_EQ(run_to_end(m, options).ropes[0].T_static, first.ropes[0].T_static);
  options.from->ropes[0].T_static = std::nan("");
  EXPECT_TRUE(std::isnan(run_to_end(m, options).ropes[0].T_static));
}

/// Beyond what dampers can hold the rope does slip at once: a drum whose pull jumps to more than twice the tension.
TEST(TransientRestart, WhatDampersCantHoldSlipsAtOnce) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("load", {0.2, 0, -10}, 100, "z")};
  machine::Node drum = sheave("winch", {0, 0, 0}, 0.2, 1);
  drum.drum = 0;
  m.drums.resize(1);
  m.drums[0].drive = {machine::DriveKind::pull, {}};
  m.drums[0].drive.signal.law = 5000.0;
  m.reevings.push_back(reeve("rope", {drum, anchor_on("load", 0)}, 10 / (1 + 981 / 1e5), 0, 1e5));
  m.reevings[0].damping_time = 1e-3;
  const TransientResult r = run_to_end(m, by_steps(0.2, 1e-4, TimeMethod::implicit));
  EXPECT_NEAR(r.frames.front().branches[0].T_from, 5000, 1e-8 * 5000);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), -10 + (5000.0 / 100 - 9.81) * 0.04 / 2, 1e-6);
}

}  // namespace
}  // namespace taut_test::transient_restart_test
