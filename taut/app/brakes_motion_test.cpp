#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Brakes of drums that hang 1 t: what a drum does once its brake opens, and what its turning brings when it is set.
namespace taut::app::brakes_motion_test {

using namespace taut_test;

Result hung(const std::string& drum, const std::string& signals, const std::string& length, const std::string& event,
            const char* duration) {
  return run_text(fmt::format(
      "taut: 1\nmachine:\n  signals: {{{}}}\n  ropes: {{r: {{mass: 0 kg/m, stiffness: 5 MN, breaking_force: 100 kN, "
      "diameter: 10 mm, damping_ratio: 0.05}}}}\n  bodies: {{hook: {{mass: 1 t, at: [0.2 m, 0 m, -10 m], free: "
      "[z]}}}}\n"
      "  drums: {{w: {{at: [0 m, 0 m, 0 m], core_diameter: 390 mm, {}}}}}\n  reevings: [{{rope: r, path: [{{drum: w, "
      "side: right}}, {{anchor: hook}}]{}}}]\n  events: [{}]\n  observe: [hook.z, r.T_max]\nanalyses: [transient: "
      "{{duration: {}}}]\nchecks: {{ropes: {{r: {{dynamic_safety_factor: 3}}}}}}\n",
      signals, drum, length, event, duration));
}

// a = m g/(m + J/R^2) = 6.54 m/s2 for 3 s.
TEST(BrakesInMotion, ADrumTurnsFreelyOnceItsBrakeOpens) {
  const double fall = 1000 * 9.80665 / (1000 + 20 / (0.2 * 0.2)) * 9 / 2;
  for (const char* drive : {"drive: {brake: set}, brake_torque: 3 kN m, ", ""}) {
    const Result r = hung(fmt::format("{}inertia: 20 kg m^2", drive), "", ", length: 10 m",
                          "{at: 1 s, brake: w, mode: open}", "4 s");
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_NEAR(value_of(r, "hook.z_min"), -10 - fall, 0.03) << drive;
  }
}

// A pull lowers at 1.8 m/s; a torque of nothing in between, or not: the drum's 1000 kg m2 go into the brake.
TEST(BrakesInMotion, ADrumThatPulledTurnsWhenItsBrakeIsSet) {
  const std::string drum = "inertia: 1000 kg m^2, drive: {pull: p}, brake_torque: 6 kN m";
  const std::string signal = "p: {ramp: {from: 9806.65 N, to: 9000 N, start: 0.5 s, duration: 0.5 s}}";
  const Result r = hung(drum, signal, "", "{at: 3 s, brake: w}", "6 s");
  const Result twin = hung(drum, signal, "", "{at: 3 s, drive: w, torque: 0 N m}, {at: 3 s, brake: w}", "6 s");
  EXPECT_NEAR(value_of(r, "hook.z_min"), value_of(twin, "hook.z_min"), 1e-3);
  EXPECT_NEAR(value_of(r, "hook.z_min"), -14.176, 0.01);
  EXPECT_LT(value_of(r, "T_max"), 13e3);
}

// The drive of an event acts once the brake opens, at 3 s: 0.5 m/s for 1 s.
TEST(BrakesInMotion, ANewDriveLeavesASetBrakeAsItIs) {
  const std::string drum = "inertia: 20 kg m^2, drive: {speed: 0 m/s}, brake_torque: 6 kN m";
  const std::string signal = "v: {ramp: {to: 0.5 m/s, start: 3 s, duration: 0.1 s}}";
  const std::string driven = "{at: 1 s, brake: w}, {at: 2 s, drive: w, speed: v}";
  const Result held = hung(drum, signal, ", length: 10 m", driven, "4 s");
  EXPECT_NEAR(value_of(held, "hook.z_end"), -10.01961, 1e-4);
  const Result opened = hung(drum, signal, ", length: 10 m", driven + ", {at: 3 s, brake: w, mode: open}", "4 s");
  EXPECT_NEAR(value_of(opened, "hook.z_end"), -10.01961 + 0.475, 1e-2);
}

// A drum of no diameter is a point: no rope slips in its brake, and there is no D/d.
TEST(BrakesInMotion, ADrumWithoutADiameterIsAPoint) {
  const auto drum = [](const std::string& checks) {
    return run_text(R"(taut: 1
machine:
  signals: {v: {sequence: [{at: 0.2 s, to: 0.3 m/s, over: 0.5 s}]}}
  ropes: {h: {mass: 0 kg/m, stiffness: 6 MN, breaking_force: 300 kN, damping_ratio: 0.1, diameter: 20 mm}}
  bodies: {L: {mass: 1 t, at: [0 m, 0 m, 5 m], free: [z]}}
  drums: {w: {at: [0 m, 0 m, 20 m], drive: {speed: v}}}
  reevings: [{rope: h, path: [{drum: w}, {anchor: L}], length: 15 m}]
analyses: [{transient: {duration: 2 s, tolerance: 1e-3}}]
checks: {ropes: {h: {dynamic_safety_factor: 4)" +
                    checks + "}}}\n");
  };
  const Result plain = drum("");
  EXPECT_TRUE(plain.unsafe.empty()) << plain.unsafe.front();
  ASSERT_TRUE(verdict_of(plain)) << to_text(plain.errors);
  EXPECT_EQ(verdict_of(plain)->kind, VerdictKind::passes) << verdict_of(plain)->reason;
  const Result ratio = drum(", diameter_ratio: 15");
  EXPECT_EQ(verdict_of(ratio)->kind, VerdictKind::not_judged) << verdict_of(ratio)->reason;
  EXPECT_NE(verdict_of(ratio)->reason.find("D/d is not checked: no diameter is known of 'w'"), std::string::npos)
      << verdict_of(ratio)->reason;
}

// A lift of 2 t and 1.6 t on four ropes over a sheave that does not turn begins as it hangs, 4.903 and 3.923 kN a rope:
// it began 12 m lower, with the same tension on both sides, where the load had run off. A tail of 0.5 kN cannot hold 1
// t by a friction of exp(0.12 pi): it slips.
TEST(BrakesInMotion, ARopeOverADrivenSheaveBeginsWithTheTensionsThatItHolds) {
  const auto driven = [](const std::string& bodies, const std::string& path, const std::string& more) {
    return run_text(
        "taut: 1\nmachine:\n  ropes: {r: {mass: 0 kg/m, stiffness: 8 MN, breaking_force: 80 kN, damping_ratio: 0.1}}\n"
        "  bodies: {" +
        bodies +
        "}\n  points: {tail: [1 m, 0 m, 0 m]}\n"
        "  sheaves: {trac: {at: [0.5 m, 0 m, 52 m], diameter: 1 m, friction: 0.12, inertia: 50 kg m^2, "
        "motor: {speed: 0 m/s}}}\n  reevings: [{rope: r, path: " +
        path + ", " + more +
        "}]\n  observe: [r.T_start, r.T_end]\nanalyses: [transient: {duration: 1 s}]\n"
        "checks: {ropes: {r: {dynamic_safety_factor: 3}}}\n");
  };
  const std::string cage = "cage: {mass: 2 t, at: [0 m, 0 m, 10 m], free: [z]}";
  const Result lift = driven(cage + ", cw: {mass: 1.6 t, at: [1 m, 0 m, 40 m], free: [z]}",
                             "[{anchor: cage}, {over: trac}, {anchor: cw}]",
                             "copies: 4, length: 55.57 m, tension_at_start: 4.903325 kN");
  ASSERT_EQ(lift.status, Status::ok) << lift.message << to_text(lift.errors);
  EXPECT_NEAR(value_of(lift, "r.T_start_min"), 4903.325, 1);
  EXPECT_NEAR(value_of(lift, "r.T_end_max"), 3922.66, 1);
  const Result tail =
      driven(cage, "[{anchor: cage}, {over: trac}, {anchor: tail}]", "copies: 2, length: 94 m, tension_at_end: 0.5 kN");
  ASSERT_EQ(tail.status, Status::ok) << tail.message << to_text(tail.errors);
  EXPECT_THAT(tail.unsafe, testing::Contains(testing::HasSubstr("slips on 'trac'")));
}

}  // namespace taut::app::brakes_motion_test
