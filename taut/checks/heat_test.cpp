#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::heat_test {

using taut_test::run_text;
using testing::AnyOf;
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

}  // namespace taut::checks::heat_test
