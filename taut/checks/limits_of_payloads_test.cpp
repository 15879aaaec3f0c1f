#include "taut/checks/limits_of_payloads.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::limits_of_payloads_test {

using taut_test::check_of;
using taut_test::has_check;
using taut_test::run_text;
using taut_test::value_of;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A clamped carriage of 300 kg with 0.5 t on a line of 200 m, 300 kN, 45 m and more over flat ground.
std::string line(const std::string& limits, const std::string& more, const std::string& checks = {}) {
  return R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 60 m], B: [200 m, 0 m, 80 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm, damping_ratio: 0.05}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, length_before: 101 m}}
  reevings: [{rope: sky, path: [{anchor: A}, {through: car}, {anchor: B}], length: 203.5 m}]
  loads: [{at: car, mass: 0.5 t, name: logs}]
  terrain: {x: [-10 m, 210 m], z: [0 m, 0 m]}
analyses:
  - payload: {carriage: car, from: 80 m, to: 120 m, steps: 4, limits: {)" +
         limits + "}}\n" + more + checks;
}

std::string envelope(const std::string& load, const std::string& more = {}) {
  return fmt::format("  - envelope: {{carriage: car, from: 80 m, to: 120 m, steps: 4, loads: [{}]{}}}\n", load, more);
}

// The load of the envelope is 5 t, the payload 2.7 t: what the rule of the payload does not allow, `checks` do not.
TEST(LimitsOfPayloads, ATensionLimitHoldsInOtherAnalysesToo) {
  for (const char* limit : {"sky: {rule: safety.skyline.ch}", "sky: {safety_factor: 3}", "sky: {tension: 100 kN}"}) {
    SCOPED_TRACE(limit);
    const Result more = run_text(line(limit, envelope("5 t")));
    EXPECT_EQ(verdict_of(more)->kind, VerdictKind::fails) << verdict_of(more)->reason;
    const Check& c = check_of(more, "sky.payload_T_max");
    EXPECT_NEAR(c.limit, 100e3, 1e-6);
    EXPECT_NEAR(c.value / value_of(more, "sky.T_max_envelope"), 1, 1e-12);
    EXPECT_NEAR(300e3 / c.value, value_of(more, "sky.safety_factor"), 1e-9);
    EXPECT_THAT(c.where, HasSubstr("envelope"));
    const Result less = run_text(line(limit, envelope("2.5 t")));
    EXPECT_EQ(verdict_of(less)->kind, VerdictKind::passes) << verdict_of(less)->reason;
    EXPECT_NEAR(check_of(less, "sky.payload_T_max").utilisation, 1, 1e-9);
    const Result beside = run_text(line(limit, envelope("5 t", ", judge: false")));
    EXPECT_NE(verdict_of(beside)->kind, VerdictKind::fails) << verdict_of(beside)->reason;
  }
  // whichever analysis comes first: equilibria and load paths are solved before all others
  const Result path =
      run_text(line("sky: {tension: 30 kN}", "  - load_path: {carriage: car, from: 80 m, to: 120 m, steps: 4}\n"),
               {"machine.loads.logs.mass=1.5 t", "analyses[0].payload.limits.sky.tension=200 kN"});
  EXPECT_EQ(verdict_of(path)->kind, VerdictKind::passes) << verdict_of(path)->reason;
  const Result over =
      run_text(line("sky: {tension: 25 kN}", "  - equilibrium: {carriage: car, x: 100 m}\n"),
               {"analyses[0].payload.from=5 m", "analyses[0].payload.to=10 m", "analyses[0].payload.steps=1"});
  EXPECT_GT(value_of(over, "payload_min"), 0);
  EXPECT_EQ(check_of(over, "sky.payload_T_max").where, "at rest");
  EXPECT_EQ(verdict_of(over)->kind, VerdictKind::fails) << verdict_of(over)->reason;
}

// Each payload has its own limits.
TEST(LimitsOfPayloads, AnotherPayloadKeepsItsOwn) {
  const std::string weaker =
      "  - payload: {name: rare, carriage: car, from: 80 m, to: 120 m, steps: 4, limits: {sky: {safety_factor: 2}}}\n";
  const Result r = run_text(line("sky: {safety_factor: 3}", weaker));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes) << verdict_of(r)->reason;
  EXPECT_NEAR(check_of(r, "sky.payload_T_max").value, 100e3, 1);
  EXPECT_NEAR(check_of(r, "sky.payload_T_max_rare").value, 150e3, 1);
}

// An unverified rule limits a payload as it limits a rope of `checks`: with a doubt that can be refused and confirmed.
TEST(LimitsOfPayloads, AnUnverifiedRuleIsDoubted) {
  const std::string rule = "sky: {rule: safety.ropeway_track}";
  const Result doubted = run_text(line(rule, ""));
  EXPECT_EQ(verdict_of(doubted)->kind, VerdictKind::passes_with_warnings) << verdict_of(doubted)->reason;
  EXPECT_THAT(check_of(doubted, "sky.payload_T_max").trust, testing::StartsWith("UNVERIFIED: "));
  const Result refused = run_text(line(rule, "", "checks: {refuse_unverified: true}\n"));
  EXPECT_TRUE(check_of(refused, "sky.payload_T_max").refused);
  EXPECT_EQ(verdict_of(refused)->kind, VerdictKind::not_judged) << verdict_of(refused)->reason;
  const Result confirmed = run_text(line(rule, "", "checks: {refuse_unverified: true, confirmed: [EN 12927]}\n"));
  EXPECT_EQ(verdict_of(confirmed)->kind, VerdictKind::passes) << verdict_of(confirmed)->reason;
  EXPECT_EQ(verdict_of(run_text(line("sky: {rule: safety.skyline.ch}", "")))->kind, VerdictKind::passes);
}

// So is a breaking force that was recalled; a tension of the deck rests on none.
TEST(LimitsOfPayloads, AnUnverifiedBreakingForceIsDoubted) {
  const auto limited = [](const char* limit, const char* checks) {
    std::string deck = line(limit, "", checks);
    const std::string own = "mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm";
    deck.replace(deck.find(own), own.size(), R"(rope: "GOST 2688-80|6x19(1+6+6/6)-FC|18|1570", stiffness: 20 MN)");
    return run_text(deck);
  };
  const Result doubted = limited("sky: {safety_factor: 3}", "");
  EXPECT_EQ(verdict_of(doubted)->kind, VerdictKind::passes_with_warnings) << verdict_of(doubted)->reason;
  EXPECT_THAT(check_of(doubted, "sky.payload_T_max").trust, testing::StartsWith("UNVERIFIED: breaking force"));
  const Result refused = limited("sky: {safety_factor: 3}", "checks: {refuse_unverified: true}\n");
  EXPECT_EQ(verdict_of(refused)->kind, VerdictKind::not_judged) << verdict_of(refused)->reason;
  const Result confirmed = limited("sky: {safety_factor: 3}", "checks: {confirmed: [GOST 2688-80]}\n");
  EXPECT_EQ(verdict_of(confirmed)->kind, VerdictKind::passes) << verdict_of(confirmed)->reason;
  EXPECT_EQ(check_of(limited("sky: {tension: 50 kN}", ""), "sky.payload_T_max").trust, "user");
}

TEST(LimitsOfPayloads, OtherLimitsLeaveAnotherAnalysisUnjudged) {
  const std::string checks = "checks: {ropes: {sky: {safety_factor: 1.2}}, confirmed: [elastic_limit]}\n";
  const Result deep =
      run_text(line("clearance: 50 m", envelope("5 t"), checks), {"machine.ropes.sky.breaking_force=600 kN"});
  EXPECT_EQ(verdict_of(deep)->kind, VerdictKind::not_judged) << verdict_of(deep)->reason;
  EXPECT_THAT(deep.unmade, Contains(HasSubstr("the payload limits the clearance of 'car' to 50 m")));
  const Result high = run_text(line("clearance: 50 m", envelope("0.1 t"), checks));
  EXPECT_THAT(high.unmade, Not(Contains(HasSubstr("the payload limits"))));
  // beyond the way of the payload its clearance is not asked for
  const std::string away = "  - envelope: {carriage: car, from: 10 m, to: 40 m, steps: 3, loads: [5 t]}\n";
  const Result beyond = run_text(line("clearance: 50 m", away, checks));
  EXPECT_THAT(beyond.unmade, Not(Contains(HasSubstr("the payload limits"))));
}

// A jolt of 20 kN in 0.2 s: the rope has more than with the payload, which is the most that it may have at rest.
TEST(LimitsOfPayloads, AMotionWithMoreNeedsALimitOfItsOwn) {
  const auto with = [&](const char* limit, const std::string& checks) {
    std::string deck = line(fmt::format("sky: {{tension: {}}}", limit),
                            "  - transient: {duration: 2 s, output_step: 50 ms, tolerance: 1e-3}\n", checks);
    deck.replace(deck.find("  terrain:"), 10,
                 "  signals: {jolt: {ramp: {to: 20 kN, start: 0.1 s, duration: 0.2 s}}}\n"
                 "  terrain:");
    deck.replace(deck.find("name: logs}"), 11, "name: logs}, {at: car, force: [0 kN, 0 kN, -1 kN], signal: jolt}");
    return run_text(deck);
  };
  const Result peak = with("60 kN", {});
  ASSERT_EQ(peak.status, Status::ok) << peak.message << to_text(peak.errors);
  EXPECT_EQ(verdict_of(peak)->kind, VerdictKind::not_judged) << verdict_of(peak)->reason;
  EXPECT_THAT(peak.unjudged, Contains("sky"));
  EXPECT_THAT(peak.warnings, Contains(HasSubstr("is one of a rope at rest")));
  const Result strong = with("200 kN", {});
  EXPECT_THAT(strong.unjudged, Not(Contains("sky"))) << verdict_of(strong)->reason;
}

}  // namespace taut::checks::limits_of_payloads_test
