#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test/support/machine_decks.hpp"

/// Drives that give way to their loads, in motions.
namespace taut::dragged_test {

using taut_test::run_text;

bool told(const Result& r, const std::string& words) {
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return std::any_of(r.unsafe.begin(), r.unsafe.end(),
                     [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

/// 1 t on a drum of 0.2 m, which needs 1.96 kN m, on a jib that a signal slews by `angle`.
Result slewed(const std::string& angle, const std::string& torque) {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{s: {{ramp: {{to: {}, start: 0.1 s, duration: 6 s, smooth: true}}}}}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.1}}}}
  bodies:
    jib: {{at: [0 m, 0 m, 20 m], motion: {{rz: s}}}}
    load: {{mass: 1 t, at: [10.2 m, 0 m, 10 m], free: [x, y, z]}}
  sheaves: {{h: {{body: jib, at: [10 m, 0 m, 0 m], diameter: 400 mm}}}}
  drums:
    d: {{body: jib, at: [0 m, 0 m, 0 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {{speed: 0 m/s}}, brake_torque: 4 kN m}}
  reevings: [{{rope: r, path: [{{drum: d}}, {{over: h}}, {{anchor: load}}], length: 20.3 m}}]
  events: [{{at: 0.5 s, drive: d, torque: {}}}]
analyses: [{{transient: {{duration: 2 s, tolerance: 1e-4}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}}}}}
)",
                              angle, torque));
}

TEST(Dragged, ASlewingJibDrawsNoHoistRopeOut) {
  EXPECT_TRUE(told(slewed("30 deg", "1.5 kN m"), "the load drags 'd'"));
  EXPECT_TRUE(told(slewed("0 deg", "1.5 kN m"), "the load drags 'd'"));
  EXPECT_FALSE(told(slewed("30 deg", "2.3 kN m"), "the load drags"));
}

/// The same load on a trolley, which a winch moves.
Result trolley(const std::string& torque, const std::string& drive) {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{v: {{ramp: {{to: 0.2 m/s, start: 0.1 s, duration: 0.3 s}}}}}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.1, diameter: 12 mm}}}}
  bodies:
    tr: {{mass: 300 kg, at: [5 m, 0 m, 20 m], free: [x]}}
    load: {{mass: 1 t, at: [5.2 m, 0 m, 10 m], free: [x, z]}}
  sheaves: {{h: {{body: tr, at: [0 m, 0 m, 0 m], diameter: 400 mm}}}}
  drums:
    d: {{at: [0 m, 0 m, 20 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {{speed: 0 m/s}}, brake_torque: 4 kN m}}
    w: {{at: [10 m, 0 m, 20 m], core_diameter: 0 mm, drive: {{speed: v}}}}
  reevings:
    - {{name: r, rope: r, path: [{{drum: d, side: right}}, {{over: h, side: right}}, {{anchor: load}}], length: 15.3 m}}
    - {{name: t, rope: r, path: [{{drum: w}}, {{anchor: tr}}], length: 5 m}}
  events: [{{at: 0.5 s, drive: d, {}: {}}}]
analyses: [{{transient: {{duration: 2 s, tolerance: 1e-4}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}, t: {{dynamic_safety_factor: 2}}}}}}
)",
                              drive, torque));
}

TEST(Dragged, AWinchOfATrolleyDrawsNoHoistRopeOut) {
  EXPECT_TRUE(told(trolley("1.5 kN m", "torque"), "the load drags 'd'"));
  EXPECT_TRUE(told(trolley("-0.01 kN m", "torque"), "the load drags 'd'"));
}

/// 1 t over a sheave on a drum of 0.2 m.
Result hoist(const std::string& drive, const std::string& event, const std::string& drum = "") {
  return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 1 MN, breaking_force: 200 kN, damping_ratio: 0.1}}}}
  bodies: {{hook: {{mass: 1 t, at: [0.2 m, 0 m, 5 m], free: [z]}}}}
  sheaves: {{head: {{at: [0 m, 0 m, 12 m], diameter: 400 mm}}}}
  drums: {{winch: {{at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, inertia: 200 kg m^2, drive: {{{}}}{}}}}}
  reevings: [{{rope: r, path: [{{drum: winch}}, {{over: head}}, {{anchor: hook}}]{}}}]
  events: [{{at: 0.5 s, drive: winch, {}}}]
analyses: [{{transient: {{duration: 2 s, tolerance: 1e-4}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}}}}}
)",
                              drive, drum, drive.find("pull") == 0 ? "" : ", length: 19.3 m", event));
}

// A torque that turns the drum the way in which the load falls holds nothing.
TEST(Dragged, ATorqueBelowZeroDropsTheLoad) {
  for (const char* torque : {"1 N m", "0 N m", "-1 N m", "-300 N m", "-2.5 kN m"}) {
    EXPECT_TRUE(told(hoist("speed: 0 m/s", std::string("torque: ") + torque), "the load drags 'winch'")) << torque;
  }
  // its drag takes nearly all at 2.2 m/s, and the drive gives more than the load: this one lowers it on purpose
  EXPECT_FALSE(told(hoist("speed: 0 m/s", "torque: -2.5 kN m", ", drag: 400 N m s"), "the load drags"));
}

// The 2 t run off the drum while its first rope, of 1 t, is taken in; both ways round one load falls.
TEST(Dragged, ALoadOnTheSecondRopeOfADrumFallsToo) {
  const auto hung = [](const char* first, const char* second, const char* drive, const char* ratio = "0.3",
                       const char* more = "inertia: 5 kg m^2") {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{hoist: {{mass: 0 kg/m, stiffness: 13 MN, breaking_force: 400 kN, damping_ratio: {3}}}}}
  bodies:
    hook: {{mass: {0}, at: [0.2 m, 0 m, 0 m], free: [z]}}
    other: {{mass: {1}, at: [-0.2 m, 0 m, 0 m], free: [z]}}
  drums: {{winch: {{at: [0 m, 0 m, 10 m], core_diameter: 400 mm, {4}, drive: {{{2}}}}}}}
  reevings:
    - {{rope: hoist, name: a, path: [{{drum: winch, side: right}}, {{anchor: hook}}], length: 10 m}}
    - {{rope: hoist, name: b, path: [{{drum: winch, side: left}}, {{anchor: other}}], length: 10 m, haul: to_end}}
checks: {{ropes: {{hoist: {{dynamic_safety_factor: 3}}}}}}
analyses: [{{transient: {{duration: 1.2 s, start: assembled, tolerance: 1e-3}}}}]
)",
                                first, second, drive, ratio, more));
  };
  for (const char* drive : {"brake: open", "torque: 0.1 kN m", "torque: -0.1 kN m"}) {
    EXPECT_TRUE(told(hung("1 t", "2 t", drive), "the load drags 'winch'")) << drive;
    EXPECT_TRUE(told(hung("2 t", "1 t", drive), "the load drags 'winch'")) << drive;
  }
  EXPECT_FALSE(told(hung("1 t", "1 t", "brake: open"), "the load drags"));
  // a light drum: the pulls of its two ropes swing about each other
  EXPECT_TRUE(told(hung("1 t", "2 t", "torque: 0.1 kN m", "0.01", "inertia: 0.2 kg m^2"), "the load drags 'winch'"));
  EXPECT_TRUE(told(hung("2 t", "1 t", "torque: -0.1 kN m", "0.01", "inertia: 0.2 kg m^2"), "the load drags 'winch'"));
  // the torque runs ahead of the load, at 0.3 kN m/(5 kg m^2) 0.2 m = 12 m/s^2: it falls freely on a slack rope
  EXPECT_TRUE(told(hung("1 kg", "1 t", "torque: 0.3 kN m"), "the load drags 'winch'"));
  EXPECT_TRUE(told(hung("1 t", "1 kg", "torque: -0.3 kN m"), "the load drags 'winch'"));
  // 2 kN m hold the difference of 10 kN on 0.2 m: 4 kN m hoist the heavier load; what they lower has nearly all of it
  // taken by the drag, and more of it from the drive
  EXPECT_FALSE(told(hung("1 t", "2 t", "torque: -4 kN m"), "the load drags"));
  EXPECT_FALSE(told(hung("2 t", "1 t", "torque: 4 kN m"), "the load drags"));
  EXPECT_FALSE(
      told(hung("1 t", "2 t", "torque: 4 kN m", "0.3", "inertia: 5 kg m^2, drag: 1 kN m s"), "the load drags"));
  EXPECT_FALSE(
      told(hung("2 t", "1 t", "torque: -4 kN m", "0.3", "inertia: 5 kg m^2, drag: 1 kN m s"), "the load drags"));
}

TEST(Dragged, ADrumByAPullGivesWay) {
  const Result drops = hoist("pull: 9.80665 kN", "pull: 5 kN");
  EXPECT_TRUE(told(drops, "the load drags 'winch'"));
  EXPECT_TRUE(told(drops, "against its pull of 5 kN"));
  EXPECT_FALSE(told(hoist("pull: 9.80665 kN", "pull: 12 kN"), "the load drags"));
}

/// Two hoists on one head: 5 t by a speed, 1 t by a pull.
Result two_hoists(const char* speed, const char* pull) {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{run: {{constant: {}}}}}
  points: {{roof: [0 m, 0 m, 20 m]}}
  ropes: {{hoist: {{mass: 0 kg/m, stiffness: 13 MN, breaking_force: 400 kN, damping_ratio: 0.3}}}}
  bodies:
    crown: {{mass: 500 kg, at: [0 m, 0 m, 15 m], free: [z]}}
    a: {{mass: 5 t, at: [0.4 m, 0 m, 8 m], free: [z]}}
    b: {{mass: 1 t, at: [-0.4 m, 0 m, 8 m], free: [z]}}
  sheaves:
    sa: {{body: crown, at: [0.2 m, 0 m, 0 m], diameter: 400 mm}}
    sb: {{body: crown, at: [-0.2 m, 0 m, 0 m], diameter: 400 mm}}
  drums:
    wa: {{at: [0 m, 0 m, 0 m], core_diameter: 400 mm, inertia: 5 kg m^2, drive: {{speed: run}}}}
    wb: {{at: [0 m, 0 m, 1 m], core_diameter: 400 mm, inertia: 5 kg m^2, drive: {{pull: {}}}}}
  reevings:
    - {{rope: hoist, name: ra, path: [{{drum: wa, side: left}}, {{over: sa}}, {{anchor: a}}], length: 22.6 m}}
    - {{rope: hoist, name: rb, path: [{{drum: wb, side: right}}, {{over: sb}}, {{anchor: b}}]}}
    - {{rope: hoist, name: hang, path: [{{anchor: roof}}, {{anchor: crown}}], length: 4.97 m}}
checks: {{ropes: {{hoist: {{dynamic_safety_factor: 2}}}}}}
analyses: [{{transient: {{duration: 1.2 s, start: assembled, tolerance: 1e-3}}}}]
)",
                              speed, pull));
}

// 1 t against 5 kN: 4.8 m/s^2 for 1.2 s are 5.8 m/s. It gives 57 kW, and its drum takes 29 kW. The other drum takes
// 49 kW of its own load.
TEST(Dragged, TheBrakingOfAnotherLoadHoldsNothing) {
  for (const char* speed : {"-1 m/s", "0 m/s", "1 m/s"}) {
    EXPECT_TRUE(told(two_hoists(speed, "5 kN"), "the load drags 'wb'")) << speed;
    EXPECT_FALSE(told(two_hoists(speed, "12 kN"), "the load drags")) << speed;
  }
}

/// Downhill by a mainline: the haulback pays out by its pull.
TEST(Dragged, AHaulbackByItsPullIsDrawnOut) {
  const auto yard = [](const char* pull, const char* mainline) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{line: {{mass: 0.8 kg/m, stiffness: 9.8 MN, breaking_force: 400 kN, damping_ratio: 0.2}}}}
  bodies: {{car: {{mass: 2 t, at: [40 m, 0 m, 20 m], guide: [2, 0, 1]}}}}
  drums:
    main: {{at: [0 m, 0 m, 0 m], core_diameter: 400 mm, drive: {{{1}}}, inertia: 50 kg m^2}}
    back: {{at: [80 m, 0 m, 40 m], core_diameter: 400 mm, drive: {{pull: {0}}}, inertia: 50 kg m^2}}
  reevings:
    - {{name: pull, rope: line, path: [{{drum: main}}, {{anchor: car}}], tension_at_start: 12 kN}}
    - {{name: back, rope: line, path: [{{anchor: car}}, {{drum: back}}]}}
analyses: [{{transient: {{duration: 1.5 s, output_step: 20 ms, tolerance: 1e-3, start: assembled}}}}]
checks: {{ropes: {{pull: {{safety_factor: 2}}, back: {{safety_factor: 2}}}}}}
)",
                                pull, mainline));
  };
  EXPECT_FALSE(told(yard("20 kN", "speed: 1 m/s"), "the load drags"));
  EXPECT_TRUE(told(yard("3 kN", "brake: open"), "the load drags 'back'"));
}

/// 2 t and 1.5 t on a driven sheave of 1 m: 4.9 kN m hold them.
Result koepe(const std::string& torque) {
  return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.1}}
  bodies:
    a: {mass: 2 t, at: [-1 m, 0 m, -20 m], free: [z]}
    b: {mass: 1.5 t, at: [1 m, 0 m, -20 m], free: [z]}
  sheaves: {k: {at: [0 m, 0 m, 0 m], diameter: 2 m, friction: 0.3, inertia: 500 kg m^2, motor: {torque: )" +
                  torque + R"(}}}
  reevings: [{rope: r, path: [{anchor: a}, {over: k, side: right}, {anchor: b}], length: 43.1 m}]
analyses: [{transient: {duration: 2 s, tolerance: 1e-4, start: assembled}}]
checks: {ropes: {r: {dynamic_safety_factor: 2}}}
)");
}

TEST(Dragged, ADrivenSheaveRunsBack) {
  EXPECT_TRUE(told(koepe("-1 kN m"), "the load drags 'k'"));
  EXPECT_TRUE(told(koepe("1 kN m"), "the load drags 'k'"));
  EXPECT_FALSE(told(koepe("7 kN m"), "the load drags")) << "it hoists";
}

/// A boom on a cylinder, with 500 kg on its tip: 32.7 kN at 1 t.
Result boom(const std::string& drive, const std::string& events = "") {
  return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.1}}}}
  bodies:
    boom: {{mass: 1 t, at: [0 m, 0 m, 2 m], centre: [5 m, 0 m, 3 m], free: [ry], inertia: 10000 kg m^2}}
    load: {{mass: 500 kg, at: [10 m, 0 m, 3 m], free: [x, z]}}
  points: {{tip: {{body: boom, at: [10 m, 0 m, 6 m]}}, lug: {{body: boom, at: [3 m, 0 m, 1.5 m]}}, base: [3 m, 0 m, 0 m]}}
  reevings: [{{rope: r, path: [{{anchor: tip}}, {{anchor: load}}], length: 4.995 m}}]
  actuators: {{cyl: {{from: base, to: lug, lock_stiffness: 20 MN/m, lock_damping: 100 kN s/m, {}}}}}
{}analyses: [{{transient: {{duration: 1.5 s, tolerance: 1e-4, start: assembled}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}}}}}
)",
                              drive, events));
}

TEST(Dragged, ABoomSinksOnItsCylinder) {
  EXPECT_TRUE(told(boom("force: 27 kN"), "the load drags 'cyl'"));
  EXPECT_TRUE(told(boom("speed: 0 m/s", "  events: [{at: 0.3 s, actuator: cyl, mode: free}]\n"), "'cyl'"));
  EXPECT_FALSE(told(boom("speed: 0 m/s"), "'cyl'"));
  EXPECT_FALSE(told(boom("speed: -0.05 m/s"), "'cyl'")) << "it is lowered";
  EXPECT_FALSE(told(boom("force: 40 kN"), "'cyl'")) << "it rises";
}

// 1 t on 1.5 turns of friction 0.2, exp(0.2 x 3 pi) = 6.59: it takes 152 kg to hold it
TEST(Dragged, ALoadRunsAwayOnABollard) {
  const auto bollard = [](const char* tail) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.05}}}}
  bodies:
    w: {{mass: 1 t, at: [1 m, 0 m, 0 m], free: [z]}}
    c: {{mass: {}, at: [-1 m, 0 m, 0 m], free: [z]}}
  supports: {{s: {{at: [0 m, 0 m, 10 m], diameter: 2 m, friction: 0.2}}}}
  reevings: [{{rope: r, path: [{{anchor: w}}, {{over: s, turns: 1, side: left}}, {{anchor: c}}], length: 29.4248 m}}]
analyses: [{{transient: {{duration: 1 s, start: assembled, tolerance: 1e-5}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}}}}}
)",
                                tail));
  };
  EXPECT_TRUE(told(bollard("60 kg"), "slips over 's'"));
  EXPECT_FALSE(told(bollard("200 kg"), "slips over"));
}

}  // namespace taut::dragged_test
