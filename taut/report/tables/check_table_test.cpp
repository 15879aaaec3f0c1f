#include "taut/report/tables/check_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut::report::check_table_test {

using testing::HasSubstr;
using testing::Not;

std::size_t times(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

Check check(const std::string& part, const std::string& name, double value, double limit) {
  Check c =
      make_check(part + "." + name, value, si::one,
                 {.sense = Sense::at_most, .limit = limit, .rule = "rule of " + name, .trust = "UNVERIFIED: recalled"});
  c.part = part;
  return c;
}

TEST(CheckTable, HasALineForEachCheckAndEachRuleOnce) {
  Result r;
  for (int i = 0; i < 5; ++i) r.checks.push_back(check(fmt::format("guy{}", i), "slack", 0.5, 1));
  r.checks.push_back(check("mast", "buckling", 2, 1));
  const std::string html = checks_html(r);
  EXPECT_EQ(times(html, "<tr class=\"good\">"), 5U);
  EXPECT_EQ(times(html, "<tr class=\"bad\">"), 1U);
  EXPECT_EQ(times(html, "rule of slack"), 1U);
  EXPECT_EQ(times(html, "<li>"), 2U);
  EXPECT_EQ(times(html, ": recalled"), 2U);
  EXPECT_EQ(checks_html(Result{}), "");
}

TEST(CheckTable, TheSummaryHasTenPartsWorstFirst) {
  Result r;
  for (int i = 0; i < 60; ++i) r.checks.push_back(check(fmt::format("guy{}", i), "slack", 0.01 * i, 1));
  r.checks.push_back(check("mast", "buckling", 2, 1));
  const std::string html = worst_checks_html(r);
  EXPECT_EQ(times(html, "<tr class="), 10U);
  EXPECT_LT(html.find("mast"), html.find("guy59"));
  EXPECT_THAT(html, HasSubstr("<b>fails</b>"));
  EXPECT_THAT(html, HasSubstr("51 more parts"));
  EXPECT_THAT(html, Not(HasSubstr("guy50<")));
}

TEST(CheckTable, APartWithoutLimitNeverReadsAsPassing) {
  Result r;
  r.checks = {check("drop", "T_max", 0.1, 1)};
  r.unjudged = {"drop"};
  EXPECT_THAT(worst_checks_html(r), HasSubstr(">part has no strength limit<"));
}

}  // namespace taut::report::check_table_test
