#include "taut/app/explain/report_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "taut/app/explain/explain_name.hpp"
#include "taut/app/job.hpp"
#include "test/paths.hpp"

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

TEST(ReportNames, AreTablesOfNamedAnalyses) {
  EXPECT_THAT(explain_name("beam_ends_inhaul").value_or(""), HasSubstr("tables of results: beam_ends\n"));
  EXPECT_THAT(explain_name("spans_in_haul").value_or(""), HasSubstr("tables of results: spans\n"));
}

TEST(ReportNames, AreChecksOfLoadCases) {
  EXPECT_THAT(explain_name("mast.buckling [loaded]").value_or(""), HasSubstr("checks of a mast: NAME.buckling"));
  EXPECT_THAT(explain_name("skyline.T_max [loaded]").value_or(""), HasSubstr("largest tension"));
  EXPECT_EQ(plain_name("a.b [c] [loaded]"), "a.b [c]");
  EXPECT_EQ(plain_name("reevings[]"), "reevings[]");
}

TEST(ReportNames, RollersAreOfTheirCarriage) {
  EXPECT_EQ(plain_name("track.car.roller12.T_in"), "track.car.T_in");
  for (const char* name : {"roller2", "car.roller.T_in", "car.roller2", "car.rollers"})
    EXPECT_EQ(plain_name(name), name);
  EXPECT_TRUE(explain_name("track.car.roller2.wrap"));
}

/// Whatever a report of a machine with masts, guys, lines, anchors, supports and yarders shows by a name.
TEST(ReportNames, EachOneOfTheExamplesIsExplained) {
  std::set<std::string> names;
  for (const char* deck : {"tower_yarder", "guyed_tower", "yarder_and_carriage", "dragged_bunch", "endless_haul",
                           "counterweighted_ropeway", "skyline_over_terrain"}) {
    const std::filesystem::path file = taut_test::source_dir() / "examples/machines" / (std::string(deck) + ".yaml");
    const auto job = read_job(file.string());
    ASSERT_TRUE(job.has_value()) << file;
    const Result r = run(*job);
    EXPECT_FALSE(r.checks.empty()) << deck << ": " << r.message << to_text(r.errors);
    for (const Check& one : r.checks) names.insert(one.name);
    for (const Value& one : r.values) names.insert(one.name);
    for (const Table& one : r.tables) {
      names.insert(one.name);
      for (const Column& column : one.columns) names.insert(column.name);
    }
  }
  EXPECT_GT(names.size(), 100U);
  for (const std::string& name : names) EXPECT_TRUE(explain_name(name)) << name << ": " << explain_name(name).error();
}

/// Checks that no example has.
TEST(ReportNames, OtherChecksOfMachinesAreExplained) {
  for (const char* name : {"s.anchor_clips", "s.anchor_spikes", "s.anchor_staples", "s.anchor_wraps",
                           "sky.anchor_off_line", "w.capacity", "car.least_rope", "car.most_rope", "mast.member",
                           "mast.shear", "sky.payload_T_max", "r.phi2", "s.slipped", "tower.haulback_base_tension"}) {
    EXPECT_TRUE(explain_name(name)) << name;
  }
}

TEST(ReportNames, OthersAreNone) {
  for (const char* name : {"discard_", "hoist.drum_ration", "", ".", "7"})
    EXPECT_FALSE(explain_report_name(name)) << name;
}

}  // namespace taut::app::report_names_test
