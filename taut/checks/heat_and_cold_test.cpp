#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::heat_and_cold_test {

using taut_test::run_text;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A guy between two points, judged as such and for a payload; `more`: further lines of `checks`.
Result guyed(const std::string& degrees, const std::string& more = "") {
  return run_text(fmt::format(R"(taut: 1
machine:
  temperature: {}
  ropes: {{steel: {{mass: 2.3 kg/m, stiffness: 30 MN, breaking_force: 400 kN, diameter: 24 mm}}}}
  points: {{top: [0 m, 0 m, 20 m], stump: [20 m, 0 m, 0 m], far: [80 m, 0 m, 20 m]}}
  guys: {{g: {{rope: steel, from: top, to: stump, length: 28.28 m}}}}
  carriages: {{car: {{mass: 300 kg, rides: line, at: [40 m, 0 m, 17 m]}}}}
  reevings: [{{name: line, rope: steel, path: [{{anchor: top}}, {{through: car}}, {{anchor: far}}], length: 81 m}}]
analyses:
  - payload: {{carriage: car, from: 40 m, to: 40 m, held: true, limits: {{line: {{safety_factor: 3}}}}}}
checks:
  guys: {{g: {{safety_factor: 3}}}}
{})",
                              degrees, more));
}

// A rope at 250 degC has three quarters of its strength, and keeps no factor of 3 that the cold one just keeps.
TEST(Heat, GuysAndPayloadsOfHotRopesAreNotJudged) {
  const Result cold = guyed("20 degC");
  ASSERT_EQ(cold.status, Status::ok) << cold.message << to_text(cold.errors);
  EXPECT_THAT(cold.unmade, Not(Contains(HasSubstr("weaker"))));
  const Result hot = guyed("250 degC");
  ASSERT_EQ(hot.status, Status::ok) << hot.message << to_text(hot.errors);
  EXPECT_EQ(verdict_of(hot)->kind, VerdictKind::not_judged);
  EXPECT_THAT(hot.unmade, Contains(HasSubstr("g: how much weaker it is at 250 degC is not checked")));
  EXPECT_THAT(hot.unmade, Contains(HasSubstr("line: how much weaker it is at 250 degC is not checked")));
  const Result weakened = guyed("250 degC", "  ropes: {steel: {safety_factor: 3, core: IWRC}}\n");
  EXPECT_THAT(weakened.unmade, Not(Contains(HasSubstr("weaker"))));
  EXPECT_EQ(verdict_of(weakened)->kind, VerdictKind::fails);
  // each check of the strength, not the rope's own factor alone: 400 kN/3 in the cold, 100 kN in the heat
  EXPECT_NEAR(taut_test::check_of(weakened, "line.payload_T_max").value, 400e3 / 3, 10);
  EXPECT_NEAR(taut_test::check_of(weakened, "line.payload_T_max").limit, 100e3, 1e-6);
  EXPECT_NEAR(taut_test::check_of(weakened, "g.guy_safety").value,
              0.75 * taut_test::check_of(cold, "g.guy_safety").value, 0.05);
}

// With nothing but a temperature under `ropes` the payload's limit is what judges the rope.
TEST(Heat, ALimitOfAPayloadIsThatOfTheHotRope) {
  const auto at = [](const char* degrees) {
    return guyed("20 degC", fmt::format("  ropes: {{line: {{core: IWRC, temperature: {}}}}}\n", degrees));
  };
  EXPECT_TRUE(taut_test::check_of(at("20 degC"), "line.payload_T_max").passes);
  const Result hot = at("250 degC");
  EXPECT_FALSE(taut_test::check_of(hot, "line.payload_T_max").passes);
  EXPECT_THAT(taut_test::check_of(hot, "line.payload_T_max").rule,
              HasSubstr("with the cold rope; breaking force x 0.75"));
  const Result unknown = at("420 degC");
  EXPECT_FALSE(taut_test::has_check(unknown, "line.payload_T_max"));
  EXPECT_THAT(unknown.unmade, Contains(HasSubstr("line: the payload's limit by its breaking force is not checked")));
}

TEST(Heat, HotMastsAreNotJudged) {
  const auto mast = [](const char* degrees) {
    return run_text(fmt::format(R"(taut: 1
machine:
  temperature: {}
  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}}
  beams: {{mast: {{from: foot, to: head, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}}}}
  loads: [{{at: mast.top, force: [0.1 kN, 0 kN, -20 kN]}}]
analyses: [{{equilibrium: {{}}}}]
checks: {{masts: {{mast: {{load_factor: 1.35}}}}}}
)",
                                degrees));
  };
  const Result cold = mast("20 degC");
  ASSERT_EQ(cold.status, Status::ok) << cold.message << to_text(cold.errors);
  EXPECT_THAT(cold.unmade, Not(Contains(HasSubstr("weaker and softer"))));
  EXPECT_THAT(mast("390 degC").unmade, Contains(HasSubstr("mast: its steel is weaker and softer at 390 degC")));
}

// A mast that the checks describe, with a load of its own, is no beam of the machine.
TEST(Heat, HotMastsOfTheirOwnAreNotJudged) {
  const char* const mast =
      "  masts: {pole: {height: 8 m, section: CHS 219.1x8, steel: S355, loads: [{at: 8 m, down: 20 kN}]}}\n";
  const Result cold = guyed("20 degC", mast);
  ASSERT_EQ(cold.status, Status::ok) << cold.message << to_text(cold.errors);
  EXPECT_THAT(cold.unmade, Not(Contains(HasSubstr("weaker and softer"))));
  EXPECT_THAT(guyed("390 degC", mast).unmade, Contains(HasSubstr("pole: its steel is weaker and softer at 390 degC")));
}

TEST(Cold, BelowMinus40IsTold) {
  EXPECT_THAT(guyed("-40 degC").warnings, Not(Contains(HasSubstr("brittle"))));
  EXPECT_THAT(guyed("-41 degC").warnings, Contains(HasSubstr("at -41 degC: ropes")));
  const std::string own = "  ropes: {steel: {safety_factor: 3, core: IWRC, temperature: -55 degC}}\n";
  EXPECT_THAT(guyed("20 degC", own).warnings, Contains(HasSubstr("at -55 degC: ropes")));
}

}  // namespace taut::checks::heat_and_cold_test
