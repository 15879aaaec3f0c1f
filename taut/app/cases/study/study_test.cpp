#include "taut/app/cases/study/study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>

#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/app/methods.hpp"
#include "taut/base/long_rows.hpp"
#include "taut/calc/verdict.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::study_test {

using testing::HasSubstr;

/// A skyline of one span with a clamped load, and a study of it.
std::string deck_with(const std::string& study, const std::string& more = "") {
  return "taut: 1\n"
         "machine:\n"
         "  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, 30 m]}\n"
         "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
         "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
         "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
         "  loads: [{at: car, mass: 1 t}]\n"
         "analyses: [{equilibrium: {motion: at_rest}}]\n" +
         more + "study:\n" + study;
}

const char* const usual =
    "  vary:\n"
    "    machine.loads[0].mass: {normal: {mean: 1 t, cov: 10 %}}\n"
    "    machine.ropes.sky.stiffness: {uniform: {low: 15 MN, high: 25 MN}}\n"
    "    machine.reevings.sky.length: {normal: {mean: 205 m, sd: 0.2 m}}\n"
    "  of: [equilibrium.sky.T_max, equilibrium.car.z]\n";

Study read(const std::string& text) {
  auto study = read_study({.text = text, .name = "deck.yaml", .set = {}, .progress = {}});
  if (!study) throw std::runtime_error(study.error().message + to_text(study.error().errors));
  return std::move(*study);
}

Result refused(const std::string& text) {
  const auto study = read_study({.text = text, .name = "deck.yaml", .set = {}, .progress = {}});
  EXPECT_FALSE(study.has_value());
  return study ? Result{} : study.error();
}

/// The whole study in a folder of its own.
Result whole(const std::string& text, int threads = 2) {
  const taut_test::ScratchFolder scratch;
  const Study study = read(text);
  const auto folder =
      StudyFolder::make(scratch.path().string(), {.text = text, .name = "deck.yaml", .set = {}, .progress = {}}, study);
  if (!folder) throw std::runtime_error(folder.error().message);
  const auto state = run_cases(study, *folder, {.threads = threads});
  if (!state || !state->whole()) throw std::runtime_error("not whole");
  return study_result(study, *read_cases(study, *folder), {.threads = threads, .progress = {}});
}

double value(const Result& r, const std::string& name) {
  const Value* v = r.find_value(name);
  return v != nullptr ? v->value : std::nan("");
}

TEST(Cases, EqualARunOfTheDeckWithTheSameNumbers) {
  const std::string text = deck_with(usual);
  const Study study = read(text);
  for (const std::uint64_t index : {0U, 7U, 501U, 9999U}) {
    const chance::Point p = study.values_at(index);
    const CaseAnswer answer = study.model.answer(p);
    ASSERT_TRUE(answer.outcome.ok()) << answer.outcome.message;
    const Result r = run({.text = text,
                          .name = "deck.yaml",
                          .set = {fmt::format("machine.loads[0].mass={:.17g} kg", p[0]),
                                  fmt::format("machine.ropes.sky.stiffness={:.17g} N", p[1]),
                                  fmt::format("machine.reevings[0].length={:.17g} m", p[2])},
                          .progress = {}});
    EXPECT_NEAR(answer.outputs[0], value(r, "sky.T_max"), 1e-8 * answer.outputs[0]);
    EXPECT_NEAR(answer.outputs[1], value(r, "car.z"), 1e-7);
  }
}

TEST(Cases, ArePure) {
  const Study study = read(deck_with(usual));
  const chance::Point p = study.values_at(17);
  const std::vector<double> first = study.model.answer(p).outputs;
  for (std::uint64_t i = 0; i < 50; ++i) study.model.answer(study.values_at(i));
  EXPECT_EQ(study.model.answer(p).outputs, first);
  EXPECT_EQ(read(deck_with(usual)).model.answer(p).outputs, first);
  EXPECT_EQ(parallel(study.model, 2)(std::vector<chance::Point>{study.values_at(3), p})[1], first);
}

TEST(Cases, OfAMethodEqualItsRun) {
  const std::string deck = std::string(find_method("closed_loop")->example) +
                           "study:\n  vary: {input.gathering_force: {normal: {mean: 20 kN, sd: 2 kN}}}\n  of: [T_lA]\n";
  const auto study = read_study({.text = deck, .name = "deck.yaml", .set = {}, .progress = {}});
  ASSERT_TRUE(study.has_value()) << to_text(study.error().errors);
  const double x = study->values_at(5)[0];
  const Result r = run(
      {.text = deck, .name = "deck.yaml", .set = {fmt::format("input.gathering_force={:.17g} N", x)}, .progress = {}});
  EXPECT_EQ(study->model.answer(study->values_at(5)).outputs[0], value(r, "T_lA"));
}

TEST(Study, ShardsAndThreadsMakeNoDifference) {
  const taut_test::ScratchFolder scratch;
  const std::string text = deck_with(std::string(usual) + "  samples: 512\n");
  const Job job{.text = text, .name = "deck.yaml", .set = {}, .progress = {}};
  const Study study = read(text);
  const auto one = StudyFolder::make((scratch.path() / "one").string(), job, study);
  const auto many = StudyFolder::make((scratch.path() / "many").string(), job, study);
  ASSERT_TRUE(one && many);
  ASSERT_TRUE(run_cases(study, *one, {.threads = 1})->whole());
  for (std::uint64_t k = 3; k >= 1; --k) {
    EXPECT_FALSE(state_of(*many).whole());
    ASSERT_TRUE(run_cases(study, *many, {.threads = 2, .shard = k, .of = 3}).has_value());
  }
  EXPECT_TRUE(state_of(*many).whole());
  const auto a = read_cases(study, *one), b = read_cases(study, *many);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->outputs, b->outputs);
  EXPECT_EQ(a->outputs[0].size(), 512U);
}

TEST(Study, APartThatIsThereIsNotCalculatedAgain) {
  const taut_test::ScratchFolder scratch;
  const std::string text = deck_with(std::string(usual) + "  samples: 256\n");
  Study study = read(text);
  const auto folder =
      StudyFolder::make(scratch.path().string(), {.text = text, .name = "deck.yaml", .set = {}, .progress = {}}, study);
  ASSERT_TRUE(folder.has_value());
  int asked = 0;
  const auto own = study.model.answer;
  study.model.answer = [&](std::span<const double> p) {
    ++asked;
    return own(p);
  };
  int left = 100;
  const auto stopped =
      run_cases(study, *folder, {.threads = 1, .progress = [&](const Progress&) { return --left > 0; }});
  ASSERT_TRUE(stopped && stopped->interrupted);
  EXPECT_EQ(stopped->cases_done, 64U) << "the part in work is not kept";
  asked = 0;
  ASSERT_TRUE(run_cases(study, *folder, {.threads = 1})->whole());
  EXPECT_EQ(asked, 256 - 64);
}

TEST(Study, AFolderOfAnotherStudyIsRefused) {
  const taut_test::ScratchFolder scratch;
  const std::string text = deck_with(usual), other = deck_with(std::string(usual) + "  seed: 2\n");
  ASSERT_TRUE(StudyFolder::make(scratch.path().string(), {.text = text, .name = "deck.yaml", .set = {}, .progress = {}},
                                read(text)));
  const auto made = StudyFolder::make(scratch.path().string(),
                                      {.text = other, .name = "deck.yaml", .set = {}, .progress = {}}, read(other));
  ASSERT_FALSE(made.has_value());
  EXPECT_THAT(made.error().message, HasSubstr("another study"));
}

TEST(Study, JudgesAnAllowedProbability) {
  const auto verdict = [](const std::string& limit) {
    const Result r =
        whole(deck_with(std::string(usual) + "  samples: 1024\n  limit: {equilibrium.sky.T_max: " + limit + "}\n"));
    return *verdict_of(r);
  };
  EXPECT_EQ(verdict("{at_most: 300 kN, allowed: 0.01}").kind, VerdictKind::passes);
  EXPECT_EQ(verdict("{at_most: 10 kN, allowed: 0.01}").kind, VerdictKind::fails);
  const Verdict unsure = verdict("{at_most: 300 kN, allowed: 1e-6}");
  EXPECT_EQ(unsure.kind, VerdictKind::not_judged);
  EXPECT_EQ(unsure.verdict_class, "unmade");
  EXPECT_THAT(unsure.reason, HasSubstr("samples would tell"));
  EXPECT_EQ(verdict("{at_most: 300 kN}").verdict_class, "unasked");
}

TEST(Study, FailedCasesAreRowsWithReasonsAndCountAsBeyond) {
  // a rope shorter than its span has no equilibrium
  const Result r = whole(
      deck_with("  vary: {machine.reevings.sky.length: {list: [205 m, 206 m, 207 m, 120 m]}}\n"
                "  of: [equilibrium.sky.T_max]\n  limit: {equilibrium.sky.T_max: {at_most: 300 kN, allowed: 0.1}}\n"
                "  points: random\n  samples: 200\n"));
  EXPECT_EQ(r.status, Status::ok);
  const Table* failed = r.find_table("failed");
  ASSERT_NE(failed, nullptr);
  EXPECT_GT(failed->rows.size(), 20U);
  EXPECT_FALSE(std::get<std::string>(failed->rows[0][2]).empty());
  EXPECT_NEAR(value(r, "p"), static_cast<double>(failed->rows.size()) / 200, 1e-12);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("have no answer"));
}

TEST(Study, AGridHasEveryCombination) {
  const Result r =
      whole(deck_with("  vary:\n    machine.loads[0].mass: {from: 0.5 t, to: 1.5 t, steps: 4}\n"
                      "    machine.ropes.sky.stiffness: {list: [15 MN, 20 MN, 25 MN]}\n"
                      "  of: [equilibrium.sky.T_max]\n  points: grid\n"));
  EXPECT_EQ(r.series.at(0).long_rows->size(), 15U);
  EXPECT_LT(value(r, "equilibrium.sky.T_max.least"), value(r, "equilibrium.sky.T_max.largest"));
}

TEST(Study, AGridHasToKeepItsLimitsEverywhere) {
  const auto verdict = [](const std::string& list, const std::string& limit) {
    return *verdict_of(whole(deck_with("  vary: {machine.reevings.sky.length: {list: " + list +
                                       "}}\n  of: [equilibrium.sky.T_max]\n  points: grid\n"
                                       "  limit: {equilibrium.sky.T_max: {" +
                                       limit + "}}\n")));
  };
  EXPECT_EQ(verdict("[205 m, 206 m]", "at_most: 300 kN").kind, VerdictKind::passes);
  EXPECT_EQ(verdict("[205 m, 206 m]", "at_most: 30 kN").kind, VerdictKind::fails);
  EXPECT_EQ(verdict("[205 m, 120 m]", "at_most: 300 kN").kind, VerdictKind::not_judged) << "one has no answer";
  EXPECT_THAT(to_text(refused(deck_with("  vary: {machine.reevings.sky.length: {list: [205 m, 206 m]}}\n"
                                        "  of: [equilibrium.sky.T_max]\n  points: grid\n"
                                        "  limit: {equilibrium.sky.T_max: {at_most: 1 kN, allowed: 0.1}}\n"))
                          .errors),
              HasSubstr("a grid has no probability"));
}

TEST(Study, LawsAreReadInTheUnitsOfTheirNumbers) {
  const auto law_of = [](const std::string& law) {
    const Study s =
        read(deck_with("  vary: {machine.reevings.sky.length: {" + law + "}}\n  of: [equilibrium.sky.T_max]\n"));
    return s.inputs.of[0];
  };
  const auto expect = [&](const std::string& law, double mean, double sd) {
    EXPECT_NEAR(chance::mean(law_of(law)), mean, 1e-6) << law;
    EXPECT_NEAR(chance::sd(law_of(law)), sd, 1e-6) << law;
  };
  expect("normal: {mean: 205 m, sd: 30 cm}", 205, 0.3);
  expect("lognormal: {mean: 205 m, cov: 0.1 %}", 205, 0.205);
  expect("uniform: {low: 204 m, high: 206 m}", 205, 2 / std::sqrt(12.0));
  using std::numbers::egamma, std::numbers::pi;
  expect("gumbel: {mode: 205 m, scale: 100 mm}", 205 + 0.1 * egamma, 0.1 * pi / std::sqrt(6.0));
  expect("weibull: {shape: 1, scale: 0.2 m, shift: 204.5 m}", 204.7, 0.2);  // the exponential law
  expect("triangular: {low: 204 m, mode: 205 m, high: 206 m}", 205, 1 / std::sqrt(6.0));
  expect("list: [204 m, 206 m], weights: [1, 3]", 205.5, std::sqrt(0.75));
  expect("from: 204 m, to: 206 m, steps: 2", 205, std::sqrt(2.0 / 3));
  // cut symmetrically at one standard deviation: variance 1 - 2 phi(1)/(2 Phi(1) - 1)
  expect("normal: {mean: 205 m, sd: 0.3 m}, truncate: [204.7 m, 205.3 m]", 205, 0.3 * std::sqrt(0.29112509));
}

// What `taut study` refuses without a calculation, `taut check` finds too, at its place; it said "no mistakes found".
TEST(Study, ACheckOfTheDeckFindsMistakesOfItsBlock) {
  const auto found = [](const std::string& vary, const std::string& of = "equilibrium.T_max") {
    const Job job{
        .text = deck_with("  vary: {" + vary + "}\n  of: [" + of + "]\n"), .name = "d", .set = {}, .progress = {}};
    const Diagnostics all = check(job);
    const auto study = read_study(job);
    EXPECT_FALSE(study) << vary;
    EXPECT_TRUE(all.empty() || all.front().message == study.error().errors.front().message) << to_text(all);
    return all.empty() ? std::string() : all.front().message;
  };
  EXPECT_EQ(found("'machine.loads[0].mass': {uniform: {low: 1 t, high: 2 t}}", "equilibrium.no_such"), "")
      << "names of outputs need a run";
  EXPECT_THAT(found("'machine.loads[5].mass': {list: [1 t]}"), HasSubstr("loads"));
  EXPECT_THAT(found("'machine.loads[0].mass': {list: [1 m]}"), HasSubstr("'m' is a unit of length"));
  EXPECT_NE(found("'machine.reevings[0].length': {list: [205 m]}, machine.reevings.sky.length: {list: [205 m]}"), "");
  EXPECT_NE(found("machine.temperature: {normal: {mean: 20 degC, cov: 5 %}}"), "");
  EXPECT_NE(found("'machine.loads[0].mass': {uniform: {low: 2 t, high: 1 t}}"), "");
}

TEST(Study, AnInterruptedFormLeavesNoNumberAndKeepsTheCases) {
  const std::string text = deck_with(
      usual + std::string("  limit: {equilibrium.sky.T_max: {at_most: 35.5 kN, allowed: 0.9}}\n  samples: 64\n"
                          "  answer: [form]\n"));
  const taut_test::ScratchFolder scratch;
  const Study study = read(text);
  const auto folder =
      StudyFolder::make(scratch.path().string(), {.text = text, .name = "deck.yaml", .set = {}, .progress = {}}, study);
  ASSERT_TRUE(folder && run_cases(study, *folder, {})->whole());
  const StudyData data = *read_cases(study, *folder);
  int told = 0;
  const Result ended = study_result(study, data, {.threads = 2, .progress = [&](const Progress& p) {
                                                    EXPECT_THAT(p.what, HasSubstr("FORM"));
                                                    EXPECT_LE(p.done, 1);
                                                    return ++told < 3;
                                                  }});
  EXPECT_EQ(told, 3);
  EXPECT_TRUE(ended.interrupted);
  EXPECT_EQ(exit_code(ended), 130);
  EXPECT_TRUE(std::isnan(value(ended, "p")));
  EXPECT_TRUE(ended.checks.empty());
  ASSERT_EQ(ended.unmade.size(), 1u);
  EXPECT_THAT(ended.unmade.front(), HasSubstr("interrupted"));
  EXPECT_THAT(verdict_of(ended)->reason, HasSubstr("above 35.5 kN: FORM was interrupted"));
  const Result whole_one = study_result(study, data, {});
  EXPECT_FALSE(whole_one.interrupted);
  EXPECT_GT(value(whole_one, "p"), 0);
}

TEST(Study, FormAgreesWithTheSampleAndWithoutAnAnswerThereIsNoNumber) {
  const std::string limit = "  limit: {equilibrium.sky.T_max: {at_most: 35.5 kN}}\n  samples: 16384\n";
  const Result sampled = whole(deck_with(usual + limit));
  const Result form = whole(deck_with(usual + limit + "  answer: [form]\n"));
  const double p = value(sampled, "p");
  ASSERT_GT(p, 0.001);
  ASSERT_LT(p, 0.5);
  EXPECT_NEAR(value(form, "p"), p, 0.1 * p);
  EXPECT_EQ(form.status, Status::ok);
  // a tension that no load of the law can reach
  const Result none = whole(deck_with(
      "  vary: {machine.ropes.sky.stiffness: {uniform: {low: 15 MN, high: 25 MN}}}\n  of: [equilibrium.sky.T_max]\n"
      "  limit: {equilibrium.sky.T_max: {at_most: 250 kN}}\n  samples: 64\n  answer: [form]\n"));
  EXPECT_NE(none.status, Status::ok);
  EXPECT_EQ(exit_code(none), 3);
  EXPECT_TRUE(std::isnan(value(none, "p")));
}

/// A study of a line whose rope breaks in about half of the cases.
struct Breaking {
  explicit Breaking(const std::string& vary, const std::string& more = "") : study(vary + more) {
    T = read(deck_with(study)).model.outputs[0].base;
  }
  Result operator()(const std::string& limit = "") const {
    std::string text = deck_with(study + limit);
    const std::string strong = "breaking_force: 300 kN";
    text.replace(text.find(strong), strong.size(), fmt::format("breaking_force: {:.17g} N", T));
    return whole(text);
  }
  std::string study;
  double T = 0;  ///< of the deck as it is, and what the rope bears
};

const char* const half_break =
    "  vary: {'machine.loads[0].mass': {normal: {mean: 1 t, cov: 10 %}}}\n"
    "  of: [equilibrium.sky.T_max, equilibrium.sky.safety_factor, equilibrium.car.z]\n  samples: 256\n";

TEST(Study, CasesThatBreakARopeLetNoStudyPass) {
  const Breaking line(half_break);
  const Result r = line("  limit: {equilibrium.car.z: {at_least: -100 m, allowed: 0.05}}\n");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.checks.at(0).passes) << "the limit that it has is kept";
  const Verdict v = *verdict_of(r);
  EXPECT_EQ(v.kind, VerdictKind::not_judged);
  EXPECT_EQ(v.verdict_class, "unmade");
  EXPECT_THAT(v.reason, HasSubstr("of 256 cases fail sky.T_max, which no 'limit' of the study counts"));
  EXPECT_THAT(v.reason, HasSubstr("minimum breaking force of the rope"));
  ASSERT_NE(r.find_table("flaws"), nullptr);
  const double cases = std::get<double>(r.find_table("flaws")->rows.at(0).at(0));
  EXPECT_NEAR(cases, 128, 16);
  // where no limit is asked for, too
  EXPECT_EQ(verdict_of(line())->verdict_class, "unmade");
}

TEST(Study, ALimitThatABrokenRopeIsBeyondCountsIt) {
  const Breaking line(half_break);
  for (const std::string& limit : {fmt::format("equilibrium.sky.T_max: {{at_most: {:.17g} N, allowed: 0.9}}", line.T),
                                   std::string("equilibrium.sky.safety_factor: {at_least: 1, allowed: 0.9}")}) {
    EXPECT_EQ(verdict_of(line("  limit: {" + limit + "}\n"))->kind, VerdictKind::passes) << limit;
  }
  const Result r =
      line(fmt::format("  limit: {{equilibrium.sky.T_max: {{at_most: {:.17g} N, allowed: 0.9}}}}\n", 2 * line.T));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << "a limit above the breaking force does not";
}

TEST(Study, AGridWithABrokenRopeFails) {
  const Breaking line("  points: grid\n  vary: {'machine.loads[0].mass': {list: [0.9 t, 1.1 t]}}\n",
                      "  of: [equilibrium.sky.T_max, equilibrium.car.z]\n");
  const Result r = line("  limit: {equilibrium.car.z: {at_least: -100 m}}\n");
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("cases that fail sky.T_max"));
}

/// A deck whose rope has a factor of less than 4 in its analysis `mid` alone, and a grid over it.
std::string two_places(const std::string& limit, const std::string& of = "checks.sky.safety_factor") {
  std::string text = deck_with(fmt::format("  points: grid\n  vary: {{'machine.loads[0].mass': {{list: [1 t, 3 t]}}}}\n"
                                           "  of: [equilibrium.sky.T_max, equilibrium.sky.safety_factor, {}]\n"
                                           "  limit: {{{}}}\n",
                                           of, limit),
                               "checks: {ropes: {sky: {safety_factor: 4}}}\n");
  const std::string own = "[{equilibrium: {motion: at_rest}}]";
  return text.replace(text.find(own), own.size(),
                      "[{equilibrium: {carriage: car, x: 2 m, held: true}},\n"
                      "  {equilibrium: {name: mid, carriage: car, x: 100 m, held: true}}]");
}

TEST(Study, ALimitOnOneAnalysisLeavesTheChecksOfAllToJudge) {
  const Result r = whole(two_places("equilibrium.sky.safety_factor: {at_least: 4}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_GT(value(r, "equilibrium.sky.safety_factor.least"), 4) << "the limit is kept";
  EXPECT_LT(value(r, "checks.sky.safety_factor.least"), 4);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("cases that fail sky.safety_factor"));
  // of all analyses, or where there is no other one that is judged, it takes the place of the check
  EXPECT_NE(verdict_of(whole(two_places("checks.sky.safety_factor: {at_least: 2}")))->kind, VerdictKind::fails);
  std::string alone = two_places("equilibrium.sky.safety_factor: {at_least: 2}");
  alone.replace(alone.find("name: mid"), 9, "name: mid, judge: false");
  const Result one = whole(alone);
  EXPECT_NE(verdict_of(one)->kind, VerdictKind::fails);
  EXPECT_THAT(verdict_of(one)->reason, HasSubstr("left out by 'judge: false': mid"));
}

// The second analysis of the deck fails, and no output needs it.
TEST(Study, SaysWhichAnalysesOfTheDeckItLeavesOut) {
  const std::string text = two_places("equilibrium.sky.safety_factor: {at_least: 4}", "equilibrium.car.z");
  const Result r = whole(text);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes);
  EXPECT_THAT(
      verdict_of(r)->reason,
      testing::StartsWith("no case calculates equilibrium_mid; no case makes the deck's sky.safety_factor; nearest"));
  EXPECT_EQ(
      verdict_of(run({.text = text, .name = "deck.yaml", .set = {"machine.loads[0].mass=3 t"}, .progress = {}}))->kind,
      VerdictKind::fails);
}

// 5 kN at rest, then 50 kN more for good: the deck alone is not judged, nor is a study of its factor at rest.
TEST(Study, AFactorAtRestPassesNoMotion) {
  const Result r = whole(
      "taut: 1\n"
      "machine:\n"
      "  signals: {pull: {ramp: {to: 50 kN, start: 0.2 s, duration: 1 s, smooth: true}}}\n"
      "  points: {top: [0 m, 0 m, 20 m]}\n"
      "  ropes: {r: {breaking_force: 150 kN, stiffness: 15 MN, mass: 1 kg/m, damping_ratio: 0.05}}\n"
      "  bodies: {hook: {mass: 500 kg, at: [0 m, 0 m, 10 m], free: [z]}}\n"
      "  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 10 m}]\n"
      "  loads: [{at: hook, force: [0 kN, 0 kN, -1 N], signal: pull}]\n"
      "analyses: [{transient: {duration: 2 s, output_step: 20 ms}}]\n"
      "study:\n"
      "  points: grid\n"
      "  vary: {machine.ropes.r.stiffness: {list: [14 MN, 16 MN]}}\n"
      "  of: [transient.r.safety_factor]\n"
      "  limit: {transient.r.safety_factor: {at_least: 5}}\n");
  EXPECT_GT(value(r, "transient.r.safety_factor.least"), 29);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("more than twice the tension at rest"));
}

/// A boom that a rope holds and from which a load hangs on another one. It fails as a member, at 1.26 of what it bears.
std::string boom_deck(const std::string& checks, const std::string& study) {
  return "taut: 1\n"
         "machine:\n"
         "  points: {foot: [0 m, 0 m, 0 m], head: [6 m, 0 m, 8 m], wall: [0 m, 0 m, 12 m]}\n"
         "  ropes:\n"
         "    t: {rope: 'EN 12385-4|6x36-IWRC|16|1960'}\n"
         "    p: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 120 kN}\n"
         "  bodies: {hook: {mass: 10 kg, at: [6 m, 0 m, 3 m], free: [x, z]}}\n"
         "  beams: {boom: {from: foot, to: head, section: CHS 88.9x5, steel: S355, base: clamped}}\n"
         "  reevings:\n"
         "    - {rope: t, path: [{anchor: wall}, {anchor: boom.top}], length: 7.2 m}\n"
         "    - {rope: p, path: [{anchor: boom.top}, {anchor: hook}], length: 5 m}\n"
         "  loads: [{at: hook, mass: 3 t}]\n"
         "analyses: [{equilibrium: {}}]\n" +
         checks +
         "study:\n"
         "  vary: {'machine.loads[0].mass': {uniform: {low: 2.9 t, high: 3.1 t}}}\n"
         "  samples: 16\n" +
         study;
}

const char* const factors = "checks: {ropes: {t: {safety_factor: 3}, p: {safety_factor: 3}}";

// The boom fails in each case, and no case makes its check: the study says so, as it does where the deck has no check.
TEST(Study, APartThatTheDeckChecksAndNoCaseIsNotJudged) {
  const std::string mast = std::string(factors) + ", masts: {boom: {load_factor: 1.5, gamma_M1: 1.1}}}\n";
  const std::string of_ropes =
      "  of: [equilibrium.p.safety_factor, equilibrium.t.safety_factor]\n"
      "  limit: {equilibrium.p.safety_factor: {at_least: 3, allowed: 0.9}, equilibrium.t.safety_factor: {at_least: 3, "
      "allowed: 0.9}}\n";
  const Result r = whole(boom_deck(mast, of_ropes));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade") << verdict_of(r)->reason;
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("the deck as it is fails boom.member, which no case makes"));
  EXPECT_THAT(r.unjudged, testing::ElementsAre(HasSubstr("boom (no case makes the deck's boom.")));
  // of a boom that passes alone, too: the cases may be beyond what the deck is
  std::string strong = boom_deck(mast, of_ropes);
  strong.replace(strong.find("CHS 88.9x5"), 10, "CHS 219.1x10");
  EXPECT_EQ(verdict_of(run({.text = strong, .name = "deck.yaml", .set = {}, .progress = {}}))->kind,
            VerdictKind::passes);
  EXPECT_EQ(verdict_of(whole(strong))->verdict_class, "unasked");
  // the check of each case is that of the deck
  const std::string of_checks =
      "  of: [checks.p.safety_factor, checks.boom.member]\n"
      "  limit: {checks.p.safety_factor: {at_least: 3, allowed: 0.9}}\n";
  EXPECT_THAT(verdict_of(whole(boom_deck(mast, of_checks)))->reason, HasSubstr("fail boom.member"));
  strong.replace(strong.find(of_ropes), of_ropes.size(), of_checks);
  EXPECT_EQ(verdict_of(whole(strong))->kind, VerdictKind::passes) << verdict_of(whole(strong))->reason;
}

// A tension or a stress that nothing reaches before it breaks or yields is no limit of strength.
TEST(Study, ALimitBeyondBreakingOrYieldIsNoneOfStrength) {
  const auto unjudged = [](const std::string& limits) {
    return whole(boom_deck("", "  of: [equilibrium.T_max, equilibrium.boom.stress_max]\n  limit: {" + limits + "}\n"))
        .unjudged;
  };
  const std::string stress = ", equilibrium.boom.stress_max: {at_most: ";
  EXPECT_THAT(unjudged("equilibrium.T_max: {at_most: 110 kN, allowed: 0.9}" + stress + "355 MPa, allowed: 0.9}"),
              testing::IsEmpty());
  // 120 kN break the one rope, 178.6 kN the other
  EXPECT_THAT(
      unjudged("equilibrium.T_max: {at_most: 150 kN, allowed: 0.9}" + stress + "5000 MPa, allowed: 0.9}"),
      testing::UnorderedElementsAre("p (the limit of equilibrium.T_max is beyond breaking or yield)",
                                    "boom (the limit of equilibrium.boom.stress_max is beyond breaking or yield)"));
}

TEST(Study, ALimitOfTheOtherSideLeavesAFailedCheckToJudge) {
  const Result r = whole(two_places("equilibrium_mid.sky.T_max: {at_least: 10 kN}",
                                    "equilibrium_mid.sky.T_max, checks.sky.safety_factor"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
}

TEST(Study, WhatTheDeckTakesOutOfTheVerdictStaysOutOfIt) {
  const std::string study =
      std::string(half_break) + "  limit: {equilibrium.car.z: {at_least: -100 m, allowed: 0.05}}\n";
  std::string text = deck_with(study, "checks: {exempt: [sky]}\n");
  text.replace(text.find("300 kN"), 6, "1 kN");
  const Result r = whole(text);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes);
  EXPECT_THAT(r.exempt, testing::ElementsAre("sky")) << "page 1 says it";
}

TEST(Study, MistakesHaveTheirPlace) {
  const auto message = [](const std::string& study) { return to_text(refused(deck_with(study)).errors); };
  EXPECT_THAT(
      message("  vary: {'machine.loads[1].mass': {uniform: {low: 1 t, high: 2 t}}}\n  of: [equilibrium.T_max]\n"),
      HasSubstr("deck.yaml:10:35: error"));
  EXPECT_THAT(
      message("  vary: {'machine.loads[0].mass': {uniform: {low: 1 m, high: 2 t}}}\n  of: [equilibrium.T_max]\n"),
      HasSubstr("study.vary.machine.loads[0].mass.uniform.low"));
  EXPECT_THAT(
      message("  vary: {'machine.loads[0].mass': {uniform: {low: 2 t, high: 1 t}}}\n  of: [equilibrium.T_max]\n"),
      HasSubstr("study.vary.machine.loads[0].mass"));
  EXPECT_THAT(message("  vary: {'machine.loads[0].mass': {uniform: {low: 1 t, high: 2 t}}}\n  of: [load_path.T_max]\n"),
              HasSubstr("none of the deck's analyses"));
  EXPECT_THAT(
      message("  vary: {'machine.loads[0].mass': {uniform: {low: 1 t, high: 2 t}}}\n  of: [equilibrium.sky.T_mux]\n"),
      HasSubstr("did you mean 'sky.T_max'"));
  EXPECT_THAT(
      message("  vary:\n    machine.reevings.sky.length: {normal: {mean: 205 m, sd: 1 m}}\n"
              "    'machine.reevings[0].length': {uniform: {low: 204 m, high: 206 m}}\n  of: [equilibrium.T_max]\n"),
      HasSubstr("deck.yaml:12:35: error: study.vary.machine.reevings[0].length: 'machine.reevings[0].length' is the "
                "same number of the deck as 'machine.reevings.sky.length'"));
  EXPECT_THAT(message("  vary: {'machine.loads[0].mass': {uniform: {low: 1 t, high: 2 t}}}\n"
                      "  of: [equilibrium.sky.T_max, equilibrium.sky.T_max]\n"),
              HasSubstr("deck.yaml:11:31: error: study.of[1]: 'equilibrium.sky.T_max' is the same value as "
                        "'equilibrium.sky.T_max': give it once"));
  for (const char* points : {"", "  points: grid\n", "  points: lhs\n"}) {
    EXPECT_THAT(message(std::string("  vary: {}\n  of: [equilibrium.T_max]\n") + points),
                HasSubstr("deck.yaml:10:9: error: study.vary: names no number"));
  }
  EXPECT_THAT(message(std::string(usual) + "  points: grid\n"), HasSubstr("a grid is made of lists and steps"));
  EXPECT_THAT(message("  vary: {'machine.loads[0].mass': {list: [1 t, 2 t], weights: [1, 0]}}\n"
                      "  of: [equilibrium.T_max]\n  points: grid\n"),
              HasSubstr("leave 'weights' away"));
  EXPECT_THAT(message(std::string(usual) + "  answer: [form]\n"), HasSubstr("about a limit"));
  EXPECT_THAT(
      message(std::string(usual) +
              "  correlate: [['machine.loads[0].mass', machine.ropes.sky.stiffness, 0.5]]\n  answer: [indices]\n"),
      HasSubstr("study.answer"));
  EXPECT_THAT(message(std::string(usual) + "  limit: {equilibrium.sky.T_mix: {at_most: 1 kN}}\n"),
              HasSubstr("did you mean"));
  EXPECT_THAT(to_text(refused("taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m]}\n").errors), HasSubstr("error"));
}

}  // namespace taut::app::study_test
