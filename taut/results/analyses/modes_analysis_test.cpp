#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::results::modes_analysis_test {

using namespace taut_test;
using testing::HasSubstr;

/// An arm that stands on its foot, held a little by a rope, beside a ball on a rope.
std::string standing_arm(const std::string& modes) {
  return "taut: 1\nmachine:\n  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 500 kN}}\n  points: {a: [0 "
         "m, "
         "0 m, 10 m], t: {body: arm, at: [0 m, 0 m, 0.5 m]}, b: [5 m, 0 m, 10 m]}\n  bodies:\n    arm: {mass: 100 kg, "
         "at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 0.5 m], inertia: 10 kg m^2, free: [ry]}\n    ball: {mass: 100 kg, "
         "at: "
         "[5 m, 0 m, 0 m], free: [x, z]}\n  reevings:\n    - {rope: r, name: s, path: [{anchor: a}, {anchor: t}], "
         "length: 9.4999 m}\n    - {rope: r, name: p, path: [{anchor: b}, {anchor: ball}], length: 10 m}\nanalyses: "
         "[modes: " +
         modes + "]\nchecks: {ropes: {r: {safety_factor: 4}}}\n";
}

TEST(ModesAnalysis, AModeThatGrowsIsNoAnswerHoweverFewAreAskedFor) {
  for (const char* modes : {"{count: 1}", "{}"}) {
    const Result r = run_text(standing_arm(modes));
    const auto v = verdict_of(r);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->kind, VerdictKind::no_answer) << modes;
    EXPECT_THAT(v->reason, HasSubstr("grows: the state is not one to stay in"));
    EXPECT_EQ(text_cell(table_of(r, "modes"), 0, "kind"), "unstable");
    EXPECT_EQ(cell(table_of(r, "modes"), 0, "frequency"), 0) << "it does not swing";
  }
}

}  // namespace taut::results::modes_analysis_test
