#include "taut/report/tables/thinning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace taut::report::thinning_test {

using testing::Contains;
using testing::ElementsAre;

Table series(std::size_t rows) {
  Table t{.name = "path", .title = "", .columns = {{"x", si::m}, {"T", si::N}, {"governing", si::one}}, .rows = {}};
  for (std::size_t i = 0; i < rows; ++i) {
    const auto x = static_cast<double>(i);
    t.rows.push_back({x, std::sin(x / 20), std::string(i < 37 ? "skyline" : "mainline")});
  }
  return t;
}

TEST(Thinning, KeepsAllRowsOfAShortTable) { EXPECT_EQ(rows_that_matter(series(12), 12).size(), 12U); }

TEST(Thinning, KeepsEndsExtremesAndChangesOfTheGoverningLimit) {
  const auto rows = rows_that_matter(series(100), 12);
  EXPECT_EQ(rows.size(), 12U);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  for (const std::size_t row : {0U, 99U, 31U, 94U, 36U, 37U}) EXPECT_THAT(rows, Contains(row));
}

TEST(Thinning, SpreadsTheOtherRows) {
  Table t{.name = "t", .title = "", .columns = {{"x", si::m}}, .rows = {}};
  for (int i = 0; i < 101; ++i) t.rows.push_back({static_cast<double>(i)});
  EXPECT_THAT(rows_that_matter(t, 5), ElementsAre(0, 25, 50, 75, 100));
}

// A text that changes from row to row fills the table: the extremes stay all the same.
TEST(Thinning, ExtremesStayWhereTextsChangeOften) {
  Table t = series(200);
  for (std::size_t i = 0; i < t.rows.size(); ++i) t.rows[i][2] = std::string(i / 3 % 2 == 0 ? "a" : "b");
  for (const std::size_t most : {2U, 4U, 12U}) {
    const auto rows = rows_that_matter(t, most);
    for (const std::size_t row : {0U, 199U, 157U, 94U}) EXPECT_THAT(rows, Contains(row)) << most;
  }
}

TEST(Thinning, GapsAndRaggedRowsAreNoExtremes) {
  Table t = series(50);
  t.rows[10][1] = std::nan("");
  t.rows[11].resize(1);
  EXPECT_EQ(rows_that_matter(t, 6).size(), 6U);
}

TEST(Thinning, AListHasNamesOfItsOwn) {
  Table t{.name = "t", .title = "", .columns = {{"name", si::one}}, .rows = {{std::string("a")}, {std::string("b")}}};
  EXPECT_TRUE(is_list(t));
  t.rows.push_back({std::string("a")});
  EXPECT_FALSE(is_list(t));
  EXPECT_FALSE(is_list(series(3)));
}

}  // namespace taut::report::thinning_test
