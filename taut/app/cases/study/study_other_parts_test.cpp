#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/calc/verdict.hpp"
#include "test/support/scratch_folder.hpp"

/// What cases have that the deck as it is has not: parts that they load, ropes and sections that they choose.
namespace taut::app::study_other_parts_test {

using testing::HasSubstr;
using testing::Not;

Result study_of(const std::string& text) {
  const Job job{.text = text, .name = "deck.yaml", .set = {}, .progress = {}};
  const taut_test::ScratchFolder scratch;
  const auto study = read_study(job);
  if (!study) throw std::runtime_error(study.error().message + to_text(study.error().errors));
  const auto folder = StudyFolder::make(scratch.path().string(), job, *study);
  if (!folder) throw std::runtime_error(folder.error().message);
  const auto state = run_cases(*study, *folder, {.threads = 2});
  if (!state || !state->whole()) throw std::runtime_error("not whole");
  return study_result(*study, *read_cases(*study, *folder), {.threads = 2, .progress = {}});
}

/// Rope s is 0.2 m longer than r and 10 times as stiff. At 2 t it is slack: r is 0.144 m longer. At 4 t it bears
/// 10.6 kN and r 29.7 kN: (142857 + 1388889) N/m x = 4100 kg g + 277778 N, x = 0.2076 m.
std::string two_ropes(const std::string& study, const std::string& checks = "") {
  return R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes:
    r: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN}
    s: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 30 kN}
  bodies: {hook: {mass: 100 kg, at: [0 m, 0 m, 3 m], free: [x, z]}}
  reevings:
    - {rope: r, path: [{anchor: top}, {anchor: hook}], length: 7 m}
    - {rope: s, path: [{anchor: top}, {anchor: hook}], length: 7.2 m, may_slack: true}
  loads: [{at: hook, mass: 2 t}]
analyses: [equilibrium: {}]
)" + checks +
         "study:\n  vary: {'machine.loads[0].mass': {list: [2 t, 4 t]}}\n  points: grid\n" + study;
}

TEST(StudyOtherParts, APartThatOnlyCasesLoadNeedsALimit) {
  const Result r = study_of(
      two_ropes("  of: [equilibrium.r.safety_factor]\n  limit: {equilibrium.r.safety_factor: {at_least: 2}}\n"));
  EXPECT_NEAR(r.find_value("equilibrium.r.safety_factor.least")->value, 100 / 29.66, 1e-3);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << verdict_of(r)->reason;
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("s (in 1 of 2 cases, the first is case 1:"));
  // a check of the deck as an output makes those of all its parts: s has none
  const Result checked =
      study_of(two_ropes("  of: [checks.r.safety_factor]\n  limit: {checks.r.safety_factor: {at_least: 2}}\n",
                         "checks: {ropes: {r: {safety_factor: 2}}}\n"));
  EXPECT_EQ(verdict_of(checked)->kind, VerdictKind::not_judged) << verdict_of(checked)->reason;
  // the check of s is one of the cases that load it
  const Result both =
      study_of(two_ropes("  of: [checks.r.safety_factor]\n  limit: {checks.r.safety_factor: {at_least: 2}}\n",
                         "checks: {ropes: {r: {safety_factor: 2}, s: {safety_factor: 2}}}\n"));
  EXPECT_THAT(verdict_of(both)->reason, Not(HasSubstr("no limit is given"))) << verdict_of(both)->reason;
}

// The anchor of 25 kN fails at 3 t; no output is of its check.
TEST(StudyOtherParts, ChecksOfTheDeckThatNoCaseMakesAreSaid) {
  const std::string text = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  bodies: {hook: {mass: 100 kg, at: [0 m, 0 m, 3 m], free: [x, z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 7 m}]
  loads: [{at: hook, mass: 2 t}]
analyses: [equilibrium: {}]
checks: {ropes: {r: {safety_factor: 4}}, anchors: {top: {strength: 25 kN, safety_factor: 1}}}
study:
  vary: {'machine.loads[0].mass': {list: [2 t, 3 t, 4 t]}}
  of: [equilibrium.r.safety_factor]
  limit: {equilibrium.r.safety_factor: {at_least: 2}}
  points: grid
)";
  const Result r = study_of(text);
  EXPECT_THAT(r.preface, HasSubstr("no case makes the deck's top.anchor_strength"));
  EXPECT_THAT(r.preface, Not(HasSubstr("r.safety_factor"))) << "the limit of the study takes its place";
}

// The deck as it is chooses 19 and 22 mm; at 60 kN 28 and 32 mm, and nothing is said of what 60 kN do to 19 mm.
TEST(StudyOtherParts, CasesThatChooseOtherRopesAreTold) {
  const auto loop = [](const std::string& ropes) {
    return study_of(R"(taut: 1
method: closed_loop
input:
  span: 200 m
  slope: -8 deg
  position: [100 m]
  sag: 10 m
  gathering_force: 3000 kgf
  gathering_angle: 30 deg
  carriage_weight: 2 kN
  tail_efficiency: 0.95
  tail_sheaves: 2
  haul: in
  roller: free
)" + ropes + R"(
study:
  vary: {input.gathering_force: {list: [29 kN, 60 kN]}}
  of: [K]
  limit: {K: {at_most: 300 kN}}
  points: grid
)");
  };
  const Result chosen =
      loop("  safety_factor: 3.5\n  choose_ropes: {construction: 6x36, core: IWRC, grade: 1960 MPa}\n");
  ASSERT_TRUE(verdict_of(chosen));
  EXPECT_EQ(verdict_of(chosen)->kind, VerdictKind::passes_with_warnings) << verdict_of(chosen)->reason;
  ASSERT_FALSE(chosen.unsafe.empty());
  EXPECT_THAT(chosen.unsafe.front(), HasSubstr("1 of 2 cases choose otherwise than the deck as it is"));
  EXPECT_THAT(chosen.unsafe.front(), HasSubstr("in place of EN 12385-4|6x36-IWRC|19|1960"));
}

}  // namespace taut::app::study_other_parts_test
