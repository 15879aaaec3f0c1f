#include "taut/checks/drive/shown_loads.hpp"

#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::shown_loads_test {

TEST(ShownLoads, WhatNoStateShowsIsMissing) {
  ShownLoads loads;
  loads.show("a", {.weight = 10, .least = 1});
  loads.leave_out("b", {.weight = 10, .least = 1}, "first");
  loads.leave_out("b", {.weight = 20, .least = 1}, "second");
  const auto missing = loads.missing();
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing.at("b").words, "first");
  EXPECT_FALSE(missing.at("b").by_less);
}

TEST(ShownLoads, AHeavierMachineOrAHarderPullIsMissing) {
  const auto beside = [](const AskedLoad& asked) {
    ShownLoads loads;
    loads.leave_out("a", {.weight = 5, .least = 0.5}, "light");
    loads.leave_out("a", asked, "asked");
    loads.show("a", {.weight = 10, .least = 1});
    const auto missing = loads.missing();
    return missing.empty() ? "" : missing.at("a").words;
  };
  EXPECT_EQ(beside({.weight = 10, .least = 1}), "");
  EXPECT_EQ(beside({.weight = 10 * (1 + 1e-12), .least = 1}), "");
  EXPECT_EQ(beside({.weight = 11, .least = 0.4}), "asked");
  EXPECT_EQ(beside({.weight = 4, .least = 1.1}), "asked");
}

// Six parts of 0.97 at a drum of 0.208 m: 6.12 t at rest pull 10.0 kN, 2.08 kN m. 12.12 t lowered pull more than the
// brake of 3.5 kN m holds, in the drum's state of the smallest pull: it passed, by the rest of the light load.
Result tackle(const std::string& analyses) {
  return taut_test::run_text(R"(taut: 1
machine:
  points: {pin: [-190 mm, 0 m, 9.7 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 178 kN}}
  bodies: {hook: {mass: 120 kg, at: [0 m, 0 m, 3 m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 10 m], diameter: 400 mm, efficiency: 0.97}
    block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.97}
  drums: {winch: {at: [-6 m, 0 m, 1 m], core_diameter: 416 mm, brake_torque: 3.5 kN m}}
  reevings:
    - {rope: hoist, path: [{drum: winch}, {over: head, parts: 6, between: [head, block]}, {anchor: pin}], length: 52 m}
  loads: [{at: hook, mass: 6 t}]
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses:
)" + analyses);
}

TEST(ShownLoads, ABrakeThatHoldsALightLoadIsNotShownToHoldAHeavierOne) {
  const std::string rest = "  - equilibrium: {motion: at_rest}\n";
  const auto lowered = [](const std::string& to, const std::string& motion) {
    return "  - sweep: {parameter: 'loads[0].mass', from: 3 t, to: " + to + ", steps: 3, motion: " + motion + "}\n";
  };
  EXPECT_EQ(to_text(verdict_of(tackle(rest + lowered("6 t", "lower")))->kind), "passes");
  for (const char* const motion : {"lower", "hoist"}) {
    const Result r = tackle(rest + lowered("12 t", motion));
    EXPECT_NEAR(taut_test::check_of(r, "winch.brake_torque").value, 6120 * 9.80665 / 6 * 0.208, 10);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("winch.brake_torque is checked under less load only"), std::string::npos)
        << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("loads[0].mass = 12000 kg"), std::string::npos) << verdict_of(r)->reason;
  }
  EXPECT_EQ(to_text(verdict_of(tackle(rest + lowered("12 t", "at_rest")))->kind), "fails");
}

// Held by a torque or a pull it says nothing of its brake: 2.03 kN m on a brake of 1 kN m passed.
TEST(ShownLoads, ABrakeBesideADriveThatPullsIsNotJudged) {
  const std::string hook = "  bodies: {hook: {mass: 1 t, at: [0.2 m, 0 m, 3 m], free: [z]}}\n";
  for (const auto& [drive, end] :
       {std::pair{"{pull: 10 kN}", "{anchor: pin}]"}, {"{torque: 3 kN m}", "{anchor: hook}], length: 7 m"}}) {
    const Result r = taut_test::run_text(
        R"(taut: 1
machine:
  points: {pin: [0.2 m, 0 m, 3 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 178 kN}}
)" + (std::string(end).find("hook") == std::string::npos ? "" : hook) +
        R"(  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, brake_torque: 1 kN m, inertia: 5 kg m^2, drive: )" +
        std::string(drive) + R"(}}
  reevings: [{rope: hoist, path: [{drum: winch, side: right}, )" +
        std::string(end) + R"(}]
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses: [equilibrium: {}]
)");
    ASSERT_TRUE(verdict_of(r)) << drive << r.message << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << drive << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("winch.brake_torque is not checked"), std::string::npos);
  }
}

// W = 196 kN on four parts of 0.97: hauled in W/(0.97 + 0.97^2 + 0.97^3 + 0.97^4) = 52.88 kN, 260/52.88 = 4.92.
// Lowered, the largest has W/(1 + 0.97 + 0.97^2 + 0.97^3) = 51.30 kN, 5.07, which passed.
TEST(ShownLoads, AMotionThatOnlyLowersDoesNotShowTheRopeHauledIn) {
  const auto moved = [](const std::string& speed, const std::string& limit, const std::string& more) {
    return taut_test::run_text(R"(taut: 1
machine:
  signals: {run: {table: {t: [0 s, 0.2 s, 1.2 s, 2 s, 3 s], value: [0 m/s, 0 m/s, )" +
                               speed + ", " + speed + R"(, 0 m/s]}}}
  points: {pin: [-0.2 m, 0 m, 20 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 30 MN, breaking_force: 260 kN, damping_ratio: 0.3}}
  bodies: {hook: {mass: 20 t, at: [0 m, 0 m, 6 m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 20 m], diameter: 400 mm, efficiency: 0.97}
    block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.97}
  drums: {winch: {at: [-9 m, 0 m, 20 m], core_diameter: 380 mm, inertia: 400 kg m^2, drive: {speed: run}}}
  reevings:
    - {rope: hoist, path: [{drum: winch}, {over: head, parts: 4, between: [head, block]}, {anchor: pin}], length: 67.2 m}
checks: {ropes: {hoist: {)" + limit +
                               R"(}}}
analyses:
  - transient: {duration: 8 s, tolerance: 1e-4}
)" + more);
  };
  const Result lowered = moved("-0.2 m/s", "safety_factor: 5", "");
  EXPECT_EQ(to_text(verdict_of(lowered)->kind), "not_judged") << verdict_of(lowered)->reason;
  EXPECT_NE(verdict_of(lowered)->reason.find("only while it runs off 'winch'"), std::string::npos);
  EXPECT_EQ(to_text(verdict_of(moved("-0.2 m/s", "safety_factor: 5", "  - equilibrium: {motion: hoist}\n"))->kind),
            "fails");
  // the peak of a motion is that motion's alone
  const Result peak = moved("-0.2 m/s", "dynamic_safety_factor: 3", "");
  EXPECT_EQ(to_text(verdict_of(peak)->kind), "passes") << verdict_of(peak)->reason;
  const Result raised = moved("0.2 m/s", "safety_factor: 3", "");
  EXPECT_EQ(to_text(verdict_of(raised)->kind), "passes") << verdict_of(raised)->reason;
}

}  // namespace taut::checks::shown_loads_test
