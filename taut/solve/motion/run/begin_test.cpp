#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/solve/motion/parts/build.hpp"
#include "test/support/machines.hpp"

/// Where a motion begins, by hand: straight lines over a round, velocities, what lies on drums, what comes back from
/// rounds where a rope that hung is straight from now on.
namespace taut::solve::dynamics::transient_begin_test {

using namespace taut_test;
using std::numbers::pi;

constexpr double R = 0.5, EA = 2e6;

/// Over a sheave at the origin from 4 m to its left to 4 m to its right, 3 m below: tangents from 5 m.
machine::Model over_the_top() {
  machine::Model m;
  m.bodies.push_back(body("load", {4, 0, -3}, 100, "xz"));
  m.reevings.push_back(
      reeve("rope", {anchor("a", {-4, 0, -3}), sheave("top", origin, R, 1), anchor_on("load", 0)}, 10.6, 0, EA));
  return m;
}

TEST(TransientBegin, LinesOverARoundAreItsTangents) {
  DynamicState start = assembled(over_the_top());
  start.ropes[0].length = {4.9, 4.97};
  const machine::Model m = over_the_top();
  const Built built = build(m, start, {});
  ASSERT_TRUE(built.outcome.ok()) << built.outcome.message;
  const double l = std::sqrt(25 - R * R), up = std::atan2(3, 4) + std::asin(R / 5);
  for (std::size_t k = 0; k < 2; ++k) {
    const LineValues& line = built.values.lines[k];
    EXPECT_NEAR(line.l, l, 1e-12);
    const double free = start.ropes[0].length[k];
    EXPECT_NEAR(line.L, free + R * up / (l / free), 1e-12);  // half of the arc, of angle 2 up, has the same strain
    EXPECT_NEAR(free_rope(line), free, 1e-12);
    EXPECT_NEAR(line.T, EA * (l / free - 1), 1e-6);
    EXPECT_LT((line.t - Vector3(std::cos(up), 0, k == 0 ? std::sin(up) : -std::sin(up))).norm(), 1e-12);
    EXPECT_EQ(line.angle[0], 0);
  }
  EXPECT_NEAR(built.values.contacts[0].wrap, 2 * up, 1e-12);
  EXPECT_NEAR(built.values.contacts[0].lambda, l / 4.9, 1e-12);  // it comes from where the path begins
  EXPECT_NEAR(built.mechanism.size_of_machine, std::max(1.0, l), 1e-12);
}

/// The mean of the capstan law's tension over a round, by quadrature, is that of its ends times the share.
TEST(TransientBegin, OnAFixedRoundTheShareIsTheMeanOfTheCapstanLaw) {
  for (const double mu : {0.05, 0.3, 1.0}) {
    for (const double wrap : {0.2, pi, 3 * pi}) {
      machine::Node post;
      post.law = {.friction = mu, .efficiency = 0};
      double mean = 0;
      constexpr int n = 20000;
      for (int k = 0; k < n; ++k) mean += std::exp(-mu * wrap * (k + 0.5) / n) / n;
      EXPECT_NEAR(share_that_stretches(post, wrap) * (1 + std::exp(-mu * wrap)) / 2 / mean, 1, 1e-7);
    }
  }
  machine::Node sheave;
  EXPECT_EQ(share_that_stretches(sheave, pi), 1) << "it turns without loss";
  machine::Node clamp;
  clamp.law.efficiency = 0;
  EXPECT_EQ(share_that_stretches(clamp, pi), 0) << "the rope cannot slip";
}

TEST(TransientBegin, ALengthThatIsASlipIsRefusedByName) {
  const machine::Model m = over_the_top();
  DynamicState start = assembled(m);
  start.ropes[0].length = {4.9, 1};
  EXPECT_TRUE(build(m, start, {}).outcome.ok());  // a cord may stretch so far
  start.ropes[0].length[1] = 0.5;
  const Outcome told = build(m, start, {}).outcome;
  EXPECT_EQ(told.status, Status::infeasible);
  EXPECT_NE(told.message.find("'rope' would begin the motion stretched by 895 %: 0.5 m of rope between 'top' and"),
            std::string::npos)
      << told.message;
}

TEST(TransientBegin, ASavedStateGivesRoundsTheirTurns) {
  const machine::Model m = [] {
    machine::Model of = over_the_top();
    of.reevings[0].nodes[1].inertia = 2;
    return of;
  }();
  DynamicState start = assembled(m);
  start.t = 7;
  const double wrap = build(m, start, {}).values.contacts[0].wrap;
  DynamicState::Rope& rope = start.ropes[0];
  rope.wrap = {0, wrap + 2 * pi + 0.3, 0};  // what is between counts by the lines: full turns alone are taken over
  rope.angle = {0, 1.7, 0};
  rope.spin = {0, -4, 0};
  rope.passed = {0, 0.2, 0};
  start.bodies[0].velocity = {0.6, 9, -0.8};
  const Values v = build(m, start, {}).values;
  EXPECT_EQ(v.t, 7);
  EXPECT_NEAR(v.contacts[0].wrap, wrap + 2 * pi, 1e-12);
  const std::size_t spin = 3;  // after x and z of the load and the flow
  EXPECT_EQ(v.q.at(spin), 1.7);
  EXPECT_EQ(v.nu.at(spin), -4);
  EXPECT_EQ(v.nu[0], 0.6);  // y is not free
  EXPECT_EQ(v.nu[1], -0.8);
}

/// A rope that hung left its rounds in other directions: arcs and free rope together stay as long as they were.
TEST(TransientBegin, WhatHungAndIsStraightNowComesBackFromItsRounds) {
  machine::Model m = over_the_top();
  m.reevings[0].nodes[0].radius = 0.3;  // both of its ends are rounds
  m.reevings[0].nodes[0].side = -1;
  DynamicState start = assembled(m);
  const Values straight = build(m, start, {}).values;
  const auto turned = [](const Vector3& t, double by) { return Vector3(Eigen::AngleAxisd(by, Vector3::UnitY()) * t); };
  const double a = 0.04, b = -0.07, c = 0.05;
  start.ropes[0].leaves = {turned(straight.lines[0].t, a), turned(straight.lines[1].t, c)};
  start.ropes[0].arrives = {turned(straight.lines[0].t, b), Vector3::Zero()};
  const Values v = build(m, start, {}).values;
  // the first round is wound left-handed: a rope that left it by `a` farther right-handed had lain on it for less
  EXPECT_NEAR(free_rope(v.lines[0]) - free_rope(straight.lines[0]), -0.3 * a - R * b, 1e-12);
  EXPECT_NEAR(free_rope(v.lines[1]) - free_rope(straight.lines[1]), R * c, 1e-12);
  // all of it: with the sheave's arc between the directions that it had there, and with the one that it has
  const double arc = std::acos(start.ropes[0].arrives[0].dot(start.ropes[0].leaves[1]));
  const double hung = free_rope(straight.lines[0]) + free_rope(straight.lines[1]) + R * arc - 0.3 * a;
  EXPECT_NEAR(free_rope(v.lines[0]) + free_rope(v.lines[1]) + R * v.contacts[0].wrap, hung, 1e-9);
}

TEST(TransientBegin, DrumsHoldRopeAsItWasWound) {
  machine::Model m;
  m.bodies.push_back(body("load", {2, 0, -9}, 100, "xz"));
  m.reevings.push_back(reeve("rope", {add_drum(m, "winch", origin, 0.2), anchor_on("load", 0)}, 9.2, 0, EA));
  m.drums[0].layer = 3;
  m.drums[0].length_on_drum = 40;
  const auto drum = [&](const DynamicState& start) { return build(m, start, {}).values.on_drums.at(0); };
  DynamicState start = assembled(m);
  const double strain = std::sqrt(85 - 0.04) / 9.2 - 1;  // that of the free rope
  ASSERT_GT(strain, 0);
  EXPECT_EQ(drum(start).content, 40);
  ASSERT_EQ(drum(start).strain.size(), 3U);
  for (const double of_layer : drum(start).strain) EXPECT_NEAR(of_layer, strain, 1e-12);
  m.drums[0].wound_at = 5e3;
  EXPECT_NEAR(drum(start).strain[2], 5e3 / EA, 1e-15);
  m.drums[0].wound_at.reset();
  m.reevings[0].value = 11;  // slack: not pushed together
  EXPECT_EQ(drum(assembled(m)).strain[0], 0);
  start.on_drums = {{33, 2, {0.001, 0.002}}};  // a saved one
  EXPECT_EQ(drum(start).content, 33);
  EXPECT_EQ(drum(start).layer, 2);
  EXPECT_EQ(drum(start).strain, (std::vector<double>{0.001, 0.002}));
}

TEST(TransientBegin, SimpleMachinesAreThoseOfPointsAndLinesBetweenThem) {
  machine::Model m;
  m.bodies.push_back(body("load", {3, 0, -4}, 100, "xyz"));
  m.bodies[0].counterweight = 30;
  m.loads.push_back({{0, origin}, {10, 20, -40}});
  m.reevings.push_back(reeve("rope", {anchor("a", origin), anchor_on("load", 0)}, 4.99, 0, EA));
  const auto classified = [&] { return build(m, assembled(m), {}).mechanism; };
  Mechanism is = classified();
  EXPECT_TRUE(is.simple && is.lossless && is.lines[0].plain && !is.lines[0].still && is.bodies[0].point);
  EXPECT_LT((is.bodies[0].dead - Vector3(10, 20, -40 - 100 * m.gravity)).norm(), 1e-12);
  EXPECT_EQ(is.bodies[0].mass, 130);  // what counterweights have is inertia alone
  m.reevings[0].damping_time = 0.01;
  EXPECT_TRUE(classified().simple && !classified().lossless);
  m.reevings[0].nodes[0].radius = 0.2;
  EXPECT_FALSE(classified().simple || classified().lines[0].plain);
  m.reevings[0].nodes[0].radius = 0;
  m.bodies[0].free = body("", origin, 0, "xyzX").free;
  m.bodies[0].inertia = Vector3::Ones();
  EXPECT_FALSE(classified().simple || classified().lines[0].plain || classified().bodies[0].point);
  m.bodies[0].free.clear();
  EXPECT_TRUE(classified().lines[0].still);
}

}  // namespace taut::solve::dynamics::transient_begin_test
