#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "test/support/machine_decks.hpp"

/// Ropes that slip on driven sheaves, drums that their loads turn, in motions.
namespace taut::drive_uses_slip_test {

using taut_test::run_text;

/// An endless rope at 5 m/s, pulled by 10 kN on its slack side; for 2 s a force of `cut` holds it back. `start`: in
/// which it gets this speed, s.
Result endless(double duration, double cut, const char* arc = "", double start = 2) {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals:
    running: {{ramp: {{to: 5 m/s, start: 0 s, duration: {7} s, smooth: true}}}}
    cut: {{table: {{t: [{0} s, {1} s, {2} s, {3} s], value: [0 kN, {4} kN, {4} kN, 0 kN]}}}}
  ropes: {{haul: {{mass: 0.6 kg/m, stiffness: 13 MN, breaking_force: 150 kN, damping_ratio: 0.03}}}}
  bodies: {{slide: {{mass: 900 kg, at: [0 m, 0 m, 1 m], free: [x]}}}}
  sheaves:
    head: {{at: [30 m, 0 m, 1 m], diameter: 800 mm, friction: 0.2, inertia: 60 kg m^2, motor: {{speed: running{6}}}}}
    tail: {{body: slide, at: [0 m, 0 m, 0 m], diameter: 800 mm, inertia: 60 kg m^2}}
  loads: [{{at: slide, force: [-20 kN, 0 kN, 0 kN]}}]
  reevings: [{{name: loop, rope: haul, path: [{{over: head, side: left}}, {{over: tail, side: left}}], closed: true, length: 62.513 m}}]
  rope_loads: [{{name: cars, rope: loop, between: [tail, head], tangential: 0 kN, signal: cut, position: 0.5}}]
analyses: [{{transient: {{duration: {5} s, output_step: 50 ms, tolerance: 1e-3}}}}]
checks: {{ropes: {{haul: {{safety_factor: 3}}}}}}
)",
                              duration - 5, duration - 4.5, duration - 2.5, duration - 2.4, cut, duration, arc, start));
}

// (10 + 9.6)/10 = 1.96 > exp(0.2 pi) = 1.874: it slips for 2 s, however long it ran before
TEST(DriveSlips, HowLongItRanBeforeDoesNotCount) {
  for (const double duration : {10.0, 60.0}) {
    const Result r = endless(duration, 9.6);
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    ASSERT_EQ(r.unsafe.size(), 1U) << duration;
    EXPECT_NE(r.unsafe[0].find("the rope slips on 'head'"), std::string::npos) << r.unsafe[0];
    EXPECT_TRUE(endless(duration, 8.0).unsafe.empty()) << "it creeps";
  }
}

// What slips fails, and its grip is used up; what creeps is judged at its worst moment, (10 + 8)/10 = 1.8 of 1.874 and
// a swing of 2 %.
TEST(DriveSlips, TheGripIsACheckInMotion) {
  const Result slips = endless(10, 9.6);
  EXPECT_EQ(to_text(verdict_of(slips)->kind), "fails") << verdict_of(slips)->reason;
  EXPECT_FALSE(taut_test::check_of(slips, "head.slipped").passes);
  EXPECT_NEAR(taut_test::check_of(slips, "head.grip").utilisation, 1, 1e-6);
  EXPECT_NEAR(taut_test::check_of(slips, "head.grip").limit, std::exp(0.2 * M_PI), 1e-3);
  const Result creeps = endless(10, 8.0);
  EXPECT_FALSE(taut_test::has_check(creeps, "head.slipped"));
  const Check grip = taut_test::check_of(creeps, "head.grip");
  EXPECT_TRUE(grip.passes);
  EXPECT_NEAR(grip.value, 1.8, 0.05);
  EXPECT_NE(grip.where.find("transient, t = "), std::string::npos) << grip.where;
}

// of the half turn 90 deg grip: exp(0.2 pi/2) = 1.37 is less than (10 + 8)/10
TEST(DriveSlips, AWorkingArcCountsInMotion) {
  const Result slips = endless(10, 8.0, ", working_arc: 90 deg");
  ASSERT_EQ(slips.unsafe.size(), 1U) << slips.message << to_text(slips.errors);
  EXPECT_NE(slips.unsafe[0].find("the rope slips on 'head'"), std::string::npos) << slips.unsafe[0];
  EXPECT_TRUE(endless(10, 3.0, ", working_arc: 90 deg").unsafe.empty());
  // at 9.4 m/s2 the tail sheave, 375 kg at its rim, and half of the rope take 3.9 of 20 kN: 11.9/8.1 = 1.48
  EXPECT_EQ(endless(10, 3.0, ", working_arc: 90 deg", 0.8).unsafe.size(), 1U) << "it slips as it starts";
}

/// 3 t on a winch at 0.207 m: 6.08 kN m. From 0.5 s on it gives a torque.
Result hoist(double torque, const std::string& then = "") {
  return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{hoist: {{mass: 1 kg/m, stiffness: 9.8 MN, breaking_force: 400 kN, damping_ratio: 0.2, diameter: 14 mm}}}}
  bodies: {{hook: {{mass: 3 t, at: [0.2 m, 0 m, 9 m], free: [x, z]}}}}
  sheaves: {{head: {{at: [0 m, 0 m, 12 m], diameter: 400 mm, inertia: 0.5 kg m^2}}}}
  drums:
    winch: {{at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, drive: {{speed: 0 m/s}}, brake_torque: 9 kN m, inertia: 50 kg m^2}}
  reevings: [{{name: hoist, rope: hoist, path: [{{drum: winch}}, {{over: head}}, {{anchor: hook}}], length: 15.3 m}}]
  events: [{{at: 0.5 s, drive: winch, torque: {} kN m}}{}]
analyses: [{{transient: {{duration: 2 s, output_step: 20 ms, tolerance: 1e-3}}}}]
checks: {{ropes: {{hoist: {{safety_factor: 4}}}}}}
)",
                              torque, then));
}

TEST(DriveSlips, ALoadThatTurnsItsWinchBackIsUnsafe) {
  const Result weak = hoist(5);
  ASSERT_EQ(weak.unsafe.size(), 1U) << weak.message << to_text(weak.errors);
  EXPECT_NE(weak.unsafe[0].find("the load drags 'winch'"), std::string::npos) << weak.unsafe[0];
  EXPECT_TRUE(hoist(8).unsafe.empty());
  // lowered by its torque, and stopped
  const Result stopped = hoist(5.5, ", {at: 1 s, drive: winch, brake: set}");
  for (const std::string& words : stopped.unsafe) EXPECT_EQ(words.find("the load drags"), std::string::npos) << words;
}

bool told_as_dragged(const Result& r) {
  return std::any_of(r.unsafe.begin(), r.unsafe.end(), [](const std::string& words) {
    return words.find("the load drags 'winch'") != std::string::npos;
  });
}

// Its brake is opened, and no drive holds it.
TEST(DriveSlips, ALoadThatFallsOnAnOpenDrumIsUnsafe) {
  const auto lift = [](const std::string& drum, const std::string& then) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 12 MN, breaking_force: 200 kN, damping_ratio: 0.1}}
  bodies: {car: {mass: 1500 kg, at: [3 m, 0 m, -20 m], free: [z]}}
  sheaves: {s: {at: [2.7 m, 0 m, 5 m], diameter: 600 mm}}
  drums: {winch: {at: [0 m, 0 m, 0 m], core_diameter: 584 mm, inertia: 50 kg m^2, length_on_drum: 300 m, )" +
                    drum + R"(}}
  events: [{at: 0.5 s, brake: winch, mode: open})" +
                    then + R"(]
  reevings: [{rope: r, path: [{drum: winch}, {over: s}, {anchor: car}], length: 31 m, may_slack: true}]
analyses: [{transient: {duration: 5 s, output_step: 20 ms, tolerance: 1e-4}}]
checks: {ropes: {r: {dynamic_safety_factor: 1.1}}}
)");
  };
  for (const char* drum : {"drive: {brake: set}, brake_torque: 10 kN m", "drive: {brake: set}", "drag: 20 N m s"}) {
    const Result falls = lift(drum, "");
    EXPECT_TRUE(told_as_dragged(falls)) << drum << falls.message << to_text(falls.errors);
  }
  EXPECT_FALSE(told_as_dragged(lift("drive: {brake: set}, brake_torque: 10 kN m", ", {at: 0.7 s, brake: winch}")));
}

/// The hoist with 5 kN m for its 6.08, and a second one beside it that lifts at a given speed.
TEST(DriveSlips, AnotherHoistDoesNotDrawItsRopeOut) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 1 kg/m, stiffness: 9.8 MN, breaking_force: 400 kN, damping_ratio: 0.2, diameter: 14 mm}}
  bodies:
    hook: {mass: 3 t, at: [0.2 m, 0 m, 9 m], free: [x, z]}
    other: {mass: 9 t, at: [0.2 m, 5 m, 2 m], free: [x, z]}
  sheaves:
    head: {at: [0 m, 0 m, 12 m], diameter: 400 mm, inertia: 0.5 kg m^2}
    beside: {at: [0 m, 5 m, 12 m], diameter: 400 mm, inertia: 0.5 kg m^2}
  drums:
    winch: {at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, drive: {torque: 5 kN m}, inertia: 50 kg m^2}
    second: {at: [-5 m, 5 m, 1 m], core_diameter: 400 mm, drive: {speed: 1 m/s}, inertia: 50 kg m^2}
  reevings:
    - {name: hoist, rope: hoist, path: [{drum: winch}, {over: head}, {anchor: hook}], length: 15.3 m}
    - {name: lift, rope: hoist, path: [{drum: second}, {over: beside}, {anchor: other}], length: 22.3 m}
analyses: [{transient: {duration: 1 s, output_step: 20 ms, tolerance: 1e-3, start: assembled}}]
checks: {ropes: {hoist: {safety_factor: 4}, lift: {safety_factor: 2}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(told_as_dragged(r));
}

/// A carriage on a slope of 30 deg between a mainline below it and a haulback above it by a torque. The mainline has a
/// speed: it draws the haulback out, as long as it has to pull for that.
TEST(DriveSlips, AMainlineDrawsItsHaulbackOutDownhill) {
  const auto yard = [](const char* torque, const char* mainline) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{line: {{mass: 0.8 kg/m, stiffness: 9.8 MN, breaking_force: 400 kN, damping_ratio: 0.2, diameter: 14 mm}}}}
  bodies: {{car: {{mass: 2 t, at: [40 m, 0 m, 20 m], guide: [2, 0, 1]}}}}
  drums:
    main: {{at: [0 m, 0 m, 0 m], core_diameter: 400 mm, drive: {{{1}}}, inertia: 50 kg m^2}}
    winch: {{at: [80 m, 0 m, 40 m], core_diameter: 400 mm, drive: {{{0}}}, inertia: 50 kg m^2}}
  reevings:
    - {{name: pull, rope: line, path: [{{drum: main}}, {{anchor: car}}], tension_at_start: 12 kN}}
    - {{name: back, rope: line, path: [{{anchor: car}}, {{drum: winch}}], tension_at_end: 20 kN}}
analyses: [{{transient: {{duration: 1.5 s, output_step: 20 ms, tolerance: 1e-3, start: assembled}}}}]
checks: {{ropes: {{pull: {{safety_factor: 2}}, back: {{safety_factor: 2}}}}}}
)",
                                torque, mainline));
  };
  const Result drawn = yard("torque: 4.3 kN m", "speed: 1 m/s");
  ASSERT_EQ(drawn.status, Status::ok) << drawn.message << to_text(drawn.errors);
  EXPECT_FALSE(told_as_dragged(drawn));
  // without any torque the carriage runs ahead of its mainline; uphill an open drum below it lets its rope go
  EXPECT_TRUE(told_as_dragged(yard("brake: open", "speed: 1 m/s")));
  const Result uphill = yard("speed: 1 m/s", "brake: open");
  ASSERT_EQ(uphill.status, Status::ok) << uphill.message << to_text(uphill.errors);
  for (const std::string& words : uphill.unsafe) EXPECT_EQ(words.find("the load drags"), std::string::npos) << words;
  // the mainline too gives way by a torque: its 0.1 kN m are less than what the carriage does
  const Result runs = yard("torque: 0.5 kN m", "torque: 0.1 kN m");
  ASSERT_EQ(runs.status, Status::ok) << runs.message << to_text(runs.errors);
  EXPECT_TRUE(told_as_dragged(runs));
}

// 100 and 80 kg over a sheave that holds e = exp(0.1 pi) = 1.369 at most: the rope stands (1.25) until the rim is
// driven, from 1 s on, to 2 m/s in 1 s. With 100 (g + a) = e 80 (g - a) the masses get a = 0.4543 m/s2, the rim 2 m/s2:
// the rope slips by 1.5457 m/s2 t, 0.773 m in the second.
TEST(DriveSlips, TheWayOfASlipThatGrowsIsItsIntegral) {
  const Result r = run_text(R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN, diameter: 10 mm, damping_ratio: 0.5}}
  bodies:
    a: {mass: 100 kg, at: [-0.5 m, 0 m, -10 m], free: [z]}
    b: {mass: 80 kg, at: [0.5 m, 0 m, -10 m], free: [z]}
  sheaves: {s: {at: [0 m, 0 m, 0 m], diameter: 1 m, inertia: 10 kg m^2, friction: 0.1, motor: {torque: 100 N m}}}
  signals: {v: {sequence: [{at: 1 s, to: 2 m/s, over: 1 s}]}}
  events: [{at: 0 s, drive: s, speed: v}]
  reevings: [{rope: r, path: [{anchor: a}, {over: s}, {anchor: b}], length: 21.57 m}]
analyses: [{transient: {duration: 2 s, output_step: 0.1 s, start: assembled}}]
checks: {ropes: {r: {dynamic_safety_factor: 5}}}
)");
  const double grip = std::exp(0.1 * M_PI);
  const double a = 10 * (80 * grip - 100) / (80 * grip + 100);
  EXPECT_NEAR(taut_test::check_of(r, "s.slipped").value, (2 - a) / 2, 2e-3);
}

// The rated pull is one that lasts; 2.4 m/s in 0.7 s makes a peak of more.
TEST(DriveSlips, APeakAboveTheRatedPullIsUnsafe) {
  const auto lift = [](const std::string& rated) {
    return run_text(R"(taut: 1
machine:
  signals: {up: {sequence: [{at: 0.2 s, to: 2.4 m/s, over: 0.7 s, smooth: true}, {at: 1.7 s, to: 0 m/s, over: 1 s, smooth: true}]}}
  ropes: {hoist: {mass: 1 kg/m, stiffness: 9.8 MN, breaking_force: 400 kN, damping_ratio: 0.2, diameter: 14 mm}}
  bodies: {hook: {mass: 3 t, at: [0.2 m, 0 m, 2 m], free: [x, z]}}
  sheaves: {head: {at: [0 m, 0 m, 12 m], diameter: 400 mm, inertia: 0.5 kg m^2}}
  drums:
    winch: {at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, face_width: 600 mm, length_on_drum: 20 m, drive: {speed: up}, inertia: 50 kg m^2}
  reevings: [{name: hoist, rope: hoist, path: [{drum: winch}, {over: head}, {anchor: hook}], length: 22.3 m}]
analyses: [{transient: {duration: 7 s, output_step: 20 ms, tolerance: 1e-3}}]
checks: {ropes: {hoist: {safety_factor: 4, rated_pull: )" +
                    rated + "}}}\n");
  };
  const Result weak = lift("35 kN");
  ASSERT_EQ(weak.status, Status::ok) << weak.message << to_text(weak.errors);
  EXPECT_TRUE(std::any_of(weak.unsafe.begin(), weak.unsafe.end(), [](const std::string& words) {
    return words.find("of its rated pull of 35 kN") != std::string::npos;
  })) << weak.message;
  for (const std::string& words : lift("80 kN").unsafe) EXPECT_EQ(words.find("rated pull"), std::string::npos) << words;
}

}  // namespace taut::drive_uses_slip_test
