// Studies of the closed loop: a limit of T_max stands for the strength of both its ropes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/calc/verdict.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::study_loop_test {

VerdictKind verdict_with(const std::string& input, const std::string& vary, const std::string& limit) {
  const std::string text = fmt::format(R"(taut: 1
method: closed_loop
input:
{}
  return_rope: 6x36-IWRC 18 mm 1960 MPa
  traction_rope: 6x36-IWRC 18 mm 1960 MPa
study:
  vary: {{input.sag: {{list: {}}}}}
  points: grid
  of: [T_max]
  limit: {{T_max: {{at_most: {}}}}}
)",
                                       input, vary, limit);
  const Job job{.text = text, .name = "deck.yaml", .set = {}, .progress = {}};
  const auto study = read_study(job);
  if (!study) throw std::runtime_error(study.error().message + to_text(study.error().errors));
  const taut_test::ScratchFolder scratch;
  const auto folder = StudyFolder::make(scratch.path().string(), job, *study);
  if (!folder) throw std::runtime_error(folder.error().message);
  if (const auto state = run_cases(*study, *folder, {.threads = 1}); !state || !state->whole())
    throw std::runtime_error("not whole");
  return verdict_of(study_result(*study, *read_cases(*study, *folder), {.threads = 1, .progress = {}}))->kind;
}

constexpr const char* winch_line =
    "  span: 200 m\n"
    "  gathering_force: 30 kN\n"
    "  gathering_angle: 30 deg\n"
    "  tail_efficiency: 0.9\n"
    "  head_efficiency: 0.8\n"
    "  sag: 10 m";

// The paper's line. Hauled in, T_lA is about 86.8 kN by both tiers, and the winch pulls with T_lA / 0.8 = 108.5 kN.
TEST(StudyOfLoop, ALimitOfTMaxCountsTheRopeAtTheWinch) {
  EXPECT_EQ(verdict_with(winch_line, "[10 m, 11 m]", "90 kN"), VerdictKind::fails);
  EXPECT_EQ(verdict_with(winch_line, "[10 m, 11 m]", "110 kN"), VerdictKind::passes);
}

// Hauled out the rope is slacker than hauled in, with which it is proved too.
TEST(StudyOfLoop, ALimitOfTMaxCountsTheOtherHaul) {
  const std::string out = std::string(winch_line) + "\n  haul: out";
  EXPECT_EQ(verdict_with(out, "[10 m, 11 m]", "90 kN"), VerdictKind::fails);
}

// 30 m before the tail support: by catenaries 9.9 kN and 13.3 kN, by the closed form 8.5 kN and 7.1 kN.
TEST(StudyOfLoop, ALimitOfTMaxCountsExactValues) {
  const std::string tail =
      "  span: 600 m\n"
      "  slope: 30 deg\n"
      "  position: 570 m\n"
      "  sag: 30 m\n"
      "  gathering_force: 1 kN\n"
      "  gathering_angle: 30 deg\n"
      "  carriage_weight: 2 kN\n"
      "  tail_efficiency: 1.0";
  EXPECT_EQ(verdict_with(tail, "[30 m, 44 m]", "10 kN"), VerdictKind::fails);
  EXPECT_NE(verdict_with(tail, "[30 m, 44 m]", "14 kN"), VerdictKind::fails);
}

}  // namespace taut::app::study_loop_test
