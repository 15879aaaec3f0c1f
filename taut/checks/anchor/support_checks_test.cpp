#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/forestry/tree.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::support_checks_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::value_of;

struct Jack {
  std::string tension = "100 kN";
  std::string checks = "{height: 9 m}";
  std::string machine{};  ///< more keys of the machine
  std::string reeving{};  ///< one more
};

/// A rope of no weight over a jack, bent by the same angle on both sides.
std::string over_jack(const Jack& jack) {
  return "taut: 1\nmachine:\n  ropes: {line: {mass: 0.001 kg/m, stiffness: 20 MN, breaking_force: 900 kN}}\n"
         "  points: {a: [-100 m, 0 m, 0 m], b: [100 m, 0 m, 0 m], top: [0 m, 0 m, 20 m], stump: [0 m, 20 m, 0 m]}\n"
         "  supports: {jack: {at: [0 m, 0 m, 20 m], friction: 0}}\n" +
         jack.machine +
         "  reevings:\n    - {rope: line, path: [{anchor: a}, {over: jack}, {anchor: b}], tension_at_start: " +
         jack.tension + "}\n" + jack.reeving +
         "checks:\n  ropes: {line: {safety_factor: 2}}\n  supports: {jack: " + jack.checks + "}\n";
}

// By hand: the rope bends by 2 atan(0.2) = 22.62 deg; 100 kN give 2 x 100 sin(11.31 deg) = 39.22 kN. The next force of
// the table is 40 kN, the lashing at 9 + 3 = 12 m: 24 cm there, and 24 + (12 - 1.5) = 34.5 cm at breast height.
TEST(SupportChecks, TreeByForceAndHeight) {
  const Result r = run_text(over_jack({.checks = "{tree_diameter: 36 cm, height: 9 m}"}));
  const auto& t = table_of(r, "support_forces");
  EXPECT_NEAR(cell(t, 0, "force"), 2e5 * std::sin(std::atan(0.2)), 10);
  EXPECT_NEAR(cell(t, 0, "lean"), 0, 1e-3);
  EXPECT_NEAR(cell(t, 0, "lashing_diameter"), 0.24, 1e-12);
  EXPECT_NEAR(value_of(r, "jack.tree_diameter"), 0.345, 1e-12);
  const Check& c = check_of(r, "jack.support_tree");
  EXPECT_TRUE(c.passes);
  EXPECT_NEAR(c.limit, 0.345, 1e-12);
  EXPECT_EQ(c.trust, "derived");
  EXPECT_FALSE(
      check_of(run_text(over_jack({.checks = "{tree_diameter: 34 cm, height: 9 m}"})), "jack.support_tree").passes);
  // times 1.1: 43.1 kN, the row of 50 kN
  const Result moved = run_text(over_jack({.checks = "{tree_diameter: 36 cm, height: 9 m, dynamic_factor: 1.1}"}));
  EXPECT_NEAR(value_of(moved, "jack.tree_diameter"), 0.355, 1e-12);
}

TEST(SupportChecks, HeightFromTheTerrain) {
  const std::string ground = "  terrain: {x: [-100 m, 100 m], z: [11 m, 11 m]}\n";
  EXPECT_NEAR(value_of(run_text(over_jack({.checks = "{}", .machine = ground})), "jack.tree_diameter"), 0.345, 1e-12);
  const std::string beside = "  terrain: {x: [50 m, 100 m], z: [-50 m, -50 m]}\n";
  const Result unknown = run_text(over_jack({.checks = "{tree_diameter: 80 cm}", .machine = beside}));
  EXPECT_EQ(verdict_of(unknown)->kind, VerdictKind::not_judged);
  EXPECT_NE(verdict_of(unknown)->reason.find("height"), std::string::npos) << verdict_of(unknown)->reason;
}

TEST(SupportChecks, BeyondTheTableATreeNeverPasses) {
  // 400 kN give 157 kN; the table ends at 150 kN
  const Result r = run_text(over_jack({.tension = "400 kN", .checks = "{tree_diameter: 90 cm, height: 9 m}"}));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade");
  EXPECT_EQ(r.find_value("jack.tree_diameter"), nullptr);
}

// The table is one of trees that are pressed: a jack under the chord of its rope pulls its tree out of the ground.
TEST(SupportChecks, ATreeThatIsPulledUpwardsIsNotJudged) {
  for (const char* uplift : {"hold", "report"}) {
    std::string deck = over_jack({.checks = "{tree_diameter: 90 cm, height: 9 m}"});
    const std::string at = "at: [0 m, 0 m, 20 m], friction: 0";
    deck.replace(deck.find(at), at.size(), std::string("at: [0 m, 0 m, -20 m], friction: 0, uplift: ") + uplift);
    const Result r = run_text(deck);
    EXPECT_NEAR(cell(table_of(r, "support_forces"), 0, "lean"), std::numbers::pi, 1e-3);
    EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << verdict_of(r)->reason;
    EXPECT_NE(verdict_of(r)->reason.find("pull it upwards"), std::string::npos) << verdict_of(r)->reason;
    EXPECT_EQ(r.find_value("jack.tree_diameter"), nullptr);
  }
}

// A guy that ends on the tree adds its pull.
TEST(SupportChecks, WhatElsePullsAtTheTree) {
  const Result r = run_text(over_jack(
      {.checks = "{height: 9 m, with: [top]}",
       .reeving = "    - {name: guy, rope: line, path: [{anchor: stump}, {anchor: top}], tension_at_start: 20 kN}\n"}));
  // jack 39.22 kN down, guy 20 kN at 45 deg: 14.14 kN down, 14.14 kN aside
  const double down = 2e5 * std::sin(std::atan(0.2)) + 20e3 / std::numbers::sqrt2, aside = 20e3 / std::numbers::sqrt2;
  EXPECT_NEAR(cell(table_of(r, "support_forces"), 0, "force"), std::hypot(down, aside), 20);
  EXPECT_NEAR(cell(table_of(r, "support_forces"), 0, "lean"), std::atan2(aside, down), 1e-3);
}

TEST(SupportChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(over_jack({.checks = "{tree_diameter: 40 cm}"})), "give the 'height'");
  expect_mistake(run_text(over_jack({.checks = "{height: 9 m, with: [b1]}"})), "no rope runs over 'b1' or ends there");
  std::string other = over_jack({});
  other.replace(other.find("supports: {jack: {height"), 24, "supports: {jakc: {height");
  expect_mistake(run_text(other), "did you mean 'jack'?");
}

/// A sheave that turns a rope by 90 deg in plan bends its tree; the table is one of forces along the trunk.
TEST(SupportChecks, ATreeThatIsPulledAsideIsNotJudged) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 1.0 kg/m, stiffness: 12 MN, breaking_force: 250 kN, diameter: 16 mm}}
  points: {a: [-60 m, 0 m, 5 m]}
  bodies: {sledge: {mass: 5 t, at: [0 m, 60 m, 5 m], guide: [0, 1, 0]}}
  sheaves: {corner: {at: [0 m, 0 m, 6 m], diameter: 600 mm, axis: [0, 0, 1]}}
  reevings: [{rope: line, path: [{anchor: a}, {over: corner}, {anchor: sledge}], length: 119.9 m}]
  loads: [{at: sledge, force: [0 kN, 30 kN, 0 kN]}]
checks:
  ropes: {line: {safety_factor: 3}}
  supports: {corner: {tree_diameter: 31 cm, height: 6 m}}
)");
  EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
  EXPECT_NE(verdict_of(r)->reason.find("more sideways than downwards"), std::string::npos) << verdict_of(r)->reason;
}

/// A slope of 60 % with a jack on it, its foot at chainage 0, and a weightless rope whose ends lie level, 100 m to both
/// sides of the saddle and 20 m below it, b `z_end` higher: with 0 the saddle is pressed straight down as in over_jack.
/// `along`: -1 where the chainage grows against x.
std::string on_slope(double lean_deg, const std::string& checks, double z_end, int along = 1) {
  const double lean = lean_deg * std::numbers::pi / 180, x = 14 * std::sin(lean), z = 14 * std::cos(lean);
  return fmt::format(R"(taut: 1
machine:
  terrain: {{x: [-200 m, 200 m], z: [-120 m, 120 m], from: [0 m, 0 m], along: [{}, 0]}}
  ropes: {{line: {{mass: 0.001 kg/m, stiffness: 20 MN, breaking_force: 900 kN}}}}
  points: {{a: [{:.12f} m, 0 m, {:.12f} m], b: [{:.12f} m, 0 m, {:.12f} m]}}
  supports: {{jack: {{at: {{chainage: 0 m, over_ground: 14 m, lean: {} deg}}, friction: 0}}}}
  reevings: [{{rope: line, path: [{{anchor: a}}, {{over: jack}}, {{anchor: b}}], tension_at_start: 45 kN}}]
checks:
  ropes: {{line: {{safety_factor: 2}}}}
  supports: {{jack: {}}}
)",
                     along, along * (x - 100), z - 20, along * (x + 100), z - 20 + z_end, lean_deg, checks);
}

// By hand: 45 kN give 2 x 45 sin(atan 0.2) = 17.65 kN, the row of 20 kN. The trunk is 14 m long from its foot to the
// saddle, the lashing at 17 m. Vertically below the saddle, 1.948 m up the slope of 60 %, the ground is only
// 13.864 - 1.169 = 12.695 m down, which would be a lashing at 15.695 m and a tree that is too thin.
TEST(SupportChecks, ALeaningTrunkIsAsLongAsTheDeckSays) {
  const Result r = run_text(on_slope(8, "{tree_diameter: 60 cm}", 0));
  const auto& t = table_of(r, "support_forces");
  EXPECT_NEAR(cell(t, 0, "force"), 2 * 45e3 * std::sin(std::atan(0.2)), 10);
  EXPECT_NEAR(cell(t, 0, "height"), 14, 1e-12);
  const auto at_lashing = catalogue::support_tree_diameter(cell(t, 0, "force"), 17);
  ASSERT_TRUE(at_lashing);
  EXPECT_NEAR(value_of(r, "jack.tree_diameter"), *at_lashing + 0.155, 1e-12);
  // where the deck gives the place alone, the height is the vertical one
  std::string placed = on_slope(8, "{tree_diameter: 60 cm}", 0);
  const std::string at = "{chainage: 0 m, over_ground: 14 m, lean: 8 deg}";
  const double lean = 8 * std::numbers::pi / 180;
  placed.replace(placed.find(at), at.size(),
                 fmt::format("[{:.12f} m, 0 m, {:.12f} m]", 14 * std::sin(lean), 14 * std::cos(lean)));
  EXPECT_NEAR(cell(table_of(run_text(placed), "support_forces"), 0, "height"),
              14 * std::cos(lean) - 0.6 * 14 * std::sin(lean), 1e-9);
}

// The force leans by 8.5 deg towards growing chainage: with b 10 m above the saddle and a 20 m below it the two pulls
// add up to (100/h - 100/l, 10/h - 20/l), l = hypot(100, 20), h = hypot(100, 10). The foot of a trunk that leans by 38
// deg lies the other way, so the force stands 46.5 deg off the trunk and bends it; off one that leans by -38 deg it
// stands 29.5 deg. From the vertical both would be judged. A line whose chainage grows the other way is the same line.
TEST(SupportChecks, SidewaysCountsFromTheTrunk) {
  const double low = std::hypot(100, 20), high = std::hypot(100, 10);
  const double lean = std::atan2(100 / high - 100 / low, 20 / low - 10 / high);
  ASSERT_NEAR(lean * 180 / std::numbers::pi, 8.51, 0.01);
  for (const int along : {1, -1}) {
    const Result away = run_text(on_slope(38, "{tree_diameter: 90 cm}", 30, along)),
                 with = run_text(on_slope(-38, "{tree_diameter: 90 cm}", 30, along));
    for (const Result* r : {&away, &with}) EXPECT_NEAR(cell(table_of(*r, "support_forces"), 0, "lean"), lean, 1e-3);
    // the rope itself lies in the slope, so the verdict is another
    ASSERT_EQ(away.unmade.size(), 1U);
    EXPECT_NE(away.unmade[0].find("more sideways than along its trunk, which leans by 38 deg"), std::string::npos)
        << away.unmade[0];
    EXPECT_TRUE(with.unmade.empty());
    EXPECT_EQ(away.find_value("jack.tree_diameter"), nullptr);
    EXPECT_TRUE(check_of(with, "jack.support_tree").passes);
  }
}

}  // namespace taut::checks::support_checks_test
