#include "taut/app/explain/report_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut::app::report_names_test {

using testing::HasSubstr;

TEST(ReportNames, AreCheckedPartsWithTheirKey) {
  for (const char* name : {"hoist.drum_ratio", "a.b.drum_ratio", "hoist.drum_ratio_2", "drum_ratio"})
    EXPECT_THAT(explain_report_name(name).value_or(""), HasSubstr("D/d of the worst drum")) << name;
  EXPECT_THAT(explain_report_name("g1.guy_safety").value_or(""), HasSubstr("checks of a guy: NAME.guy_safety"));
}

TEST(ReportNames, AreTablesAlsoOfOnePart) {
  EXPECT_THAT(explain_report_name("discard_hoist").value_or(""), HasSubstr("tables of results: discard_ROPE"));
  EXPECT_THAT(explain_report_name("spans").value_or(""), HasSubstr("a table of results"));
}

TEST(ReportNames, OthersAreNone) {
  for (const char* name : {"discard_", "hoist.drum_ration", "", ".", "7"})
    EXPECT_FALSE(explain_report_name(name)) << name;
}

}  // namespace taut::app::report_names_test
