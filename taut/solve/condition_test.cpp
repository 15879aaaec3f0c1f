#include "taut/solve/condition.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/exact/running_loop.hpp"
#include "test/support/machines.hpp"

namespace condition_test {

using namespace taut_test;
using namespace taut::solve;
using Kind = Condition::Kind;

constexpr double inf = std::numeric_limits<double>::infinity();

TEST(Condition, TheSagOfALevelSpanIsTheCatenarys) {
  // an inextensible level catenary: f = a (cosh(l/2a) - 1), L = 2 a sinh(l/2a), H = w a
  machine::Model m;
  m.reevings.push_back(reeve("r", {anchor("a", {0, 0, 3}), anchor("b", {120, 0, 3})}, 121, 12, inf));
  for (const double f : {0.5, 4.0, 30.0}) {
    const Conditioned c = equilibrium_under(m, {.kind = Kind::sag_of_span, .reeving = 0, .value = f, .span = 0});
    ASSERT_TRUE(c.result.outcome.ok()) << c.result.outcome.message;
    double low = 1, high = 1e5;
    for (int i = 0; i < 200; ++i) {
      const double a = (low + high) / 2;
      (a * (std::cosh(60 / a) - 1) > f ? low : high) = a;
    }
    EXPECT_NEAR(c.result.branches[0].H / (12 * low), 1, 1e-7) << f;
    EXPECT_NEAR(c.result.ropes[0].unstretched / (2 * low * std::sinh(60 / low)), 1, 1e-10) << f;
    EXPECT_NEAR(sag_at_middle(c.result.branches[0]), f, 1e-8);
  }
}

TEST(Condition, BySagByLengthAndByTensionAreOneState) {
  const machine::Model m = with_carriage(true, 0.1, 1500);
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  options.band = false;
  for (const double sag : {6.0, 12.0}) {
    const Conditioned by_sag =
        equilibrium_under(m, {.kind = Kind::sag_at_carriage, .reeving = 0, .value = sag, .span = 0}, options);
    ASSERT_TRUE(by_sag.result.outcome.ok()) << by_sag.result.outcome.message;
    EXPECT_NEAR(sag_of_carriage(by_sag.model, by_sag.result, 0), sag, 1e-8);
    const auto& spans = by_sag.result.branches;
    const Conditioned by_tension = equilibrium_under(
        m, {.kind = Kind::tension_at_start, .reeving = 0, .value = spans.front().T_from, .span = 0}, options);
    ASSERT_TRUE(by_tension.result.outcome.ok());
    EXPECT_NEAR(sag_of_carriage(m, by_tension.result, 0), sag, 1e-6);
    EXPECT_NEAR(by_tension.result.ropes[0].unstretched, by_sag.result.ropes[0].unstretched, 1e-7);
    const Conditioned by_length = equilibrium_under(
        m, {.kind = Kind::length, .reeving = 0, .value = by_sag.result.ropes[0].unstretched, .span = 0}, options);
    EXPECT_NEAR(sag_of_carriage(m, by_length.result, 0), sag, 1e-6);
    // the same where the tension is what is given and what follows
    machine::Model pulled = m;
    pulled.reevings[0].given = machine::Given::tension_at_end;
    pulled.reevings[0].value = 30e3;
    const Conditioned as_tension =
        equilibrium_under(pulled, {.kind = Kind::sag_at_carriage, .reeving = 0, .value = sag, .span = 0}, options);
    ASSERT_TRUE(as_tension.result.outcome.ok()) << as_tension.result.outcome.message;
    EXPECT_NEAR(as_tension.result.ropes[0].unstretched, by_sag.result.ropes[0].unstretched, 1e-6);
  }
}

/// The deck's length may be far away, even too short to reach: with a state near by, the search begins from its rope.
TEST(Condition, BeginsFromTheRopeOfAStateNearBy) {
  machine::Model m = with_carriage(true, 0.1, 1500);
  m.reevings[0].stiffness = inf;
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  options.band = false;
  const Condition sag{.kind = Kind::sag_at_carriage, .reeving = 0, .value = 9, .span = 0};
  const Conditioned alone = equilibrium_under(m, sag, options);
  ASSERT_TRUE(alone.result.outcome.ok()) << alone.result.outcome.message;
  machine::Model other = m;
  for (const double times : {0.3, 0.9, 1.2}) {
    other.reevings[0].value = times * alone.model.reevings[0].value;
    const Conditioned near = equilibrium_under(other, sag, options, alone.result.state);
    ASSERT_TRUE(near.result.outcome.ok()) << times << ": " << near.result.outcome.message;
    EXPECT_NEAR(near.model.reevings[0].value, alone.model.reevings[0].value, 1e-9 * alone.model.reevings[0].value);
    EXPECT_NEAR(near.result.branches[0].T_from, alone.result.branches[0].T_from, 1e-8 * 3e4);
  }
  other.reevings[0].value = 0.3 * alone.model.reevings[0].value;
  EXPECT_FALSE(equilibrium_under(other, sag, options).result.outcome.ok());
}

TEST(Condition, AFreeCarriageStaysWhereItIsLetGo) {
  const machine::Model m = with_carriage(false, 0, 1500);
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 130};
  options.band = false;
  const Conditioned c =
      equilibrium_under(m, {.kind = Kind::free_running, .reeving = 0, .value = 0, .span = 0}, options);
  ASSERT_TRUE(c.result.outcome.ok()) << c.result.outcome.message;
  EXPECT_LT(c.result.hold.norm(), 1e-3);
  const EquilibriumResult let_go = equilibrium(c.model, {}, c.result.state);
  ASSERT_TRUE(let_go.outcome.ok()) << let_go.outcome.message;
  EXPECT_NEAR(let_go.state.bodies[0].position.x(), 130, 1e-4);
}

TEST(Condition, SaysWhenNoneFits) {
  const machine::Model m = with_carriage(true, 0.1, 1500);
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const Conditioned c =
      equilibrium_under(m, {.kind = Kind::sag_at_carriage, .reeving = 0, .value = 1e5, .span = 0}, options);
  EXPECT_EQ(c.result.outcome.status, taut::Status::infeasible);
  EXPECT_NE(c.result.outcome.message.find("no length of 'skyline' found with this sag"), std::string::npos)
      << c.result.outcome.message;
}

/// A running skyline as the engine's closed-loop solver has it and as a machine: the carriage rolls on the upper branch
/// of the return rope, is fixed to its end, and the traction rope pulls it.
struct Loop {
  RunningLoop loop;
  machine::Model machine;
};

Loop running_loop(double EA, double eta) {
  Loop all;
  RunningLoop& l = all.loop;
  l.span = 200;
  l.rise = 15;
  l.traction_rope = {.weight = 14, .stiffness = 1.5 * EA};
  l.return_rope = {.weight = 10, .stiffness = EA};
  l.efficiency = eta;
  l.pull_z = -20e3;
  l.pull_x = 8e3;
  machine::Model& m = all.machine;
  m.bodies.push_back(body("car", {90, 0, -5}, 0, "xyz"));
  m.loads.push_back({{.body = 0, .at = origin}, {8e3, 0, -20e3}});
  machine::Node tail = over("tail", {200, 0, 15});
  tail.law.efficiency = eta;
  m.reevings.push_back(
      reeve("return", {anchor("head", {0, 0, 0}), over("car", origin, 0), tail, anchor_on("car", 0)}, 306, 10, EA));
  m.reevings.push_back(reeve("traction", {anchor("winch", {0, 0, 0}), anchor_on("car", 0)}, 92, 14, 1.5 * EA));
  m.carriages.push_back({"car", 0, 0, 1, 1});
  return all;
}

TEST(Condition, TheModesOfARunningSkylineAreThoseOfTheClosedLoop) {
  for (const double EA : {5e6, 2e7}) {
    const Loop both = running_loop(EA, 0.9);
    EquilibriumOptions options;
    options.prescribed = machine::Prescribed{.carriage = 0, .x = 90};
    options.motion = Motion::in;
    options.flow = {{0, 0, 1, 0},
                    {0, 0}};  // in-haul: the return rope runs from the upper branch over B to the lower one
    LoopState by_sag;
    ASSERT_TRUE(solve_loop(both.loop, {90, 11}, by_sag).ok());
    const Conditioned c =
        equilibrium_under(both.machine, {.kind = Kind::sag_at_carriage, .reeving = 0, .value = 11, .span = 0}, options);
    ASSERT_TRUE(c.result.outcome.ok()) << c.result.outcome.message;
    const auto& spans = c.result.branches;  // head-car, car-tail, tail-car, winch-car
    ASSERT_EQ(spans.size(), 4U);
    EXPECT_NEAR(c.result.ropes[0].unstretched / by_sag.return_length, 1, 1e-7);
    EXPECT_NEAR(c.result.ropes[1].unstretched / by_sag.traction_length, 1, 1e-7);
    // the winch's pull given
    LoopSag pulled;
    ASSERT_TRUE(find_loop_sag(both.loop, 90, LoopGiven::tension_at_A, 45e3, pulled).ok());
    const Conditioned p = equilibrium_under(
        both.machine, {.kind = Kind::tension_of, .reeving = 0, .value = 45e3, .span = 0, .of = {1}}, options);
    ASSERT_TRUE(p.result.outcome.ok()) << p.result.outcome.message;
    EXPECT_NEAR(p.result.branches[3].T_from, 45e3, 1e-3);
    EXPECT_NEAR(sag_of_carriage(p.model, p.result, 0), pulled.sag, 1e-5);
    // the length of the whole loop given
    LoopSag looped;
    ASSERT_TRUE(find_loop_sag(both.loop, 90, LoopGiven::length, 403, looped).ok());
    const Conditioned l = equilibrium_under(
        both.machine, {.kind = Kind::length_of, .reeving = 0, .value = 403, .span = 0, .of = {0, 1}}, options);
    ASSERT_TRUE(l.result.outcome.ok()) << l.result.outcome.message;
    EXPECT_NEAR(l.result.ropes[0].unstretched + l.result.ropes[1].unstretched, 403, 1e-8);
    EXPECT_NEAR(sag_of_carriage(l.model, l.result, 0), looped.sag, 1e-5);
  }
}

}  // namespace condition_test
