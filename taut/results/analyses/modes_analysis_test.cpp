#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::results::modes_analysis_test {

using namespace taut_test;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// An arm that stands on its foot, held a little by a rope, beside a ball on a rope.
std::string standing_arm(const std::string& modes) {
  return "taut: 1\nmachine:\n  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 500 kN}}\n  points: {a: [0 "
         "m, "
         "0 m, 10 m], t: {body: arm, at: [0 m, 0 m, 0.5 m]}, b: [5 m, 0 m, 10 m]}\n  bodies:\n    arm: {mass: 100 kg, "
         "at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 0.5 m], inertia: 10 kg m^2, free: [ry]}\n    ball: {mass: 100 kg, "
         "at: "
         "[5 m, 0 m, 0 m], free: [x, z]}\n  reevings:\n    - {rope: r, name: s, path: [{anchor: a}, {anchor: t}], "
         "length: 9.4999 m}\n    - {rope: r, name: p, path: [{anchor: b}, {anchor: ball}], length: 10 m}\nanalyses: "
         "[modes: " +
         modes + "]\nchecks: {ropes: {r: {safety_factor: 4}}}\n";
}

TEST(ModesAnalysis, AModeThatGrowsIsNoAnswerHoweverFewAreAskedFor) {
  for (const char* modes : {"{count: 1}", "{}"}) {
    const Result r = run_text(standing_arm(modes));
    const auto v = verdict_of(r);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->kind, VerdictKind::no_answer) << modes;
    EXPECT_THAT(v->reason, HasSubstr("grows: the state is not one to stay in"));
    EXPECT_EQ(text_cell(table_of(r, "modes"), 0, "kind"), "unstable");
    EXPECT_EQ(cell(table_of(r, "modes"), 0, "frequency"), 0) << "it does not swing";
  }
}

/// A heavy span and a block on a rope beside it.
std::string heavy_span(const std::string& analysis) {
  return "taut: 1\nmachine:\n  points: {A: [0 m, 0 m, 50 m], B: [200 m, 0 m, 50 m], E: {body: blk, at: [0 m, 0 m, 0 "
         "m]}}\n  bodies: {blk: {mass: 100 kg, at: [0 m, 0 m, 40 m], free: [z]}}\n  ropes: {r: {mass: 5 kg/m, "
         "stiffness: 10 MN, breaking_force: 100 kN}}\n  reevings:\n    - {rope: r, name: span, path: [{anchor: A}, "
         "{anchor: B}], length: 199.9 m}\n    - {rope: r, name: hang, path: [{anchor: A}, {anchor: E}], length: 10 "
         "m}\nanalyses: [" +
         analysis + "]\nchecks: {ropes: {r: {safety_factor: 3}}}\n";
}

// The elastic catenary has 36.2 kN, a factor of 2.76; the straight branch EA (200/199.9 - 1) = 5.0 kN, one of 20.
TEST(ModesAnalysis, TheRestIsJudgedWithTheSagOfItsRopes) {
  const double exact = value_of(run_text(heavy_span("equilibrium: {}")), "span.safety_factor");
  EXPECT_NEAR(exact, 2.763, 1e-3);
  const Result r = run_text(heavy_span("modes: {}"));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_NEAR(value_of(r, "span.safety_factor"), exact, 1e-9);
  EXPECT_THAT(r.warnings,
              Contains(HasSubstr("modes: 'span' begins straight with 5.003 kN; with its sag it has 36.2 kN: use "
                                 "'branches: catenary'")));
  EXPECT_THAT(run_text(heavy_span("modes: {branches: catenary}")).warnings, Not(Contains(HasSubstr("straight"))));
}

TEST(ModesAnalysis, AMotionThatLeavesOutTheSagDoesNotPass) {
  const Result r = run_text(heavy_span("transient: {duration: 0.1 s}"));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("'span' begins straight with 5.003 kN"));
  EXPECT_EQ(verdict_of(run_text(heavy_span("transient: {duration: 0.1 s, branches: catenary}")))->kind,
            VerdictKind::fails);
}

// What hangs over a saddle: friction at rest holds up to e^(0.3 * 1.59) of the load, 15.8 kN.
TEST(ModesAnalysis, TheRestIsJudgedAtBothEndsOfTheBandOfFriction) {
  const auto deck = [](const std::string& analysis) {
    return "taut: 1\nmachine:\n  points: {A: [0 m, 0 m, 30 m], E: {body: blk, at: [0 m, 0 m, 0 m]}}\n  bodies: {blk: "
           "{mass: 1 t, at: [20 m, 0 m, 10 m], free: [z]}}\n  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, "
           "breaking_force: 30 kN, diameter: 16 mm}}\n  supports: {s: {at: [20 m, 0 m, 30 m], diameter: 400 mm, "
           "friction: 0.3}}\n  reevings: [{rope: r, path: [{anchor: A}, {over: s}, {anchor: E}], length: 40 "
           "m}]\nanalyses: [" +
           analysis +
           "]\nchecks: {ropes: {r: {safety_factor: 2.5, sheave_weakening: covered}}, anchors: {A: {strength: 12 kN, "
           "safety_factor: 1}}}\n";
  };
  const Result still = run_text(deck("equilibrium: {}")), swinging = run_text(deck("modes: {}"));
  EXPECT_NEAR(check_of(still, "A.anchor_strength").value, 0.759, 1e-3);
  EXPECT_EQ(verdict_of(swinging)->kind, VerdictKind::fails);
  for (const char* name : {"A.anchor_strength", "r.safety_factor"})
    EXPECT_NEAR(check_of(swinging, name).value, check_of(still, name).value, 1e-9) << name;
}

}  // namespace taut::results::modes_analysis_test
