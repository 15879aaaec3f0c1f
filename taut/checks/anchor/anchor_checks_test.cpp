#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "taut/calc/verdict.hpp"
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
  // most where it was put up with 20 kN at its top, 12 m above
  EXPECT_LT(value_of(r, "g3.T_start"), 10e3);
  EXPECT_NEAR(cell(t, 1, "force"), 20e3 - 1.2 * 9.80665 * 12, 1);
}

// Wraps, spikes, staples and clips of WAC 296-54-569: 2 clips up to 1 in., 3 above.
TEST(AnchorChecks, Fastening) {
  const std::string anchors =
      "  anchors:\n    a1: {dynamic_factor: 1.5, fastening: {wraps: 2, spikes: 8, clips: 2}}\n"
      "    a2: {fastening: {wraps: 2.5, staples: 5, clips: 3}}\n";
  const Result r = run_text(guyed(anchors), {"machine.ropes.guy.diameter=25.4 mm"});
  EXPECT_FALSE(check_of(r, "a1.anchor_wraps").passes);
  EXPECT_EQ(check_of(r, "a1.anchor_wraps").limit, 2.5);
  EXPECT_TRUE(check_of(r, "a1.anchor_spikes").passes);
  EXPECT_FALSE(has_check(r, "a1.anchor_staples"));
  EXPECT_TRUE(check_of(r, "a1.anchor_clips").passes);
  EXPECT_EQ(check_of(r, "a1.anchor_clips").trust, "verified");
  EXPECT_FALSE(check_of(r, "a2.anchor_staples").passes);
  const Result thick = run_text(guyed(anchors), {"machine.ropes.guy.diameter=26 mm"});
  EXPECT_FALSE(check_of(thick, "a1.anchor_clips").passes);
  const Result unknown = run_text(guyed(anchors));  // a line of unknown diameter counts as thick
  EXPECT_FALSE(check_of(unknown, "a1.anchor_clips").passes);
}

// Against a strength that nobody knows nothing is as strong.
TEST(AnchorChecks, AsStrongAsARopeOfUnknownStrength) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {w: {mass: 1.6 kg/m, stiffness: 20 MN}}
  points: {a: [0 m, 0 m, 20 m], b: [20 m, 0 m, 0 m]}
  reevings: [{rope: w, path: [{anchor: a}, {anchor: b}], tension_at_start: 90 kN}]
checks: {ropes: {w: {breaking_force: 300 kN, safety_factor: 3}}, anchors: {b: {strength: 100 kN, as_strong_as_rope: true}}}
)");
  EXPECT_FALSE(has_check(r, "b.anchor_as_rope"));
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade");
}

/// What the anchor `b` at the origin must be as strong as, N, with ropes of 100 kN to it from `a`, 30 m away along x,
/// and from elsewhere.
double as_strong(const std::string& reevings) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {w: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 100 kN}}
  points: {a: [30 m, 0 m, 0 m], b: [0 m, 0 m, 0 m], against: [-30 m, 0 m, 0 m], across: [0 m, 30 m, 0 m]}
  reevings:
)" + reevings + R"(
checks: {anchors: {b: {strength: 500 kN, as_strong_as_rope: true}}}
)");
  return check_of(r, "b.anchor_as_rope").limit;
}

// Two equal ropes are one line, however the deck says it. What pulls against them does not help, nor ask for more.
TEST(AnchorChecks, AsStrongAsItsRopesTogether) {
  const auto rope = [](const char* name, const char* from, const char* more = "") {
    return fmt::format(
        "    - {{name: {}, rope: w, path: [{{anchor: {}}}, {{anchor: b}}], tension_at_start: {} kN{}}}\n", name, from,
        *name == 'p' ? 9 : 5, more);
  };
  EXPECT_NEAR(as_strong(rope("p", "a")), 100e3, 1e-6);
  EXPECT_NEAR(as_strong(rope("p", "a", ", copies: 2")), 200e3, 1e-6);
  EXPECT_NEAR(as_strong(rope("p1", "a") + rope("p2", "a")), 200e3, 1e-6);
  EXPECT_NEAR(as_strong(rope("p", "a") + rope("q", "against")), 100e3, 1e-6);
  EXPECT_NEAR(as_strong(rope("p", "a", ", copies: 2") + rope("q", "against")), 200e3, 1e-6);
  EXPECT_NEAR(as_strong(rope("p", "a") + rope("q", "across")), 100e3 * std::numbers::sqrt2, 1e-3);
}

// A rope over a block pulls there with both of its parts: three parts at a becket block, two at a tail block.
TEST(AnchorChecks, ARopeOverABlockPullsWithBothItsParts) {
  const auto parts = [](const char* reevings) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{w: {{mass: 0 kg/m, stiffness: 20 MN, breaking_force: 100 kN}}}}
  points: {{a: [30 m, 0 m, 0 m], b: [0 m, 0 m, 0 m], aside: [0 m, 30 m, 0 m]}}
  bodies: {{load: {{mass: 0 kg, at: [30 m, 0 m, 0 m], free: [x]}}}}
  sheaves: {{far: {{body: load, at: [0 m, 0 m, 0 m]}}, b_block: {{at: [0 m, 0 m, 0 m], efficiency: 1}}}}
  loads: [{{at: load, force: [40 kN, 0 kN, 0 kN]}}]
  reevings: [{}]
analyses: [{{equilibrium: {{}}}}]
checks: {{anchors: {{b_block: {{strength: 500 kN, as_strong_as_rope: true}}}}}}
)",
                                          reevings));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, "b_block.anchor_as_rope").limit;
  };
  EXPECT_NEAR(
      parts("{rope: w, path: [{anchor: b_block}, {over: far}, {over: b_block}, {anchor: load}], length: 89.9 m}"),
      300e3, 1);
  // led aside by 90 degrees: sqrt(2) of it, and the end that is tied there
  const char* aside =
      "{rope: w, path: [{anchor: b_block}, {over: far}, {over: b_block}, {anchor: aside}], length: 89.9 m}";
  EXPECT_NEAR(parts(aside), 100e3 * std::sqrt(5), 1e3);
}

/// A rope of no weight that pulls with 60 kN at an anchor on the ground, up by so many degrees.
std::string pull_at(const std::string& rise, const std::string& anchor, const std::string& tension = "60 kN") {
  return "taut: 1\nmachine:\n  ropes: {line: {mass: 0.001 kg/m, stiffness: 20 MN, breaking_force: 900 kN}}\n"
         "  points: {stump: [0 m, 0 m, 0 m], head: [20 m, 0 m, " +
         rise +
         "]}\n"
         "  reevings:\n    - {rope: line, path: [{anchor: stump}, {anchor: head}], tension_at_start: " +
         tension + "}\nchecks:\n  ropes: {line: {safety_factor: 2}}\n  anchors: {stump: " + anchor + "}\n";
}

// By hand, from the table: 60 kN at 9 deg lie between 32 cm (51 kN) and 40 cm (80 kN):
// sqrt(32^2 + (60 - 51)/(80 - 51) (40^2 - 32^2)) = 34.68 cm; at 20 deg between 40 cm (53) and 48 cm (77): 42.5 cm; at
// 40 deg between 48 cm (55) and 52 cm (65): 50.04 cm.
TEST(AnchorChecks, TreeByForceAndAngle) {
  struct Row {
    double degrees, needed;
  };
  for (const Row& row : {Row{.degrees = 9, .needed = 0.34681}, Row{.degrees = 20, .needed = 0.42489},
                         Row{.degrees = 40, .needed = 0.50040}}) {
    const std::string rise = std::to_string(20 * std::tan(row.degrees * std::numbers::pi / 180)) + " m";
    const Result r = run_text(pull_at(rise, "{tree_diameter: 45 cm}"));
    EXPECT_NEAR(value_of(r, "stump.tree_diameter"), row.needed, 2e-5) << row.degrees;
    const Check& c = check_of(r, "stump.anchor_tree");
    EXPECT_NEAR(c.limit, row.needed, 2e-5);
    EXPECT_EQ(c.value, 0.45);
    EXPECT_EQ(c.passes, row.needed < 0.45);
    EXPECT_EQ(c.trust, "derived");
    EXPECT_NEAR(cell(table_of(r, "anchor_forces"), 0, "tree_diameter"), row.needed, 2e-5);
    EXPECT_FALSE(has_check(run_text(pull_at(rise, "{}")), "stump.anchor_tree")) << "a value alone";
  }
}

TEST(AnchorChecks, TheAngleCountsFromTheGround) {
  // 20 deg above the horizontal over ground that rises by 15 deg: 5 deg
  const Result r = run_text(pull_at("7.2794 m", "{tree_diameter: 45 cm, ground_slope: 15 deg}"));
  EXPECT_NEAR(value_of(r, "stump.tree_diameter"), 0.34681, 2e-5);
  // over ground that falls: 40 deg
  const Result falls = run_text(pull_at("7.2794 m", "{tree_diameter: 45 cm, ground_slope: -20 deg}"));
  EXPECT_NEAR(value_of(falls, "stump.tree_diameter"), 0.50040, 2e-5);
}

TEST(AnchorChecks, BeyondTheTableATreeNeverPasses) {
  // 50 deg: the table ends at 45 deg; 60 kN need 50.0 cm there already
  const Result thin = run_text(pull_at("23.835 m", "{tree_diameter: 48 cm}"));
  EXPECT_FALSE(check_of(thin, "stump.anchor_tree").passes);
  EXPECT_EQ(verdict_of(thin)->kind, VerdictKind::fails);
  const Result thick = run_text(pull_at("23.835 m", "{tree_diameter: 90 cm}"));
  EXPECT_FALSE(has_check(thick, "stump.anchor_tree"));
  EXPECT_EQ(thick.find_value("stump.tree_diameter"), nullptr);
  EXPECT_EQ(verdict_of(thick)->kind, VerdictKind::not_judged);
  EXPECT_EQ(verdict_of(thick)->verdict_class, "unmade");
  // 300 kN: the table ends at 215 kN and 65 cm
  EXPECT_FALSE(check_of(run_text(pull_at("1 m", "{tree_diameter: 60 cm}", "300 kN")), "stump.anchor_tree").passes);
  EXPECT_EQ(verdict_of(run_text(pull_at("1 m", "{tree_diameter: 80 cm}", "300 kN")))->kind, VerdictKind::not_judged);
}

TEST(AnchorChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(guyed("  anchors: {a9: {}}\n")), "no rope ends at 'a9'");
  expect_mistake(run_text(guyed("  anchors: {a1: {safety_factor: 2}}\n")), "needs 'strength'");
  expect_mistake(run_text(guyed("  anchors: {a1: {as_strong_as_rope: true}}\n")), "needs 'strength'");
  expect_mistake(run_text(guyed("  anchors: {a1: {fastening: {spikes: 8, staples: 6}}}\n")), "either");
}

// Six falls of a block of 6 t, and the lead line beside them, all hang on the sheave that the dead end is fixed to.
TEST(AnchorChecks, AtASheaveItsRopesPullToo) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 178 kN}}
  bodies: {hook: {mass: 6 t, at: [0 m, 0 m, 3 m], free: [x, z]}}
  sheaves: {head: {at: [0 m, 0 m, 10 m], diameter: 400 mm}, block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm}}
  drums: {winch: {at: [-6 m, 0 m, 1 m], core_diameter: 400 mm}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head, parts: 6, between: [head, block]}, {anchor: head}], length: 52 m}]
checks: {ropes: {hoist: {safety_factor: 5}}, anchors: {head: {strength: 20 kN}}}
)");
  const double T = 1e3 * 9.80665, slant = std::atan2(9.0, 6.0);  // the drum is as large as the sheave
  const double force = std::hypot(6 * T + T * std::sin(slant), T * std::cos(slant));
  EXPECT_NEAR(check_of(r, "head.anchor_strength").value, 20e3 / force, 0.01);
}

}  // namespace taut::checks::anchor_checks_test
