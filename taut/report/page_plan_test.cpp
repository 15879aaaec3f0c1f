#include "taut/report/page_plan.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/golden/made_result.hpp"

namespace taut::report::page_plan_test {

using testing::Contains;
using testing::Not;

Table long_table(const std::string& name, std::size_t rows) {
  Table t{.name = name, .title = "", .columns = {{"x", si::m}, {"T", si::N}}, .rows = {}};
  for (std::size_t i = 0; i < rows; ++i) t.rows.push_back({static_cast<double>(i), 1.0});
  return t;
}

TEST(PagePlan, DetailsStandInTheAppendixOnly) {
  Result r;
  r.method = "machine";
  r.values = {{"a", 1, si::N, "", "", ""}, {"b", 1, si::N, "", "", "", true}};
  r.tables = {long_table("a", 3), long_table("b", 3)};
  r.tables[1].detail = true;
  const PagePlan plan = plan_pages(r);
  EXPECT_THAT(plan.values, testing::ElementsAre(&r.values[0]));
  EXPECT_THAT(plan.appendix_values, testing::ElementsAre(&r.values[1]));
  EXPECT_THAT(plan.tables, testing::ElementsAre(&r.tables[0]));
  EXPECT_THAT(plan.appendix_tables, testing::ElementsAre(&r.tables[1]));
}

TEST(PagePlan, ATableWithColumnsOfDetailIsWholeInTheAppendix) {
  Result r;
  r.method = "machine";
  r.tables = {long_table("a", 3), long_table("b", 3)};
  r.tables[0].columns[1].detail = true;
  const PagePlan plan = plan_pages(r);
  EXPECT_THAT(plan.tables, testing::ElementsAre(&r.tables[0], &r.tables[1]));
  EXPECT_THAT(plan.appendix_tables, testing::ElementsAre(&r.tables[0]));
}

TEST(PagePlan, ResultsOfOneAnalysisStandTogether) {
  Result r;
  r.method = "machine";
  r.values = {{"a", 1, si::N, "", "", "", false, "hoist"},
              {"b", 1, si::N, "", "", ""},
              {"c", 1, si::N, "", "", "", false, "lower"}};
  r.tables = {long_table("t", 3), long_table("u", 3)};
  r.tables[0].heading = "lower";
  r.tables[1].heading = "sweep";
  const PagePlan plan = plan_pages(r);
  const std::vector<ResultGroup> groups = groups_of(plan);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].heading, "");
  EXPECT_THAT(groups[0].values, testing::ElementsAre(&r.values[1]));
  EXPECT_EQ(groups[1].heading, "hoist");
  EXPECT_EQ(groups[2].heading, "lower");
  EXPECT_THAT(groups[2].values, testing::ElementsAre(&r.values[2]));
  EXPECT_THAT(groups[2].tables, testing::ElementsAre(&r.tables[0]));
  EXPECT_EQ(groups[3].heading, "sweep");
}

TEST(PagePlan, WhatIsThinnedStandsInTheAppendixToo) {
  Result r;
  r.method = "machine";
  r.tables = {long_table("a", 50)};
  const PagePlan plan = plan_pages(r);
  EXPECT_THAT(plan.tables, Contains(&r.tables[0]));
  EXPECT_THAT(plan.appendix_tables, Contains(&r.tables[0]));
}

TEST(PagePlan, WhatDoesNotFitGoesToTheAppendix) {
  Result r = taut_test::made_result();
  for (int i = 0; i < 60; ++i) {
    r.tables.push_back(long_table(fmt::format("t{}", i), 30));
    r.figures.push_back(r.figures[1]);
    for (int k = 0; k < 5; ++k) r.values.push_back(r.values[0]);
  }
  const PagePlan plan = plan_pages(r);
  EXPECT_LT(plan.tables.size() * 14, 400U);
  EXPECT_LT(plan.pictures.size(), 12U);
  EXPECT_LT(plan.values.size(), 150U);
  EXPECT_EQ(plan.pictures.size() + plan.appendix_pictures.size(), r.figures.size());
  EXPECT_EQ(plan.values.size() + plan.appendix_values.size(), r.values.size());
}

TEST(PagePlan, AComparisonShowsAllItsRows) {
  Result r;
  r.method = "compare";
  r.tables = {long_table("compared", 300)};
  const PagePlan plan = plan_pages(r);
  EXPECT_THAT(plan.tables, Contains(&r.tables[0]));
  EXPECT_GE(plan.limits.rows, 300U);
}

TEST(PagePlan, AFigureOfPageOneIsNotShownAgain) {
  const Result r = taut_test::made_result();
  const PagePlan plan = plan_pages(r, {&r.figures[0]});
  EXPECT_THAT(plan.pictures, Not(Contains(&r.figures[0])));
}

}  // namespace taut::report::page_plan_test
