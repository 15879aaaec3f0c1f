#include "taut/checks/drive/shown_loads.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::shown_loads_test {

constexpr double any = 0;  ///< holds nothing beyond what was shown

Situation with(double load, double x = 0) { return {.loads = {load}, .places = {{x, 0, 0}}, .extent = 100}; }
const Situation light_load = with(1), heavy_load = with(2);

TEST(ShownLoads, WhatNoStateShowsIsMissing) {
  ShownLoads loads;
  loads.show("a", light_load, 1);
  loads.leave_out("b", light_load, {.least = 1, .most = 1}, 10, "first");
  loads.leave_out("b", heavy_load, {.least = 2, .most = 2}, 10, "second");
  const auto missing = loads.missing();
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing.at("b").words, "first");
  EXPECT_FALSE(missing.at("b").by_less);
}

// Of the same machine in the same place it is not known that it asks for more, of any other not that it asks for less.
TEST(ShownLoads, WhatMayAskForMoreIsMissing) {
  const auto beside = [](const Situation& asked, const BorneAtRest& borne, double holds) {
    ShownLoads loads;
    loads.leave_out("a", light_load, {.least = 0.5, .most = 1.5}, holds, "shown");
    loads.leave_out("a", asked, borne, holds, "asked");
    loads.show("a", light_load, 1);
    const auto missing = loads.missing();
    return missing.empty() ? "" : missing.at("a").words;
  };
  EXPECT_EQ(beside(light_load, {.least = 1, .most = 2}, any), "");
  EXPECT_EQ(beside(with(1, 0.9), {.least = 1, .most = 2}, any), "");
  EXPECT_EQ(beside(with(1, 1.1), {.least = 1, .most = 2}, any), "asked");
  EXPECT_EQ(beside(with(1, 1.1), {.least = 1, .most = 2}, 2), "");
  EXPECT_EQ(beside(light_load, {.least = 1.1, .most = 2}, any), "asked");
  EXPECT_EQ(beside(light_load, {.least = 1.1, .most = 2}, 1.2), "asked") << "it bears more there than at rest";
  EXPECT_EQ(beside(heavy_load, {.least = 0.5, .most = 1}, any), "");
  EXPECT_EQ(beside(heavy_load, {.least = 0.5, .most = 1.1}, any), "asked");
  EXPECT_EQ(beside(heavy_load, {.least = 0.5, .most = 1.1}, 1.1), "");
}

TEST(ShownLoads, OfSeveralStatesTheHardestIsNamed) {
  ShownLoads loads;
  loads.show("a", light_load, 1);
  for (const auto& [words, most] : {std::pair{"x", 2.0}, {"y", 3}, {"z", 2}})
    loads.leave_out("a", heavy_load, {.least = 0, .most = most}, any, words);
  EXPECT_EQ(loads.missing().at("a").words, "y");
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

// A force that relieves the hook is another load: 2.04 kN m without it, beyond 1.95, passed by the rest with it.
TEST(ShownLoads, ALoadThatRelievesIsAnotherOne) {
  const auto relieved = [](const std::string& motion) {
    return taut_test::run_text(R"(taut: 1
machine:
  points: {pin: [-190 mm, 0 m, 9.7 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 178 kN}}
  bodies: {hook: {mass: 6 t, at: [0 m, 0 m, 3 m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 10 m], diameter: 400 mm, efficiency: 0.97}
    block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.97}
  drums: {winch: {at: [-6 m, 0 m, 1 m], core_diameter: 416 mm, brake_torque: 1.95 kN m}}
  reevings:
    - {rope: hoist, path: [{drum: winch}, {over: head, parts: 6, between: [head, block]}, {anchor: pin}], length: 52 m}
  loads: [{name: up, at: hook, force: [0 kN, 0 kN, 5 kN]}]
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses:
  - equilibrium: {motion: at_rest}
  - sweep: {parameter: 'loads.up.force[2]', from: 5 kN, to: 0 kN, steps: 2, motion: )" +
                               motion + "}\n");
  };
  EXPECT_EQ(to_text(verdict_of(relieved("lower"))->kind), "not_judged") << verdict_of(relieved("lower"))->reason;
  EXPECT_EQ(to_text(verdict_of(relieved("at_rest"))->kind), "fails");
}

// A load of 45 kN that comes on while the drum turns: 49.9 kN at 0.2 m are 10 kN m on a brake of 1.5 kN m.
TEST(ShownLoads, AMotionAsksItsBrakeForWhatItEndsWith) {
  const auto moved = [](const std::string& force) {
    return taut_test::run_text(R"(taut: 1
machine:
  signals:
    run: {constant: -0.1 m/s}
    comes: {ramp: {from: 0 kN, to: )" +
                               force + R"(, start: 1 s, duration: 1 s}}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 400 kN, damping_ratio: 0.3}}
  bodies: {hook: {mass: 0.5 t, at: [0.2 m, 0 m, 3 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 5 kg m^2, brake_torque: 1.5 kN m,
    drive: {speed: run}}}
  reevings: [{rope: hoist, path: [{drum: winch, side: right}, {anchor: hook}], length: 7 m}]
  loads: [{at: hook, force: [0 kN, 0 kN, -1 N], signal: comes}]
checks: {ropes: {hoist: {dynamic_safety_factor: 3}}}
analyses:
  - equilibrium: {motion: at_rest}
  - transient: {duration: 8 s, tolerance: 1e-3}
)");
  };
  const Result by_light = moved("1 N");
  EXPECT_EQ(to_text(verdict_of(by_light)->kind), "passes") << verdict_of(by_light)->reason;
  const Result by_heavy = moved("45 kN");
  EXPECT_EQ(to_text(verdict_of(by_heavy)->kind), "not_judged") << verdict_of(by_heavy)->reason;
  EXPECT_NE(verdict_of(by_heavy)->reason.find("winch.brake_torque"), std::string::npos) << verdict_of(by_heavy)->reason;
}

// A boom that turns about its own origin stays where it is by that: 13.1 kN at 0.2 m where it is let down, for 1.27 kN
// m where it was shown. Its brake holds 2.3 kN m.
TEST(ShownLoads, ABoomThatIsTurnedIsInAnotherPlace) {
  for (const char* const motion : {"hoist", "lower"}) {
    const Result r = taut_test::run_text(R"(taut: 1
machine:
  points: {pin: [0 m, 0 m, 10.3 m]}
  ropes: {luff: {mass: 0 kg/m, stiffness: 30 MN, breaking_force: 600 kN}}
  bodies: {boom: {mass: 2 t, at: [0 m, 0 m, 0 m], centre: [5 m, 0 m, 0 m], free: [ry]}}
  sheaves:
    head: {at: [0 m, 0 m, 10 m], diameter: 400 mm, efficiency: 0.9}
    tip: {body: boom, at: [10 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.9}
  drums: {w: {at: [-6 m, 0 m, 0 m], core_diameter: 400 mm, brake_torque: 2.3 kN m}}
  reevings: [{rope: luff, path: [{drum: w}, {over: head, parts: 4, between: [head, tip]}, {anchor: pin}], length: 40 m}]
  loads: [{name: hang, at: tip, mass: 3 t}]
checks: {ropes: {luff: {safety_factor: 3}}}
analyses:
  - equilibrium: {motion: at_rest}
  - sweep: {parameter: 'reevings[0].length', from: 40 m, to: 68 m, steps: 28, motion: )" +
                                         std::string(motion) + "}\n");
    ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("w.brake_torque"), std::string::npos) << verdict_of(r)->reason;
  }
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

}  // namespace taut::checks::shown_loads_test
