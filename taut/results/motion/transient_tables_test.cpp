#include "taut/results/motion/transient_tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test/support/machine_decks.hpp"

/// Checks that a motion's own tables make.
namespace taut::results::transient_tables_test {

using taut_test::check_of;
using taut_test::has_check;
using taut_test::run_text;

/// 1.5 t on the ground, on a rope that is slack: 0.1 m/s from 0.5 s on.
Result picked_up(const std::string& duration) {
  return run_text(R"(taut: 1
machine:
  signals: {up: {sequence: [{at: 0.5 s, to: 0.1 m/s, over: 0.3 s, smooth: true}]}}
  points: {foot: {body: hook, at: [0 m, 0 m, -0.1 m]}}
  ropes: {h: {mass: 0.8 kg/m, stiffness: 9.8 MN, breaking_force: 140 kN, damping_ratio: 0.05}}
  bodies: {hook: {mass: 1500 kg, at: [0.2 m, 0 m, 2 m], free: [x, z]}}
  faces: {gr: {from: [-3 m, 0 m, 1.9 m], to: [3 m, 0 m, 1.9 m], normal: [0, 0, 1]}}
  contacts: [{point: foot, face: gr, stiffness: 3 MN/m, damping: 20 kN s/m, static_friction: 0.5}]
  sheaves: {head: {at: [0 m, 0 m, 12 m], diameter: 400 mm, efficiency: 0.98, inertia: 0.5 kg m^2}}
  drums: {winch: {at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, inertia: 150 kg m^2, drive: {speed: up}}}
  reevings: [{rope: h, path: [{drum: winch}, {over: head}, {anchor: hook}], length: 22.8 m, may_slack: true}]
analyses: [{transient: {output_step: 50 ms, tolerance: 1e-4, hoist_factor: {rope: h, speed: 0.1 m/s}, duration: )" +
                  duration + "}}]\nchecks: {ropes: {h: {dynamic_safety_factor: 4}}}\n");
}

TEST(HoistFactor, OfALoadFromTheGroundIsByItsWeight) {
  const Result r = picked_up("10 s");
  const Check phi = check_of(r, "h.phi2");
  const double static_tension = 1500 * 9.80665 / 0.98;  // on the drum's side of the sheave
  EXPECT_NEAR(phi.value, taut_test::value_of(r, "h.T_max") / static_tension, 0.02) << phi.rule;
  EXPECT_GT(phi.value, 1.05);
  EXPECT_LT(phi.value, 2);
  EXPECT_NE(phi.rule.find("peak over static tension of the end"), std::string::npos) << phi.rule;
}

TEST(HoistFactor, WithoutALoadThatHangsItIsNotJudged) {
  const Result r = picked_up("0.7 s");
  EXPECT_FALSE(has_check(r, "h.phi2"));
  ASSERT_FALSE(r.unmade.empty()) << r.message << to_text(r.errors);
  EXPECT_NE(r.unmade[0].find("h.phi2: the rope bears nothing where the motion begins"), std::string::npos)
      << r.unmade[0];
}

/// 2 t that stand on the ground, on a rope that is taut with 59 N or so: hoisted at 0.4 m/s. By hand the tension is
/// m g + v sqrt(k m) with k = EA/L = 2 MN/10 m: 19.6 kN + 8 kN = 28 kN or a little more, as the start is smooth.
Result hoisted_from_the_ground(const std::string& damping, const std::string& duration) {
  return run_text(R"(taut: 1
machine:
  signals: {v: {ramp: {to: 0.4 m/s, start: 0.1 s, duration: 0.2 s, smooth: true}}}
  points: {foot: {body: w, at: [0 m, 0 m, 0 m]}}
  ropes: {r: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 300 kN}}
  bodies: {w: {mass: 2 t, at: [0 m, 0 m, 0 m], free: [z]}}
  faces: {g: {from: [-2 m, 0 m, 0 m], to: [2 m, 0 m, 0 m]}}
  contacts: [{point: foot, face: g, stiffness: 100 MN/m, damping: 100 kN s/m}]
  drums: {d: {at: [-0.21 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {speed: v}}}
  reevings: [{rope: r, path: [{drum: d}, {anchor: w}], length: 9.9999 m}]
analyses: [{transient: {output_step: 10 ms, tolerance: 1e-4, hoist_factor: {rope: r, class: HC2, speed: 0.4 m/s}, damping_ratio: )" +
                  damping + ", duration: " + duration + "}}]\nchecks: {ropes: {r: {dynamic_safety_factor: 4}}}\n");
}

// The load swings to the end: phi2 was 28 kN over the 59 N of the start, 476.
TEST(HoistFactor, ATautRopeThatDoesNotBearItsLoadYetIsNoTensionAtRest) {
  const Result swings = hoisted_from_the_ground("0", "4 s");
  ASSERT_EQ(swings.status, Status::ok) << swings.message << to_text(swings.errors);
  EXPECT_FALSE(has_check(swings, "r.phi2"));
  EXPECT_EQ(swings.find_value("r.dynamic_factor"), nullptr);
  ASSERT_FALSE(swings.unmade.empty());
  EXPECT_NE(swings.unmade[0].find("r.phi2: the rope does not bear its load"), std::string::npos) << swings.unmade[0];
  EXPECT_NE(swings.unmade[0].find("'damping_ratio'"), std::string::npos) << swings.unmade[0];
  // with damping it hangs still with its weight in the end
  const Result still = hoisted_from_the_ground("0.1", "10 s");
  const double T_max = taut_test::value_of(still, "r.T_max"), weight = 2000 * 9.80665;
  EXPECT_NEAR(check_of(still, "r.phi2").value, T_max / weight, 0.01 * T_max / weight);
  EXPECT_LT(check_of(still, "r.phi2").value, 1 + 0.4 / 9.80665 * 10 + 0.05);
  EXPECT_EQ(still.find_value("r.dynamic_factor"), nullptr);
}

/// 1 t at rest on a rope of 19.588 m, or one that is shorter or longer by `slack`, as assembled: hauled in from 0.5 s
/// on.
Result assembled(double slack, const std::string& duration) {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{up: {{sequence: [{{at: 0.5 s, to: 0.1 m/s, over: 0.3 s, smooth: true}}]}}}}
  ropes: {{h: {{mass: 0 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.2}}}}
  bodies: {{hook: {{mass: 1 t, at: [0.2 m, 0 m, 5 m], free: [z]}}}}
  sheaves: {{head: {{at: [0 m, 0 m, 12 m], diameter: 400 mm}}}}
  drums: {{winch: {{at: [-5 m, 0 m, 1 m], core_diameter: 400 mm, drive: {{speed: up}}}}}}
  reevings: [{{rope: h, path: [{{drum: winch}}, {{over: head}}, {{anchor: hook}}], length: {} m, may_slack: true}}]
analyses: [{{transient: {{output_step: 50 ms, tolerance: 1e-4, start: assembled, hoist_factor: {{rope: h, speed: 0.1 m/s}}, duration: {}}}}}]
checks: {{ropes: {{h: {{dynamic_safety_factor: 4}}}}}}
)",
                              19.588 + slack, duration));
}

// At its start the rope, 0.1 m too short, bears 9.81 kN + 0.1 m x 5 MN/19.5 m = 35 kN.
TEST(HoistFactor, AnAssembledStartOutOfBalanceIsNoTensionAtRest) {
  const Result r = assembled(-0.1, "8 s");
  const double T_max = taut_test::value_of(r, "h.T_max");
  EXPECT_GT(T_max, 20e3);
  EXPECT_NEAR(check_of(r, "h.phi2").value, T_max / 9806.65, 0.02 * T_max / 9806.65);
  EXPECT_EQ(r.find_value("h.dynamic_factor"), nullptr);
  const Result ends_early = assembled(-0.1, "0.7 s");
  EXPECT_FALSE(has_check(ends_early, "h.phi2"));
  ASSERT_FALSE(ends_early.unmade.empty());
  EXPECT_NE(ends_early.unmade[0].find("h.phi2: the rope is out of balance with its load"), std::string::npos)
      << ends_early.unmade[0];
}

/// A cage of 6 t that is lowered down a shaft of 640 m in a loop of its rope. The falls run over a light sheave of the
/// cage, or one with inertia.
bool told_of_inertia(const std::string& mass, const std::string& sheave = "") {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {v: {sequence: [{at: 0.5 s, to: -8 m/s, over: 4 s, smooth: true}]}}
  ropes: {r: {stiffness: 120 MN, breaking_force: 1500 kN, damping_ratio: 0.2, mass: )" +
                            mass + R"(}}
  bodies: {cage: {mass: 6 t, at: [34 m, 0 m, -600 m], free: [z]}}
  points: {top: [36 m, 0 m, 40 m]}
  sheaves:
    s: {at: [30 m, 0 m, 40 m], diameter: 4 m, inertia: 2000 kg m^2}
    b: {body: cage, at: [0 m, 0 m, 0 m], diameter: 4 m)" +
                            sheave + R"(}
  drums: {w: {at: [0 m, 0 m, 0 m], core_diameter: 4 m, inertia: 20000 kg m^2, drive: {speed: v}}}
  reevings: [{rope: r, path: [{drum: w}, {over: s}, {over: b}, {anchor: top}], length: 1340 m}]
analyses: [{transient: {duration: 6 s, output_step: 50 ms, tolerance: 1e-3}}]
checks: {ropes: {r: {dynamic_safety_factor: 3}}}
)");
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& words) {
    return words.find("the inertia of 'r' along itself is not counted where") != std::string::npos;
  });
}

TEST(MassAlongARope, IsToldWhereItIsMuch) {
  EXPECT_TRUE(told_of_inertia("8 kg/m"));
  EXPECT_FALSE(told_of_inertia("8 kg/m", ", inertia: 10 kg m^2"));
  EXPECT_FALSE(told_of_inertia("0.5 kg/m"));
}

}  // namespace taut::results::transient_tables_test
