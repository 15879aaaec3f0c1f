#include "taut/app/cases/study/study_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"
#include "test/support/made_study.hpp"

namespace taut::app::study_result_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::data_of;
using taut_test::gridded;
using taut_test::made_study;
using taut_test::row_of;
using taut_test::table_of;
using taut_test::text_cell;
using taut_test::value_of;
using testing::HasSubstr;

/// A study whose random cases have these outputs.
Study of_cases(std::uint64_t count) {
  return taut_test::sampled(made_study({{.law = chance::Uniform{.low = 0, .high = 1}}}, 1,
                                       [](const chance::Point& p) { return std::vector<double>(p); }),
                            chance::PointKind::random, count);
}

// The value j of n stands at the share (j - 1/2)/n: of the numbers 1 to 100 the quantile p is 100 p + 1/2, the mean
// 101/2, and with the divisor n - 1 the variance n (n + 1)/12.
TEST(StudyResult, StatisticsOfTheNumbersFromOneToAHundred) {
  Study study = of_cases(100);
  study.model.outputs[0].base = 42;
  StudyData data;
  data.outputs = {{}};
  for (int i = 0; i < 100; ++i) data.outputs[0].push_back((i * 37) % 100 + 1);
  const Result r = study_result(study, data, {});
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const double sd = std::sqrt(100 * 101 / 12.0);
  const std::vector<std::pair<std::string, double>> expected = {{"mean", 50.5}, {"sd", sd},    {"q01", 1.5},
                                                                {"q05", 5.5},   {"q25", 25.5}, {"q50", 50.5},
                                                                {"q75", 75.5},  {"q95", 95.5}, {"q99", 99.5}};
  const Table& summary = table_of(r, "summary");
  for (const auto& [name, value] : expected) {
    EXPECT_NEAR(value_of(r, "y1." + name), value, 1e-9) << name;
    EXPECT_NEAR(cell(summary, row_of(summary, "what", name), "value"), value, 1e-9) << name;
  }
  const Table& quantiles = table_of(r, "quantiles");
  EXPECT_EQ(cell(quantiles, row_of(quantiles, "statistic", "the deck as it is"), "value"), 42);
  // Student's interval with 99 degrees of freedom
  const std::size_t mean = row_of(quantiles, "statistic", "mean");
  EXPECT_NEAR(cell(quantiles, mean, "high"), 50.5 + 1.9842169515 * sd / 10, 1e-6);
  EXPECT_EQ(r.answers.at(0).text, "y1: 5.5 to 95.5");
  EXPECT_EQ(r.find_table("failed"), nullptr);
}

TEST(StudyResult, TheScatterOfATemperatureIsADifference) {
  Study study = of_cases(100);
  study.model.outputs[0].unit = si::K.in("degC");
  StudyData data;
  data.outputs = {{}};
  for (int i = 0; i < 100; ++i) data.outputs[0].push_back(273.15 + (i * 37) % 100 + 1);
  const Result r = study_result(study, data, {});
  const Value& sd = *r.find_value("y1.sd");
  EXPECT_EQ(study.display.brief(sd.value, sd.unit), "29.01 K");
  EXPECT_EQ(study.display.brief(value_of(r, "y1.mean"), r.find_value("y1.mean")->unit), "50.5 degC");
  const Table& quantiles = table_of(r, "quantiles");
  EXPECT_EQ(text_cell(quantiles, row_of(quantiles, "statistic", "standard deviation"), "value"), "29.01 K");
}

TEST(StudyResult, FailedCasesAreCountedByTheirReasonsAndLeftOutOfTheStatistics) {
  const Study study = of_cases(1500);
  StudyData data;
  data.outputs = {std::vector<double>(1500, 7)};
  for (std::uint64_t i = 0; i < 1200; ++i) {
    data.outputs[0][i] = std::nan("");
    data.failed.push_back({i, i % 3 == 0 ? "too short" : "too long"});
  }
  const Result r = study_result(study, data, {});
  EXPECT_EQ(r.preface, "1200 of 1500 cases have no answer (80 %)");
  const Table& reasons = table_of(r, "reasons");
  ASSERT_EQ(reasons.rows.size(), 2U);
  EXPECT_EQ(text_cell(reasons, 0, "reason"), "too long") << "the most frequent first";
  EXPECT_EQ(cell(reasons, 0, "cases"), 800);
  EXPECT_EQ(cell(reasons, 1, "cases"), 400);
  const Table& failed = table_of(r, "failed");
  EXPECT_EQ(failed.rows.size(), 1000U) << "all of them are in the file of the cases";
  EXPECT_THAT(failed.title, HasSubstr("the first ones"));
  EXPECT_EQ(cell(failed, 999, "case"), 999);
  EXPECT_EQ(value_of(r, "y1.mean"), 7);
  EXPECT_THAT(table_of(r, "quantiles").title, HasSubstr("left out"));
  EXPECT_EQ(r.answers.at(0).text, "y1: 7 to 7, of the 20 % of cases with an answer");
}

/// The product of two lists, which has no value where the first number is `without`.
Study products(double without) {
  return gridded(made_study({{.law = chance::Listed{.values = {1, 2, 3}}}, {.law = chance::Listed{.values = {10, 20}}}},
                            1, [without](const chance::Point& p) -> std::vector<double> {
                              return {p[0] == without ? std::nan("") : p[0] * p[1]};
                            }));
}

TEST(StudyResult, WhatIsSaidAgainstCasesIsCountedWithTheFirstOfThem) {
  const Study study = of_cases(100);
  StudyData data;
  data.outputs = {std::vector<double>(100, 7)};
  for (const std::uint64_t i : {4U, 9U}) {
    // two analyses say it
    for (int k = 0; k < 2; ++k) data.flawed.push_back({i, {.words = "it stands beside its span"}});
  }
  Result r = study_result(study, data, {});
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_EQ(r.unsafe[0], "2 of 100 cases are unsafe, the first is case 4: it stands beside its span");
  EXPECT_TRUE(r.unmade.empty());
  data.flawed.push_back({9, {.kind = CaseFlaw::Kind::unmade, .words = "no angle is known"}});
  data.flawed.push_back({12, {.kind = CaseFlaw::Kind::fails, .check = "sky.T_max", .words = "too much", .fact = true}});
  r = study_result(study, data, {});
  ASSERT_EQ(r.unmade.size(), 2U);
  EXPECT_EQ(r.unmade[0],
            "1 of 100 cases fail sky.T_max, which no 'limit' of the study counts, the first is case 12: too much");
  EXPECT_EQ(r.unmade[1], "1 of 100 cases are not judged, the first is case 9: no angle is known");
  const Table& flaws = table_of(r, "flaws");
  EXPECT_EQ(cell(flaws, row_of(flaws, "are", "unsafe"), "cases"), 2);
}

// A factor at rest says nothing of a motion that goes far beyond it: no limit on it can pass.
TEST(StudyResult, AValueThatCantBeJudgedMattersWhereALimitIsAboutIt) {
  Study study = of_cases(100);
  study.model.outputs[0].name = "transient.sky.safety_factor";
  StudyData data;
  data.outputs = {std::vector<double>(100, 30)};
  data.flawed = {{.index = 3,
                  .flaw = {.kind = CaseFlaw::Kind::unmade,
                           .check = "sky.safety_factor",
                           .words = "the motion reaches 55 kN",
                           .sense = Sense::at_least,
                           .analysis = "transient"}}};
  EXPECT_TRUE(study_result(study, data, {}).unmade.empty()) << "it is looked at alone";
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_least, .value = 5}, .allowed = 0.1}};
  const Result r = study_result(study, data, {});
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_EQ(r.unmade[0], "1 of 100 cases are not judged, the first is case 3: the motion reaches 55 kN");
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  data.flawed.front().flaw.analysis = "transient_2";
  EXPECT_TRUE(study_result(study, data, {}).unmade.empty()) << "of another motion";
}

/// A case whose rope misses the factor that the deck asks of it.
FlawedCase below_3() {
  return {
      .index = 3,
      .flaw = {
          .kind = CaseFlaw::Kind::fails, .check = "sky.safety_factor", .words = "below 3", .sense = Sense::at_least}};
}

// A limit of the deck itself gives way to that of the study on the same value, breaking does not.
TEST(StudyResult, ALimitOfTheStudyTakesThePlaceOfTheDecksOwn) {
  Study study = of_cases(100);
  study.model.outputs[0].name = "checks.sky.safety_factor";
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_least, .value = 2}, .allowed = 0.1}};
  StudyData data;
  data.outputs = {std::vector<double>(100, 2.5)};
  data.flawed = {below_3()};
  EXPECT_TRUE(study_result(study, data, {}).unmade.empty());
  data.flawed[0].flaw.check = "mainline.safety_factor";
  EXPECT_EQ(study_result(study, data, {}).unmade.size(), 1U) << "of another rope";
  data.flawed[0].flaw = {.kind = CaseFlaw::Kind::fails, .check = "sky.T_max", .words = "breaks", .fact = true};
  EXPECT_EQ(study_result(study, data, {}).unmade.size(), 1U) << "at a factor of 2.5 nothing counts it";
  data.outputs[0][3] = 0.9;
  EXPECT_TRUE(study_result(study, data, {}).unmade.empty());
}

/// A study with one limit that all its cases are beyond, where one case fails a check.
struct OneLimit {
  const char* output;
  chance::Bound bound;
  const char* check;
  Sense sense;
  const char* analysis;  ///< of the failure
  bool counts;
};

// Its cases are checked each by itself: what it lacks is a limit of its own.
TEST(StudyResult, AStudyWithoutALimitSaysThatItsCasesPass) {
  const Study study = of_cases(10);
  StudyData data;
  data.outputs = {std::vector<double>(10, 1)};
  const Result r = study_result(study, data, {});
  EXPECT_EQ(verdict_of(r)->verdict_class, "unasked");
  EXPECT_THAT(verdict_of(r)->reason, testing::HasSubstr("none of the 10 cases fails a check of the deck"));
  data.flawed = {{.index = 3, .flaw = {.kind = CaseFlaw::Kind::fails, .check = "sky.T_max"}}};
  EXPECT_THAT(verdict_of(study_result(study, data, {}))->reason, testing::Not(testing::HasSubstr("none of")));
}

// Each case alone is "not judged": no limit is given for that part.
TEST(StudyResult, APartThatNeitherDeckNorStudyLimitsIsNotJudged) {
  using enum chance::Bound;
  const auto unjudged_of = [](const std::string& output, chance::Bound bound, const std::vector<std::string>& parts,
                              double limit = 2) {
    Study study = of_cases(10);
    study.model.outputs[0].name = output;
    study.model.unasked = [&] {
      Unasked unasked{.strengths = {{"sky", 2}, {"other", 3}, {"pole", 2}}};
      for (const std::string& part : parts) unasked.parts.push_back({.name = part, .is_beam = part == "pole"});
      return unasked;
    };
    study.limits = {{.output = 0, .limit = {.bound = bound, .value = limit}, .allowed = 0.9}};
    StudyData data;
    data.outputs = {std::vector<double>(10, bound == at_least ? 3 : 0.5)};
    const Result r = study_result(study, data, {});
    const auto verdict = verdict_of(r);
    EXPECT_TRUE(verdict);
    EXPECT_EQ(verdict->verdict_class, r.unjudged.empty() ? "" : "unasked") << verdict->reason;
    EXPECT_EQ(verdict->kind == VerdictKind::passes, r.unjudged.empty()) << verdict->reason;
    return r.unjudged;
  };
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(unjudged_of("equilibrium.car.z", at_least, {"sky", "other"}), ElementsAre("sky", "other"));
  EXPECT_THAT(unjudged_of("equilibrium.sky.safety_factor", at_least, {"sky", "other"}), ElementsAre("other"));
  EXPECT_THAT(unjudged_of("equilibrium.sky.safety_factor", at_most, {"sky"}), ElementsAre("sky"));
  EXPECT_THAT(unjudged_of("equilibrium.T_max", at_most, {"sky", "other"}), IsEmpty()) << "the largest of all";
  EXPECT_THAT(unjudged_of("equilibrium.pole.stress_max", at_most, {"pole"}), IsEmpty());
  EXPECT_THAT(unjudged_of("equilibrium.car.z", at_least, {}), IsEmpty());
  // beyond the breaking force of 2 N and 3 N, or the yield of 2 Pa, it limits nothing; a strength not known is believed
  const char* const beyond = " (the limit of equilibrium.T_max is beyond breaking or yield)";
  EXPECT_THAT(unjudged_of("equilibrium.T_max", at_most, {"sky", "other", "new"}, 2.5),
              ElementsAre(std::string("sky") + beyond));
  EXPECT_THAT(unjudged_of("equilibrium.T_max", at_most, {"sky", "other"}, 3.5),
              ElementsAre(std::string("sky") + beyond, std::string("other") + beyond));
  EXPECT_EQ(unjudged_of("equilibrium.pole.stress_max", at_most, {"pole"}, 2.1).size(), 1U);
  EXPECT_THAT(unjudged_of("equilibrium.T_max", at_most, {"pole"}), ElementsAre("pole")) << "no tension limits a beam";
  EXPECT_EQ(unjudged_of("equilibrium.sky.T_max.utilisation", at_most, {"sky"}, 1.1).size(), 1U);
  EXPECT_THAT(unjudged_of("equilibrium.sky.T_max.utilisation", at_most, {"sky"}, 1), IsEmpty());
  EXPECT_EQ(unjudged_of("equilibrium.sky.safety_factor", at_least, {"sky"}, 0.9).size(), 1U);
  EXPECT_THAT(unjudged_of("equilibrium.sky.safety_factor", at_least, {"sky"}, 1), IsEmpty());
}

// A limit far beyond the breaking force does not take the place of the factor that the deck asks for.
TEST(StudyResult, ALimitBeyondBreakingTakesThePlaceOfNoLimitOfTheDeck) {
  Study study = of_cases(10);
  study.model.outputs[0].name = "checks.sky.T_max";
  study.model.strengths = {{"sky", 20e3}};
  StudyData data;
  data.outputs = {std::vector<double>(10, 10e3)};
  data.flawed = {below_3()};
  for (const auto& [limit, unmade] : {std::pair{20e3, 0U}, std::pair{21e3, 1U}}) {
    study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = limit}, .allowed = 0.9}};
    EXPECT_EQ(study_result(study, data, {}).unmade.size(), unmade) << limit;
  }
}

// The same where a case has a weaker part than the deck.
TEST(StudyResult, AWeakerCaseMakesALimitOfTensionTooHigh) {
  Study study = of_cases(10);
  study.model.outputs[0].name = "checks.sky.T_max";
  study.model.strengths = {{"sky", 20e3}};
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 18e3}, .allowed = 0.9}};
  StudyData data;
  data.outputs = {std::vector<double>(10, 10e3)};
  data.flawed = {below_3()};
  EXPECT_TRUE(study_result(study, data, {}).unmade.empty());
  data.weaker = {{"sky", 15e3}};
  EXPECT_EQ(study_result(study, data, {}).unmade.size(), 1U);
}

// What no case makes and the deck as it is fails: a limit of the study on the same value counts it.
TEST(StudyResult, WhatTheDeckFailsAndNoCaseMakesIsNotJudged) {
  Study study = of_cases(10);
  study.model.outputs[0].name = "equilibrium.sky.safety_factor";
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_least, .value = 2}, .allowed = 0.9}};
  StudyData data;
  data.outputs = {std::vector<double>(10, 3)};
  std::vector<CaseFlaw> fails;
  study.model.unasked = [&] { return Unasked{.fails = fails}; };
  EXPECT_EQ(verdict_of(study_result(study, data, {}))->kind, VerdictKind::passes);
  fails = {{.kind = CaseFlaw::Kind::fails,
            .check = "sky.safety_factor",
            .sense = Sense::at_least,
            .analysis = "equilibrium"}};
  EXPECT_EQ(verdict_of(study_result(study, data, {}))->kind, VerdictKind::passes);
  fails[0].analysis = "";
  EXPECT_EQ(verdict_of(study_result(study, data, {}))->kind, VerdictKind::not_judged)
      << "a check over several analyses";
  fails[0].analysis = "equilibrium";
  fails.push_back({.kind = CaseFlaw::Kind::fails, .check = "boom.member", .words = "1.26 is too much"});
  const Verdict verdict = *verdict_of(study_result(study, data, {}));
  EXPECT_EQ(verdict.verdict_class, "unmade");
  EXPECT_THAT(verdict.reason, HasSubstr("the deck as it is fails boom.member, which no case makes and no 'limit' of "
                                        "the study is about: 1.26 is too much"));
}

// A pull of 10 kN at least, or the pull in another analysis, says nothing of a rope that has too much.
TEST(StudyResult, ALimitCountsAFailureOfItsOwnSideAndAnalysisOnly) {
  using enum chance::Bound;
  const Sense least = Sense::at_least, most = Sense::at_most;
  const OneLimit all[] = {{.output = "equilibrium.sky.T_max",
                           .bound = at_most,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.sky.T_max",
                           .bound = at_least,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = false},
                          {.output = "equilibrium.sky.T_max",
                           .bound = at_most,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.sky.T_max",
                           .bound = at_least,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = false},
                          {.output = "equilibrium.sky.safety_factor",
                           .bound = at_least,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.sky.safety_factor",
                           .bound = at_most,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = false},
                          {.output = "equilibrium.T_max",
                           .bound = at_most,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.T_max",
                           .bound = at_least,
                           .check = "sky.T_max",
                           .sense = most,
                           .analysis = "equilibrium",
                           .counts = false},
                          {.output = "equilibrium.sky.T_max.utilisation",
                           .bound = at_most,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.sky.T_max.utilisation",
                           .bound = at_least,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = false},
                          {.output = "equilibrium.rope_clearance_min",
                           .bound = at_least,
                           .check = "sky.ground",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = true},
                          {.output = "equilibrium.rope_clearance_min",
                           .bound = at_most,
                           .check = "sky.ground",
                           .sense = least,
                           .analysis = "equilibrium",
                           .counts = false},
                          // of another analysis, of all of them, of a method
                          {.output = "equilibrium.sky.T_max",
                           .bound = at_most,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium_mid",
                           .counts = false},
                          {.output = "equilibrium.sky.T_max",
                           .bound = at_most,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "",
                           .counts = false},
                          {.output = "checks.sky.safety_factor",
                           .bound = at_least,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "",
                           .counts = true},
                          {.output = "checks.sky.safety_factor",
                           .bound = at_least,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "equilibrium_mid",
                           .counts = true},
                          {.output = "checks.sky.safety_factor",
                           .bound = at_most,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "",
                           .counts = false},
                          {.output = "sky.safety_factor",
                           .bound = at_least,
                           .check = "sky.safety_factor",
                           .sense = least,
                           .analysis = "",
                           .counts = true}};
  for (const OneLimit& one : all) {
    Study study = of_cases(10);
    study.model.outputs[0].name = one.output;
    const double value = one.bound == at_least ? 0.5 : 3;
    study.limits = {{.output = 0, .limit = {.bound = one.bound, .value = 1}, .allowed = 0.1}};
    StudyData data;
    data.outputs = {std::vector<double>(10, value)};
    for (const bool fact : {false, true}) {
      data.flawed = {{.index = 3,
                      .flaw = {.kind = CaseFlaw::Kind::fails,
                               .check = one.check,
                               .words = "beyond",
                               .fact = fact,
                               .sense = one.sense,
                               .analysis = one.analysis}}};
      EXPECT_EQ(study_result(study, data, {}).unmade.empty(), one.counts) << one.output << ", " << one.analysis;
    }
  }
}

TEST(StudyResult, WhatTheDeckTakesOutOfTheVerdictIsSaid) {
  Study study = products(0);
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 100}, .allowed = {}}};
  study.model.exempt = {"drop"};
  study.model.left_out = {"equilibrium mid"};
  const Result r = study_result(study, data_of(study), {});
  EXPECT_EQ(r.exempt, study.model.exempt);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("left out by 'judge: false': equilibrium mid"));
}

TEST(StudyResult, AnalysesThatNoCaseCalculatesAreSaid) {
  Study study = products(2);
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 100}, .allowed = {}}};
  study.model.not_run = {"sweep", "transient_fast"};
  EXPECT_THAT(verdict_of(study_result(study, data_of(study), {}))->reason,
              testing::StartsWith("2 of 6 cases have no answer (33.3 %); no case calculates sweep, transient_fast; "));
}

TEST(StudyResult, AGridTellsItsExtremesAndWhereTheyAre) {
  Study study = products(0);
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 50}, .allowed = {}},
                  {.output = 0, .limit = {.bound = chance::Bound::at_least, .value = 5}, .allowed = {}}};
  const Result r = study_result(study, data_of(study), {});
  EXPECT_EQ(value_of(r, "y1.least"), 10);
  EXPECT_EQ(value_of(r, "y1.largest"), 60);
  const Table& t = table_of(r, "extremes");
  EXPECT_EQ(text_cell(t, 0, "least_at"), "x1.value 1, x2.value 10");
  EXPECT_EQ(text_cell(t, 0, "largest_at"), "x1.value 3, x2.value 20");
  EXPECT_NEAR(check_of(r, "y1.largest").utilisation, 60.0 / 50, 1e-12);
  EXPECT_FALSE(check_of(r, "y1.largest").passes);
  EXPECT_TRUE(check_of(r, "y1.least").passes);
  EXPECT_TRUE(r.missing.empty());
  EXPECT_THAT(r.assumptions, testing::Contains("6 cases on a grid"));
}

TEST(StudyResult, AGridWithACaseWithoutAnAnswerDoesNotKeepItsLimits) {
  Study study = products(2);
  EXPECT_TRUE(study_result(study, data_of(study), {}).missing.empty()) << "no limit asks for them";
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 100}, .allowed = {}}};
  const Result r = study_result(study, data_of(study), {});
  EXPECT_EQ(value_of(r, "y1.largest"), 60) << "of the cases that have an answer";
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].missing, 2);
  EXPECT_EQ(r.missing[0].places, 6);
  EXPECT_EQ(r.missing[0].first, "x1.value 2, x2.value 10");
  EXPECT_EQ(r.missing[0].all, "x1.value 2, x2.value 10 to x2.value 20 (2 states)");
  EXPECT_EQ(r.missing[0].reason, "the function has no value there");
}

TEST(StudyResult, AGridWithoutAnyAnswerHasNoNumber) {
  Study study = gridded(made_study({{.law = chance::Listed{.values = {5}}}}, 1,
                                   [](const chance::Point&) { return std::vector<double>{std::nan("")}; }));
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 100}, .allowed = {}}};
  const Result r = study_result(study, data_of(study), {});
  EXPECT_EQ(r.find_value("y1.least"), nullptr);
  EXPECT_TRUE(r.checks.empty());
  EXPECT_TRUE(table_of(r, "extremes").rows.empty());
  EXPECT_EQ(r.preface, "1 of 1 cases have no answer (100 %)");
  EXPECT_EQ(r.missing.size(), 1U);
}

}  // namespace taut::app::study_result_test
