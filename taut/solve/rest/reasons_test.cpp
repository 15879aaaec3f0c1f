#include "taut/solve/rest/reasons.hpp"

#include <gtest/gtest.h>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace reasons_test {

using namespace taut_test;
using namespace taut::solve;

void expect_reason(const machine::Model& m, const std::string& words) {
  const EquilibriumResult r = equilibrium(m);
  ASSERT_FALSE(r.outcome.ok());
  EXPECT_NE(r.outcome.message.find(words), std::string::npos) << r.outcome.message;
  EXPECT_TRUE(r.branches.empty());
}

/// A line whose counterweight hangs behind a sheave.
machine::Model with_counterweight(double mass) {
  machine::Model m;
  m.bodies.push_back(body("counterweight", {-1, 0, -12}, mass, "z"));
  m.reevings.push_back(reeve(
      "track", {anchor_on("cw", 0), sheave("deflection", origin, 1, 1), anchor("end", {200, 0, 30})}, 220, 40, 50e6));
  return m;
}

TEST(Reasons, ACounterweightTooLightIsDrawnUpToItsSheave) {
  EXPECT_TRUE(equilibrium(with_counterweight(8e3)).outcome.ok());
  expect_reason(with_counterweight(200), "body 'counterweight' is drawn up to 'deflection'");
}

// Which of two branches vanishes in the search does not tell which weight is too light.
TEST(Reasons, TwoUnequalWeightsOnOneRopeAreNamedTogether) {
  for (const double other : {510.0, 600.0, 400.0}) {
    machine::Model m;
    m.bodies.push_back(body("a", {-0.5, 0, -6}, 500, "z"));
    m.bodies.push_back(body("b", {0.5, 0, -6}, other, "z"));
    m.reevings.push_back(
        reeve("r", {anchor_on("a", 0), sheave("top", {0, 0, 0}, 0.5, 1), anchor_on("b", 1)}, 14, 0, 10e6));
    const EquilibriumResult r = equilibrium(m);
    ASSERT_FALSE(r.outcome.ok());
    EXPECT_NE(r.outcome.message.find("do not balance on rope 'r'"), std::string::npos) << r.outcome.message;
    EXPECT_EQ(r.outcome.message.find("make it heavier"), std::string::npos) << r.outcome.message;
  }
}

TEST(Reasons, ATensionBelowTheRopesOwnWeightIsNamed) {
  machine::Model m;
  m.reevings.push_back(reeve("guy", {anchor("top", {0, 0, 40}), anchor("foot", {30, 0, 0})}, 0, 40, 5e6));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 300;  // 40 m of height alone weigh 1600 N
  expect_reason(m, "rope 'guy' does not come down to 300 N at 'top'");
  m.reevings[0].value = 3000;
  EXPECT_TRUE(equilibrium(m).outcome.ok());
}

TEST(Reasons, AHookTooLightForItsRopeIsDrawnUpToTheHead) {
  machine::Model m = tackle(4, 0.9, 0.1, 50);
  EquilibriumOptions options;
  options.motion = Motion::hoist;
  const EquilibriumResult r = equilibrium(m, options);
  ASSERT_FALSE(r.outcome.ok());
  EXPECT_EQ(r.outcome.status, taut::Status::infeasible) << r.outcome.message;
  EXPECT_NE(r.outcome.message.find("body 'block' is drawn up to 'head'"), std::string::npos) << r.outcome.message;
}

/// A Spanish burton: the hook hangs on both ropes, and the runner on the first. Without loss the second rope has T, the
/// first 2 T, the hook W = 3 T: with more than 3.269 kN it goes up until it meets the runner. Nothing rolls there.
TEST(Reasons, ATensionGivenThatHaulsABlockTogetherIsNamed) {
  machine::Model m;
  m.bodies.push_back(body("hook", {0, 0, 0}, 1000, "z"));
  m.bodies.push_back(body("runner", {0.2, 0, 5}, 0, "z"));
  m.reevings.push_back(
      reeve("r1", {anchor_on("hook", 0), sheave("top", {0.1, 0, 10}, 0.1, 1), anchor_on("runner", 1)}, 15, 0, 100e6));
  machine::Node runner = sheave("sheave", {0, 0, 0}, 0.2, 1);
  runner.at.body = 1;
  m.reevings.push_back(reeve("r2", {anchor_on("hook", 0), runner, anchor("post", {0.4, 0, -20})}, 0, 0, 100e6));
  m.reevings[1].given = machine::Given::tension_at_end;
  m.reevings[1].value = 3500;
  expect_reason(m, "is drawn up to 'sheave': the tension given of rope 'r2'");
}

TEST(Reasons, ACarriageBeyondTheEndOfItsLineIsTold) {
  const machine::Model m = rollers(1, 0, 0, 500);
  for (const double x : {-40.0, 300.0}) {
    EquilibriumOptions options;
    options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
    const EquilibriumResult r = equilibrium(m, options);
    ASSERT_EQ(r.outcome.status, taut::Status::infeasible) << r.outcome.message;
    EXPECT_NE(r.outcome.message.find("but its rope runs from x = 0 m ('head') to 150 m ('tail') there"),
              std::string::npos)
        << r.outcome.message;
  }
}

TEST(Reasons, APullThatDoesNotCarryTheLoadIsNamed) {
  machine::Model m = tackle(4, 1, 3000);
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 5e3;  // of 7355 N
  expect_reason(m, "the tensions given do not balance its load");
}

}  // namespace reasons_test
