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

}  // namespace taut::checks::shown_loads_test
