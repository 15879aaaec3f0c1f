#include "taut/study/least_tension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "test/support/machines.hpp"

/// Ropes pretensioned as little as keeps them taut under all loads.
namespace taut_test::least_tension_test {
namespace {

using taut::study::least_tension;
using taut::study::least_tension_of;
using taut::study::LeastTensionResult;

constexpr double EA = 2e6;

/// A ring between two ropes of 20 m without weight, drawn along them by a force.
machine::Model ring(double force, double left = 10e3, double right = 10e3) {
  machine::Model m;
  m.bodies.push_back(body("ring", origin, 1, "x"));
  m.reevings.push_back(reeve("left", {anchor("a", {-20, 0, 0}), anchor_on("ring", 0)}, 20 / (1 + left / EA), 0, EA));
  m.reevings.push_back(reeve("right", {anchor_on("ring", 0), anchor("b", {20, 0, 0})}, 20 / (1 + right / EA), 0, EA));
  if (force != 0) m.loads.push_back({{.body = 0, .at = origin}, {force, 0, 0}});
  return m;
}

/// Each of the two is slackest where the ring is drawn its way, and has s there; the other has the force more. From the
/// lengths: both as put up have the same tension.
TEST(LeastTension, TwoRopesAreSlackInTurn) {
  const double s = 2e3, P = 5e3;
  for (const double begin : {10e3, 1e3}) {
    const LeastTensionResult r =
        least_tension({ring(0, begin, begin), ring(P, begin, begin), ring(-P, begin, begin)}, {0, 1}, s);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    // l/L of both by Hooke where the ring is drawn to the right; both ropes are equally long
    const double L = 40 / (2 + (s + s + P) / EA);
    for (const auto& one : r.ropes) {
      EXPECT_NEAR(one.unstretched, L, 1e-9 * L);
      EXPECT_NEAR(one.T_least, s, 1e-6 * s);
      EXPECT_NEAR(one.T_min[0], EA * (20 / L - 1), 1e-5 * s);
      EXPECT_NEAR(one.taken_out, 20 / (1 + begin / EA) - L, 1e-8);
    }
    EXPECT_EQ(r.ropes[0].governing, 2);
    EXPECT_EQ(r.ropes[1].governing, 1);
  }
}

/// One rope alone follows, the other stays as long as it was.
TEST(LeastTension, OneRopeFollows) {
  const LeastTensionResult r = least_tension({ring(0, 3e3, 3e3), ring(4e3, 3e3, 3e3)}, {1}, 1500);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_EQ(r.ropes[0].governing, 1);
  EXPECT_NEAR(least_tension_of(r.at[1], 1), 1500, 1e-3);
  EXPECT_NEAR(least_tension_of(r.at[1], 0), 5500, 1e-3);
  const double left = 20 / (1 + 3e3 / EA) * (1 + 5500 / EA), right = 40 - left;
  EXPECT_NEAR(r.ropes[0].unstretched, right / (1 + 1500 / EA), 1e-8);
}

/// Three heavy guys of a post on a ball, 120 degrees apart and turned by any angle, the wind from six sides: all keep
/// s, and of three equal ones under winds from their own sides all are alike.
TEST(LeastTension, ThreeHeavyGuysUnderWindFromAllSides) {
  const double s = 3e3, turned = 0.3;
  const auto post = [&](double wind, double from) {
    machine::Model m;
    m.bodies.push_back(body("top", {0, 0, 12}, 20, "xyz"));
    m.reevings.push_back(reeve("post", {anchor("foot", origin), anchor_on("top", 0)}, 12, 0, 1e9));
    // the post is the weight: held down by its guys, held up by a rope from above
    m.reevings[0].nodes[0].at.at = {0, 0, 200};
    m.reevings[0].value = 188 / (1 + 60e3 / 1e9);
    for (const int k : {0, 1, 2}) {
      const double a = turned + k * 2 * std::numbers::pi / 3;
      const Vector3 foot(15 * std::cos(a), 15 * std::sin(a), 0);
      m.reevings.push_back(reeve("guy" + std::to_string(k), {anchor_on("top", 0), anchor("anchor", foot)},
                                 Vector3(foot - Vector3(0, 0, 12)).norm() / (1 + 20e3 / 10e6), 15, 10e6));
    }
    if (wind > 0) m.loads.push_back({{.body = 0, .at = origin}, {wind * std::cos(from), wind * std::sin(from), 0}});
    return m;
  };
  std::vector<machine::Model> cases = {post(0, 0)};
  for (int k = 0; k < 3; ++k) cases.push_back(post(4e3, turned + k * 2 * std::numbers::pi / 3));
  const LeastTensionResult r = least_tension(cases, {1, 2, 3}, s);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (const auto& one : r.ropes) {
    EXPECT_NEAR(one.T_least, s, 1e-6 * s);
    EXPECT_NEAR(*std::min_element(one.T_min.begin(), one.T_min.end()), s, 1e-6 * s);
    EXPECT_NEAR(one.unstretched, r.ropes[0].unstretched, 1e-7);
    EXPECT_EQ(one.governing, one.reeving);  // blown towards its own anchor
  }
}

/// Friction on a saddle holds one half of the rope slacker than the other: the slacker half keeps s whichever it is.
TEST(LeastTension, FrictionCountsInBothDirections) {
  const double s = 5e3, f = 0.3, S = std::sqrt(200.0);
  machine::Model m;
  m.reevings.push_back(
      reeve("rope", {anchor("a", {-10, 0, 0}), saddle("top", {0, 0, 10}, f), anchor("b", {10, 0, 0})}, 28.2, 0, EA));
  const LeastTensionResult r = least_tension({m}, {0}, s);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double taut = s * std::exp(f * std::numbers::pi / 2);
  EXPECT_NEAR(r.ropes[0].unstretched, S / (1 + s / EA) + S / (1 + taut / EA), 1e-7);
  EXPECT_NEAR(r.ropes[0].T_min.at(0), s, 1e-3);
  ASSERT_EQ(r.at.size(), 1U);
  EXPECT_NEAR(r.at[0].branches[0].T_from_min, s, 1e-2);
  EXPECT_NEAR(r.at[0].branches[0].T_from_max, taut, 1e-2);
}

TEST(LeastTension, WhatCannotBeIsToldWithItsRope) {
  // the ring's left rope is held by its length alone: no length of the right one gives the left one less
  const LeastTensionResult r = least_tension({ring(0), ring(-1e9)}, {1}, 1e9);
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_FALSE(r.outcome.message.empty());
}

TEST(LeastTension, CanBeInterrupted) {
  const LeastTensionResult r = least_tension({ring(0), ring(5e3), ring(-5e3)}, {0, 1}, 2e3, [] { return false; });
  EXPECT_TRUE(r.interrupted);
  EXPECT_TRUE(r.ropes.empty());
}

}  // namespace
}  // namespace taut_test::least_tension_test
