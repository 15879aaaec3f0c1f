#include "taut/chance/reliability/importance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/chance/standard_laws.hpp"
#include "test/support/limit_states.hpp"

namespace taut::chance::importance_test {

using namespace taut_test;

/// One plane at the distance beta: p = Phi(-beta) exactly, also far out.
TEST(Importance, a_plane_has_its_probability) {
  for (const double beta : {1.0, 3.0, 5.0}) {
    const LimitState state =
        state_of(normals(3), [beta](const Point& x) { return beta - (2 * x[0] - x[1] + 2 * x[2]) / 3; });
    const ImportanceSampling s = importance_sampling(state, form(state));
    ASSERT_EQ(s.status, ImportanceStatus::found) << s.reason;
    EXPECT_NEAR(s.counted.value, normal_above(beta), 4 * s.counted.standard_error) << beta;
    EXPECT_LT(s.counted.variation, 0.05);
    EXPECT_EQ(s.rests_on.empty(), beta < 3.5) << beta;
  }
}

// Where the medians fail, beta < 0, the kept region is sampled: p = Phi(-beta) lies below 1 and is known to Phi(beta)'s
// error. Weights of the failing region around the same points gave 1.08 at beta = -2.5.
TEST(Importance, a_plane_that_the_medians_do_not_keep) {
  for (const double beta : {-0.5, -2.5, -4.0, -6.0}) {
    const LimitState state = state_of(normals(2), [beta](const Point& x) { return beta - (3 * x[0] - 4 * x[1]) / 5; });
    const ImportanceSampling s = importance_sampling(state, form(state));
    ASSERT_EQ(s.status, ImportanceStatus::found) << beta << s.reason;
    EXPECT_NEAR(1 - s.counted.value, normal_below(beta), 4 * s.counted.standard_error) << beta;
    EXPECT_LT(s.counted.standard_error, 0.03 * normal_below(beta)) << beta;
    EXPECT_EQ(s.left_out.value, s.counted.value) << beta;
  }
}

TEST(Importance, failed_cases_where_the_medians_fail) {
  const LimitState state = state_of(normals(1), [](const Point& x) { return x[0] < -1 ? std::nan("") : x[0] - 2; });
  const ImportanceSampling s = importance_sampling(state, form(state));
  ASSERT_EQ(s.status, ImportanceStatus::found) << s.reason;
  EXPECT_NEAR(s.counted.value, normal_below(2), 4 * s.counted.standard_error);
  const double beyond = normal_below(2) - normal_below(-1);
  EXPECT_NEAR(s.left_out.value, beyond / normal_above(-1), 4 * s.left_out.standard_error);
  EXPECT_LT(s.left_out.standard_error, 0.01);
  EXPECT_TRUE(std::isnan(importance_sampling(state, form(state), {.plain_samples = 0}).left_out.value));
}

TEST(Importance, nothing_without_a_design_point) {
  const LimitState state = state_of(normals(1), [](const Point& x) { return 20 - x[0]; });
  const ImportanceSampling s = importance_sampling(state, form(state));
  EXPECT_EQ(s.status, ImportanceStatus::no_design_point);
  EXPECT_EQ(s.samples, 0u);
  EXPECT_FALSE(s.reason.empty());
}

// Beyond the limit the machine has no equilibrium: those cases count as beyond and are reported as failed.
TEST(Importance, failed_cases_both_ways) {
  const LimitState state =
      state_of(normals(1), [](const Point& x) { return x[0] > 2.5 ? std::nan("") : 2 - x[0]; }, {});
  const Form f = form(state);
  ASSERT_EQ(f.points.size(), 1u) << f.reason;
  EXPECT_NEAR(f.points[0].beta, 2, 1e-5);
  const ImportanceSampling s = importance_sampling(state, f);
  ASSERT_EQ(s.status, ImportanceStatus::found) << s.reason;
  EXPECT_NEAR(s.counted.value, normal_above(2), 4 * s.counted.standard_error);
  const double beyond = normal_above(2) - normal_above(2.5);
  EXPECT_NEAR(s.left_out.value, beyond / normal_below(2.5), 4 * s.left_out.standard_error);
  EXPECT_GT(s.failed, 1000u);
}

// A second way to fail that has no design point: the plain sample finds it, and there is no number.
TEST(Importance, disagrees_where_a_way_to_fail_was_missed) {
  const OutputOf two = [](const Point& x) { return std::min(2.8 - x[0], 2.2 + x[1]); };
  const LimitState state = state_of(normals(2), two);
  Form f = form(state);
  ASSERT_EQ(f.points.size(), 2u);
  EXPECT_EQ(importance_sampling(state, f).status, ImportanceStatus::found);
  f.points.erase(f.points.begin());  // the nearer one
  const ImportanceSampling s = importance_sampling(state, f);
  EXPECT_EQ(s.status, ImportanceStatus::disagrees);
  EXPECT_NE(s.reason.find("FORM has missed a way to fail"), std::string::npos);
  // a plain sample that the study has already is taken
  LimitProbability plain;
  plain.cases = 1000000;
  plain.beyond = static_cast<std::uint64_t>(std::round(1e6 * s.counted.value));
  plain.counted.value = s.counted.value;
  EXPECT_EQ(importance_sampling(state, f, {}, plain).status, ImportanceStatus::found);
}

/// 64 cases of a study, none of which lies beyond.
LimitProbability clean_64() {
  LimitProbability few;
  few.cases = 64;
  few.counted.interval.high = 1;
  return few;
}

// A small sample of the study does not stand for the plain sample that sees a missed way of 1e-3: cases are added to
// it. Of 64 clean cases alone p = 1e-9 was "found".
TEST(Importance, completes_a_small_sample_of_the_study) {
  // a region without an answer has no design point
  const LimitState hidden =
      state_of(normals(2), [](const Point& x) { return x[1] < -2.5 && x[0] < 1 ? std::nan("") : 6 - x[0]; });
  const ImportanceSampling s = importance_sampling(hidden, form(hidden), {.seed = 3}, clean_64());
  EXPECT_EQ(s.status, ImportanceStatus::disagrees);
  ASSERT_TRUE(s.plain);
  const auto& [low, high] = s.plain->counted.interval;
  const double p = normal_above(2.5) * normal_below(1) + normal_above(6);
  EXPECT_TRUE(low < p && p < high) << low << ' ' << high;
  EXPECT_EQ(s.plain->beyond, 0u);
  EXPECT_EQ(s.plain->left_out.value, 0);

  // (1 - 1e-3)^n = 0.025 where nothing lies beyond: n = 3688; more where some cases do anyway, up to 20000
  const auto cases = [](double beta, double confidence) {
    const LimitState plane = state_of(normals(2), [beta](const Point& x) { return beta - x[0] + 0 * x[1]; });
    const ImportanceSampling found = importance_sampling(plane, form(plane), {.confidence = confidence}, clean_64());
    return found.plain->cases;
  };
  EXPECT_EQ(cases(6, 0.95), 3688u);
  EXPECT_EQ(cases(6, 0.99), 5296u);    // ln 0.005/ln(1 - 1e-3)
  EXPECT_EQ(cases(5.2, 0.95), 3688u);  // p = 1e-7 takes none away
  EXPECT_GT(cases(4, 0.95), 3688u);
  EXPECT_LT(cases(4, 0.95), cases(3.5, 0.95));
  EXPECT_EQ(cases(2, 0.95), 20000u);
}

TEST(Importance, too_few_samples_beyond) {
  const LimitState state = state_of(normals(1), [](const Point& x) { return 3 - x[0]; });
  Form f = form(state);
  f.points[0].scores[0] = -3;  // as if FORM had ended elsewhere
  const ImportanceSampling s = importance_sampling(state, f, {.seed = 3, .most_samples = 2000});
  EXPECT_EQ(s.status, ImportanceStatus::not_converged);
  EXPECT_EQ(s.samples, 2000u);
  // the plain sample may decide yet
  ASSERT_TRUE(s.plain);
  EXPECT_EQ(s.plain->cases, 20000u);
  EXPECT_TRUE(s.plain->counted.interval.low < normal_above(3) && normal_above(3) < s.plain->counted.interval.high);
}

}  // namespace taut::chance::importance_test
