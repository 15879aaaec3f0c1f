#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// What the motor and the brake of a winch have to hold at rest.
namespace taut::drive_uses_winch_test {

using taut_test::run_text;

/// 1 t at 0.2 m: 1.96 kN m. A torque by a signal is a limit as a constant is; one that swings has no largest value that
/// statics could take.
TEST(DriveUses, ATorqueByASignalIsALimit) {
  const auto lift = [](const std::string& law) {
    return run_text(R"(taut: 1
machine:
  signals: {tq: {)" +
                    law + R"(}}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 20 m], core_diameter: 400 mm, drive: {torque: tq}}}
  reevings: [{rope: r, path: [{drum: winch}, {anchor: load}], length: 20 m}]
checks: {ropes: {r: {safety_factor: 5}}}
)");
  };
  for (const auto& [law, limit] : {std::pair{"constant: 0.5 kN m", 500.0},
                                   {"ramp: {to: 1.9 kN m, duration: 1 s}", 1900},
                                   {"ramp: {from: 3 kN m, to: 0.2 kN m, duration: 10 s}", 200}}) {
    const Result r = lift(law);
    EXPECT_EQ(to_text(verdict_of(r)->kind), "fails") << law;
    EXPECT_NEAR(taut_test::check_of(r, "winch.torque").value, 1e3 * 9.80665 * 0.2, 1e-6);
    EXPECT_EQ(taut_test::check_of(r, "winch.torque").limit, limit);
  }
  const Result swings = lift("sine: {mean: 1 kN m, amplitude: 2 kN m, frequency: 1 Hz}");
  EXPECT_EQ(to_text(verdict_of(swings)->kind), "not_judged") << verdict_of(swings)->reason;
  EXPECT_NE(verdict_of(swings)->reason.find("winch.torque is not checked"), std::string::npos);
}

/// 1 t at 0.2 m: a brake that is set holds it in place of the motor, whose torque would be enough.
TEST(DriveUses, ABrakeThatIsSetHoldsInPlaceOfTheMotor) {
  const auto held = [](const std::string& drum) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 20 m], core_diameter: 400 mm, inertia: 5 kg m^2, )" +
                    drum + R"(}}
  reevings: [{rope: r, path: [{drum: winch}, {anchor: load}], length: 20 m}]
checks: {ropes: {r: {safety_factor: 5}}}
)");
  };
  const std::string set = "drive: {torque: 3 kN m, brake: set}, brake_torque: ";
  const Result weak = held(set + "0.1 kN m");
  ASSERT_TRUE(verdict_of(weak)) << to_text(weak.errors);
  EXPECT_EQ(to_text(verdict_of(weak)->kind), "fails") << verdict_of(weak)->reason;
  EXPECT_NEAR(taut_test::check_of(weak, "winch.brake_torque").value, 1e3 * 9.80665 * 0.2, 1e-6);
  EXPECT_FALSE(taut_test::has_check(weak, "winch.torque"));
  EXPECT_EQ(to_text(verdict_of(held(set + "2 kN m"))->kind), "passes");
  const Result open = held("drive: {torque: 3 kN m}, brake_torque: 0.1 kN m");
  EXPECT_FALSE(taut_test::has_check(open, "winch.brake_torque"));
  EXPECT_TRUE(taut_test::has_check(open, "winch.torque"));
}

/// At rest a drum stands, whatever holds it; one whose brake is open, without a drive, has nothing.
TEST(DriveUses, ALoadOnAFreeDrumIsNotJudged) {
  const auto hoist = [](const std::string& brake) {
    return run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 100 kN}}
  bodies: {hook: {mass: 2 t, at: [0.2 m, 0 m, 3 m], free: [z]}}
  drums: {w: {at: [0 m, 0 m, 20 m], core_diameter: 400 mm, inertia: 50 kg m^2, brake_torque: 5 kN m, drive: {brake: )" +
                    brake + R"(}}}
  reevings: [{rope: hoist, path: [{drum: w}, {anchor: hook}], length: 17 m}]
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses: [equilibrium: {}]
)");
  };
  const Result open = hoist("open");
  ASSERT_TRUE(verdict_of(open)) << open.message << to_text(open.errors);
  EXPECT_EQ(to_text(verdict_of(open)->kind), "not_judged");
  EXPECT_NE(verdict_of(open)->reason.find("nothing holds 'w', whose brake is open"), std::string::npos)
      << verdict_of(open)->reason;
  EXPECT_TRUE(
      std::none_of(open.checks.begin(), open.checks.end(), [](const Check& c) { return c.name == "w.brake_torque"; }));
  EXPECT_EQ(to_text(verdict_of(hoist("set"))->kind), "passes");
}

/// A closed rope that nothing holds back needs no torque, and rounding is none.
TEST(DriveUses, NoTorqueIsEnoughForNone) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {haul: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 180 kN}}
  sheaves:
    a: {at: [0 m, 0 m, 5 m], diameter: 400 mm, efficiency: 0.9, friction: 0.3, motor: {torque: 0 N m}}
    b: {at: [5 m, 0 m, 5 m], diameter: 400 mm, efficiency: 0.9}
    c: {at: [5 m, 0 m, 1 m], diameter: 400 mm, efficiency: 0.9}
    d: {at: [0 m, 0 m, 1 m], diameter: 400 mm, efficiency: 0.9}
  reevings: [{rope: haul, closed: true, path: [{over: a}, {over: b}, {over: c}, {over: d}], length: 19.2 m}]
analyses: [equilibrium: {motion: at_rest}]
checks: {ropes: {haul: {safety_factor: 3}}}
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_EQ(taut_test::check_of(r, "a.torque").value, 0);
  EXPECT_TRUE(taut_test::check_of(r, "a.torque").passes);
}

/// A skyline of 210 m beside 60 m on its drum, which has room for 65.35 m.
std::string on_its_drum(const std::string& analysis) {
  return R"(taut: 1
machine:
  points: {b: [200 m, 0 m, 40 m]}
  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN, diameter: 20 mm, breaking_force: 300 kN}}
  carriages: {car: {mass: 800 kg, rides: sky}}
  drums: {winch: {at: [0 m, 0 m, 40 m], core_diameter: 480 mm, face_width: 400 mm, flange_diameter: 560 mm, layers: auto,
                  length_on_drum: 60 m}}
  reevings: [{rope: sky, path: [{drum: winch}, {through: car}, {anchor: b}], length: 210 m}]
analyses: [)" +
         analysis + "]\n";
}

// The rope that a drum takes in lies on it, whichever way its length is found.
TEST(DriveUses, ADrumHoldsWhatAGivenSagOrPullTakesIn) {
  for (const char* given : {"sag: 8 m", "winch_pull: 60 kN"}) {
    const Result r = run_text(on_its_drum(
        std::string("{equilibrium: {carriage: car, x: 100 m, held: true, given: {reeving: sky, ") + given + "}}}"));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    const double free = taut_test::value_of(r, "sky.unstretched");
    EXPECT_LT(free, 203) << given;
    EXPECT_NEAR(taut_test::check_of(r, "winch.capacity").value, 270 - free, 1e-9) << given;
    EXPECT_EQ(to_text(verdict_of(r)->kind), "fails") << given;
  }
}

// A rope whose free length is swept is hauled in: the rest is on its drum.
TEST(DriveUses, ADrumHoldsWhatASweepTakesIn) {
  const Result r = run_text(
      on_its_drum("{sweep: {parameter: reevings.sky.length, from: 210 m, to: 203 m, steps: 2, carriage: car, x: 100 m, "
                  "held: true}}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(taut_test::check_of(r, "winch.capacity").value, 67, 1e-9);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "fails");
}

// At rest a brake needs no inertia, in a motion it does. A face is as wide as one turn.
TEST(DriveUses, WhatADrumNeeds) {
  const auto brake = [](const std::string& analyses, const std::string& drum = "") {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN, diameter: 16 mm}}
  bodies: {load: {mass: 1 t, at: [0.2 m, 0 m, 0 m], free: [z]}}
  drums: {winch: {at: [0 m, 0 m, 20 m], core_diameter: 400 mm, brake_torque: 3 kN m)" +
                    drum + R"(}}
  reevings: [{rope: r, path: [{drum: winch}, {anchor: load}], length: 20 m}]
analyses: [)" + analyses +
                    "]\nchecks: {ropes: {r: {safety_factor: 5}}}\n");
  };
  EXPECT_TRUE(taut_test::check_of(brake("{equilibrium: {}}"), "winch.brake_torque").passes);
  taut_test::expect_mistake(brake("{transient: {duration: 1 s}}"), "needs the 'inertia' of what it stops");
  taut_test::expect_mistake(brake("{equilibrium: {}}", ", face_width: 10 mm"), "a rope of 16 mm has no room on 10 mm");
}

}  // namespace taut::drive_uses_winch_test
