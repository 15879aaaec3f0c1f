#include "taut/study/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/study/line/rope_clearance.hpp"
#include "taut/study/load_path.hpp"
#include "taut/study/payload.hpp"
#include "test/support/machines.hpp"

namespace limits_test {

namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;

TEST(Clearance, OfARopeIsThatOfAFineGrid) {
  machine::Model m = with_carriage(true, 0.1, 1500);
  m.terrain = {{.x = -10, .z = 2},  {.x = 40, .z = 21},  {.x = 70, .z = 20}, {.x = 120, .z = 36},
               {.x = 160, .z = 30}, {.x = 230, .z = 55}, {.x = 310, .z = 60}};
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const solve::EquilibriumResult e = solve::equilibrium(m, options);
  ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
  for (const auto& [from, to] : {std::pair{0.0, 300.0}, {60.0, 110.0}, {280.0, 100.0}, {210.0, 215.0}}) {
    double least = 1e9;
    for (const solve::BranchResult& s : e.branches) {
      if (s.reeving != 0) continue;
      for (int i = 0; i <= 20000; ++i) {
        const Vector3 p = s.start + taut::rope::point_at(s.shape, s.shape.rope.length * (i / 20000.0));
        if (p.x() < std::min(from, to) || p.x() > std::max(from, to)) continue;
        least = std::min(least, p.z() - ground_height(m.terrain, p.x()));
      }
    }
    const RopeClearance low = rope_clearance(m, e.branches, 0, {.along = Vector3::UnitX(), .from = from, .to = to});
    EXPECT_LE(low.height, least + 1e-9);
    EXPECT_NEAR(low.height, least, 2e-3) << from << " to " << to;
    EXPECT_GE(low.place.x(), std::min(from, to) - 1e-9);
    EXPECT_LE(low.place.x(), std::max(from, to) + 1e-9);
  }
  m.terrain.clear();
  EXPECT_TRUE(std::isnan(rope_clearance(m, e.branches, 0, {Vector3::UnitX(), 0, 300}).height));
}

TEST(Clearance, OfALineTurnedInPlanIsTheSame) {
  machine::Model m = with_carriage(true, 0.1, 200);
  m.terrain = {{.x = -10, .z = -12}, {.x = 40, .z = 7},   {.x = 70, .z = 6},  {.x = 120, .z = 22},
               {.x = 160, .z = 16},  {.x = 230, .z = 41}, {.x = 310, .z = 46}};
  PayloadLimits limits;
  limits.rope_clearance = {2.5, -std::numeric_limits<double>::infinity()};
  limits.rope_between = {.along = Vector3::UnitX(), .from = 100, .to = 190};
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const Payload straight = payload(m, 0, limits, options);
  ASSERT_TRUE(straight.outcome.ok()) << straight.outcome.message;
  ASSERT_EQ(straight.limit.kind, LimitKind::rope_clearance) << straight.governing;
  for (const double angle : {0.5, M_PI / 2, 2.5, M_PI, -1.2}) {
    const Vector3 by(12, -7, 3), along(std::cos(angle), std::sin(angle), 0);
    const double shift = by.dot(along);
    machine::Model other = turned(m, angle, by);
    for (machine::GroundPoint& p : other.terrain) p.z += by.z();
    PayloadLimits there = limits;
    there.rope_between = {.along = along, .from = 100 + shift, .to = 190 + shift};
    solve::EquilibriumOptions placed;
    placed.prescribed = machine::Prescribed{.carriage = 0, .x = 150 + shift, .along = along};
    const Payload p = payload(other, 0, there, placed);
    ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
    EXPECT_EQ(p.governing, straight.governing);
    EXPECT_NEAR(p.mass / straight.mass, 1, 1e-7) << angle;
  }
}

TEST(Clearance, OfAWindowCountsItsEdgesAndTheTerrains) {
  machine::Model m;
  m.reevings.push_back(reeve("rope", {anchor("a", {0, 0, 10}), anchor("b", {100, 0, 10})}, 100.2, 15, 1e9));
  m.terrain = {{.x = 0, .z = 0}, {.x = 100, .z = 0}};
  const solve::EquilibriumResult e = solve::equilibrium(m);
  ASSERT_TRUE(e.outcome.ok());
  const auto height = [&](double from, double to) {
    return rope_clearance(m, e.branches, 0, {.along = Vector3::UnitX(), .from = from, .to = to}).height;
  };
  const auto z_at = [&](double x) { return 10 - taut::rope::sag_at(e.branches[0].shape, x); };
  EXPECT_NEAR(height(100, 0), z_at(50), 1e-9);
  EXPECT_NEAR(height(10, 30), z_at(30), 1e-9);
  EXPECT_NEAR(height(70, 90), z_at(70), 1e-9);
  EXPECT_NEAR(height(0, 0), 10, 1e-9);
  EXPECT_TRUE(std::isnan(height(-20, -1)));
  m.terrain = {{.x = 60, .z = 0}, {.x = 80, .z = 0}};
  EXPECT_NEAR(height(0, 100), z_at(60), 1e-9);
  // a terrain across the rope is one place of it
  m.terrain_along = Vector3::UnitY();
  m.terrain = {{.x = -5, .z = 3}, {.x = 5, .z = 3}};
  EXPECT_NEAR(height(0, 100), z_at(50) - 3, 1e-9);
}

TEST(Clearance, SaysWhichPartOfTheExtentTheTerrainDoesNotReach) {
  machine::Model m;
  m.reevings.push_back(reeve("rope", {anchor("a", {0, 0, 10}), anchor("b", {100, 0, 10})}, 100.2, 15, 1e9));
  m.reevings.push_back(reeve("guy", {anchor("c", {0, 0, 10}), anchor("d", {-30, 40, 0})}, 51, 15, 1e9));
  const solve::EquilibriumResult e = solve::equilibrium(m);
  ASSERT_TRUE(e.outcome.ok());
  const auto expect_gap = [](const TerrainGap& gap, double before, double after) {
    EXPECT_NEAR(gap.before, before, 1e-9);
    EXPECT_NEAR(gap.after, after, 1e-9);
    EXPECT_NEAR(gap.missing(), before + after, 1e-9);
  };
  expect_gap(terrain_gap(m, e.branches, 0), 100, 0);
  m.terrain = {{.x = 20, .z = 0}, {.x = 70, .z = 0}};
  expect_gap(terrain_gap(m, e.branches, 0), 20, 30);
  expect_gap(terrain_gap(m, e), 50, 30);
  expect_gap(terrain_gap(m, e.branches, 0, {.along = Vector3::UnitX(), .from = 90, .to = 25}), 0, 20);
  expect_gap(terrain_gap(m, e.branches, 0, {.along = Vector3::UnitX(), .from = 80, .to = 90}), 0, 10);
  expect_gap(terrain_gap(m, e.branches, 0, {.along = Vector3::UnitX(), .from = 200, .to = 300}), 0, 0);
  expect_gap(terrain_gap(m, 15, 5), 10, 0);
  m.terrain = {{.x = 0, .z = 0}, {.x = 100, .z = 0}};
  expect_gap(terrain_gap(m, e.branches, 0), 0, 0);
  // the terrain's x runs the other way, from the middle
  m.terrain_from = {50, 0, 0};
  m.terrain_along = -Vector3::UnitX();
  m.terrain = {{.x = -40, .z = 0}, {.x = 50, .z = 0}};
  expect_gap(terrain_gap(m, e.branches, 0), 10, 0);
  expect_gap(terrain_gap(m, e), 10, 30);
}

TEST(Limits, EachIsReachedByItsPayload) {
  machine::Model m = with_carriage(true, 0.1, 200);
  m.terrain = {{.x = 0, .z = 0}, {.x = 300, .z = 60}};
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  options.motion = solve::Motion::in;
  PayloadLimits pull;
  pull.ends = {{.reeving = 1, .at_end = false, .pull = 3e3}};
  PayloadLimits rope;
  rope.rope_clearance = {2.5, -std::numeric_limits<double>::infinity()};
  rope.rope_between = {.along = Vector3::UnitX(), .from = 100, .to = 190};
  PayloadLimits angle;
  angle.break_angle = 0.9;
  for (const auto& [limits, kind] :
       {std::pair{pull, LimitKind::pull}, {rope, LimitKind::rope_clearance}, {angle, LimitKind::break_angle}}) {
    const Payload p = payload(m, 0, limits, options);
    ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
    ASSERT_EQ(p.limit.kind, kind) << p.governing;
    EXPECT_GT(p.mass, 10);
    EXPECT_NEAR(p.limit.value / p.limit.limit, 1, 1e-7) << p.governing;
    machine::Model loaded = m;
    for (const double share : {0.999, 1.001}) {
      loaded.bodies[0].mass = 200 + share * p.mass;
      const auto all = limits_at(loaded, 0, limits, solve::equilibrium(loaded, options));
      const bool broken = std::any_of(all.begin(), all.end(), [](const LimitState& s) { return s.margin < 0; });
      EXPECT_EQ(broken, share > 1) << p.governing << " " << share;
    }
  }
}

TEST(Limits, LiftOffEndsThePayload) {
  // a support low between two high ones: the load beside it draws the rope out of it
  machine::Model m;
  m.reevings.push_back(reeve("skyline",
                             {anchor("a", {0, 0, 10}), saddle("low", {100, 0, 1}, 0), anchor("b", {200, 0, 10})}, 201.6,
                             15, 500e6));
  m.bodies.push_back(body("car", {60, 0, 3}, 10, "xyz"));
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 1, over("car", origin, 0));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 60};
  PayloadLimits limits;
  limits.lift_off = true;
  limits.most = 20e3;
  const Payload p = payload(m, 0, limits, options);
  ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
  ASSERT_EQ(p.limit.kind, LimitKind::lift_off) << p.governing;
  EXPECT_EQ(p.governing, "lift-off from 'low'");
  m.bodies[0].mass = 10 + 0.999 * p.mass;
  EXPECT_LT(solve::equilibrium(m, options).contacts[1].force.z(), 0) << "still presses on it";
  m.bodies[0].mass = 10 + 1.001 * p.mass;
  EXPECT_EQ(solve::equilibrium(m, options).contacts[1].state, solve::ContactState::pulled);
}

// A saddle that holds its rope down may bend it as little as it will, not as much.
TEST(Limits, ASaddleThatHoldsBendsItsRopeToo) {
  machine::Model m;
  m.reevings.push_back(reeve(
      "line", {anchor("a", {0, 0, 10}), saddle("jack", {100, 0, 14}, 0.1), anchor("b", {200, 0, 10})}, 201, 15, 500e6));
  m.bodies.push_back(body("car", {60, 0, 3}, 10, ""));
  PayloadLimits limits;
  limits.break_angle = 0.01;
  limits.least_break_angle = 0.02;
  for (const bool holds : {false, true}) {
    m.reevings[0].nodes[1].support = holds ? Vector3(Vector3::Zero()) : Vector3(Vector3::UnitZ());
    const auto all = limits_at(m, 0, limits, solve::equilibrium(m));
    ASSERT_EQ(all.size(), holds ? 1U : 2U);
    EXPECT_EQ(all[0].kind, LimitKind::break_angle);
    EXPECT_LT(all[0].margin, 0);
  }
}

TEST(Limits, AWinchPullsAllCopies) {
  machine::Model m = with_carriage(true, 0.1, 200);
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  options.motion = solve::Motion::in;
  PayloadLimits limits;
  limits.ends = {{.reeving = 1, .at_end = false, .pull = 3e3}};
  const double one = limits_at(m, 0, limits, solve::equilibrium(m, options)).at(0).value;
  m.reevings[1].copies = 2;
  const solve::EquilibriumResult e = solve::equilibrium(m, options);
  const LimitState both = limits_at(m, 0, limits, e).at(0);
  EXPECT_NEAR(both.value, 2 * e.ropes[1].T_max, 1e-3 * one);
  EXPECT_NEAR(both.margin, 1 - both.value / 3e3, 1e-12);
}

/// Two ropes that are wound on one drum the same way pull it together; one that is wound the other way does not add to
/// that.
TEST(Limits, AWinchPullsAllRopesOnItsDrum) {
  machine::Model m;
  m.bodies.push_back(body("load", {0, 0, 0}, 1000, "z"));
  m.drums.emplace_back().name = "winch";
  m.drums[0].core_radius = 0.15;
  machine::Node on_drum = sheave("winch", {0, 0, 20}, 0.16, 1);
  on_drum.kind = machine::NodeKind::anchor;
  on_drum.drum = 0;
  m.reevings.push_back(reeve("one", {on_drum, anchor_on("load", 0)}, 19.9, 0, 1e6));
  m.reevings.push_back(reeve("three", {on_drum, anchor_on("load", 0)}, 19.9, 0, 1e6));
  m.reevings[1].copies = 3;
  PayloadLimits limits;
  limits.ends = {{.reeving = 0, .at_end = false, .pull = 9e3}, {.reeving = 1, .at_end = false, .pull = 9e3}};
  for (const bool crossed : {false, true}) {
    if (crossed) m.reevings[1].nodes.front().side *= -1;
    const solve::EquilibriumResult e = solve::equilibrium(m);
    ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
    const auto all = limits_at(m, 0, limits, e);
    // all four ropes are alike, and but for the radius of the drum they hang straight down
    const double W = 1000 * m.gravity;
    EXPECT_NEAR(all.at(0).value / W, crossed ? 0.25 : 1, 1e-3);
    EXPECT_NEAR(all.at(1).value / W, crossed ? 0.75 : 1, 1e-3);
    EXPECT_NEAR(all.at(0).margin, 1 - all.at(0).value / 9e3, 1e-12);
    EXPECT_EQ(limit_words(m, 0, all.at(0)), "pull of 'one', 'three' at 'winch'");
  }
}

}  // namespace limits_test
