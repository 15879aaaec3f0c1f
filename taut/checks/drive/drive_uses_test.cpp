#include "taut/checks/drive/drive_uses.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Drives count in every analysis.
namespace taut::drive_uses_test {

using taut_test::run_text;

/// A belt over a driven sheave and a tail sheave that a weight pulls; a brake holds the belt back.
std::string belt(const std::string& analyses) {
  return R"(taut: 1
machine:
  ropes: {belt: {mass: 0.6 kg/m, stiffness: 0.65 MN, breaking_force: 60 kN}}
  bodies: {slide: {mass: 85 kg, at: [9 m, 0 m, 0 m], free: [x]}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 500 mm, friction: 0.2, inertia: 4 kg m^2, motor: {speed: 3 m/s}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 500 mm, efficiency: 0.95, inertia: 2 kg m^2}
  take_up: [{body: slide, weight: 300 kg, along: [1, 0, 0]}]
  reevings: [{rope: belt, path: [{over: drive, side: left}, {over: tail, side: left}], closed: true, length: 19.53 m}]
  rope_loads: [{name: cut, rope: belt, between: [tail, drive], rate: 60 N/m, from: 0.2, to: 0.7}]
checks: {ropes: {belt: {safety_factor: 3}}}
analyses: [)" +
         analyses + "]\n";
}

Verdict judged(const std::string& analyses) {
  const Result r = run_text(belt(analyses));
  EXPECT_TRUE(verdict_of(r)) << to_text(r.errors);
  return verdict_of(r).value_or(Verdict{});
}

TEST(DriveUses, AGripThatFailsInAnyStateFails) {
  EXPECT_EQ(to_text(judged("equilibrium: {motion: in}").kind), "passes") << judged("equilibrium: {motion: in}").reason;
  const std::string sweep = "{parameter: \"rope_loads[0].rate\", from: 60 N/m, to: 400 N/m, steps: 4, motion: in}";
  const Verdict swept = judged("equilibrium: {motion: in}, sweep: " + sweep);
  EXPECT_EQ(to_text(swept.kind), "fails") << swept.reason;
  EXPECT_NE(swept.reason.find("drive.grip"), std::string::npos) << swept.reason;
  EXPECT_NE(swept.reason.find("sweep"), std::string::npos) << swept.reason;
}

TEST(DriveUses, ADrivenSheaveWithoutFrictionIsNotJudged) {
  for (const char* analyses : {"equilibrium: {motion: in}", "transient: {duration: 0.2 s, tolerance: 1e-3}"}) {
    std::string text = belt(analyses);
    text.erase(text.find(" friction: 0.2,"), 15);
    const Result r = run_text(text);
    ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("drive.grip is not checked"), std::string::npos) << verdict_of(r)->reason;
    EXPECT_TRUE(run_text(text.substr(0, text.find("checks:"))).unmade.empty()) << "no verdict is asked for";
    const Result arc = run_text(text, {"machine.sheaves.drive.motor.working_arc=170 deg"});
    ASSERT_EQ(arc.errors.size(), 1U);
    EXPECT_NE(arc.errors[0].message.find("needs the 'friction' of the sheave"), std::string::npos);
  }
}

TEST(DriveUses, AnAnalysisThatIsNotJudgedDoesNotCount) {
  const Verdict v = judged(
      "equilibrium: {motion: in}, sweep: {parameter: \"rope_loads[0].rate\", from: 60 N/m, to: 400 N/m, steps: 4, "
      "motion: in, judge: false}");
  EXPECT_EQ(to_text(v.kind), "passes") << v.reason;
}

TEST(DriveUses, ARopeThatSlipsInAMotionFails) {
  const std::string slow = "transient: {duration: 0.5 s, output_step: 10 ms, tolerance: 1e-3}";
  const Result r = run_text(belt(slow), {"machine.rope_loads[0].rate=450 N/m"});
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "fails") << verdict_of(r)->reason;
  ASSERT_FALSE(r.unsafe.empty());
  EXPECT_NE(r.unsafe.front().find("the rope slips on 'drive'"), std::string::npos) << r.unsafe.front();
}

/// A hoist that winds 19 m at its speed onto a drum that has 12 m on it: 13.1 m to a layer, three layers within flanges
/// of 510 mm.
std::string hoist(const std::string& analyses, const std::string& flanges) {
  return R"(taut: 1
machine:
  points: {end: [1 m, 0 m, 30 m]}
  signals: {up: {ramp: {to: 2 m/s, start: 0 s, duration: 1 s, smooth: true}}}
  ropes: {line: {rope: "EN 12385-4|6x36-IWRC|16|1960", stiffness: 12 MN, damping_ratio: 0.05}}
  bodies: {block: {mass: 2 t, at: [1.2 m, 0 m, 0 m], free: [x, z]}}
  sheaves:
    head: {at: [1.4 m, 0 m, 30 m], diameter: 400 mm}
    hook: {body: block, at: [0 m, 0 m, 0 m], diameter: 400 mm}
  drums:
    winch: {at: [-8 m, 0 m, 2 m], core_diameter: 400 mm, face_width: 160 mm, flange_diameter: )" +
         flanges + R"(, length_on_drum: 12 m, layers: auto, drive: {speed: up}}
  reevings: [{rope: line, path: [{drum: winch}, {over: head}, {over: hook}, {anchor: end}], length: 102 m}]
checks: {ropes: {line: {field: crane_running, class: M1, drum: grooved, rated_pull: 30 kN}}}
analyses: [)" +
         analyses + "]\n";
}

TEST(DriveUses, WhatLiesOnADrumCountsAtEveryMoment) {
  const std::string rest = "equilibrium: {motion: hoist}", motion = "transient: {duration: 10 s, output_step: 10 s}";
  const std::string both = fmt::format("{{{}}}, {{{}}}", rest, motion);
  for (const std::string& analyses : {motion, both}) {
    const Result r = run_text(hoist(analyses, "800 mm"));
    ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "passes") << verdict_of(r)->reason;
    EXPECT_NEAR(taut_test::check_of(r, "winch.capacity").value, 12 + 19, 0.02);
    EXPECT_EQ(taut_test::check_of(r, "line.drum_layers").value, 3);
    EXPECT_NEAR(taut_test::check_of(r, "line.last_layer_pull").limit, 30e3 * 416 / (416 + 4 * 16), 1e-6);
    EXPECT_TRUE(taut_test::has_check(r, "line.fleet_angle"));
    EXPECT_TRUE(taut_test::has_check(r, "line.drum_ratio"));
  }
  const Result full = run_text(hoist(both, "470 mm"));
  EXPECT_EQ(to_text(verdict_of(full)->kind), "fails") << verdict_of(full)->reason;
  EXPECT_FALSE(taut_test::check_of(full, "winch.capacity").passes);
  EXPECT_NE(taut_test::check_of(full, "winch.capacity").where.find("transient, t = "), std::string::npos);
}

/// 60 m of 16 mm on a core of 400 mm within flanges of 420 mm: not one layer. Without the face nobody can tell.
TEST(DriveUses, AFlangeWithoutAFaceIsNotJudged) {
  const auto lift = [](const std::string& drum) {
    return run_text(R"(taut: 1
machine:
  ropes: {line: {rope: "EN 12385-4|6x36-IWRC|16|1960", stiffness: 12 MN}}
  bodies: {load: {mass: 2 t, at: [0.2 m, 0 m, -10 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 0 m], flange_diameter: 420 mm, )" +
                    drum + R"(}}
  reevings: [{rope: line, path: [{drum: winch}, {anchor: load}], length: 10 m}]
checks: {ropes: {line: {safety_factor: 4}}}
)");
  };
  const std::string core = "core_diameter: 400 mm", face = ", face_width: 500 mm", rope = ", length_on_drum: 60 m";
  const Result full = lift(core + face + rope);
  EXPECT_EQ(to_text(verdict_of(full)->kind), "fails") << verdict_of(full)->reason;
  EXPECT_FALSE(taut_test::check_of(full, "winch.capacity").passes);
  EXPECT_EQ(taut_test::check_of(full, "winch.capacity").limit, 0);
  EXPECT_EQ(taut_test::check_of(full, "winch.capacity").value, 60);
  EXPECT_EQ(taut_test::check_of(full, "winch.capacity").rule.find("together"), std::string::npos);
  for (const auto& [drum, words] : {std::pair{core + rope, "give its 'face_width'"},
                                    {core, "give its 'face_width'"},
                                    {core + face, "give its 'length_on_drum'"},
                                    {core + ", face_width: 10 mm" + rope, "thicker than the face is wide"}}) {
    const Result r = lift(drum);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find(words), std::string::npos) << verdict_of(r)->reason;
  }
}

/// Two ropes hold a weight each from one winch: its motor pulls both where they are wound the same way.
TEST(DriveUses, TheWinchPullsAllRopesOfItsDrum) {
  const auto winch = [](const std::string& second) {
    return run_text(R"(taut: 1
machine:
  ropes:
    line: {rope: "EN 12385-4|6x36-IWRC|16|1960", mass: 0 kg/m, stiffness: 12 MN}
    other: {rope: "EN 12385-4|6x36-IWRC|16|1960", mass: 0 kg/m, stiffness: 12 MN}
  bodies:
    left: {mass: 2 t, at: [0.4 m, 0 m, -20 m], free: [z]}
    right: {mass: 3 t, at: [)" +
                    second + R"( m, 0 m, -20 m], free: [z]}
  drums: {winch: {at: [0 m, 0 m, 0 m], axis: [0, 1, 0], core_diameter: 784 mm, face_width: 160 mm, length_on_drum: 12 m, layers: auto}}
  reevings:
    - {rope: line, path: [{drum: winch}, {anchor: left}], length: 20 m}
    - {rope: other, path: [{drum: winch}, {anchor: right}], length: 20 m}
checks: {ropes: {line: {running: stands, rated_pull: 30 kN}, other: {running: stands, rated_pull: 60 kN}}}
analyses: [{equilibrium: {}}]
)");
  };
  const Result r = winch("0.4");
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  EXPECT_NEAR(taut_test::check_of(r, "line.last_layer_pull").value, 5 * 9806.65, 0.1);
  EXPECT_FALSE(taut_test::check_of(r, "line.last_layer_pull").passes);
  EXPECT_NEAR(taut_test::check_of(r, "other.last_layer_pull").value, 5 * 9806.65, 0.1);
  EXPECT_NE(taut_test::check_of(r, "line.last_layer_pull").rule.find("its other ropes"), std::string::npos);
  const Result against = winch("-0.4");
  EXPECT_NEAR(taut_test::check_of(against, "line.last_layer_pull").value, 2 * 9806.65, 0.1);
  EXPECT_NEAR(taut_test::check_of(against, "other.last_layer_pull").value, 3 * 9806.65, 0.1);
}

/// A load of 20 kN that comes 0.5 s after the start and stays. Beside it lies a rope with both ends on the drum, one
/// wound as the rope of the load: 1 t g + 20 kN + 1 t g/2.
TEST(DriveUses, TheWinchPullsAllRopesForAsLongAsTheyLast) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes:
    line: {mass: 0 kg/m, stiffness: 12 MN, breaking_force: 300 kN, diameter: 16 mm, damping_ratio: 0.3}
    both: {mass: 0 kg/m, stiffness: 12 MN, breaking_force: 300 kN, diameter: 16 mm, damping_ratio: 0.3}
  signals: {more: {ramp: {to: 20 kN, start: 0.5 s, duration: 0.5 s}}}
  bodies:
    weight: {mass: 1 t, at: [0.4 m, 0 m, -20 m], free: [z]}
    block: {mass: 1 t, at: [0 m, 0 m, -20 m], free: [z]}
  sheaves: {pulley: {body: block, at: [0 m, 0 m, 0 m], diameter: 800 mm}}
  loads: [{at: weight, force: [0 N, 0 N, -1 N], signal: more}]
  drums: {winch: {at: [0 m, 0 m, 0 m], core_diameter: 784 mm, face_width: 160 mm, length_on_drum: 12 m, layers: auto}}
  reevings:
    - {rope: line, path: [{drum: winch}, {anchor: weight}], length: 20 m}
    - {rope: both, path: [{drum: winch}, {over: pulley}, {drum: winch}], length: 41.3 m}
checks: {ropes: {line: {running: stands, rated_pull: 90 kN}, both: {running: stands, rated_pull: 90 kN}}}
analyses: [{transient: {duration: 8 s}}]
)");
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  for (const char* name : {"line.last_layer_pull", "both.last_layer_pull"})
    EXPECT_NEAR(taut_test::check_of(r, name).value, 1.5 * 9806.65 + 20e3, 50) << name;
}

/// 120 m of rope reach layer 5 of the drum, whether two copies, two ropes or one rope bring them there.
TEST(DriveUses, TheTorqueIsThatOfTheLayerThatAllRopesReach) {
  const auto lift = [](const std::string& on_drum, const std::string& reevings, const std::string& analysis) {
    return run_text(R"(taut: 1
machine:
  bodies: {load: {mass: 1 t, at: [0.3 m, 0 m, 0 m], free: [x, z]}}
  ropes: {r: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm, damping_ratio: 0.3}}
  signals: {up: {ramp: {to: 1 m/s, start: 0 s, duration: 1 s}}}
  drums:
    w: {at: [0 m, 0 m, 20 m], core_diameter: 300 mm, face_width: 400 mm, flange_diameter: 700 mm, layers: auto,
        length_on_drum: )" +
                    on_drum + ", brake_torque: 2.2 kN m, inertia: 5 kg m^2" +
                    (analysis == "transient" ? ", drive: {speed: up}" : "") + "}\n  reevings:\n" + reevings +
                    "analyses: [{" + analysis + (analysis == "transient" ? ": {duration: 3 s}" : ": {}") + "}]\n");
  };
  const std::string path = "path: [{drum: w}, {anchor: load}], length: 15 m}\n";
  const std::string two = "    - {rope: r, copies: 2, " + path;
  const std::string each = "    - {rope: r, name: r1, " + path + "    - {rope: r, name: r2, " + path;
  const std::string one = "    - {rope: r, " + path;
  const double torque = 1000 * 9.80665 * (0.15 + 4.5 * 0.02);
  for (const auto& [on_drum, reevings] : {std::pair{"60 m", two}, std::pair{"60 m", each}, std::pair{"120 m", one}}) {
    const Result r = lift(on_drum, reevings, "equilibrium");
    ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
    EXPECT_NEAR(taut_test::check_of(r, "w.brake_torque").value, torque, 0.1) << on_drum << reevings;
    EXPECT_EQ(to_text(verdict_of(r)->kind), "fails");
  }
  // in motion two copies and two ropes climb onto the next layer together
  const Result copies = lift("62 m", two, "transient"), ropes = lift("62 m", each, "transient");
  ASSERT_TRUE(verdict_of(copies)) << to_text(copies.errors);
  EXPECT_GT(taut_test::value_of(copies, "load.x_end"), 0.15 + 5 * 0.02) << "layer 6 from 125.6 m on";
  for (const char* name : {"load.x_end", "load.z_end"})
    EXPECT_NEAR(taut_test::value_of(copies, name), taut_test::value_of(ropes, name), 1e-4) << name;
}

/// A mainline that hauls its carriage from 248 m to 20 m: it has 40 m on its drum, and 20 turns to a layer of 12 mm.
TEST(DriveUses, WhatLiesOnADrumCountsAtEveryPlaceOfALine) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 20 m], tail: [300 m, 0 m, 10 m]}
  ropes:
    skyline: {rope: "EN 12385-4|6x36-IWRC|20|1960", stiffness: 20 MN}
    mainline: {rope: "EN 12385-4|6x36-IWRC|12|1960", stiffness: 7 MN}
  drums: {winch: {at: [-1 m, 0 m, 19 m], core_diameter: 300 mm, face_width: 240 mm, length_on_drum: 40 m, layers: auto}}
  carriages: {car: {mass: 1350 kg, rides: skyline, hold: rolling, mainline: mainline, at: [250 m, 0 m, 9 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], tension_at_start: 60 kN}
    - {rope: mainline, path: [{drum: winch}, {anchor: car}], length: 253 m}
analyses: [{load_path: {carriage: car, from: 160 m, to: 20 m, steps: 4, motion: in}}]
checks: {ropes: {skyline: {safety_factor: 3}, mainline: {safety_factor: 3, drum: grooved}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  // 253 m less 21 m, and 40 m: ten layers have 264 m, eleven 298 m
  EXPECT_EQ(taut_test::check_of(r, "mainline.drum_layers").value, 11);
}

/// 1 t at 0.2 m: 1.96 kN m.
TEST(DriveUses, ABrakeHasToHoldTheLoadAtRest) {
  const auto at_rest = [](const std::string& drive, const std::string& motion) {
    return run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [x, z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, )" +
                    drive + R"(}}
  reevings: [{rope: line, path: [{drum: winch, side: left}, {anchor: load}], length: 9.5 m}]
checks: {ropes: {line: {safety_factor: 4}}}
analyses: [{equilibrium: {motion: )" +
                    motion + "}}]\n");
  };
  const Result holds = at_rest("inertia: 5 kg m^2, brake_torque: 2 kN m", "at_rest");
  EXPECT_NEAR(taut_test::check_of(holds, "winch.brake_torque").value, 1e3 * 9.80665 * 0.2, 1e-6);
  EXPECT_EQ(to_text(verdict_of(holds)->kind), "passes") << verdict_of(holds)->reason;
  const Result slips = at_rest("inertia: 5 kg m^2, brake_torque: 1.9 kN m", "at_rest");
  EXPECT_EQ(to_text(verdict_of(slips)->kind), "fails") << verdict_of(slips)->reason;
  EXPECT_FALSE(
      taut_test::has_check(at_rest("inertia: 5 kg m^2, brake_torque: 1.9 kN m", "hoist"), "winch.brake_torque"));
  EXPECT_FALSE(taut_test::has_check(at_rest("drive: {torque: 1.9 kN m}", "at_rest"), "winch.brake_torque"));
}

/// A drum of 0.2 m and 12 m of rope that lets out 10 m: 2.03 m are 1.55 turns of 1.31 m.
TEST(DriveUses, FewerThanTwoTurnsLeftOnADrumAreUnsafe) {
  const auto lowered = [](const std::string& more) {
    return run_text(
        hoist("transient: {duration: 10 s, output_step: 10 s}", "800 mm"),
        {"machine.signals.up.ramp.to=-" + more, "machine.bodies.block.at[2]=15 m", "machine.reevings[0].length=72 m"});
  };
  EXPECT_TRUE(lowered("0.9 m/s").unsafe.empty());
  const Result r = lowered("1.05 m/s");
  ASSERT_EQ(r.unsafe.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("1.6 turns are left on 'winch'; at least 2"), std::string::npos) << r.unsafe[0];
  EXPECT_NE(r.unsafe[0].find("t = 10 s"), std::string::npos) << r.unsafe[0];
}

/// A drum that lets out 0.1 m/s until its brake is set at 0.5 s: 9.8 kN at 0.2 m are 1.96 kN m.
TEST(DriveUses, ABrakeThatDoesNotHoldIsUnsafe) {
  const auto braked = [](const std::string& torque, const std::string& duration) {
    return run_text(R"(taut: 1
machine:
  signals: {out: {ramp: {to: -0.1 m/s, start: 0 s, duration: 0.1 s}}}
  ropes: {line: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN, damping_ratio: 0.1}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [x, z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 5 kg m^2, drive: {speed: out}, brake_torque: )" +
                    torque + R"(}}
  events: [{at: 0.5 s, brake: winch}]
  reevings: [{rope: line, path: [{drum: winch}, {anchor: load}], length: 9.5 m}]
checks: {ropes: {line: {safety_factor: 4}}}
analyses: [{transient: {tolerance: 1e-4, duration: )" +
                    duration + "}}]\n");
  };
  const Result holds = braked("2.4 kN m", "2 s");
  EXPECT_TRUE(holds.unsafe.empty()) << holds.unsafe.front();
  EXPECT_EQ(to_text(verdict_of(holds)->kind), "passes") << verdict_of(holds)->reason;
  for (const Result& turns : {braked("1.8 kN m", "2 s"), braked("2.4 kN m", "0.503 s")}) {
    ASSERT_EQ(turns.unsafe.size(), 1U) << turns.message << to_text(turns.errors);
    EXPECT_NE(turns.unsafe[0].find("'winch' still turns when the motion ends"), std::string::npos) << turns.unsafe[0];
    EXPECT_EQ(to_text(verdict_of(turns)->kind), "passes_with_warnings");
  }
}

TEST(DriveUses, ABrakeThatIsSetFromTheStartHasNoTime) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {brake: set},
    brake_torque: 1.5 kN m}}
  reevings: [{rope: line, path: [{drum: winch, side: right}, {anchor: load}], length: 10 m}]
checks: {ropes: {line: {safety_factor: 4}}}
analyses: [{transient: {duration: 1 s}}]
)");
  ASSERT_EQ(r.unsafe.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("though its brake is set from the start"), std::string::npos) << r.unsafe[0];
}

// 6 t on two ropes of one drum of 0.2 m: each pulls 5.88 kN m, both 11.77. Wound the other way one holds the other.
TEST(DriveUses, ABrakeHoldsAllRopesOfItsDrum) {
  const auto two = [](const std::string& right, const std::string& copies) {
    return run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 178 kN}}
  bodies: {hook: {mass: 6 t, at: [0 m, 0 m, 3 m], free: [x, z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 50 kg m^2, brake_torque: 7 kN m, drive: {brake: set}}}
  reevings:
    - {rope: hoist, name: left, path: [{drum: winch}, {anchor: hook}], length: 7 m)" +
                    copies + "}\n" + right + R"(
analyses: [{equilibrium: {motion: at_rest}}]
checks: {ropes: {hoist: {safety_factor: 5}}}
)");
  };
  const double torque = 6e3 * 9.80665 * 0.2;
  const std::string right = "    - {rope: hoist, name: right, path: [{drum: winch}, {anchor: hook}], length: 7 m}";
  EXPECT_NEAR(taut_test::check_of(two(right, ""), "winch.brake_torque").value, torque, 1e-5 * torque);
  EXPECT_NEAR(taut_test::check_of(two("", ", copies: 2"), "winch.brake_torque").value, torque, 1e-5 * torque);
  const Result against =
      two("    - {rope: hoist, name: right, path: [{drum: winch, side: left}, {anchor: hook}], length: 7 m}", "");
  ASSERT_EQ(against.status, Status::ok) << against.message << to_text(against.errors);
  EXPECT_LT(taut_test::check_of(against, "winch.brake_torque").value, 0.1 * torque);
}

/// An endless rope of 36 kN over a driving sheave that stands: (18 + 3)/(18 - 3) = 1.4 is more than exp(0.1 pi) = 1.37.
TEST(DriveUses, SlipOnAStandingSheaveIsUnsafeWhateverTheOutputs) {
  const auto pulled = [](const std::string& force, const std::string& output) {
    return run_text(R"(taut: 1
machine:
  signals: {train: {ramp: {to: )" +
                    force + R"(, start: 0.2 s, duration: 1 s, smooth: true}}}
  ropes: {haul: {mass: 1 kg/m, breaking_force: 200 kN, stiffness: 13 MN, damping_ratio: 0.03}}
  bodies: {slide: {mass: 900 kg, at: [0 m, 0 m, 1 m], free: [x]}}
  sheaves:
    head: {at: [120 m, 0 m, 1 m], diameter: 1200 mm, friction: 0.1, inertia: 60 kg m^2, motor: {speed: 0 m/s}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 1200 mm, inertia: 60 kg m^2}
  loads: [{at: slide, force: [-36 kN, 0 kN, 0 kN]}]
  reevings: [{name: loop, rope: haul, path: [{over: head, side: left}, {over: tail, side: left}], closed: true, length: 243.5 m}]
  rope_loads: [{name: cars, rope: loop, between: [tail, head], tangential: 0 kN, signal: train, direction: along_path}]
checks: {ropes: {haul: {safety_factor: 3}}}
analyses: [{transient: {duration: 2 s, tolerance: 1e-3, output_step: )" +
                    output + "}}]\n");
  };
  for (const char* output : {"20 ms", "2 s"}) {
    const Result slips = pulled("7 kN", output);
    ASSERT_EQ(slips.unsafe.size(), 1U) << slips.message << to_text(slips.errors);
    EXPECT_NE(slips.unsafe[0].find("the rope slips on 'head' by "), std::string::npos) << slips.unsafe[0];
    EXPECT_TRUE(pulled("4 kN", output).unsafe.empty());
  }
}

/// A brake that holds 16 kN of rope; 1 t hangs on it, and 15 kN pull for a second.
TEST(DriveUses, ABrakeThatSlipsForAWhileIsUnsafe) {
  const auto pulled = [](const std::string& force) {
    return run_text(R"(taut: 1
machine:
  signals: {F: {table: {t: [0 s, 1 s, 1.5 s, 2.5 s, 3 s, 10 s], value: [0 kN, 0 kN, FORCE, FORCE, 0 kN, 0 kN]}}}
  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}
  bodies: {cage: {mass: 1 t, at: [0.5 m, 0 m, -20 m], free: [z]}}
  drums: {w: {at: [0 m, 0 m, 0 m], core_diameter: 1000 mm, inertia: 500 kg m^2, drive: {brake: set}, brake_torque: 8 kN m}}
  loads: [{at: cage, force: [0 kN, 0 kN, -1 kN], signal: F}]
  reevings: [{rope: r, path: [{drum: w}, {anchor: cage}], length: 20 m}]
checks: {ropes: {r: {safety_factor: 5}}}
analyses: [{transient: {duration: 8 s, output_step: 0.5 s, tolerance: 1e-3}}]
)",
                    {"machine.signals.F.table.value[2]=" + force, "machine.signals.F.table.value[3]=" + force});
  };
  EXPECT_TRUE(pulled("2 kN").unsafe.empty());
  // while it stands in its brake that holds the pull of the moment: 1.02 t and 4 kN at 0.5 m are 7 kN m
  const Check holds = taut_test::check_of(pulled("4 kN"), "w.brake_torque");
  EXPECT_NEAR(holds.value, (1020 * 9.80665 + 4000) / 2, 250) << holds.where;
  EXPECT_TRUE(holds.passes);
  const Result r = pulled("15 kN");
  const std::string slips = "'w' slips in its brake, which is set and had stopped it, by 7.";
  EXPECT_TRUE(std::any_of(r.unsafe.begin(), r.unsafe.end(),
                          [&](const std::string& words) { return words.find(slips) != std::string::npos; }))
      << r.message << to_text(r.errors);
}

/// A boom on a cylinder that stands: 4 t at 6 m and 2 t at 3 m need 147 kN at a lever of 2 m.
/// 12 m on a drum that takes 39.4 m: two copies of it need twice as much of that.
TEST(DriveUses, ADrumTakesAllCopies) {
  const auto used = [](const std::string& copies) {
    return taut_test::check_of(
        run_text(hoist("equilibrium: {motion: at_rest}", "800 mm"), {"machine.reevings[0].copies=" + copies}),
        "winch.capacity");
  };
  EXPECT_NEAR(used("2").value, 2 * used("1").value, 1e-9);
  EXPECT_EQ(used("2").limit, used("1").limit);
}

// A brake is judged where its drum stands: a deck that only hoists leaves it out, and says so.
TEST(DriveUses, ABrakeNeedsAStateAtRest) {
  const auto judged = [](const std::string& analyses) {
    return verdict_of(run_text(R"(taut: 1
machine:
  ropes: {w: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  sheaves: {s1: {at: [0 m, 0 m, 10 m], diameter: 800 mm}}
  bodies: {load: {mass: 4 t, at: [0.4 m, 0 m, 2 m], free: [x, z]}}
  drums: {winch: {at: [-10 m, 0 m, 0 m], core_diameter: 400 mm, brake_torque: 1 kN m, inertia: 10 kg m^2}}
  reevings: [{rope: w, path: [{drum: winch}, {over: s1}, {anchor: load}], length: 20 m}]
checks: {ropes: {w: {safety_factor: 3}}}
analyses: [)" + analyses + "]\n"))
        .value_or(Verdict{});
  };
  const Verdict hoists = judged("equilibrium: {motion: hoist}");
  EXPECT_EQ(to_text(hoists.kind), "not_judged") << hoists.reason;
  EXPECT_NE(hoists.reason.find("winch.brake_torque is not checked"), std::string::npos) << hoists.reason;
  EXPECT_EQ(to_text(judged("equilibrium: {}, equilibrium: {name: up, motion: hoist}").kind), "fails");
  // a motion holds a drum without a drive whatever it takes: 4 t at 0.2 m are 7.8 kN m, at a brake of 1 kN m
  const Verdict held = judged("transient: {duration: 0.2 s, output_step: 0.1 s, tolerance: 1e-3}");
  EXPECT_EQ(to_text(held.kind), "fails") << held.reason;
  EXPECT_NE(held.reason.find("winch.brake_torque"), std::string::npos) << held.reason;
}

// The brake of a drum in its third layer has more to hold than in the first one, with which the machine is calculated.
TEST(DriveUses, ALayerThatTheRopePassesIsNotJudged) {
  const auto run = [](const std::string& drum) {
    return run_text(R"(taut: 1
machine:
  ropes: {w: {diameter: 20 mm, mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  sheaves: {s1: {at: [0 m, 0 m, 10 m], diameter: 800 mm}}
  bodies: {load: {mass: 4 t, at: [0.4 m, 0 m, 2 m], free: [x, z]}}
  drums: {winch: {at: [-10 m, 0 m, 0 m], core_diameter: 400 mm, face_width: 400 mm, flange_diameter: 700 mm,
    length_on_drum: 79 m, inertia: 10 kg m^2)" +
                    drum + R"(}}
  reevings: [{rope: w, path: [{drum: winch}, {over: s1}, {anchor: load}], length: 20 m}]
checks: {ropes: {w: {safety_factor: 3}}}
)");
  };
  const std::string brake = ", brake_torque: 9 kN m";
  const Result first = run(brake);
  EXPECT_EQ(to_text(verdict_of(first)->kind), "not_judged") << first.message << to_text(first.errors);
  EXPECT_NE(verdict_of(first)->reason.find("winch.brake_torque is not checked in layer 3"), std::string::npos)
      << verdict_of(first)->reason;
  EXPECT_EQ(to_text(verdict_of(run(", brake_torque: 8 kN m"))->kind), "fails") << "in layer 1 already";
  EXPECT_EQ(to_text(verdict_of(run(", drive: {torque: 9 kN m}"))->kind), "not_judged");
  const Result layers = run(brake + ", layers: auto");
  EXPECT_TRUE(layers.unmade.empty());
  EXPECT_EQ(to_text(verdict_of(layers)->kind), "fails");  // 39.2 kN x 0.25 m over 9 kN m
  // without a limit of its torque nothing is judged by it
  const Result free = run("");
  ASSERT_EQ(free.unsafe.size(), 1U) << free.message << to_text(free.errors);
  EXPECT_NE(free.unsafe[0].find("reaches layer 3"), std::string::npos) << free.unsafe[0];
}

/// A winch whose rope lies at 0.207 m; `drum`: how it is driven and braked, `more`: signals and events.
Result braked_winch(const std::string& mass, const std::string& drum, const std::string& more,
                    const std::string& duration) {
  return run_text(R"(taut: 1
machine:
  gravity: 9.81 m/s^2
  ropes: {hoist: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 600 kN, damping_ratio: 0.1, diameter: 14 mm}}
  bodies: {load: {mass: )" +
                  mass + R"(, at: [0.2 m, 0 m, 4 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 30 m], core_diameter: 400 mm, inertia: 50 kg m^2, )" +
                  drum + R"(}}
  reevings: [{rope: hoist, path: [{drum: winch}, {anchor: load}], length: 26 m}]
)" + more + R"(
checks: {ropes: {hoist: {safety_factor: 4, dynamic_safety_factor: 1.5, diameter_ratio: [10, 10]}}}
analyses: [{transient: {output_step: 10 ms, tolerance: 1e-4, duration: )" +
                  duration + "}}]\n");
}

// 0.5 t and for a while 20 kN more: (4.9 + 20) 0.207 = 5.16 kN m and a little by the swing. A brake that is set later,
// or never, holds nothing before.
TEST(DriveUses, ABrakeHoldsNothingBeforeItIsSet) {
  const std::string pull = R"(
  signals:
    f: {sequence: [{at: 0.5 s, to: 20 kN, over: 0.5 s, smooth: true}, {at: 3 s, to: 1 kN, over: 0.5 s, smooth: true}]}
  loads: [{at: load, force: [0 kN, 0 kN, -1 kN], signal: f}])";
  const std::string drum = "brake_torque: 2 kN m";
  for (const char* events :
       {"", "\n  events: [{at: 5 s, brake: winch}]", "\n  events: [{when: \"load.z > 20 m\", brake: winch}]"}) {
    const Result r = braked_winch("0.5 t", drum, pull + events, "6 s");
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "fails") << events << verdict_of(r)->reason;
    EXPECT_NEAR(taut_test::check_of(r, "winch.brake_torque").value, 5.4e3, 0.2e3) << events;
  }
  // one that is set before the pull is judged by its slip
  const Result set = braked_winch("0.5 t", drum, pull + "\n  events: [{at: 0.1 s, brake: winch}]", "6 s");
  EXPECT_TRUE(taut_test::check_of(set, "winch.brake_torque").passes);
  ASSERT_FALSE(set.unsafe.empty());
  EXPECT_NE(set.unsafe[0].find("slips in its brake"), std::string::npos) << set.unsafe[0];
}

// 1.5 t at 0.207 m are 3.05 kN m: more than the brake of 2.5 kN m, in which the rope runs faster and faster.
TEST(DriveUses, ABrakeThatIsReleasedBeforeItHasStoppedTheDrumIsUnsafe) {
  const auto braked = [](const std::string& torque, const std::string& release) {
    return braked_winch("1.5 t", "drive: {speed: lowering}, brake_torque: " + torque, R"(
  signals: {lowering: {ramp: {to: -0.8 m/s, start: 0.2 s, duration: 0.8 s}}}
  events: [{at: 2 s, brake: winch}, {at: )" + release + ", brake: winch, mode: open}]",
                        "6 s");
  };
  const auto told = [](const Result& one, const char* what) {
    return std::any_of(one.unsafe.begin(), one.unsafe.end(),
                       [&](const std::string& text) { return text.find(what) != std::string::npos; });
  };
  const Result r = braked("2.5 kN m", "4 s");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(told(r, "t = 4 s: the brake of 'winch' is released, or set anew, before it has stopped the drum"));
  EXPECT_NEAR(taut_test::check_of(r, "winch.brake_torque").value, 1.5e3 * 9.81 * 0.207, 5)
      << "at the start, where it stands";
  // (4.5 - 3.05)/0.207 over 1500 kg + 50/0.207^2 stop 0.8 m/s in 0.31 s
  EXPECT_TRUE(braked("4.5 kN m", "4 s").unsafe.empty());
  EXPECT_EQ(to_text(verdict_of(braked("4.5 kN m", "4 s"))->kind), "passes");
  EXPECT_TRUE(told(braked("4.5 kN m", "2.2 s"), "t = 2.2 s: the brake of 'winch' is released"));
}

// A drum that hoists 26 m and stands: 1 t on its third layer of 0.25 m are 2.45 kN m, on its first 1.96 (and 2.06 with
// half a rope).
TEST(DriveUses, ABrakeHoldsWhereTheMotionHasLeftTheDrum) {
  const auto hoist_to = [](const std::string& end, const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  gravity: 9.81 m/s^2
  signals: {v: {sequence: [{at: 0 s, to: 2 m/s, over: 1 s, smooth: true}, {at: )" +
                    end + R"(, to: 0 m/s, over: 1 s, smooth: true}]}}
  ropes: {r: {mass: 0 kg/m, stiffness: 40 MN, breaking_force: 380 kN, damping_time: 3 ms, diameter: 20 mm}}
  bodies: {m: {mass: 1 t, at: [0.21 m, 0 m, 5 m], free: [x, z]}}
  drums:
    w: {at: [0 m, 0 m, 40 m], core_diameter: 400 mm, inertia: 10 kg m^2, drive: {speed: v}, layers: auto,
        length_on_drum: 10 m, face_width: 200 mm, flange_diameter: 900 mm, brake_torque: 2.15 kN m}
  reevings: [{name: a, rope: r, path: [{drum: w}, {anchor: m}], length: 35 m}]
checks: {ropes: {r: {dynamic_safety_factor: 3, safety_factor: 3, diameter_ratio: [10, 10]}}}
analyses: [)" + analyses +
                    "{transient: {duration: 20 s, output_step: 100 ms, tolerance: 1e-5}}]\n");
  };
  for (const char* analyses : {"", "{equilibrium: {}}, "}) {
    const Result r = hoist_to("14 s", analyses);
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "fails") << verdict_of(r)->reason;
    EXPECT_NEAR(taut_test::check_of(r, "w.brake_torque").value, 1e3 * 9.81 * 0.25, 0.02e3);
  }
  EXPECT_TRUE(taut_test::check_of(hoist_to("1.2 s", ""), "w.brake_torque").passes);
}

// A place of rest about which a machine vibrates has no brake that slips: 1 t at 0.2 m.
TEST(DriveUses, ABrakeThatIsSetHasToHoldWhereAMachineVibrates) {
  const auto modes = [](const std::string& torque) {
    return run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {brake: set}, brake_torque: )" +
                    torque + R"(}}
  reevings: [{rope: line, path: [{drum: winch, side: left}, {anchor: load}], length: 10 m}]
checks: {ropes: {line: {safety_factor: 4}}}
analyses: [{modes: {}}]
)");
  };
  const Result weak = modes("1.5 kN m");
  ASSERT_EQ(weak.status, Status::ok) << weak.message << to_text(weak.errors);
  EXPECT_NEAR(taut_test::check_of(weak, "winch.brake_torque").value, 1e3 * 9.80665 * 0.2, 4);
  EXPECT_EQ(to_text(verdict_of(weak)->kind), "fails");
  EXPECT_EQ(to_text(verdict_of(modes("3 kN m"))->kind), "passes");
}

}  // namespace taut::drive_uses_test
