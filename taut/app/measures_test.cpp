#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "test/support/machine_decks.hpp"

namespace taut_test::measures_test {

/// A mass let go on a rope over an arm: x is its distance along the arm, z from it.
std::string deck(const std::string& measures, const std::string& more = "") {
  return fmt::format(R"(taut: 1
parameters: {{l: 5 m, up: 30 deg}}
machine:
  gravity: 9.81 m/s^2
  bodies:
    arm: {{at: [1 m, 0 m, 2 m], motion: {{ry: '= -up'}}}}
    hook: {{mass: 300 kg, at: [10 m, 0 m, = -l - 1 m], free: [x, z]}}
  points: {{tip: {{body: arm, at: [10 m, 0 m, 0 m]}}}}
  ropes: {{hoist: {{mass: 0 kg/m, stiffness: 10 MN}}}}
  reevings: [{{rope: hoist, path: [{{anchor: tip}}, {{anchor: hook}}], length: 40 m, may_slack: true}}]
  measures:
{}
{}
analyses: [transient: {{duration: 1 s, output_step: 0.05 s, start: assembled}}]
)",
                     measures, more);
}

TEST(Measures, AFallSeenFromAnArm) {
  const taut::Result r = run_text(deck(R"(
    fall: {of: hook.z, relative: difference, factor: -1}
    out: {of: hook.x, seen_from: arm, offset: -1 m}
    below: {of: hook.z, seen_from: arm}
    away: {of: hook.vx, seen_from: arm}
    late: {of: hook.vz, since: 0.5 s, value: max}
    times: {of: hook.vz, since: 0.5 s, relative: ratio}
    speed: {of: hook.vz, mean: {from: 0.25 s, to: 0.75 s}}
    deep: {of: hook.vz, mean: {of: fall, from: 1 m, to: 3 m}}
)"));
  const double g = 9.81, c = std::cos(std::numbers::pi / 6), s = 0.5;
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "fall"), g / 2, 1e-5);
  EXPECT_NEAR(value_of(r, "fall_min"), 0, 1e-12);
  EXPECT_NEAR(value_of(r, "fall_max"), g / 2, 1e-5);
  // seen from (1, 0, 2) along (c, 0, s) and (-s, 0, c)
  const double x = 9, z = -8 - g / 2;
  EXPECT_NEAR(value_of(r, "out"), c * x + s * z - 1, 1e-5);
  EXPECT_NEAR(value_of(r, "below"), -s * x + c * z, 1e-5);
  EXPECT_NEAR(value_of(r, "away"), -s * g, 1e-5);
  EXPECT_NEAR(value_of(r, "late"), -0.5 * g, 1e-4);
  EXPECT_NEAR(value_of(r, "late_min"), -g, 1e-5);
  EXPECT_NEAR(value_of(r, "times_end"), 2, 1e-4);
  EXPECT_NEAR(value_of(r, "speed"), -0.5 * g, 1e-5 * g);
  // over time from sqrt(2/g) to sqrt(6/g): mean of v is the way over the time
  EXPECT_NEAR(value_of(r, "deep"), -2 / (std::sqrt(6 / g) - std::sqrt(2 / g)), 1e-2);
  EXPECT_EQ(r.series.at(0).columns.back().name, "deep");
}

/// Where a measure begins or ends within a step: steps are long in a motion of one speed, and in one by given steps.
TEST(Measures, BeginAndEndWithinSteps) {
  for (const char* step : {"", ", step: 0.4 s", ", method: verlet"}) {
    const taut::Result r = run_text(fmt::format(R"(taut: 1
machine:
  signals: {{x: {{formula: "0.5 m/s * t"}}}}
  points: {{q: [0 m, 0 m, 40 m]}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 2 MN}}}}
  bodies:
    block: {{mass: 200 kg, at: [0 m, 0 m, 0 m], motion: {{x: x}}}}
    load: {{mass: 100 kg, at: [0 m, 0 m, 20 m], free: [x, z]}}
  reevings: [{{rope: r, path: [{{anchor: q}}, {{anchor: load}}], length: 20 m, may_slack: true}}]
  measures:
    way: {{of: block.x, since: 1.3 s, relative: difference}}
    ratio: {{of: block.x, since: 1.3 s, relative: ratio}}
    mean: {{of: block.x, mean: {{from: 1.3 s, to: 2.7 s}}}}
    short: {{of: block.x, mean: {{from: 1.3 s, to: 1.6 s}}}}
    late: {{of: block.x, since: 1.5 s, mean: {{from: 1.3 s, to: 1.6 s}}}}
    by_place: {{of: block.x, factor: 2, mean: {{of: block.x, from: 0.55 m, to: 1.05 m}}}}
    least: {{of: block.x, since: 3.3 s, value: min}}
analyses: [transient: {{duration: 4 s, output_step: 2 s, tolerance: 1e-3, start: settled{}}}]
)",
                                                step));
    ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
    EXPECT_NEAR(value_of(r, "way"), 1.35, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "ratio"), 4 / 1.3, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "mean"), 1, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "short"), 0.725, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "late"), 0.775, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "by_place"), 1.6, 1e-9) << step;
    EXPECT_NEAR(value_of(r, "least"), 1.65, 1e-9) << step;
  }
}

TEST(Measures, StopAMotion) {
  const taut::Result r = run_text(
      deck("    fall: {of: hook.z, relative: difference, factor: -1}", "  events: [{when: fall > 2 m, stop: true}]"));
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "fall"), 2, 1e-5);
}

TEST(Measures, MistakesAreToldAtTheirPlace) {
  const auto reported = [](const std::string& measure) { return to_text(run_text(deck("    a: " + measure)).errors); };
  EXPECT_NE(reported("{of: hok.z}").find("machine.measures.a.of: 'hok' names no body"), std::string::npos);
  EXPECT_NE(reported("{of: hook.z, seen_from: arn}").find("there is no body 'arn'; did you mean 'arm'?"),
            std::string::npos);
  EXPECT_NE(reported("{of: hoist.T_max, seen_from: arm}").find("belongs to a place"), std::string::npos);
  EXPECT_NE(reported("{of: hook.z, offset: 1 kN}").find("machine.measures.a.offset"), std::string::npos);
  EXPECT_NE(reported("{of: hook.z, mean: {from: 2 s, to: 1 s}}").find("must not be below 'from'"), std::string::npos);
  EXPECT_NE(reported("{of: hook.z, mean: {from: 2 m, to: 3 m}}").find("machine.measures.a.mean.from"),
            std::string::npos);
  EXPECT_NE(reported("{of: hook.z, value: mean}").find("a mean needs 'mean'"), std::string::npos);
  EXPECT_NE(to_text(run_text(deck("    a.b: {of: hook.z}")).errors).find("without blanks, dots and brackets"),
            std::string::npos);
  const taut::Result never = run_text(deck("    a: {of: hook.z, mean: {from: 2 s, to: 3 s}}"));
  EXPECT_EQ(never.find_value("a"), nullptr);
  ASSERT_EQ(never.warnings.size(), 1U);
  EXPECT_NE(never.warnings[0].find("a has no value"), std::string::npos);
  for (const char* taken : {"relative: difference", "value: max"}) {
    const taut::Result after = run_text(deck(fmt::format("    a: {{of: hook.z, since: 1000 s, {}}}", taken)));
    EXPECT_EQ(after.find_value("a"), nullptr) << taken;
    EXPECT_EQ(after.find_value("a_max"), nullptr) << taken;
    ASSERT_EQ(after.warnings.size(), 1U) << taken;
    EXPECT_NE(after.warnings[0].find("a has no value"), std::string::npos) << taken;
  }
}

/// A column `t` beside the time would be taken for it, and a value T_max for the machine's.
TEST(Measures, NamesOfColumnsAndValuesAreTaken) {
  const auto first_error = [](const std::string& measures, const std::string& more = "") {
    const taut::Result r = run_text(deck(measures, more));
    EXPECT_EQ(r.status, taut::Status::bad_deck);
    return r.errors.empty() ? std::string() : to_text(r.errors);
  };
  EXPECT_NE(first_error("    t: {of: hook.z}").find("'t' is the time in the series"), std::string::npos);
  EXPECT_NE(first_error("    T_max: {of: hoist.T_max}").find("name of another value"), std::string::npos);
  const std::string signal = "    out: {of: hook.x}\n  signals: {t: {constant: 1 kN}}\n";
  EXPECT_NE(first_error(signal + "  observe: [hook.z, t]").find("'t' is the time in the series"), std::string::npos);
  EXPECT_EQ(run_text(deck(signal + "  observe: [hook.z]")).status, taut::Status::ok) << "a signal may be called so";
}

}  // namespace taut_test::measures_test
