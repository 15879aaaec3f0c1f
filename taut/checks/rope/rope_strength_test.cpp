#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::rope_strength_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::has_check;
using taut_test::row_of;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::value_of;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* recalled = "GOST 2688-80|6x19(1+6+6/6)-FC|18|1570";  // 166 kN, unverified
constexpr const char* steel = "EN 12385-4|6x36-IWRC|18|1770";              // 0.356 x 18^2 x 1770 N = 204.2 kN, derived

/// A hinged mast of 12 m on three guys that are put up with 20 kN.
std::string guyed(const std::string& rope, const std::string& checks) {
  return fmt::format(R"(taut: 1
machine:
  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 12 m], s1: [-12 m, 8 m, 0 m], s2: [-12 m, -8 m, 0 m], s3: [14 m, 0 m, 0 m]}}
  ropes: {{guy: {{rope: "{}", stiffness: 12 MN}}}}
  beams: {{mast: {{from: foot, to: head, section: CHS 219.1x10, steel: S355, base: hinge}}}}
  guys:
    g1: {{rope: guy, from: mast.top, to: s1, install: {{tension: 20 kN, at: top}}}}
    g2: {{rope: guy, from: mast.top, to: s2, install: {{tension: 20 kN, at: top}}}}
    g3: {{rope: guy, from: mast.top, to: s3, install: {{tension: 20 kN, at: top}}}}
  loads: [{{at: mast.top, force: [5 kN, 5 kN, -5 kN]}}]
checks:
{}analyses: [{{equilibrium: {{}}}}]
)",
                     rope, checks);
}

/// 4 t on two ropes `r`, the reevings hoist and tag: 2 t on each, 20 kN. `machine`: more lines of it.
std::string hoist(const std::string& ropes, const std::string& machine = "") {
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
{}  points: {{a: [0 m, 0 m, 0 m], b: [1 m, 0 m, 0 m]}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 12 MN, breaking_force: 100 kN, reference_temperature: 300 degC}}}}
  bodies:
    load: {{mass: 2 t, at: [0 m, 0 m, -6 m], free: [x, y, z]}}
    other: {{mass: 2 t, at: [1 m, 0 m, -6 m], free: [x, y, z]}}
  reevings:
    - {{rope: r, name: hoist, path: [{{anchor: a}}, {{anchor: load}}], length: 6 m}}
    - {{rope: r, name: tag, path: [{{anchor: b}}, {{anchor: other}}], length: 6 m}}
analyses: [{{equilibrium: {{}}}}]
checks:
  ropes: {}
)",
                     machine, ropes);
}

// The reader's deck: a hot guy of 204.2 kN with 25.54 kN has the factor 0.75 x 204.2/25.54 = 5.997, and passed 6.4 with
// 7.996. Naming it under `ropes` is what the warning of the heat asks for.
TEST(StrengthInUse, AHotGuyIsJudgedByItsHotStrength) {
  const std::string guys = "  guys: {guy: {safety_factor: 6.4, check_pretension: false, may_go_slack: true}}\n";
  const Result hot = run_text(guyed(steel, "  ropes: {guy: {temperature: 300 degC}}\n" + guys));
  ASSERT_EQ(hot.status, Status::ok) << hot.message << to_text(hot.errors);
  for (const std::string g : {"g1", "g2", "g3"}) {
    const Check& factor = check_of(hot, g + ".guy_safety");
    EXPECT_NEAR(factor.value, value_of(hot, g + ".safety_factor"), 1e-9);
    EXPECT_NEAR(factor.value, 0.75 * 0.356 * 18 * 18 * 1770 / value_of(hot, g + ".T_max"), 0.01);
    EXPECT_THAT(factor.rule, HasSubstr(" x 0.75 ("));
    EXPECT_THAT(factor.trust, StartsWith("UNVERIFIED")) << "the share in the heat is recalled";
  }
  EXPECT_FALSE(check_of(hot, "g3.guy_safety").passes);
  EXPECT_EQ(verdict_of(hot)->kind, VerdictKind::fails);
  // the heat of the machine, which the entry takes over
  const Result around = run_text(guyed(steel, "  ropes: {guy: {}}\n" + guys), {"machine.temperature=300 degC"});
  EXPECT_FALSE(check_of(around, "g3.guy_safety").passes);
  // by its own name too
  const Result own = run_text(guyed(steel, "  ropes: {g3: {temperature: 300 degC}}\n" + guys));
  EXPECT_FALSE(check_of(own, "g3.guy_safety").passes);
  EXPECT_TRUE(check_of(own, "g2.guy_safety").passes);
  // beyond the tables nobody knows
  const Result unknown = run_text(guyed(steel, "  ropes: {guy: {temperature: 420 degC}}\n" + guys));
  EXPECT_FALSE(has_check(unknown, "g3.guy_safety"));
  EXPECT_THAT(unknown.unmade, Contains(HasSubstr("g3: its safety is not checked: no strength is known of a rope at")));
}

// The plate of a spar names a strength, which a hot guy may not have: 0.75 x 204.2 kN = 153 kN.
TEST(StrengthInUse, AHotGuyAgainstThePlateOfItsSpar) {
  const auto plate = [](const std::string& ropes) {
    return run_text(
        guyed(steel, ropes + "  masts: {mast: {load_factor: 1.5, plate: {guys: 3, guy_strength: 200 kN}}}\n"));
  };
  EXPECT_TRUE(check_of(plate(""), "mast.guy_strength_by_plate").passes);
  const Result hot = plate("  ropes: {guy: {temperature: 300 degC}}\n");
  EXPECT_NEAR(check_of(hot, "mast.guy_strength_by_plate").value, 0.75 * 0.356 * 18 * 18 * 1770, 100);
  EXPECT_FALSE(check_of(hot, "mast.guy_strength_by_plate").passes);
  const Result unknown = plate("  ropes: {guy: {temperature: 420 degC}}\n");
  EXPECT_FALSE(has_check(unknown, "mast.guy_strength_by_plate"));
  EXPECT_THAT(unknown.unmade, Contains(HasSubstr("'plate.guy_strength' is not checked")));
}

// A breaking force that was recalled is doubted in all checks that measure by it, not under `ropes` alone.
TEST(StrengthInUse, AnUnverifiedBreakingForceIsDoubtedEverywhere) {
  const auto judged = [](const std::string& rope, const std::string& more) {
    return run_text(guyed(rope, more +
                                    "  guys: {guy: {safety_factor: 6.4, pretension: [0.02, 0.4], may_go_slack: true}}\n"
                                    "  anchors: {s1: {strength: 205 kN, safety_factor: 2, as_strong_as_rope: true}}\n"
                                    "  masts: {mast: {load_factor: 1.5, plate: {guys: 3, guy_strength: 160 kN}}}\n"));
  };
  const char* const names[] = {"g3.guy_safety", "g3.pretension_max", "g3.pretension_min", "s1.anchor_as_rope",
                               "mast.guy_strength_by_plate"};
  const Result doubted = judged(recalled, "  confirmed: [EN 1993-1-1]\n");
  ASSERT_EQ(doubted.status, Status::ok) << doubted.message << to_text(doubted.errors);
  EXPECT_EQ(verdict_of(doubted)->kind, VerdictKind::passes_with_warnings) << verdict_of(doubted)->reason;
  const Result refused = judged(recalled, "  refuse_unverified: true\n  confirmed: [EN 1993-1-1]\n");
  EXPECT_EQ(verdict_of(refused)->kind, VerdictKind::not_judged) << verdict_of(refused)->reason;
  const Result confirmed = judged(recalled, "  confirmed: [EN 1993-1-1, GOST 2688-80]\n");
  EXPECT_EQ(verdict_of(confirmed)->kind, VerdictKind::passes) << verdict_of(confirmed)->reason;
  const Result known = judged(steel, "  confirmed: [EN 1993-1-1]\n");
  for (const char* name : names) {
    EXPECT_TRUE(check_of(doubted, name).passes) << name;
    EXPECT_THAT(check_of(doubted, name).trust, StartsWith("UNVERIFIED: breaking force of the rope GOST")) << name;
    EXPECT_TRUE(check_of(refused, name).refused) << name;
    EXPECT_THAT(check_of(confirmed, name).trust, StartsWith("user")) << name;
    EXPECT_THAT(check_of(known, name).trust, Not(StartsWith("UNVERIFIED"))) << name;
  }
}

TEST(StrengthInUse, TheRatingOfASparDoubtsTheRopeToo) {
  const auto rated = [](const std::string& rope) {
    return run_text(fmt::format(R"(taut: 1
machine:
  points: {{a: [-30 m, 0 m, 40 m], b: [30 m, 0 m, 40 m]}}
  ropes: {{s: {{rope: "{}", stiffness: 12 MN}}}}
  reevings: [{{rope: s, path: [{{anchor: a}}, {{anchor: b}}], tension_at_start: 20 kN}}]
checks: {{lines: {{s: {{spar_rating: 210 kN}}}}}}
)",
                                rope));
  };
  EXPECT_TRUE(check_of(rated(recalled), "s.spar_rating").passes);
  EXPECT_THAT(check_of(rated(recalled), "s.spar_rating").trust, StartsWith("UNVERIFIED: breaking force"));
  EXPECT_EQ(check_of(rated(steel), "s.spar_rating").trust, "verified");
}

// One rope, one entry. By its own and by its rope's name a hot rope of 3.75 passed 4.5 with 5, and the value beside the
// factor 3.75 was 2.81: the share of the heat was in it twice.
TEST(EntryOfARope, ASecondOneIsRefused) {
  const Result second =
      run_text(hoist("{hoist: {safety_factor: 4.5}, tag: {safety_factor: 3}, r: {temperature: 300 degC}}"));
  expect_mistake(second,
                 "deck.yaml:14:68: error: checks.ropes.r: each reeving or guy of 'r' has an entry of its own here, "
                 "'hoist', 'tag'");
  EXPECT_EQ(second.errors.size(), 1U) << to_text(second.errors);
  // whichever comes first
  expect_mistake(run_text(hoist("{r: {elastic_limit: 0.5}, hoist: {safety_factor: 3}, tag: {safety_factor: 3}}")),
                 "deck.yaml:14:14: error: checks.ropes.r: each reeving or guy of 'r'");
}

// An entry of its own takes a reeving out of that of its rope, which goes on for the others; not out of its heat.
TEST(EntryOfARope, TheOwnOneStandsForItsReeving) {
  const Result own = run_text(hoist("{r: {safety_factor: 5}, hoist: {safety_factor: 4, core: IWRC}}"));
  ASSERT_EQ(own.status, Status::ok) << own.message << to_text(own.errors);
  EXPECT_EQ(check_of(own, "hoist.safety_factor").limit, 4);
  EXPECT_EQ(check_of(own, "tag.safety_factor").limit, 5);
  const std::string hot = "r: {safety_factor: 3, core: IWRC, temperature: 300 degC}";
  const Result lost = run_text(hoist("{hoist: {safety_factor: 4.5}, " + hot + "}"));
  expect_mistake(lost, "deck.yaml:14:18: error: checks.ropes.hoist: 'r' gives the rope of 'hoist' a temperature");
  const Result said = run_text(hoist("{hoist: {safety_factor: 4.5, core: IWRC, temperature: 300 degC}, " + hot + "}"));
  ASSERT_EQ(said.status, Status::ok) << said.message << to_text(said.errors);
  for (const std::string name : {"hoist.safety_factor", "tag.safety_factor"}) {
    EXPECT_NEAR(check_of(said, name).value, 0.75 * 100 / 20, 1e-6);
    EXPECT_NEAR(value_of(said, name), 0.75 * 100 / 20, 1e-6);
  }
  EXPECT_FALSE(check_of(said, "hoist.safety_factor").passes);
}

// The factor of the table is that of its state, 5 in the cold, with the share that the heat leaves: 3.75, as the value.
TEST(EntryOfARope, TheTableOfRopesHasTheHotFactor) {
  const Result hot =
      run_text(hoist("{hoist: {safety_factor: 3, core: IWRC, temperature: 300 degC}, tag: {safety_factor: 3}}"));
  ASSERT_EQ(hot.status, Status::ok) << hot.message << to_text(hot.errors);
  const Table& ropes = table_of(hot, "ropes");
  EXPECT_NEAR(cell(ropes, row_of(ropes, "name", "hoist"), "safety_factor"), 3.75, 1e-6);
  EXPECT_NEAR(value_of(hot, "hoist.safety_factor"), 3.75, 1e-6);
  EXPECT_NEAR(cell(ropes, row_of(ropes, "name", "tag"), "safety_factor"), 5, 1e-6);
}

}  // namespace taut::checks::rope_strength_test
