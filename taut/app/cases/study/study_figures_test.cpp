#include "taut/app/cases/study/study_figures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "test/support/made_study.hpp"

namespace taut::app::study_figures_test {

using taut_test::data_of;
using taut_test::gridded;
using taut_test::made_study;
using taut_test::sampled;
using testing::ElementsAre;
using testing::HasSubstr;

const chance::Distribution standard{.law = chance::Normal{.mean = 0, .sd = 1}};

/// 100 cases of one input with these outputs.
Study hundred() {
  return sampled(made_study({standard}, 1, [](const chance::Point& p) -> std::vector<double> { return {p[0]}; }),
                 chance::PointKind::random, 100);
}

Result figures_of(const Study& study, const StudyData& data, const ChanceSummary& chance = {}) {
  Result r;
  add_study_figures(study, data, chance, r);
  return r;
}

template <class Kind>
const Kind* figure(const Result& r, const std::string& name) {
  for (const Figure& one : r.figures) {
    const Kind* own = std::get_if<Kind>(&one);
    if (own != nullptr && own->name == name) return own;
  }
  return nullptr;
}

// The numbers 0 to 99: quartiles 50 apart, so that a bin of 2 * 50/100^(1/3) = 21.5 is asked for, and 5 bins of 19.8
// are made, each with 20 numbers.
TEST(StudyFigures, AHistogramShowsTheShareOfTheCasesInEachBin) {
  Study study = hundred();
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 90}, .allowed = {}},
                  {.output = 0, .limit = {.bound = chance::Bound::at_least, .value = -5}, .allowed = {}}};
  StudyData data;
  data.outputs = {{}};
  for (int i = 0; i < 100; ++i) data.outputs[0].push_back(99 - i);
  const Result r = figures_of(study, data);
  const Plot* p = figure<Plot>(r, "histogram");
  ASSERT_NE(p, nullptr);
  const Curve& c = p->curves.at(0);
  ASSERT_EQ(c.x.size(), 12U) << "up, two ends of five bins, down";
  EXPECT_EQ(c.y.front(), 0);
  EXPECT_EQ(c.y.back(), 0);
  for (std::size_t bin = 0; bin < 5; ++bin) {
    EXPECT_NEAR(c.x[1 + 2 * bin], 19.8 * static_cast<double>(bin), 1e-9);
    EXPECT_NEAR(c.y[1 + 2 * bin], 0.2, 1e-12);
    EXPECT_NEAR(c.y[2 + 2 * bin], 0.2, 1e-12);
  }
  ASSERT_EQ(p->marks.size(), 2U);
  EXPECT_EQ(p->marks[0].x, 90);
  EXPECT_THAT(p->caption, HasSubstr("the limit, at least -5, lies outside"));
  EXPECT_THAT(p->caption, testing::Not(HasSubstr("at most 90, lies outside")));
}

TEST(StudyFigures, AProbabilitySettlesAtThatOfAllCases) {
  Study study = hundred();
  study.limits = {{.output = 0, .limit = {.bound = chance::Bound::at_most, .value = 0}, .allowed = 0.3}};
  StudyData data;
  data.outputs = {std::vector<double>(100, -1)};
  for (std::size_t i = 0; i < 25; ++i) data.outputs[0][i] = i % 5 == 0 ? std::nan("") : 1;
  const Result r = figures_of(study, data);
  const Plot* p = figure<Plot>(r, "convergence");
  ASSERT_NE(p, nullptr);
  ASSERT_EQ(p->curves.size(), 3U);
  EXPECT_EQ(p->curves[0].x.back(), 100);
  EXPECT_DOUBLE_EQ(p->curves[0].y.back(), 0.25) << "failed cases count as beyond";
  EXPECT_DOUBLE_EQ(p->curves[0].y.front(), 1) << "those that are beyond came first";
  for (std::size_t i = 0; i < p->curves[0].x.size(); ++i) {
    EXPECT_LE(p->curves[1].y[i], p->curves[0].y[i]);
    EXPECT_GE(p->curves[2].y[i], p->curves[0].y[i]);
  }
  ASSERT_EQ(p->marks.size(), 1U);
  EXPECT_EQ(p->marks[0].y, 0.3);
}

// Ranks do not change under a function that only rises, or only falls.
TEST(StudyFigures, AnOutputIsShownOverTheInputThatItFollowsMost) {
  const Study study = sampled(made_study({standard, standard}, 2,
                                         [](const chance::Point& p) -> std::vector<double> {
                                           return {p[0] < -2 ? std::nan("") : std::exp(p[1]), -std::pow(p[0], 3)};
                                         }),
                              chance::PointKind::random, 400);
  const StudyData data = data_of(study);
  ASSERT_FALSE(data.failed.empty());
  const Result r = figures_of(study, data);
  const Plot* first = figure<Plot>(r, "scatter_1");
  const Plot* second = figure<Plot>(r, "scatter_2");
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_EQ(first->title, "y1 over x2.value");
  EXPECT_THAT(first->caption, HasSubstr("rank correlation 1.00"));
  EXPECT_EQ(first->curves.at(0).x.size(), 400 - data.failed.size());
  for (std::size_t i = 0; i < first->curves[0].x.size(); ++i) {
    EXPECT_EQ(first->curves[0].y[i], std::exp(first->curves[0].x[i])) << i;
  }
  EXPECT_EQ(second->title, "y2 over x1.value");
  EXPECT_THAT(second->caption, HasSubstr("rank correlation -1.00"));
}

// Equal values have no order: that of the cases would say something of the inputs.
TEST(StudyFigures, EqualValuesHaveOneRank) {
  const Study study = sampled(made_study({standard, standard}, 2,
                                         [](const chance::Point& p) -> std::vector<double> {
                                           return {5, p[1] > 2 ? 1.0 : 0.0};
                                         }),
                              chance::PointKind::random, 400);
  const Result r = figures_of(study, data_of(study));
  EXPECT_THAT(figure<Plot>(r, "scatter_1")->caption, HasSubstr("rank correlation 0.00"));
  const Plot* rare = figure<Plot>(r, "scatter_2");
  EXPECT_EQ(rare->title, "y2 over x2.value");
  // k ones among n: both ranks in closed form give r = sqrt(3 k (n - k)/(n^2 - 1)), as the ones have the last ranks
  const std::vector<double>& y = rare->curves.at(0).y;
  const double n = 400, k = static_cast<double>(std::count(y.begin(), y.end(), 1.0));
  ASSERT_GT(k, 0);
  EXPECT_THAT(rare->caption, HasSubstr(fmt::format("correlation {:.2f}", std::sqrt(3 * k * (n - k) / (n * n - 1)))));
}

TEST(StudyFigures, AScatterHasNoMoreDotsThanCanBeTold) {
  for (const std::uint64_t cases : {1500U, 1501U, 2999U, 3000U, 4000U}) {
    const Study study =
        sampled(made_study({standard}, 1, [](const chance::Point& p) -> std::vector<double> { return {p[0]}; }),
                chance::PointKind::random, cases);
    const Result r = figures_of(study, data_of(study));
    const std::size_t dots = figure<Plot>(r, "scatter")->curves.at(0).x.size();
    EXPECT_LE(dots, 1500U) << cases;
    EXPECT_GT(dots, 750U) << cases;
  }
}

TEST(StudyFigures, BarsAreSortedAndWithoutWhatHasNoNumber) {
  Study study = made_study({standard, standard, standard}, 1,
                           [](const chance::Point& p) -> std::vector<double> { return {7 + 2 * p[0] + 5 * p[1]}; });
  study.request.answer = {"tornado"};
  study = sampled(study, chance::PointKind::random, 64);
  const auto share = [](double x) {
    return chance::Indices{.first = {.value = x / 2, .interval = {}}, .total = {.value = x, .interval = {}}};
  };
  ChanceSummary chance;
  chance.indices = {{.of = {share(0.2), share(0.9), share(std::nan(""))}}};
  const Result r = figures_of(study, data_of(study), chance);
  const Bars* sobol = figure<Bars>(r, "sobol");
  ASSERT_NE(sobol, nullptr);
  ASSERT_EQ(sobol->rows.size(), 2U);
  EXPECT_EQ(sobol->rows[0].label, "x2.value");
  EXPECT_EQ(sobol->rows[0].bars.at(0).to, 0.9);
  EXPECT_EQ(sobol->rows[0].bars.at(1).to, 0.45);
  const Bars* tornado = figure<Bars>(r, "tornado_bars");
  ASSERT_NE(tornado, nullptr);
  EXPECT_EQ(tornado->base, 7) << "all inputs at their medians";
  EXPECT_THAT(std::vector({tornado->rows.at(0).label, tornado->rows.at(1).label, tornado->rows.at(2).label}),
              ElementsAre("x2.value", "x1.value", "x3.value"));
  constexpr double q = 1.6448536269514722;  // the 95 % quantile of the standard normal law
  EXPECT_NEAR(tornado->rows[0].bars.at(0).to, 7 - 5 * q, 1e-9);
  EXPECT_NEAR(tornado->rows[0].bars.at(1).to, 7 + 5 * q, 1e-9);
  EXPECT_EQ(tornado->rows[0].bars.at(1).from, 7);
}

TEST(StudyFigures, OfAGridOnlyThatOfOneInputIsACurve) {
  const chance::Distribution list{.law = chance::Listed{.values = {1, 2, 4}}};
  const auto square = [](const chance::Point& p) -> std::vector<double> { return {p[0] * p[0]}; };
  const Study one = gridded(made_study({list}, 1, square)), two = gridded(made_study({list, list}, 1, square));
  const Result r = figures_of(one, data_of(one));
  const Plot* p = figure<Plot>(r, "grid");
  ASSERT_NE(p, nullptr);
  EXPECT_THAT(p->curves.at(0).x, ElementsAre(1, 2, 4));
  EXPECT_THAT(p->curves.at(0).y, ElementsAre(1, 4, 16));
  EXPECT_TRUE(figures_of(two, data_of(two)).figures.empty());
}

}  // namespace taut::app::study_figures_test
