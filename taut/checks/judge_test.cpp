#include "taut/checks/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// What makes a state unsafe, or fails without being asked.
namespace taut::checks::judge_test {

using taut_test::check_of;
using taut_test::has_check;
using taut_test::run_text;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A carriage of 2 t on a line over flat ground, held up by a strap that is cut at 1 s.
std::string strap_is_cut(const std::string& ground) {
  return R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 10 m], hang: [100 m, 0 m, 20 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 1000 kN, damping_ratio: 0.05}
    strap: {mass: 0.1 kg/m, stiffness: 1 MN, breaking_force: 50 kN, damping_ratio: 0.05}
  carriages: {car: {mass: 2 t, rides: skyline, hold: clamped, length_before: 100.5 m, at: [100 m, 0 m, 5 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 201 m}
    - {rope: strap, path: [{anchor: hang}, {anchor: car}], length: 11.9 m}
  terrain: {x: [0 m, 200 m], z: [)" +
         ground + ", " + ground + R"(]}
  events: [{at: 1 s, break: strap}]
checks: {ropes: {skyline: {dynamic_safety_factor: 2}, strap: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 4 s, output_step: 50 ms, tolerance: 1e-3}}]
)";
}

// It falls to 10.2 m below the ground of 2 m: to -8.2 m.
TEST(Judge, AfterABreakTheOtherRopesAreJudgedOn) {
  const Result into = run_text(strap_is_cut("2 m"));
  EXPECT_EQ(verdict_of(into)->kind, VerdictKind::fails) << verdict_of(into)->reason;
  EXPECT_THAT(verdict_of(into)->reason, HasSubstr("The deck breaks strap at 1 s; car.ground"));
  EXPECT_LT(check_of(into, "car.ground").value, -10);
  const Result above = run_text(strap_is_cut("-9 m"));
  EXPECT_EQ(verdict_of(above)->kind, VerdictKind::passes) << verdict_of(above)->reason;
  EXPECT_FALSE(has_check(above, "strap.ground"));
}

// The carriage of a rope that is cut itself falls: its height says nothing. Another one in that place counts.
TEST(Judge, WhatTheDeckBreaksIsJudgedUpToItsBreak) {
  std::string deck = strap_is_cut("-5 m");
  deck.replace(deck.find("break: strap"), 12, "break: skyline");
  deck.replace(deck.find("length: 11.9 m"), 14, "length: 40 m, may_slack: true");
  deck.replace(deck.find("  events:"), 9, "  observe: [car.z]\n  events:");
  const Result r = run_text(deck);
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  ASSERT_NE(r.find_value("car.z_min"), nullptr) << r.message;
  EXPECT_LT(r.find_value("car.z_min")->value, -6);
  EXPECT_FALSE(has_check(r, "car.ground"));
  EXPECT_FALSE(has_check(r, "skyline.ground"));
}

// What a motion has broken is whole in the states at rest behind it.
TEST(Judge, ABreakIsOfItsMotionAlone) {
  const auto beside = [](const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 40 m], far: [230 m, 0 m, 44 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 900 kN, damping_ratio: 0.05}
    main: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.05}
  carriages: {car: {mass: 800 kg, rides: skyline, mainline: main, at: [190 m, 0 m, 36 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 210 m}
    - {rope: main, path: [{anchor: far}, {anchor: car}], length: 40 m}
  events: [{at: 0.1 s, break: skyline}]
checks: {ropes: {skyline: {safety_factor: 2}, main: {safety_factor: 2}}}
analyses:
)" + analyses + "  - sweep: {parameter: 'machine.reevings[1].length', from: 38 m, to: 25 m, steps: 4}\n");
  };
  const std::string motion = "  - transient: {duration: 0.3 s, output_step: 0.1 s, tolerance: 1e-2}\n";
  for (const std::string& analyses : {std::string(), motion}) {
    const Result r = beside(analyses);
    EXPECT_THAT(r.unsafe, Contains(HasSubstr("sweep"))) << r.message << to_text(r.errors);
    EXPECT_THAT(r.unsafe, Contains(HasSubstr("carriage car stands at x = 20")));
  }
}

TEST(Judge, ACarriageBesideItsSpanIsToldInMotion) {
  const auto hauled = [](const std::string& speed) {
    return run_text(R"(taut: 1
machine:
  signals: {in: {ramp: {to: )" +
                    speed + R"(, start: 0 s, duration: 1 s, smooth: true}}}
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 40 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 900 kN, damping_ratio: 0.05}
    main: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.05}
  drums: {winch: {at: [230 m, 0 m, 44 m], core_diameter: 400 mm, drive: {speed: in}}}
  carriages: {car: {mass: 800 kg, rides: skyline, mainline: main, at: [190 m, 0 m, 36 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 210 m}
    - {rope: main, path: [{drum: winch}, {anchor: car}], length: 40 m, may_slack: true}
checks: {ropes: {skyline: {dynamic_safety_factor: 2}, main: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 6 s, output_step: 0.5 s, tolerance: 1e-3}}]
)");
  };
  EXPECT_THAT(hauled("0.5 m/s").unsafe, IsEmpty());
  EXPECT_THAT(hauled("3 m/s").unsafe, Contains(HasSubstr("carriage car stands at x = 200.")));
}

/// A rope over a saddle, whose far end rises so that the rope comes off the saddle.
std::string raised(const std::string& uplift, const std::string& rise) {
  return R"(taut: 1
machine:
  signals: {up: {ramp: {to: )" +
         rise + R"(, start: 0.5 s, duration: 3 s, smooth: true}}}
  points: {head: [0 m, 0 m, 20 m], top: {body: lift, at: [0 m, 0 m, 0 m]}}
  ropes: {line: {mass: 0.5 kg/m, stiffness: 2 MN, breaking_force: 330 kN, damping_ratio: 0.05}}
  bodies: {lift: {at: [100 m, 0 m, 17 m], motion: {z: up}}}
  supports: {jack: {at: [50 m, 0 m, 21 m], diameter: 400 mm, friction: 0.1)" +
         uplift + R"(}}
  reevings: [{rope: line, path: [{anchor: head}, {over: jack}, {anchor: top}], length: 99.9 m}]
checks: {ropes: {line: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 5 s, output_step: 0.5 s, tolerance: 1e-3}}]
)";
}

TEST(Judge, ARopeThatLeavesItsSaddleInMotionIsUnsafe) {
  EXPECT_THAT(run_text(raised("", "3 m")).unsafe, IsEmpty());
  EXPECT_THAT(run_text(raised("", "8 m")).unsafe, ElementsAre(HasSubstr("the rope pulls 'jack' upwards")));
  EXPECT_THAT(run_text(raised(", uplift: lift", "8 m")).unsafe,
              ElementsAre(HasSubstr("the rope pulls 'jack' upwards")));
}

// A rope that a guard holds down may press on it.
TEST(Judge, AnUpliftThatIsHeldIsNoNews) { EXPECT_THAT(run_text(raised(", uplift: hold", "8 m")).unsafe, IsEmpty()); }

// A clearance, a life or the limit of something of the same name does not judge the rope's strength: 95 of 100 kN.
TEST(Judge, ALimitOfSomethingElseDoesNotJudgeARope) {
  const auto judged = [](const std::string& checks) {
    return verdict_of(run_text(R"(taut: 1
machine:
  ropes: {r: {rope: "EN 12385-4|6x36-IWRC|16|1770", stiffness: 12 MN}}
  points: {sky: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  terrain: {x: [0 m, 100 m], z: [0 m, 0 m]}
  reevings: [{name: sky, rope: r, path: [{anchor: sky}, {anchor: b}], tension_at_start: 95 kN}]
checks: )" + checks + "\n"));
  };
  for (const std::string side : {"{lines: {sky: {clearance: true}}}", "{anchors: {sky: {strength: 400 kN}}}"}) {
    const auto v = judged(side);
    ASSERT_TRUE(v) << side;
    EXPECT_EQ(v->kind, VerdictKind::not_judged) << side << v->reason;
    EXPECT_EQ(v->reason, "no limit is given for sky.") << side;
  }
  EXPECT_EQ(judged("{ropes: {sky: {safety_factor: 1.2}}, lines: {sky: {clearance: true}}}")->kind, VerdictKind::passes);
  EXPECT_EQ(judged("{ropes: {sky: {safety_factor: 3}}, lines: {sky: {clearance: true}}}")->kind, VerdictKind::fails);
}

}  // namespace taut::checks::judge_test
