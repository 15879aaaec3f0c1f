#include "taut/report/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut::report::summary_test {

using testing::ElementsAre;

Check check(const std::string& name, double utilisation, const std::string& part) {
  Check c;
  c.name = name;
  c.utilisation = utilisation;
  c.passes = utilisation <= 1;
  c.part = part;
  return c;
}

TEST(Summary, HasTheWorstCheckOfEachPart) {
  Result r;
  r.checks = {check("drop.T_max", 0.2, "drop"), check("hoist.T_max", 0.3, "hoist"),
              check("hoist.bending", 0.9, "hoist"), check("grip", 0.5, ""), check("slip", 1.1, "")};
  std::vector<std::string> names;
  for (const Check* c : worst_by_part(r)) names.push_back(c->name);
  EXPECT_THAT(names, ElementsAre("slip", "hoist.bending", "grip", "drop.T_max"));
}

TEST(Summary, ARefusedCheckIsNotHiddenByOneThatPasses) {
  Result r;
  r.checks = {check("hoist.T_max", 0.9, "hoist"), check("hoist.groove", 0.3, "hoist"),
              check("drop.T_max", 1.2, "drop")};
  r.checks[1].refused = true;
  r.checks[1].passes = false;
  std::vector<std::string> names;
  for (const Check* c : worst_by_part(r)) names.push_back(c->name);
  EXPECT_THAT(names, ElementsAre("drop.T_max", "hoist.groove"));
}

TEST(Summary, HasTheWorstLimitBesideAWorseFact) {
  Result r;
  r.checks = {check("hoist.safety_factor", 0.7, "hoist"), check("hoist.sheave_ratio", 0.9, "hoist"),
              check("drop.T_max", 0.8, "drop")};
  r.checks[1].limits = false;
  std::vector<std::string> names;
  for (const Check* c : worst_by_part(r)) names.push_back(c->name);
  EXPECT_THAT(names, ElementsAre("hoist.sheave_ratio", "drop.T_max", "hoist.safety_factor"));
}

TEST(Summary, SaysTheNameOfACheckInWords) {
  EXPECT_EQ(words_below_part(check("skyline.safety_factor", 1, "skyline")), "safety factor");
  EXPECT_EQ(words_below_part(check("skyline.payload_T_max", 1, "skyline")), "payload T_max");
  EXPECT_EQ(words_below_part(check("skyline.T_max", 1, "skyline")), "T_max");
  EXPECT_EQ(words_below_part(check("guy1.guy_safety [loaded]", 1, "guy1")), "guy safety [loaded]");
}

TEST(Summary, LeavesUsesToTheTable) {
  Result r;
  r.answers = {{.label = "Build", .text = "a rope"}, {.label = "Uses", .text = "rope.T_max 0.5"}};
  EXPECT_EQ(answers_beside_checks(r).size(), 2U);
  r.checks = {check("rope.T_max", 0.5, "rope")};
  EXPECT_EQ(answers_beside_checks(r).size(), 1U);
}

TEST(Summary, NamesACheckWithoutItsPart) {
  EXPECT_EQ(name_below_part(check("skyline.T_max", 1, "skyline")), "T_max");
  EXPECT_EQ(name_below_part(check("skyline: D/d", 1, "skyline")), "D/d");
  EXPECT_EQ(name_below_part(check("skyline.T_max", 1, "mast")), "skyline.T_max");
  EXPECT_EQ(name_below_part(check("grip", 1, "")), "grip");
}

TEST(Summary, ShowsUnsafeWarningsFirst) {
  Result r;
  r.warnings = {"a rope is not used", "the mainline goes slack"};
  r.unsafe = {"the mainline goes slack"};
  EXPECT_THAT(warnings_by_weight(r), ElementsAre("the mainline goes slack", "a rope is not used"));
}

TEST(Summary, SaysWhatTheDeckGivesOfItsProject) {
  EXPECT_EQ(project_line({}), "");
  Project p;
  p.project = "Hinterwald";
  p.number = "12";
  p.revision = "B";
  EXPECT_EQ(project_line(p), "Hinterwald \u00B7 no. 12 \u00B7 revision B");
}

}  // namespace taut::report::summary_test
