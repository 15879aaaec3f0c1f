#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// The reference by rows of numbers known otherwise, and the fast schemes by the reference.
namespace taut_test::transient_reference_test {
namespace {

using std::numbers::pi;
using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

TransientOptions by(TimeMethod method, double duration) {
  TransientOptions options = lasting(duration, 1e-6, 10);
  options.method = method;
  return options;
}

/// A load on a tackle with losses that a drum hoists: light sheaves, and sheaves with inertia, friction and bearings.
machine::Model hoist(bool heavy) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("block", {0, 0, -10}, 3000, "z"));
  std::vector<machine::Node> nodes{add_drum(m, "winch", {-10, 0, -8}, 0.2)};
  for (int i = 0; i < 4; ++i) {
    nodes.push_back(i % 2 == 0 ? sheave("head", {0, 0, 0}, 0.2, 1, 0.96) : sheave("block", {0, 0, 0}, 0.2, 1, 0.96, 0));
    if (!heavy) continue;
    nodes.back().inertia = 0.5;
    nodes.back().law.friction = 0.3;
  }
  nodes.push_back(anchor("becket", {-0.2, 0, 0}));
  m.reevings.push_back(reeve("hoist", nodes, 54.68, heavy ? 12 : 0, 1e7));
  m.reevings[0].damping_time = 1e-3;
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, 0.6, 0.1, 0.4)};
  return m;
}

TEST(TransientReference, TheFastSchemeHoistsATackleAsItDoes) {
  for (const bool heavy : {false, true}) {
    TransientOptions options = by(TimeMethod::reference, 0.8);
    options.start = Start::settled;
    const TransientResult exact = run_to_end(hoist(heavy), options);
    options.method = TimeMethod::implicit;
    const TransientResult fast = run_to_end(hoist(heavy), options);
    ASSERT_EQ(exact.frames.size(), fast.frames.size());
    for (std::size_t f = 0; f < exact.frames.size(); ++f) {
      EXPECT_NEAR(fast.frames[f].bodies[0].position.z(), exact.frames[f].bodies[0].position.z(), 2e-6) << heavy << f;
      for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(fast.frames[f].branches[k].T_from, exact.frames[f].branches[k].T_from, 2e-4 * exact.ropes[0].T.max)
            << heavy << ' ' << f << ' ' << k;
      }
    }
  }
}

/// A belt that slips on its drive as it starts and grips later; its mass runs with it.
TEST(TransientReference, ABeltThatSlipsAndGrips) {
  machine::Model m;
  m.gravity = 9.81;
  for (const double side : {0.0, 1.0}) {
    machine::Node wheel = sheave(side > 0 ? "driven" : "drive", {5 * side, 0, 0}, 0.3, 1);
    wheel.kind = side > 0 ? machine::NodeKind::contact : machine::NodeKind::drive;
    if (side == 0) wheel.motor = 0;
    wheel.law.friction = side > 0 ? 0.5 : 0.25;  // the drive slips, the other one doesn't
    wheel.inertia = side > 0 ? 20 : 0.5;
    if (m.reevings.empty()) m.reevings.push_back(reeve("belt", {}, 0, 0.3 * 9.81, 2e5));
    m.reevings[0].nodes.push_back(wheel);
  }
  m.reevings[0].closed = true;
  m.reevings[0].value = (10 + 2 * pi * 0.3) / (1 + 800 / 2e5);
  m.reevings[0].damping_time = 5e-3;
  m.motors.resize(1);
  m.motors[0].drive = {machine::DriveKind::speed, smooth_move(0, 5, 0, 0.5)};
  const TransientResult exact = run_to_end(m, by(TimeMethod::reference, 2.2)),
                        fast = run_to_end(m, by(TimeMethod::implicit, 2.2));
  bool slipped = false;
  for (std::size_t f = 0; f < exact.frames.size(); ++f) {
    const auto &a = exact.frames[f].contacts[0], &b = fast.frames[f].contacts[0];
    slipped = slipped || a.slip < -0.1;
    EXPECT_NEAR(b.slip, a.slip, 1e-5) << f;
    const double allowed = 2e-5 * exact.ropes[0].T.max;
    EXPECT_NEAR(b.T_in, a.T_in, allowed) << f;
    EXPECT_NEAR(b.T_out, a.T_out, allowed) << f;
  }
  EXPECT_TRUE(slipped);
  EXPECT_NEAR(exact.frames.back().contacts[0].slip, 0, 1e-6);
}

/// The search for the moment at which the drum stands leaves a little of its turning, which sent it back and forth
/// without end.
TEST(TransientReference, ABrakeStopsADrum) {
  const machine::Model m = braked_load();
  TransientOptions options = by(TimeMethod::reference, 3);
  options.start = Start::settled;
  const TransientResult r = run_to_end(m, options);
  EXPECT_NEAR(r.frames.front().bodies[0].position.z() - r.frames.back().bodies[0].position.z(), 1.35, 1e-3);
  EXPECT_NEAR(r.frames.back().drums[0].speed, 0, 1e-30);
  EXPECT_LT(r.steps, 20000);
}

TEST(TransientReference, ItIsInterrupted) {
  int asked = 0;
  TransientOptions options = by(TimeMethod::reference, 1e6);
  options.progress = [&](double) { return ++asked < 3; };
  EXPECT_TRUE(transient(hoist(true), options).interrupted);
}

TEST(TransientReference, WhatItCannotDoIsTold) {
  machine::Model m = hoist(false);
  m.drums[0].automatic_layers = true;
  EXPECT_NE(transient(m, by(TimeMethod::reference, 0.1)).outcome.message.find("not in the reference"),
            std::string::npos);
}

}  // namespace
}  // namespace taut_test::transient_reference_test
