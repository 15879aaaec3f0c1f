#include "taut/solve/running.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

/// Ropes that run along themselves, against Routh's theorem in its plain words: on fixed supports the shape and the
/// tension of an elastic rope do not know of the speed; what holds it feels the tension less m v^2.
namespace taut::solve::running_test {

using namespace taut_test;

constexpr double speed = 40, mass = 2.5, c = mass * speed * speed;  // 4 kN

/// A rope over a sheave between two pins on walls; it runs through (as long as there is rope).
machine::Model over_a_sheave(double weight) {
  machine::Model m;
  m.reevings.push_back(reeve("rope",
                             {anchor("a", {-30, 0, 0}), sheave("top", {0, 0, 12}, 0.4, 1), anchor("b", {25, 0, -3})},
                             61.5, weight, 3e6));
  m.reevings[0].mass = mass;
  return m;
}

EquilibriumResult running_at(machine::Model m, double v) {
  m.reevings[0].speed = v;
  EquilibriumOptions options;
  options.motion = Motion::in;
  EquilibriumResult r = equilibrium(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

TEST(Running, OnFixedSupportsASpeedPressesLessAndPullsTheSame) {
  const EquilibriumResult rest = running_at(over_a_sheave(0), 0), runs = running_at(over_a_sheave(0), speed);
  ASSERT_GT(rest.branches[0].T_from, c);
  EXPECT_NEAR(runs.branches[0].T_from, rest.branches[0].T_from, 1e-9 * rest.branches[0].T_from);
  EXPECT_NEAR(runs.contacts[0].T_in, rest.contacts[0].T_in, 1e-9 * rest.branches[0].T_from);
  const double share = 1 - c / rest.contacts[0].T_in;  // same wrap, both tensions less c
  EXPECT_NEAR(runs.contacts[0].force.norm() / rest.contacts[0].force.norm(), share, 1e-9);
}

/// From the start of a branch to its end by the rope's differential equation: each metre hangs by T' = T - c and is
/// stretched by T. Height of the end over the start, and the unstretched length.
struct Shot {
  double z = 0, length = 0;
};
Shot shot(const BranchResult& span, double weight, double stiffness) {
  constexpr int steps = 2000;
  const double h = std::abs(span.end.x() - span.start.x()) / steps;
  double V = span.V_from;
  Shot end;
  const auto per_x = [&](double at) {
    const double T = std::hypot(span.H, at);
    return T / (span.H * (1 + (T + c) / stiffness));
  };
  for (int i = 0; i < steps; ++i) {
    const double middle = V + h / 2 * weight * per_x(V);
    end.z += h * middle / span.H;
    end.length += h * per_x(middle);
    V += h * weight * per_x(middle);
  }
  EXPECT_NEAR(V, span.V_to, 1e-4);
  return end;
}

/// With weight: it hangs by what the speed leaves of its tension, and is as long as all of it makes it.
TEST(Running, AHeavyRopeHangsByWhatTheSpeedLeaves) {
  const EquilibriumResult r = running_at(over_a_sheave(25), speed);
  double length = 0;
  for (const BranchResult& span : r.branches) {
    EXPECT_NEAR(std::hypot(span.H, span.V_from), span.T_from - c, 1e-8 * span.T_from);
    const Shot end = shot(span, 25, 3e6);
    EXPECT_NEAR(end.z, (span.end - span.start).z(), 1e-6);
    length += end.length;
  }
  const double T = r.contacts[0].T_in;
  EXPECT_NEAR(r.contacts[0].T_out, T, 1e-9 * T);  // no loss
  EXPECT_NEAR(length + 0.4 * r.contacts[0].wrap / (1 + T / 3e6), 61.5, 1e-6);
  EXPECT_NEAR(r.ropes[0].unstretched, 61.5, 1e-9);
}

/// A rope on a take-up: the weight holds 2 (T - c), so T = W/2 + c; at rest it is W/2.
TEST(Running, ATakeUpHoldsWhatIsLeft) {
  for (const double v : {0.0, speed}) {
    machine::Model m;
    m.bodies.push_back(body("take-up", {0, 0, -10}, 9000 / 9.80665, "z"));
    m.reevings.push_back(
        reeve("rope", {anchor("a", {-0.3, 0, 0}), sheave("block", origin, 0.3, -1, 1, 0), anchor("b", {0.3, 0, 0})},
              20.95, 0, 2e6));
    m.reevings[0].mass = mass;
    const EquilibriumResult r = running_at(m, v);
    EXPECT_NEAR(r.branches[0].T_to, 4500 + mass * v * v, 1e-6);
    // it lies where its rope, stretched by all of T, comes down to: two falls and half a turn
    EXPECT_NEAR(-2 * r.state.bodies[0].position.z() + 0.3 * M_PI, 20.95 * (1 + r.branches[0].T_to / 2e6), 1e-7);
  }
}

TEST(Running, WhatIsGivenHasToBeMoreThanTheCentrifugalTension) {
  machine::Model m = over_a_sheave(0);
  m.reevings[0].speed = speed;
  m.reevings[0].given = machine::Given::tension_at_end;
  const taut::Array<taut::Array<int>> flow = {{1, 1, 1}}, still = {{0, 0, 0}};
  m.reevings[0].value = c + 1;
  const auto just = running(m, flow);
  ASSERT_TRUE(just.has_value());
  EXPECT_NEAR(just->reevings[0].value, 1, 1e-9);
  EXPECT_EQ(m.reevings[0].value, c + 1);
  m.reevings[0].value = c;
  const auto lifts = running(m, flow);
  ASSERT_FALSE(lifts.has_value());
  EXPECT_NE(lifts.error().find("'rope' lifts off"), std::string::npos) << lifts.error();
  ASSERT_TRUE(running(m, still).has_value());  // what does not run has none
  EXPECT_EQ(centrifugal(m.reevings[0], {0, 0, 0}), 0);
  EXPECT_EQ(centrifugal(m.reevings[0], {0, -1, 0}), c);
  // the other tension of a rope over a drive counts as well
  m.reevings[0].value = 3 * c;
  m.reevings[0].also = std::pair(machine::Given::tension_at_start, c / 2);
  EXPECT_FALSE(running(m, flow).has_value());
  m.reevings[0].also = std::pair(machine::Given::length, c / 2);
  EXPECT_TRUE(running(m, flow).has_value());
}

TEST(Running, LoadsByMotionAreHeldAsTheHaulGoes) {
  for (const int haul : {1, -1}) {
    for (const int sense : {1, -1}) {
      machine::Model m = over_a_sheave(0);
      m.reevings[0].haul = haul;
      machine::Node load = anchor("cut", {5, 0, 8});
      load.kind = machine::NodeKind::load;
      load.load.by_motion = true;
      load.load.sense = sense;
      m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 2, load);
      const machine::Model held = with_loads_held(m);
      EXPECT_FALSE(held.reevings[0].nodes[2].load.by_motion);
      EXPECT_EQ(held.reevings[0].nodes[2].load.sense, sense * haul);
      EXPECT_EQ(with_loads_held(held).reevings[0].nodes[2].load.sense, sense * haul);  // once is enough
      EXPECT_EQ(flow_of(m, {.motion = Motion::hoist, .flow = {}, .creep = {}, .prescribed = {}})[0],
                std::vector<int>(4, haul));
      EXPECT_EQ(flow_of(m, {.motion = Motion::out, .flow = {}, .creep = {}, .prescribed = {}})[0],
                std::vector<int>(4, -haul));
      EXPECT_EQ(flow_of(m, {})[0], std::vector<int>(4, 0));
    }
  }
}

/// At rest the largest tension is that of both directions of motion. A rope that runs weighs outward there, whether its
/// sheaves lose something or not: no jump at the ideal sheave.
TEST(Running, TheBandAtRestIsContinuousInTheLoss) {
  const auto at_rest = [](double efficiency) {
    machine::Model m = over_a_sheave(25);
    m.reevings[0].speed = speed;
    m.reevings[0].breaking_force = 100e3;
    m.reevings[0].nodes[1].law.efficiency = efficiency;
    EquilibriumResult r = equilibrium(m, {});
    EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_TRUE(r.band);
    return r;
  };
  const EquilibriumResult ideal = at_rest(1);
  EquilibriumOptions options;
  options.motion = Motion::in;
  machine::Model m = over_a_sheave(25);
  m.reevings[0].speed = speed;
  EXPECT_NEAR(ideal.ropes[0].T_max, equilibrium(m, options).ropes[0].T_max, 1e-9 * ideal.ropes[0].T_max);
  for (const double loss : {1e-11, 1e-6}) {
    const EquilibriumResult r = at_rest(1 - loss);
    const double near = 1e-9 + 5 * loss;
    EXPECT_NEAR(r.ropes[0].T_max / ideal.ropes[0].T_max, 1, near);
    EXPECT_NEAR(r.ropes[0].safety_factor / ideal.ropes[0].safety_factor, 1, near);
    for (std::size_t k = 0; k < r.branches.size(); ++k) {
      EXPECT_NEAR(r.branches[k].T_from / ideal.branches[k].T_from, 1, near);
      EXPECT_NEAR(r.branches[k].T_to_max / ideal.branches[k].T_to_max, 1, near);
      EXPECT_NEAR(r.branches[k].T_to_min / ideal.branches[k].T_to_min, 1, near);
    }
  }
}

}  // namespace taut::solve::running_test
