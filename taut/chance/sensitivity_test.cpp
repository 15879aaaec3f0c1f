#include "taut/chance/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace taut::chance::sensitivity_test {

std::vector<double> outputs(const SaltelliPlan& plan, const Inputs& inputs, double (*f)(const Point&)) {
  std::vector<double> all;
  all.reserve(plan.size());
  for (std::uint64_t k = 0; k < plan.size(); ++k) all.push_back(f(values_at(inputs, plan.at(k))));
  return all;
}

// The worked case of the specification; its total indices are exact ones.
TEST(Sensitivity, worked_case) {
  const Inputs in{.of = {{.law = Lognormal{.mean = 400, .sd = 16}},
                         {.law = Normal{.mean = 25, .sd = 3}},
                         {.law = Normal{.mean = 0.06, .sd = 0.004}},
                         {.law = Gumbel{.mode = 1.05, .scale = 0.03}}}};
  const SaltelliPlan plan(PointKind::sobol, 4, 100000, 1);
  EXPECT_LT(plan.size(), 107000u);
  const Sensitivity s =
      sensitivity(plan, outputs(plan, in, [](const Point& x) { return x[0] / (x[3] * x[1] / (4 * x[2])); }));
  const double exact[] = {0.0704, 0.6867, 0.1951, 0.0534};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(s.of[i].total.value, exact[i], 3e-3);
    EXPECT_LT(s.of[i].total.interval.low, exact[i] + 1e-3);
    EXPECT_GT(s.of[i].total.interval.high, exact[i] - 1e-3);
    EXPECT_LT(s.of[i].total.interval.high - s.of[i].total.interval.low, 0.03);
    EXPECT_LT(s.of[i].first.value, s.of[i].total.value + 2e-3);
  }
  EXPECT_EQ(s.left_out, 0u);
}

double ishigami(const Point& x) {
  return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

// Ishigami & Homma 1990 with a = 7, b = 0.1: first 0.3139, 0.4424, 0; total 0.5576, 0.4424, 0.2437.
TEST(Sensitivity, ishigami) {
  constexpr double pi = std::numbers::pi;
  const Inputs in{.of = std::vector<Distribution>(3, {Uniform{.low = -pi, .high = pi}})};
  for (const PointKind kind : {PointKind::random, PointKind::latin, PointKind::sobol}) {
    const SaltelliPlan plan(kind, 3, 80000, 1);
    const Sensitivity s = sensitivity(plan, outputs(plan, in, ishigami));
    const double first[] = {0.3139, 0.4424, 0};
    const double total[] = {0.5576, 0.4424, 0.2437};
    for (std::size_t i = 0; i < 3; ++i) {
      const double slack = kind == PointKind::sobol ? 2e-2 : 4e-2;
      EXPECT_NEAR(s.of[i].first.value, first[i], slack);
      EXPECT_NEAR(s.of[i].total.value, total[i], slack);
      EXPECT_LT(s.of[i].total.interval.high - s.of[i].total.interval.low, 4 * slack);
    }
  }
}

TEST(Sensitivity, failed_and_constant_outputs) {
  const Inputs in{.of = std::vector<Distribution>(2, {Normal{}})};
  const SaltelliPlan plan(PointKind::sobol, 2, 16ULL * 64 * 4, 1);
  const auto sum = [](const Point& x) { return x[0] > 2.5 ? std::nan("") : x[0] + 2 * x[1]; };
  const Sensitivity s = sensitivity(plan, outputs(plan, in, sum));
  EXPECT_GT(s.left_out, 0u);
  EXPECT_LT(s.left_out, s.base / 20);
  EXPECT_NEAR(s.of[1].total.value, 0.8, 0.03);
  const Sensitivity constant = sensitivity(plan, outputs(plan, in, [](const Point&) { return 0.1; }));
  EXPECT_TRUE(std::isnan(constant.of[0].first.value));
  EXPECT_FALSE(constant.varies);
  // the last digits that a solver leaves are no variance, and 1e-8 of the value is one
  const auto leftover = [](const Point& x) { return 3 + 1e-12 * x[0]; };
  EXPECT_FALSE(sensitivity(plan, outputs(plan, in, leftover)).varies);
  EXPECT_TRUE(std::isnan(sensitivity(plan, outputs(plan, in, leftover)).of[0].total.value));
  const Sensitivity small = sensitivity(plan, outputs(plan, in, [](const Point& x) { return 3 + 3e-8 * x[0]; }));
  EXPECT_TRUE(small.varies);
  EXPECT_NEAR(small.of[0].total.value, 1, 0.02);
}

TEST(Sensitivity, a_case_is_known_without_the_others) {
  const SaltelliPlan plan(PointKind::sobol, 3, 1000, 1);
  const Point base = plan.base().at(7);
  EXPECT_EQ(plan.at(7ULL * 5), Point(base.begin(), base.begin() + 3));
  EXPECT_EQ(plan.at(7 * 5 + 1), Point(base.begin() + 3, base.end()));
  EXPECT_EQ(plan.at(7 * 5 + 3), (Point{base[0], base[4], base[2]}));
}

TEST(Sensitivity, refused_for_correlated_inputs) {
  Inputs in{.of = std::vector<Distribution>(2, {Normal{}})};
  EXPECT_EQ(indices_refused(in), "");
  in.correlation = *correlation(std::vector<CorrelatedPair>{{.first = 0, .second = 1, .r = 0.5}},
                                std::vector<std::string>{"a", "b"});
  EXPECT_NE(indices_refused(in).find("correlated"), std::string::npos);
}

TEST(Sensitivity, tornado) {
  const Inputs in{.of = {{.law = Uniform{.low = 0, .high = 10}}, {.law = Normal{.mean = 5, .sd = 1}}}};
  const Points p = tornado_points(in, 0.1);
  ASSERT_EQ(p.size(), 5u);
  EXPECT_EQ(p[0], (Point{5, 5}));
  EXPECT_NEAR(p[1][0], 1, 1e-12);
  EXPECT_NEAR(p[2][0], 9, 1e-12);
  EXPECT_EQ(p[1][1], 5);
  EXPECT_NEAR(p[4][1] - 5, 1.2815515655, 1e-9);
}

}  // namespace taut::chance::sensitivity_test
