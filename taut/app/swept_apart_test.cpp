/// Sweeps of the machine itself: what is judged at each value is judged as the deck that has it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace swept_apart_test {

using namespace taut_test;
using taut::Result;
using taut::verdict_of;
using taut::VerdictKind;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

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

/// A load of 500 kg on its hoist of 6 m, and a tag line of 15 m: at b.x = 10 m its ends are at most 11.7 m apart, at
/// 16 m more than 17 m.
std::string tagged(const std::string& rest) {
  return R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], b: [10 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 50 kN, diameter: 14 mm}}
  bodies: {load: {mass: 500 kg, at: [0 m, 0 m, -6 m], free: [x, y, z]}}
  reevings:
    - {rope: r, name: hoist, path: [{anchor: a}, {anchor: load}], length: 6 m}
    - {rope: r, name: tag, path: [{anchor: b}, {anchor: load}], length: 15 m, may_slack: true}
)" + rest;
}

/// All states count together: a rope that one value loads is judged, whether the others, or another analysis, do or
/// not.
TEST(SweptApart, ARopeThatOneStateLoadsIsJudged) {
  const std::string sweep = "sweep: {parameter: points.b.at.x, from: 10 m, to: ",
                    checks = "checks: {ropes: {r: {safety_factor: 5}}}\n";
  const Result one = run_text(tagged("analyses: [{" + sweep + "16 m, steps: 6}}]\n" + checks));
  ASSERT_TRUE(verdict_of(one)) << one.message << to_text(one.errors);
  EXPECT_EQ(verdict_of(one)->kind, VerdictKind::passes) << verdict_of(one)->reason;
  EXPECT_THAT(one.warnings, Not(Contains(HasSubstr("no load case")))) << to_text(one.errors);
  // the equilibrium leaves it slack, and so does the first value
  const Result both = run_text(tagged("analyses: [{equilibrium: {}}, {" + sweep + "16 m, steps: 6}}]\n" + checks));
  EXPECT_EQ(verdict_of(both)->kind, VerdictKind::passes) << verdict_of(both)->reason;
  // no state at all loads it: said once, without the value of a state
  const Result none = run_text(tagged("analyses: [{equilibrium: {}}, {" + sweep + "11 m, steps: 2}}]\n" + checks));
  EXPECT_EQ(verdict_of(none)->verdict_class, "unmade") << verdict_of(none)->reason;
  const std::string words = "tag: its strength is not checked: no load case gives it a tension";
  EXPECT_THAT(none.unmade, ElementsAre(words));
  EXPECT_EQ(std::count(none.warnings.begin(), none.warnings.end(), words), 1);
}

/// The motion breaks the hoist, and the load falls onto its tag line above, which every value of the sweep leaves
/// slack: the motion judges it, though nothing lasts on it in its 2 s.
TEST(SweptApart, ARopeThatAMotionLoadsIsJudged) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], b: [0 m, 0 m, 12 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 500 kN, diameter: 14 mm, damping_ratio: 0.1}}
  bodies: {load: {mass: 500 kg, at: [0 m, 0 m, -6 m], free: [z]}}
  reevings:
    - {rope: r, name: hoist, path: [{anchor: a}, {anchor: load}], length: 6 m}
    - {rope: r, name: tag, path: [{anchor: b}, {anchor: load}], length: 18.1 m, may_slack: true}
  events: [{at: 0.5 s, break: hoist}]
analyses:
  - transient: {duration: 2 s, output_step: 10 ms}
  - sweep: {parameter: points.b.at.z, from: 11.9 m, to: 12 m, steps: 2}
checks: {ropes: {r: {safety_factor: 5}}}
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade, IsEmpty()) << r.unmade.front();
  EXPECT_TRUE(check_of(r, "tag.safety_factor").passes);
}

/// What is exempt is not left unmade, and no warning of it is unsafe.
TEST(SweptApart, WhatIsExemptIsOutWithAllThatIsSaidOfIt) {
  const std::string more = "analyses: [{equilibrium: {}}]\nchecks: {ropes: {r: {safety_factor: 5}}";
  const Result judged = run_text(tagged(more + "}\n")), exempt = run_text(tagged(more + ", exempt: [tag]}\n"));
  ASSERT_TRUE(verdict_of(judged) && verdict_of(exempt)) << to_text(exempt.errors);
  EXPECT_EQ(verdict_of(judged)->verdict_class, "unmade") << verdict_of(judged)->reason;
  EXPECT_EQ(verdict_of(exempt)->kind, VerdictKind::passes) << verdict_of(exempt)->reason;
  EXPECT_THAT(exempt.warnings, Not(Contains(HasSubstr("its strength"))));
  // without 'may_slack' it is unsafe where it counts
  std::string deck = tagged(more + ", exempt: [tag]}\n");
  deck.erase(deck.find(", may_slack: true"), std::string(", may_slack: true").size());
  const Result slack = run_text(deck);
  EXPECT_EQ(verdict_of(slack)->kind, VerdictKind::passes) << verdict_of(slack)->reason;
  EXPECT_THAT(slack.warnings, Contains(HasSubstr("tag between b and load is slack")));
  EXPECT_THAT(slack.unsafe, IsEmpty());
}

/// A lighter hook at rest does not say what the brake bears, and what the rope has, with the 5 t that are only let
/// down.
TEST(SweptApart, WhatOneMachineShowsIsStillMissingInAnother) {
  const auto hook = [](const std::string& sweep) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 1 kg/m, stiffness: 50 MN, breaking_force: 300 kN, diameter: 20 mm}}
  bodies: {hook: {mass: 5 t, at: [0.1 m, 0 m, -6 m], free: [x, z]}}
  sheaves: {head: {at: [0.2 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.9}}
  drums: {w: {at: [-6 m, 0 m, -3 m], core_diameter: 400 mm, brake_torque: 30 kN m}}
  reevings: [{rope: r, path: [{drum: w}, {over: head}, {anchor: hook}], length: 14 m}]
analyses:
  - equilibrium: {name: h, motion: lower}
)" + sweep + "checks: {ropes: {r: {safety_factor: 3}}}\n");
  };
  const std::string from = "  - sweep: {parameter: bodies.hook.mass, from: 100 kg, to: 500 kg, steps: 2, motion: ";
  const Result rests = hook(from + "at_rest}\n"), lowers = hook(from + "lower}\n");
  ASSERT_TRUE(verdict_of(rests) && verdict_of(lowers)) << to_text(rests.errors);
  for (const Result* r : {&rests, &lowers}) {
    EXPECT_THAT(r->unmade, testing::Contains(HasSubstr("w.brake_torque is not checked")));
    EXPECT_THAT(r->unmade, testing::Contains(HasSubstr("only while it runs off")));
  }
}

/// The same of a guy in the tag line's place.
TEST(SweptApart, AGuyThatOneStateLoadsIsJudged) {
  const auto held = [](const std::string& to) {
    std::string deck = tagged(
        "  guys: {g1: {rope: r, from: b, to: load, length: 15 m}}\nanalyses: [{sweep: {parameter: "
        "points.b.at.x, from: 10 m, to: " +
        to +
        ", steps: 2}}]\nchecks: {ropes: {hoist: {safety_factor: 5}}, "
        "guys: {g1: {safety_factor: 2, may_go_slack: true}}}\n");
    const std::size_t tag = deck.find("    - {rope: r, name: tag");
    deck.erase(tag, deck.find('\n', tag) + 1 - tag);
    return run_text(deck);
  };
  const Result loaded = held("16 m"), slack = held("11 m");
  ASSERT_TRUE(verdict_of(loaded) && verdict_of(slack)) << loaded.message << to_text(loaded.errors);
  EXPECT_THAT(loaded.unmade, IsEmpty());
  EXPECT_THAT(slack.unmade, ElementsAre(HasSubstr("g1: its safety is not checked: no load case gives it a tension")));
}

}  // namespace swept_apart_test
