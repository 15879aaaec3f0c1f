#include "taut/report/given.hpp"

#include <gtest/gtest.h>

namespace given_test {

using namespace taut;
using namespace taut::report;

Given given(const std::string& key, double x) {
  return {.key = key, .symbol = "x", .words = "words", .unit = si::m, .numbers = {x}, .text = "", .is_default = false};
}

TEST(Given, ListsOfRecordsBecomeTables) {
  const std::vector<Given> all{given("span", 1), given("cases[0].falls", 2), given("cases[0].length", 3),
                               given("cases[1].length", 5), given("ropes[0].falls", 2)};
  const auto tables = record_tables(all);
  ASSERT_EQ(tables.size(), 1U);  // a list of one stays among the others
  EXPECT_EQ(tables[0].name, "cases");
  ASSERT_EQ(tables[0].columns.size(), 2U);
  EXPECT_EQ(std::get<double>(tables[0].rows[1][1]), 5);
  EXPECT_TRUE(std::holds_alternative<std::string>(tables[0].rows[1][0]));
  EXPECT_FALSE(is_in_table(all[0], tables));
  EXPECT_TRUE(is_in_table(all[1], tables));
  EXPECT_FALSE(is_in_table(all[4], tables));
}

TEST(Given, OddKeysStayRows) {
  for (const char* key : {"a[", "a[]", "[0].x", "a[x].y", "a[-1].y", "a[0]", "a].[0", ""}) {
    EXPECT_TRUE(record_tables({given(key, 1), given(key, 2)}).empty()) << key;
  }
}

TEST(Given, EveryValueIsOnThePage) {
  Result r;
  r.given = {given("span", 111), given("cases[0].a", 222), given("cases[1].a", 333)};
  const std::string html = given_html(r);
  for (const char* number : {"111", "222", "333"}) EXPECT_NE(html.find(number), std::string::npos) << number;
}

}  // namespace given_test
