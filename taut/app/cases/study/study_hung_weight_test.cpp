#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/calc/verdict.hpp"
#include "test/support/scratch_folder.hpp"

/// Studies of a weight on one weightless upright rope: its tension is the weight, its factor 100 kN over the weight.
namespace taut::app::study_hung_weight_test {

using testing::HasSubstr;
using testing::Not;

struct Deck {
  std::string study;
  std::string sweep{};       ///< the weight at its end, "-56 kN"; empty: the deck has no sweep
  std::string factor = "2";  ///< that the deck asks of the rope; empty: none
  std::string weight = "30 kN";

  std::string text() const {
    return "taut: 1\n"
           "machine:\n"
           "  points: {top: [0 m, 0 m, 20 m]}\n"
           "  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}\n"
           "  bodies: {b: {at: [0 m, 0 m, 10 m], free: [z]}}\n"
           "  reevings: [{rope: r, path: [{anchor: top}, {anchor: b}], length: 10 m}]\n" +
           fmt::format("  loads: [{{name: w, at: b, force: [0 kN, 0 kN, -{}]}}]\n", weight) +
           "analyses:\n  - equilibrium: {}\n" +
           (sweep.empty()
                ? ""
                : fmt::format("  - sweep: {{parameter: 'loads.w.force[2]', from: -20 kN, to: {}, steps: 6}}\n",
                              sweep)) +
           (factor.empty() ? "" : fmt::format("checks: {{ropes: {{r: {{safety_factor: {}}}}}}}\n", factor)) +
           "study:\n" + study;
  }
  Job job(const std::vector<std::string>& set = {}) const {
    return {.text = text(), .name = "deck.yaml", .set = set, .progress = {}};
  }
};

Result whole(const Deck& deck) {
  const taut_test::ScratchFolder scratch;
  const auto study = read_study(deck.job());
  if (!study) throw std::runtime_error(study.error().message + to_text(study.error().errors));
  const auto folder = StudyFolder::make(scratch.path().string(), deck.job(), *study);
  if (!folder) throw std::runtime_error(folder.error().message);
  const auto state = run_cases(*study, *folder, {.threads = 2});
  if (!state || !state->whole()) throw std::runtime_error("not whole");
  return study_result(*study, *read_cases(*study, *folder), {.threads = 2, .progress = {}});
}

Verdict judged(const Deck& deck) { return *verdict_of(whole(deck)); }

const std::string stiffness = "  vary: {machine.ropes.r.stiffness: {list: [9 MN, 10 MN]}}\n  points: grid\n";
const std::string both = "  of: [equilibrium.r.safety_factor, sweep.r.safety_factor]\n";

// The factor is 100/30 at rest and 100/56 at the end of the sweep, which the deck does not allow: a limit at rest says
// nothing of it.
TEST(HungWeight, ALimitOfOneAnalysisHidesNoFailureInAnother) {
  const std::string at_rest = "  limit: {equilibrium.r.safety_factor: {at_least: 2}}\n";
  const Deck deck{.study = stiffness + both + at_rest, .sweep = "-56 kN"};
  EXPECT_EQ(verdict_of(run(deck.job()))->kind, VerdictKind::fails);
  const Verdict v = judged(deck);
  EXPECT_EQ(v.kind, VerdictKind::not_judged) << v.reason;
  EXPECT_THAT(v.reason, HasSubstr("the deck as it is fails r.safety_factor, which no case makes"));
  // nor does it where no case calculates the other one
  EXPECT_EQ(judged({.study = stiffness + "  of: [equilibrium.r.safety_factor]\n" + at_rest, .sweep = "-56 kN"}).kind,
            VerdictKind::not_judged);
  // with chance
  const std::string law = "  vary: {machine.ropes.r.stiffness: {uniform: {low: 9 MN, high: 11 MN}}}\n  samples: 64\n" +
                          both + "  limit: {equilibrium.r.safety_factor: {at_least: 2, allowed: 0.1}}\n";
  EXPECT_EQ(judged({.study = law, .sweep = "-56 kN"}).kind, VerdictKind::not_judged);
  // a sweep that the deck allows lets it pass, with the check as an output (45 kN are near the elastic limit)
  const std::string over_all = stiffness + "  of: [checks.r.safety_factor]\n";
  EXPECT_EQ(judged({.study = over_all + "  limit: {checks.r.safety_factor: {at_least: 2}}\n", .sweep = "-45 kN"}).kind,
            VerdictKind::passes_with_warnings);
  EXPECT_EQ(judged({.study = over_all + "  limit: {checks.r.safety_factor: {at_least: 2}}\n", .sweep = "-56 kN"}).kind,
            VerdictKind::fails);
}

// Without a limit in the deck the rope needs one of the study in each analysis that loads it.
TEST(HungWeight, ARopeNeedsALimitInEachAnalysisThatLoadsIt) {
  const auto limited = [](const std::string& limit) {
    return judged({.study = stiffness + both + "  limit: {" + limit + "}\n", .sweep = "-56 kN", .factor = ""});
  };
  const std::string at_rest = "equilibrium.r.safety_factor: {at_least: 2}";
  EXPECT_EQ(limited(at_rest).verdict_class, "unasked");
  EXPECT_THAT(limited(at_rest).reason, HasSubstr("r (in sweep)"));
  EXPECT_EQ(limited(at_rest + ", sweep.r.safety_factor: {at_least: 1.5}").kind, VerdictKind::passes);
  EXPECT_EQ(limited(at_rest + ", sweep.r.safety_factor: {at_least: 2}").kind, VerdictKind::fails);
}

// The deck's rope breaks at 100 kN, that of a case at 75 kN: a tension of 100 kN at most breaks it. 70 kN do not.
TEST(HungWeight, ALimitOfTensionEndsAtTheLeastBreakingForceOfTheCases) {
  const auto grid = [](const std::string& limit, const std::string& of = "equilibrium.r.T_max") {
    return whole({.study = "  vary:\n"
                           "    'machine.loads[0].force[2]': {from: -70 kN, to: -60 kN, steps: 2}\n"
                           "    machine.ropes.r.breaking_force: {list: [75 kN, 120 kN]}\n"
                           "  points: grid\n  of: [" +
                           of + "]\n  limit: {" + of + ": {" + limit + "}}\n",
                  .weight = "30 kN"});
  };
  const Result r = grid("at_most: 100 kN");
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_THAT(verdict_of(r)->reason,
              HasSubstr("r (the limit of equilibrium.r.T_max is beyond breaking or yield of some cases)"));
  EXPECT_EQ(verdict_of(grid("at_most: 75 kN"))->kind, VerdictKind::passes);
  EXPECT_EQ(verdict_of(grid("at_most: 1", "equilibrium.r.T_max.utilisation"))->kind, VerdictKind::passes)
      << "70/75: the share knows the breaking force of its case";
  const Verdict chance =
      judged({.study = "  vary: {machine.ropes.r.breaking_force: {uniform: {low: 33 kN, high: 47 kN}}}\n"
                       "  of: [equilibrium.r.T_max]\n"
                       "  limit: {equilibrium.r.T_max: {at_most: 90 kN, allowed: 0.1}}\n"
                       "  samples: 64\n"});
  EXPECT_EQ(chance.kind, VerdictKind::not_judged) << chance.reason;
}

// The tension of 30 kN comes out as 30000.000000004 N: it is on its limit, as in a grid and in a run.
TEST(HungWeight, ACaseOnItsLimitIsNotBeyondIt) {
  const auto probability = [](double limit) {
    const Result r = whole({.study = "  vary: {'machine.loads[0].force[2]': {list: [-29 kN, -30 kN]}}\n"
                                     "  of: [equilibrium.r.T_max, equilibrium.r.safety_factor]\n" +
                                     fmt::format("  limit: {{equilibrium.r.T_max: {{at_most: {} kN, allowed: 0.1}}}}\n"
                                                 "  samples: 64\n",
                                                 limit)});
    return r.find_value("p")->value;
  };
  EXPECT_EQ(probability(30), 0);
  EXPECT_NEAR(probability(29.9999), 0.5, 0.1);
}

// The deck asks for 3, and its factor at 60 kN is 1.67: no case makes that check, as no output is a check.
TEST(HungWeight, AStudyWithoutALimitTellsWhichChecksItsCasesMake) {
  const auto reason = [](const std::string& of, const std::string& weight, const std::string& factor = "3") {
    return judged(
        {.study = "  vary: {machine.ropes.r.stiffness: {list: [9 MN, 10 MN]}}\n  points: grid\n  of: [" + of + "]\n",
         .factor = factor,
         .weight = weight});
  };
  const Verdict failing = reason("equilibrium.r.safety_factor", "60 kN");
  EXPECT_THAT(failing.reason, HasSubstr("the deck as it is fails r.safety_factor, which no case makes"));
  EXPECT_EQ(failing.kind, VerdictKind::not_judged);
  const Verdict open = reason("equilibrium.r.safety_factor", "30 kN");
  EXPECT_THAT(open.reason, HasSubstr("no case makes the deck's r.safety_factor"));
  EXPECT_THAT(open.reason, Not(HasSubstr("none of the")));
  EXPECT_THAT(reason("checks.r.safety_factor", "30 kN").reason, HasSubstr("none of the 2 cases fails a check"));
}

// Where the body begins does not act on where it hangs: what the solver leaves of 1e-13 of the value is not shared out.
TEST(HungWeight, AnOutputThatNoInputActsOnDoesNotVary) {
  const Result r = whole({.study = "  vary:\n"
                                   "    machine.reevings.r.length: {normal: {mean: 10 m, cov: 1 %}}\n"
                                   "    machine.bodies.b.at.z: {uniform: {low: 9 m, high: 11 m}}\n"
                                   "  of: [equilibrium.b.z, equilibrium.r.safety_factor]\n"
                                   "  answer: [tornado, indices]\n  samples: 256\n"});
  std::string most;
  for (const Answer& one : r.answers) {
    if (one.label == "Matters most") most += one.text + "\n";
  }
  EXPECT_THAT(most, HasSubstr("equilibrium.b.z: r.length, total Sobol index "));
  EXPECT_THAT(most, HasSubstr("equilibrium.r.safety_factor: does not vary"));
  const Table* tornado = r.find_table("tornado_2");
  ASSERT_NE(tornado, nullptr);
  for (const auto& row : tornado->rows) EXPECT_EQ(std::get<double>(row.back()), 0);
  EXPECT_THAT(tornado->title, testing::EndsWith("it does not vary"));
}

}  // namespace taut::app::study_hung_weight_test
