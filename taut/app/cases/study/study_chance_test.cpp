#include "taut/app/cases/study/study_chance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "test/support/machine_decks.hpp"
#include "test/support/made_study.hpp"

namespace taut::app::study_chance_test {

using taut_test::cell;
using taut_test::data_of;
using taut_test::made_study;
using taut_test::row_of;
using taut_test::sampled;
using taut_test::table_of;
using taut_test::text_cell;
using taut_test::value_of;
using testing::HasSubstr;

constexpr double far_out = 1e3;

const chance::Distribution standard{.law = chance::Normal{.mean = 0, .sd = 1}};

/// 3 a + 4 b of standard normal numbers: normal itself, with the standard deviation 5.
Study linear() {
  return made_study({standard, standard}, 1,
                    [](const chance::Point& p) -> std::vector<double> { return {3 * p[0] + 4 * p[1]}; });
}

StudyLimit at_most(double value, std::optional<double> allowed = {}) {
  return {.output = 0, .limit = {.bound = chance::Bound::at_most, .value = value}, .allowed = allowed};
}

/// What the result says of 64 random cases: so many beyond a limit, so many without an answer, the others within it.
Result counted(std::size_t beyond, std::size_t failed, std::optional<double> allowed) {
  Study study = sampled(linear(), chance::PointKind::random, 64);
  study.limits = {at_most(1, allowed)};
  StudyData data;
  data.outputs = {std::vector<double>(64, 0)};
  for (std::size_t i = 0; i < beyond; ++i) data.outputs[0][3 * i] = far_out;
  for (std::size_t i = 0; i < failed; ++i) data.outputs[0][3 * i + 1] = std::nan("");
  ChanceSummary summary;
  Result r;
  add_chance(study, data, {}, summary, r);
  EXPECT_EQ(summary.probabilities.size(), 1U);
  return r;
}

TEST(StudyChance, CasesWithoutAnAnswerCountAsBeyondALimit) {
  const Result r = counted(5, 3, {});
  EXPECT_DOUBLE_EQ(value_of(r, "p"), 8.0 / 64);
  const Table& t = table_of(r, "probabilities");
  EXPECT_EQ(text_cell(t, 0, "event"), "y1 above 1");
  EXPECT_DOUBLE_EQ(cell(t, 0, "failed_left_out"), 5.0 / 61);
  EXPECT_EQ(text_cell(t, 0, "from"), "64 cases, 5 beyond, 3 without an answer");
  EXPECT_LT(cell(t, 0, "low"), 8.0 / 64);
  EXPECT_GT(cell(t, 0, "high"), 8.0 / 64);
}

// Clopper and Pearson's interval of no case of n ends at 1 - 0.025^(1/n), that of all cases begins at 0.025^(1/n).
TEST(StudyChance, AnAllowedProbabilityIsJudgedByTheWholeInterval) {
  const double most = 1 - std::pow(0.025, 1.0 / 64), least = 1 - most;
  const Result kept = counted(0, 0, 0.06);
  ASSERT_EQ(kept.checks.size(), 1U);
  EXPECT_TRUE(kept.checks[0].passes);
  EXPECT_NEAR(kept.checks[0].value, most, 1e-9);
  EXPECT_TRUE(kept.unmade.empty());
  const Result unsure = counted(0, 0, 0.05);
  EXPECT_TRUE(unsure.checks.empty());
  ASSERT_EQ(unsure.unmade.size(), 1U);
  // the upper end falls with the number of cases: 64 * 0.0560/0.05 = 71.7
  EXPECT_THAT(unsure.unmade[0], HasSubstr("about 72 samples would tell"));
  const Result lost = counted(21, 21, 0.5);
  ASSERT_EQ(lost.checks.size(), 1U) << "42 of 64, half of them failed";
  EXPECT_FALSE(lost.checks[0].passes);
  EXPECT_NEAR(cell(table_of(counted(0, 0, {}), "probabilities"), 0, "low"), 0, 1e-12);
  EXPECT_EQ(counted(0, 0, {}).unjudged.size(), 1U) << "nothing is allowed, so that nothing is judged";
  Study all = sampled(linear(), chance::PointKind::random, 64);
  all.limits = {at_most(-far_out)};
  ChanceSummary summary;
  Result r;
  add_chance(all, data_of(all), {}, summary, r);
  EXPECT_NEAR(cell(table_of(r, "probabilities"), 0, "low"), least, 1e-9);
}

// Of 3 a + 4 b the variance is 9 + 16, without interplay; of a b none of it comes from one factor alone.
TEST(StudyChance, SobolIndicesOfASumAndOfAProduct) {
  Study study = made_study({standard, standard}, 2, [](const chance::Point& p) -> std::vector<double> {
    return {3 * p[0] + 4 * p[1], p[0] * p[1]};
  });
  study.request.answer = {"indices"};
  study = sampled(study, chance::PointKind::sobol, 16384);
  ChanceSummary summary;
  Result r;
  add_chance(study, data_of(study), {}, summary, r);
  const Table& sum = table_of(r, "sensitivity_1");
  ASSERT_EQ(sum.rows.size(), 2U);
  for (const char* share : {"first", "total"}) {
    EXPECT_NEAR(cell(sum, 0, share), 9.0 / 25, 0.01) << share;
    EXPECT_NEAR(cell(sum, 1, share), 16.0 / 25, 0.01) << share;
  }
  const Table& product = table_of(r, "sensitivity_2");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(cell(product, i, "first"), 0, 0.03);
    EXPECT_NEAR(cell(product, i, "total"), 1, 0.03);
  }
  ASSERT_EQ(summary.indices.size(), 2U);
  ASSERT_FALSE(r.answers.empty());
  EXPECT_THAT(r.answers[0].text, HasSubstr("y1: x2.value, total Sobol index 0.64"));
}

TEST(StudyChance, ATornadoGoesFromQuantileToQuantileTheWidestFirst) {
  Study study = made_study({standard, standard, standard}, 1, [](const chance::Point& p) -> std::vector<double> {
    return {std::abs(p[2]) > 1.6 ? std::nan("") : 3 * p[0] - 4 * p[1]};
  });
  study.request.answer = {"tornado"};
  study = sampled(study, chance::PointKind::random, 64);
  ChanceSummary summary;
  Result r;
  add_chance(study, data_of(study), {}, summary, r);
  const Table& t = table_of(r, "tornado");
  ASSERT_EQ(t.rows.size(), 3U);
  constexpr double q = 1.6448536269514722;  // the 95 % quantile of the standard normal law
  EXPECT_EQ(text_cell(t, 0, "input"), "x2.value");
  EXPECT_NEAR(cell(t, 0, "at_from"), 4 * q, 1e-9);
  EXPECT_NEAR(cell(t, 0, "change"), -8 * q, 1e-9);
  EXPECT_EQ(text_cell(t, 0, "from"), "-1.6449");
  EXPECT_NEAR(cell(t, 1, "change"), 6 * q, 1e-9);
  EXPECT_EQ(text_cell(t, 2, "input"), "x3.value") << "a bar without an answer comes last";
  EXPECT_TRUE(std::isnan(cell(t, 2, "change")));
}

// Beyond 15 = 3 * 5 lies Phi(-3); the most likely place is (15/25) (3, 4), where a has 9/25 of the importance.
TEST(StudyChance, FormOfALinearLimitIsExact) {
  Study study = linear();
  study.request.answer = {"sorm"};
  study.limits = {at_most(15, 0.01), at_most(10)};
  study = sampled(study, chance::PointKind::random, 64);
  ChanceSummary summary;
  Result r;
  add_chance(study, data_of(study), {.threads = 1, .progress = {}}, summary, r);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  constexpr double beyond = 1.3498980316300945e-3;  // Phi(-3)
  EXPECT_NEAR(value_of(r, "beta_1"), 3, 1e-6);
  EXPECT_NEAR(value_of(r, "p_form_1"), beyond, 1e-6 * beyond);
  EXPECT_NEAR(value_of(r, "p_sorm_1"), beyond, 1e-3 * beyond) << "a plane has no curvature";
  EXPECT_NEAR(value_of(r, "p_1"), beyond, 0.1 * beyond);
  EXPECT_NEAR(value_of(r, "beta_2"), 2, 1e-6);
  const Table& t = table_of(r, "design_point_1");
  EXPECT_EQ(text_cell(t, row_of(t, "input", "x1.value"), "value"), "1.8");
  EXPECT_EQ(text_cell(t, row_of(t, "input", "x2.value"), "value"), "2.4");
  EXPECT_NEAR(cell(t, row_of(t, "input", "x1.value"), "importance"), 9.0 / 25, 1e-6);
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_TRUE(r.checks[0].passes) << "0.00135 of 0.01";
}

/// What FORM says of 64 cases of the model.
Result by_form(Study study, const StudyLimit& limit) {
  study.request.answer = {"form"};
  study.limits = {limit};
  study = sampled(study, chance::PointKind::random, 64);
  ChanceSummary summary;
  Result r;
  add_chance(study, data_of(study), {.threads = 1, .progress = {}}, summary, r);
  return r;
}

// Where b < -2.5 and a < 1 a machine has no answer, P = 0.0052; FORM sees the limit at a = 6 alone, P = 1e-9, and of
// 64 cases none may lie there. The added plain cases see it and decide.
TEST(StudyChance, FormDoesNotPassWhereTheStudyHasFewCases) {
  const auto model = [](const chance::Point& p) -> std::vector<double> {
    return {p[1] < -2.5 && p[0] < 1 ? std::nan("") : p[0]};
  };
  const Result r = by_form(made_study({standard, standard}, 1, model), at_most(6, 1e-3));
  EXPECT_EQ(r.status, Status::ok) << r.message;
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_FALSE(r.checks[0].passes);
  EXPECT_NEAR(value_of(r, "p"), 5.2e-3, 2.5e-3);
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_THAT(r.warnings[0], HasSubstr("FORM has missed a way to fail"));
}

// Phi(-3) = 1.35e-3. What 20000 plain cases leave open is more than 1.5e-3, and less than 1e-2. Below 1e-3 the plain
// sample does not reach, and the verdict says so.
TEST(StudyChance, APlainSampleStandsBesideAKeptLimit) {
  const Result open = by_form(linear(), at_most(15, 1.5e-3));
  EXPECT_TRUE(open.checks.empty());
  ASSERT_EQ(open.unmade.size(), 1U);
  EXPECT_THAT(open.unmade[0], HasSubstr("samples would tell"));
  const Result kept = by_form(linear(), at_most(15, 1e-2));
  ASSERT_EQ(kept.checks.size(), 1U);
  EXPECT_TRUE(kept.checks[0].passes);
  EXPECT_TRUE(kept.unsafe.empty());
  const Result rare = by_form(linear(), at_most(25, 1e-5));
  ASSERT_EQ(rare.checks.size(), 1U);
  EXPECT_TRUE(rare.checks[0].passes);
  ASSERT_EQ(rare.unsafe.size(), 1U);
  EXPECT_THAT(rare.unsafe[0], HasSubstr("a way to fail that FORM has not found is excluded only above"));
  EXPECT_LE(rare.unsafe[0].size(), 160U);
}

// The medians lie 2.5 and 4 standard deviations beyond the limit: P = 0.99379 and 0.99997, not 1.08 and no answer.
TEST(StudyChance, AMachineThatNearlyAlwaysFails) {
  for (const auto& [beta, p] : {std::pair{-2.5, 0.993790334674224}, {-4.0, 0.999968328758167}}) {
    const Result r = by_form(linear(), at_most(5 * beta, 1e-2));
    ASSERT_EQ(r.status, Status::ok) << r.message;
    EXPECT_NEAR(value_of(r, "p"), p, 0.1 * (1 - p));
    const Table& t = table_of(r, "probabilities");
    EXPECT_TRUE(cell(t, 0, "low") < p && p < cell(t, 0, "high") && cell(t, 0, "high") < 1);
    ASSERT_EQ(r.checks.size(), 1U);
    EXPECT_FALSE(r.checks[0].passes);
  }
}

// FORM has no design point of an output that never changes. No case of 64 lies beyond: at most 0.056 by the sample.
TEST(StudyChance, WithoutADesignPointTheSampleDecidesIfItCan) {
  const Study flat =
      made_study({standard, standard}, 1, [](const chance::Point&) -> std::vector<double> { return {0}; });
  const Result kept = by_form(flat, at_most(1, 0.06));
  EXPECT_EQ(kept.status, Status::ok) << kept.message;
  ASSERT_EQ(kept.checks.size(), 1U);
  EXPECT_TRUE(kept.checks[0].passes);
  ASSERT_EQ(kept.warnings.size(), 1U);
  EXPECT_THAT(kept.warnings[0], HasSubstr("The plain sample of 64 cases decides"));
  const Result open = by_form(flat, at_most(1, 0.05));
  EXPECT_EQ(open.status, Status::not_converged);
  EXPECT_THAT(open.message, HasSubstr("about 72 samples would tell"));
  EXPECT_TRUE(open.checks.empty());
  const Result free = by_form(flat, at_most(1));
  EXPECT_EQ(free.status, Status::not_converged);
  EXPECT_THAT(free.message, HasSubstr("leaving form, sorm and importance out of 'answer'"));
}

}  // namespace taut::app::study_chance_test
