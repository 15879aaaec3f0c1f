/// Sweeps of the machine itself: what is judged at each value is judged as the deck that has it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace swept_apart_test {

using namespace taut_test;
using taut::Result;
using taut::verdict_of;
using taut::VerdictKind;
using testing::Contains;
using testing::HasSubstr;

/// A rope of 100 m over 60 m with its carriage in the middle, 40 m below: T = W/(2 0.8), and at most 100 kN/3.
Result with_payload(const std::string& sweep) {
  return run_text(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {a: [-30 m, 0 m, 40 m], b: [30 m, 0 m, 40 m]}
  ropes: {s: {mass: 0 kg/m, stiffness: .inf, breaking_force: 100 kN, diameter: 20 mm}}
  carriages: {car: {mass: 4 t, rides: s, hold: clamped}}
  reevings: [{rope: s, path: [{anchor: a}, {through: car}, {anchor: b}], length: 100 m}]
analyses:
  - payload: {carriage: car, from: 0 m, to: 0 m, limits: {s: {safety_factor: 3}}}
  - sweep: {)" + sweep +
                  R"(, steps: 2, carriage: car, x: 0 m}
)");
}

TEST(SweptApart, ThePayloadsLimitHoldsInASweepOfTheMachine) {
  const Result r = with_payload("parameter: carriages.car.mass, from: 4 t, to: 8 t");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails) << verdict_of(r)->reason;
  EXPECT_NEAR(value_of(r, "s.T_max"), 80e3 / 1.6, 1);
  const Result light = with_payload("parameter: carriages.car.mass, from: 3 t, to: 4 t");
  EXPECT_EQ(verdict_of(light)->kind, VerdictKind::passes) << verdict_of(light)->reason;
}

TEST(SweptApart, APayloadsFactorIsThatOfTheRopeThatItHas) {
  const Result r = with_payload("parameter: ropes.s.breaking_force, from: 100 kN, to: 50 kN");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade") << verdict_of(r)->reason;
  EXPECT_THAT(r.unmade, Contains(HasSubstr("its breaking force is 75 kN"))) << to_text(r.errors);
  const Result stronger = with_payload("parameter: ropes.s.breaking_force, from: 100 kN, to: 150 kN");
  EXPECT_EQ(verdict_of(stronger)->kind, VerdictKind::passes) << verdict_of(stronger)->reason;
}

/// A hinged mast on three guys.
Result mast(const std::string& east, const std::string& rest) {
  return run_text(R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 12 m], s1: [-12 m, 8 m, 0 m], s2: [-12 m, -8 m, 0 m], s3: [)" +
                  east + R"(, 0 m, 0 m], t: [60 m, 0 m, 12 m]}
  ropes: {guy: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 400 kN, diameter: 16 mm}}
  beams: {mast: {from: foot, to: head, section: CHS 219.1x10, steel: S355, base: hinge}}
  guys:
    g1: {rope: guy, from: mast.top, to: s1, install: {tension: 20 kN, at: top}}
    g2: {rope: guy, from: mast.top, to: s2, install: {tension: 20 kN, at: top}}
    g3: {rope: guy, from: mast.top, to: s3, install: {tension: 20 kN, at: top}}
)" + rest);
}

/// With s1 at y = 0 no guy pulls towards +y: the guys alone let the mast fall, which only its load holds.
TEST(SweptApart, GuysAloneHoldTheMastAtEachValue) {
  const std::string load = R"(  loads: [{at: mast.top, force: [5 kN, 25 kN, -5 kN]}]
checks:
  guys: {guy: {safety_factor: 2, pretension: [0.02, 0.4], may_go_slack: true}}
  masts: {mast: {load_factor: 1.5}}
analyses: [{sweep: {parameter: points.s1.y, from: 8 m, to: )";
  const Result holds = mast("12 m", load + "6 m, steps: 2}}]\n"), falls = mast("12 m", load + "0 m, steps: 2}}]\n");
  ASSERT_TRUE(verdict_of(holds) && verdict_of(falls)) << holds.message << falls.message << to_text(falls.errors);
  EXPECT_EQ(verdict_of(holds)->kind, VerdictKind::passes) << verdict_of(holds)->reason;
  EXPECT_EQ(verdict_of(falls)->verdict_class, "unmade") << verdict_of(falls)->reason;
  EXPECT_THAT(falls.unmade, Contains(HasSubstr("on its guys alone")));
}

/// A sweep that no combination of the mast names is in none of its checks.
TEST(SweptApart, AMastThatNoCombinationJudgesIsToldInASweepToo) {
  const auto judged = [](const std::string& combinations) {
    return mast("14 m", R"(  reevings: [{rope: guy, path: [{anchor: mast.top}, {anchor: t}], tension_at_end: 30 kN}]
analyses:
  - equilibrium: {}
  - sweep: {name: one, parameter: points.t.z, from: 12 m, to: 0 m, steps: 2}
checks:
  ropes: {guy: {safety_factor: 3}}
  guys: {guy: {safety_factor: 2, pretension: [0.02, 0.4], may_go_slack: true}}
  masts: {mast: {combinations: {)" +
                            combinations + "}}}\n");
  };
  const Result one = judged("A: {equilibrium: 1.5}"), both = judged("A: {equilibrium: 1.5}, B: {one: 1.5}");
  ASSERT_TRUE(verdict_of(one) && verdict_of(both)) << one.message << to_text(one.errors);
  EXPECT_EQ(verdict_of(one)->verdict_class, "unasked") << verdict_of(one)->reason;
  EXPECT_THAT(one.unjudged, Contains(HasSubstr("mast in 'one'")));
  EXPECT_EQ(verdict_of(both)->kind, VerdictKind::passes) << verdict_of(both)->reason;
}

}  // namespace swept_apart_test
