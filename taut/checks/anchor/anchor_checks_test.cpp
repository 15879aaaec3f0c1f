#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "test/support/guyed_decks.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::anchor_checks_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::guyed;
using taut_test::has_check;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::value_of;

TEST(AnchorChecks, PullOfAllRopesThere) {
  const Result r =
      run_text(guyed("  anchors:\n    a1: {strength: 100 kN, safety_factor: 2, angle: 50 deg, uplift: 10 kN, "
                     "as_strong_as_rope: true}\n"
                     "    a3: {strength: 100 kN}\n"));
  const auto& t = table_of(r, "anchor_forces");
  ASSERT_EQ(t.rows.size(), 2U);
  const double T = value_of(r, "g1.T_end");
  EXPECT_NEAR(cell(t, 0, "force"), T, 1e-6 * T);
  EXPECT_NEAR(check_of(r, "a1.anchor_strength").value, 100e3 / T, 1e-6);
  EXPECT_NEAR(check_of(r, "a1.anchor_angle").value, std::atan2(12, std::hypot(12, 6)), 0.02);
  EXPECT_TRUE(check_of(r, "a1.anchor_angle").passes);
  EXPECT_FALSE(check_of(r, "a1.anchor_uplift").passes);
  EXPECT_FALSE(check_of(r, "a1.anchor_as_rope").passes);
  // the one that begins at its anchor pulls upwards too
  EXPECT_GT(cell(t, 1, "upwards"), 0);
  EXPECT_NEAR(cell(t, 1, "force"), value_of(r, "g3.T_start"), 1e-6 * T);
}

// Wraps, spikes, staples and clips of WAC 296-54-569: 2 clips up to 1 in., 3 above; a tree of 40 cm by the rule of
// thumb 80 kN at 50 cm and the square of the diameter: 51.2 kN.
TEST(AnchorChecks, FasteningAndTree) {
  const std::string anchors =
      "  anchors:\n    a1: {tree_diameter: 40 cm, dynamic_factor: 1.5, fastening: {wraps: 2, spikes: 8, clips: 2}}\n"
      "    a2: {fastening: {wraps: 2.5, staples: 5, clips: 3}}\n";
  const Result r = run_text(guyed(anchors), {"machine.ropes.guy.diameter=25.4 mm"});
  EXPECT_FALSE(check_of(r, "a1.anchor_wraps").passes);
  EXPECT_EQ(check_of(r, "a1.anchor_wraps").limit, 2.5);
  EXPECT_TRUE(check_of(r, "a1.anchor_spikes").passes);
  EXPECT_FALSE(has_check(r, "a1.anchor_staples"));
  EXPECT_TRUE(check_of(r, "a1.anchor_clips").passes);
  EXPECT_EQ(check_of(r, "a1.anchor_clips").trust, "verified");
  EXPECT_FALSE(check_of(r, "a2.anchor_staples").passes);
  EXPECT_NEAR(check_of(r, "a1.anchor_tree").limit, 51.2e3, 1e-6);
  EXPECT_NEAR(check_of(r, "a1.anchor_tree").value, 1.5 * value_of(r, "g1.T_end"), 0.1);
  EXPECT_NE(check_of(r, "a1.anchor_tree").trust.find("UNVERIFIED"), std::string::npos);
  const Result thick = run_text(guyed(anchors), {"machine.ropes.guy.diameter=26 mm"});
  EXPECT_FALSE(check_of(thick, "a1.anchor_clips").passes);
  const Result unknown = run_text(guyed(anchors));  // a line of unknown diameter counts as thick
  EXPECT_FALSE(check_of(unknown, "a1.anchor_clips").passes);
}

TEST(AnchorChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(guyed("  anchors: {a9: {}}\n")), "no rope ends at 'a9'");
  expect_mistake(run_text(guyed("  anchors: {a1: {safety_factor: 2}}\n")), "needs 'strength'");
  expect_mistake(run_text(guyed("  anchors: {a1: {as_strong_as_rope: true}}\n")), "needs 'strength'");
  expect_mistake(run_text(guyed("  anchors: {a1: {fastening: {spikes: 8, staples: 6}}}\n")), "either");
}

}  // namespace taut::checks::anchor_checks_test
