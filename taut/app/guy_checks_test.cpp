#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/app/machine_decks_test.hpp"

namespace guy_checks_test {

using namespace taut_test;

const taut::Check& check_of(const taut::Result& r, const std::string& name) {
  static const taut::Check none;
  const auto found = std::find_if(r.checks.begin(), r.checks.end(), [&](const auto& c) { return c.name == name; });
  EXPECT_NE(found, r.checks.end()) << "no check " << name << to_text(r.errors) << r.message;
  return found == r.checks.end() ? none : *found;
}

/// A hinged mast between two pairs of guys, pulled towards x.
std::string guyed(const std::string& checks, const std::string& pull = "[30 kN, 0 N, -20 kN]") {
  return R"(taut: 1
machine:
  ropes: {guy: {mass: 1.2 kg/m, stiffness: 15 MN, breaking_force: 200 kN}}
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, 12 m]
    a1: [-12 m, 6 m, 0 m]
    a2: [-12 m, -6 m, 0 m]
    a3: [12 m, 6 m, 0 m]
    a4: [12 m, -6 m, 0 m]
  beams:
    mast: {from: foot, to: head, section: CHS 219.1x8, steel: S355, base: hinge}
  guys:
    g1: {rope: guy, from: mast.top, to: a1, install: {tension: 20 kN, at: top}}
    g2: {rope: guy, from: mast.top, to: a2, install: {tension: 20 kN, at: top}}
    g3: {rope: guy, from: a3, to: mast.top, install: {tension: 20 kN, at: anchor}}
    g4: {rope: guy, from: mast.top, to: a4, install: {tension: 20 kN, at: top}}
  loads: [{at: mast.top, force: )" +
         pull + "}]\nchecks:\n" + checks;
}

TEST(GuyChecks, AllGuysOfARope) {
  const taut::Result r = run_text(guyed("  guys: {guy: {dynamic_factor: 1.2, pretension: [0.05, 0.09]}}\n"));
  for (const std::string g : {"g1", "g2", "g3", "g4"}) {
    const double T = value_of(r, g + ".T_max");
    EXPECT_NEAR(check_of(r, g + ".guy_safety").value, 200e3 / (1.2 * T), 1e-9 * 200e3 / T);
    EXPECT_NEAR(check_of(r, g + ".pretension_min").value, 0.1, 1e-12);
    EXPECT_TRUE(check_of(r, g + ".pretension_min").passes);
    EXPECT_FALSE(check_of(r, g + ".pretension_max").passes);
    EXPECT_TRUE(check_of(r, g + ".slackness").passes);
  }
  EXPECT_NE(check_of(r, "g1.guy_safety").trust.find("UNVERIFIED"), std::string::npos);
  const taut::Result own = run_text(guyed("  guys: {g1: {safety_factor: 3}}\n"));
  EXPECT_EQ(check_of(own, "g1.guy_safety").trust, "user");
  const taut::Result ruled = run_text(guyed("  guys: {g1: {rule: safety.guyline.ch_at}}\n"));
  EXPECT_NEAR(check_of(ruled, "g1.guy_safety").limit, 3, 1e-12);
}

TEST(GuyChecks, SlackGuyIsTold) {
  const taut::Result r = run_text(guyed("  guys: {guy: {}}\n", "[90 kN, 0 N, -20 kN]"));
  EXPECT_FALSE(check_of(r, "g3.slackness").passes);
  EXPECT_TRUE(check_of(r, "g1.slackness").passes);
  // pulled the other way, the others
  const taut::Result s = run_text(guyed("  guys: {guy: {}}\n", "[-90 kN, 0 N, -20 kN]"));
  EXPECT_FALSE(check_of(s, "g1.slackness").passes);
  EXPECT_TRUE(check_of(s, "g3.slackness").passes);
}

TEST(GuyChecks, StiffTopAgainstEuler) {
  const taut::Result r = run_text(guyed("  masts: {mast: {top_criterion: 3}}\n", "[1 N, 0 N, -1 N]"));
  const auto& c = check_of(r, "mast.top_stiffness");
  const double I = std::numbers::pi / 64 * (std::pow(0.2191, 4) - std::pow(0.2031, 4));
  const double N_cr = std::pow(std::numbers::pi / 12, 2) * 210e9 * I;
  EXPECT_NEAR(c.limit / (3 * N_cr / 12), 1, 1e-5);
  // four guys, 18 m long: along y 4 (EA/L) (6/18)^2 and the tension's part (T/L) (1 - (6/18)^2); sag takes little
  const double L = 18, k = 4 * (15e6 / L / 9 + 20e3 / L * 8 / 9);
  EXPECT_NEAR(c.value / k, 1, 0.02);
}

TEST(AnchorChecks, PullOfAllRopesThere) {
  const taut::Result r =
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

std::string line(const std::string& checks, const std::string& anchor = "[330 m, 0 m, 10 m]") {
  return R"(taut: 1
machine:
  ropes: {skyline: {mass: 2 kg/m, stiffness: 30 MN, breaking_force: 400 kN}}
  points: {head: [0 m, 0 m, 30 m], stump: )" +
         anchor + R"(}
  supports:
    jack: {at: [150 m, 0 m, 40 m], friction: 0}
    tree: {at: [300 m, 0 m, 35 m], friction: 0}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {over: jack}, {over: tree}, {anchor: stump}], tension_at_start: 100 kN}
checks:
)" + checks;
}

TEST(LineChecks, TailTreeAndAnchor) {
  const std::string checks =
      "  lines: {skyline: {tail_tree: tree, break_angles: true, end_masts: [tree], spar_rating: 350 kN}}\n";
  const taut::Result r = run_text(line(checks));
  const double angle = std::atan2(25, 30);
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").value, angle, 0.01);
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").limit, 50 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.anchor_off_line").value, 0, 1e-6);
  EXPECT_FALSE(check_of(r, "skyline.spar_rating").passes);
  EXPECT_NEAR(check_of(r, "skyline.tree.break_angle").limit, std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").limit, std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").value, std::atan(10.0 / 150) + std::atan(5.0 / 150), 0.05);
  // 4.5 m off the line in 30 m: 8.53 degrees
  const taut::Result off = run_text(line(checks, "[330 m, 4.5 m, 10 m]"));
  EXPECT_NEAR(check_of(off, "skyline.anchor_off_line").value, std::atan2(4.5, 30), 0.003);
  EXPECT_FALSE(check_of(off, "skyline.anchor_off_line").passes);
  const taut::Result other = run_text(line(checks, "[330 m, -4.5 m, 10 m]"));
  EXPECT_NEAR(check_of(other, "skyline.anchor_off_line").value, check_of(off, "skyline.anchor_off_line").value, 1e-9);
}

TEST(LineChecks, LimiterTakesTheRopesPlace) {
  const taut::Result r = run_text(line("  lines: {skyline: {spar_rating: 350 kN, limiter: 200 kN}}\n"));
  EXPECT_TRUE(check_of(r, "skyline.limiter").passes);
  EXPECT_NEAR(check_of(r, "skyline.limiter").limit, 350e3, 1e-9);
}

TEST(GuyChecks, MistakesHaveTheirPlace) {
  const auto complaint = [](const taut::Result& r, const std::string& words) {
    return to_text(r.errors).find(words) != std::string::npos;
  };
  EXPECT_TRUE(complaint(run_text(guyed("  guys: {g9: {}}\n")), "no guy"));
  EXPECT_TRUE(complaint(run_text(guyed("  guys: {g1: {pretension: [0.2, 0.1]}}\n")), "[0.08, 0.15]"));
  EXPECT_TRUE(complaint(run_text(guyed("  guys: {g1: {rule: layout.tail_tree_angle}}\n")), "no safety factor"));
  EXPECT_TRUE(complaint(run_text(guyed("  anchors: {a9: {}}\n")), "no rope ends at 'a9'"));
  EXPECT_TRUE(complaint(run_text(guyed("  anchors: {a1: {safety_factor: 2}}\n")), "needs 'strength'"));
  EXPECT_TRUE(complaint(run_text(line("  lines: {skyline: {tail_tree: jock}}\n")), "did you mean 'jack'"));
  EXPECT_TRUE(complaint(run_text(line("  lines: {skylin: {}}\n")), "did you mean 'skyline'"));
}

}  // namespace guy_checks_test
