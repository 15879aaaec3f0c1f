#include "taut/app/job.hpp"

#include <gtest/gtest.h>

namespace taut::app::job_test {

const std::string mast =
    "taut: 1\ntitle: case A\nmethod: mast_section\ndisplay: {force: N}\ninput:\n  skyline_force: 100 kN\n  "
    "mainline_force: 40 kN\n"
    "  skyline_block_height: 8 m\n  branch_angle: 12 deg\n  wrap: paper\n  allowable_stress: 160 MPa\n";

TEST(Job, RunsADeck) {
  const Result r = run(Job{.text = mast, .name = "mast.yaml", .set = {}});
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_EQ(r.title, "case A");
  EXPECT_EQ(r.deck_name, "mast.yaml");
  EXPECT_EQ(r.display.at("force"), "N");
  EXPECT_NEAR(r.find_value("N")->value, 162638.979, 1e-3);
}

TEST(Job, HashFollowsTextAndOverrides) {
  const std::string plain = run(Job{.text = mast, .name = "a", .set = {}}).deck_hash;
  EXPECT_EQ(plain, run(Job{mast, "b", {}}).deck_hash);
  EXPECT_NE(plain, run(Job{mast + "# x\n", "a", {}}).deck_hash);
  EXPECT_NE(plain, run(Job{mast, "a", {"input.branch_angle=13 deg"}}).deck_hash);
}

TEST(Job, FindsMistakesOfHeadFieldsAndRulesInOneGo) {
  const Diagnostics mistakes =
      check(Job{.text = mast + "  span: {length: 200 m}\ncolour: red\n", .name = "m", .set = {}});
  EXPECT_GE(mistakes.size(), 2U);
  EXPECT_TRUE(check(Job{mast, "m", {}}).empty());
}

TEST(Job, AMissingIncludeIsAMistake) {
  // a deck that includes nothing readable is a mistake, not an exception
  const Result r = run(
      Job{.text = "taut: 1\ninclude: nowhere.part.yaml\nmethod: mast_section\ninput: {}\n", .name = "m", .set = {}});
  EXPECT_EQ(r.status, Status::bad_deck);
  EXPECT_GE(r.errors.size(), 1U);
}

TEST(Job, MissingFileIsAFileError) { EXPECT_FALSE(read_job("/nowhere/at/all.yaml").has_value()); }

}  // namespace taut::app::job_test
