#include <gtest/gtest.h>

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

}  // namespace taut::drive_uses_winch_test
