#include "taut/chance/reliability/form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "taut/chance/reliability/importance.hpp"
#include "taut/chance/sensitivity.hpp"
#include "taut/chance/standard_laws.hpp"
#include "test/support/limit_states.hpp"

namespace taut::chance::form_test {

using namespace taut_test;

// The worked case of the specification: a rope's safety factor n = R/(k Q/(4 f)) below 3.
const Inputs rope{.of = {{.law = Lognormal{.mean = 400, .sd = 16}},
                         {.law = Normal{.mean = 25, .sd = 3}},
                         {.law = Normal{.mean = 0.06, .sd = 0.004}},
                         {.law = Gumbel{.mode = 1.05, .scale = 0.03}}}};
double factor(const Point& x) { return x[0] / (x[3] * x[1] / (4 * x[2])); }

TEST(Form, worked_case) {
  const LimitState state = state_of(rope, factor, {.bound = Bound::at_least, .value = 3});
  const Form f = form(state);
  ASSERT_EQ(f.status, FormStatus::found) << f.reason;
  EXPECT_GE(f.starts, 5u);
  ASSERT_EQ(f.points.size(), 1u);
  const DesignPoint& p = f.points[0];
  EXPECT_NEAR(p.beta, 1.3139, 1e-3);
  EXPECT_NEAR(p.probability, 0.0944, 1e-4);
  EXPECT_NEAR(p.breitung, 0.0994, 2e-4);
  EXPECT_NEAR(factor(p.values), 3, 1e-3);
  EXPECT_NEAR(p.importance[0] + p.importance[1] + p.importance[2] + p.importance[3], 1, 1e-12);
  EXPECT_EQ(f.evaluations, state.evaluations());
  EXPECT_LT(f.evaluations, 4000u);

  const ImportanceSampling s = importance_sampling(state, f, {.most_samples = 200000, .wanted_variation = 2e-3});
  ASSERT_EQ(s.status, ImportanceStatus::found) << s.reason;
  EXPECT_NEAR(s.counted.value, 0.1012, 7e-4);
  EXPECT_LT(s.counted.standard_error, 4e-4);
  EXPECT_EQ(s.counted.value, s.left_out.value);
  EXPECT_TRUE(s.plain->counted.interval.low < s.counted.value && s.counted.value < s.plain->counted.interval.high);
  EXPECT_EQ(s.rests_on, "");
}

// The other bound, another unit, another order of the inputs, the parameters of the model in pieces: the same answer.
TEST(Form, the_same_question_has_the_same_answer) {
  const Form a = form(state_of(rope, factor, {.bound = Bound::at_least, .value = 3}));
  const Form b =
      form(state_of(rope, [](const Point& x) { return -1e6 * factor(x); }, {.bound = Bound::at_most, .value = -3e6}));
  EXPECT_NEAR(a.points[0].beta, b.points[0].beta, 1e-6);
  const Inputs turned{.of = {rope.of[3], rope.of[2], rope.of[1], rope.of[0]}};
  const Form c = form(state_of(turned,
                               [](const Point& x) {
                                 return factor({x[3], x[2], x[1], x[0]});
                               },
                               {.bound = Bound::at_least, .value = 3}));
  EXPECT_NEAR(a.points[0].beta, c.points[0].beta, 1e-4);
  EXPECT_NEAR(a.points[0].importance[1], c.points[0].importance[2], 2e-3);
  EXPECT_NEAR(a.points[0].breitung, c.points[0].breitung, 1e-5);
  const Form again = form(state_of(rope, factor, {.bound = Bound::at_least, .value = 3}));
  EXPECT_EQ(a.points[0].scores, again.points[0].scores);
}

// A plane is exact: beta = (mean of the margin)/(its sd), also with correlated normal inputs; where the medians fail,
// beta is below 0.
TEST(Form, plane) {
  Inputs in{.of = {{.law = Normal{.mean = 10, .sd = 2}}, {.law = Normal{.mean = 4, .sd = 1}}}};
  const OutputOf g = [](const Point& x) { return x[0] - x[1]; };
  EXPECT_NEAR(form(state_of(in, g)).points[0].beta, 6 / std::sqrt(5.), 1e-6);
  EXPECT_NEAR(form(state_of(in, g)).points[0].breitung, normal_above(6 / std::sqrt(5.)), 1e-9);
  const Form failing = form(state_of(in, g, {.bound = Bound::at_least, .value = 8}));
  EXPECT_NEAR(failing.points[0].beta, -2 / std::sqrt(5.), 1e-6);
  EXPECT_NEAR(failing.points[0].breitung, normal_below(2 / std::sqrt(5.)), 1e-9);
  in.correlation = *correlation(std::vector<CorrelatedPair>{{.first = 0, .second = 1, .r = 0.5}},
                                std::vector<std::string>{"R", "S"});
  const Form correlated = form(state_of(in, g));
  EXPECT_NEAR(correlated.points[0].beta, 6 / std::sqrt(5. - 2), 1e-6);
  // alike in either order of the inputs: gamma ~ (2, -1) of the scores' own gradient
  EXPECT_NEAR(correlated.points[0].importance[0], 0.8, 1e-6);
}

// p = integral of phi(y) Phi(-(b + k y^2/2)) over y: Breitung's exact case is its limit for a large b.
TEST(Form, breitung_of_a_paraboloid) {
  for (const double k : {-0.1, 0.5, 2.}) {
    const double b = 4;
    const LimitState state = state_of(normals(2), [=](const Point& x) { return b + k * x[1] * x[1] / 2 - x[0]; });
    const Form f = form(state);
    ASSERT_EQ(f.points.size(), 1u) << k;
    EXPECT_NEAR(f.points[0].beta, b, 1e-5);
    EXPECT_NEAR(f.points[0].curvatures[0], k, 1e-3);
    double exact = 0;
    for (int i = -8000; i <= 8000; ++i) {
      const double y = i * 1e-3;
      exact += 1e-3 * normal_density(y) * normal_above(b + k * y * y / 2);
    }
    EXPECT_NEAR(f.points[0].breitung / exact, 1, 0.06) << k;
    const ImportanceSampling s = importance_sampling(state, f);
    ASSERT_EQ(s.status, ImportanceStatus::found) << s.reason;
    EXPECT_NEAR(s.counted.value, exact, 4 * s.counted.standard_error);
    EXPECT_NE(s.rests_on.find("samples around the design points"), std::string::npos);
  }
}

// The axis x1 is the saddle of a limit that bends back to both sides: two design points, not one.
TEST(Form, leaves_a_saddle_to_both_sides) {
  const Form f = form(state_of(normals(2), [](const Point& x) { return 4 - x[0] - 0.4 * x[1] * x[1]; }));
  ASSERT_EQ(f.points.size(), 2u);
  // least x0^2 + x1^2 with x0 = 4 - 0.4 x1^2: x0 = 1/0.8
  for (const DesignPoint& p : f.points) {
    EXPECT_NEAR(p.scores[0], 1.25, 1e-2);
    EXPECT_NEAR(p.beta, std::sqrt(1.25 * 1.25 + (4 - 1.25) / 0.4), 1e-4);
  }
}

// A model whose results carry the noise of a solver: larger steps, the same beta.
TEST(Form, noisy_model) {
  const OutputOf noisy = [](const Point& x) {
    const double noise = std::fmod(1e7 * (x[0] + 3 * x[1] + x[2] * 1e3 + x[3]), 1.) - 0.5;
    return factor(x) * (1 + 1e-4 * noise);
  };
  const Form f = form(state_of(rope, noisy, {.bound = Bound::at_least, .value = 3}));
  ASSERT_EQ(f.status, FormStatus::found) << f.reason;
  EXPECT_NEAR(f.points[0].beta, 1.3139, 2e-3);
}

TEST(Form, no_answer_has_a_reason_and_no_number) {
  const Form never = form(state_of(normals(2), [](const Point& x) { return 1 + x[0] * x[0] + x[1] * x[1]; }));
  EXPECT_EQ(never.status, FormStatus::not_converged);
  EXPECT_TRUE(never.points.empty());
  EXPECT_NE(never.reason.find("Sample instead"), std::string::npos);
  const LimitState never_state = state_of(normals(2), [](const Point&) { return 1.; });
  const ImportanceSampling s = importance_sampling(never_state, form(never_state));
  EXPECT_EQ(s.status, ImportanceStatus::no_design_point);
  EXPECT_NE(s.reason.find("the margin does not change"), std::string::npos) << s.reason;

  // no equilibrium before the limit is reached
  const Form cut = form(state_of(normals(2), [](const Point& x) { return x[0] > 2 ? std::nan("") : 3 - x[0]; }));
  EXPECT_EQ(cut.status, FormStatus::not_converged);
  const Form nothing = form(state_of(normals(1), [](const Point&) { return std::nan(""); }));
  EXPECT_EQ(nothing.status, FormStatus::refused);
  EXPECT_NE(nothing.reason.find("medians failed"), std::string::npos);
  const Form list = form(
      state_of({.of = {{.law = Normal{}}, {.law = Listed{.values = {1, 2}}}}}, [](const Point& x) { return x[0]; }));
  EXPECT_EQ(list.status, FormStatus::refused);
  EXPECT_NE(list.reason.find("input 2 is a list"), std::string::npos);
}

// The model sees the same points in any batch: a model of one point at a time gives the same bits.
TEST(Form, batches_do_not_matter) {
  const auto one_by_one = [](std::span<const Point> points) {
    std::vector<std::vector<double>> rows;
    for (std::size_t k = 0; k < points.size(); ++k)
      rows.insert(rows.begin(), {0, factor(points[points.size() - 1 - k])});
    return rows;
  };
  const LimitState a = state_of(rope, factor, {.bound = Bound::at_least, .value = 3});
  const LimitState b(rope, one_by_one, 1, {.bound = Bound::at_least, .value = 3});
  EXPECT_EQ(form(a).points[0].scores, form(b).points[0].scores);
  EXPECT_EQ(importance_sampling(a, form(a)).counted.value, importance_sampling(b, form(b)).counted.value);
}

}  // namespace taut::chance::form_test
