#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/section_search.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::mast_checks_test {

using namespace taut_test;

std::string case_a(const std::string& mast) {
  return mast_deck("wrap: paper", "checks: {masts: {mast: {" + mast + "}}}\n");
}

/// Case A of the paper with its ropes hauled in, whose forces are known by hand: test/cases/ec3_mast_test.cpp.
std::string hauled_in(const std::string& mast) {
  return case_a(mast + ", height: 8 m, loads: [{down: 162638.979 N, across: 106508.023 N}]");
}

TEST(MastChecks, CaseAByBothRoutes) {
  const taut::Result r =
      run_text(hauled_in("section: CHS 508x16, steel: S355, sway: 0, bow: 0, allowable_stress: 160 MPa"));
  EXPECT_EQ(exit_code(r), 4);  // [sigma] of the paper
  EXPECT_NEAR(check_of(r, "mast.member").value, 0.608284, 1e-5);
  EXPECT_NEAR(check_of(r, "mast.section").value, 0.634255, 1e-5);
  EXPECT_NEAR(check_of(r, "mast.buckling").value, 0.0350853, 1e-6);
  EXPECT_NEAR(check_of(r, "mast.wall").value, 31.75, 1e-9);
  EXPECT_NEAR(check_of(r, "mast.wall").limit, 59.5775, 1e-4);
  EXPECT_NEAR(check_of(r, "mast.allowable_stress").value, 295.4926e6, 2e3);
  EXPECT_FALSE(check_of(r, "mast.allowable_stress").passes);
  EXPECT_EQ(check_of(r, "mast.section").part, "mast");
  EXPECT_NE(check_of(r, "mast.section").trust.find("UNVERIFIED"), std::string::npos);
  const auto says = [&](const std::string& text) {
    return std::any_of(r.assumptions.begin(), r.assumptions.end(),
                       [&](const std::string& a) { return a.find(text) != std::string::npos; });
  };
  EXPECT_TRUE(says("gamma_F = 1)"));
  EXPECT_TRUE(says("f_y/[sigma] = 2.219"));
  EXPECT_GT(r.steps.size(), 20U);
}

/// A mast beside the machine judges no rope of its name, and a mast of other beams no beam of its name.
TEST(MastChecks, AMastJudgesTheBeamsThatItIs) {
  const auto unjudged = [](const std::string& parts, const std::string& masts) {
    const taut::Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], b: [0 m, 0 m, 8 m], c: [5 m, 0 m, 0 m], d: [5 m, 0 m, 8 m]}
)" + parts + "analyses: [{equilibrium: {}}]\nchecks: {masts: {" +
                                    masts + "}}\n");
    EXPECT_TRUE(r.errors.empty()) << to_text(r.errors);
    return r.unjudged;
  };
  const std::string rope =
      "  ropes: {wire: {rope: 'EN 12385-4|6x36-IWRC|20|1960', stiffness: 20 MN}}\n"
      "  reevings: [{name: spar, rope: wire, path: [{anchor: b}, {anchor: d}], tension_at_start: 250 kN}]\n";
  const std::string own = "height: 8 m, section: CHS 219.1x8, steel: S355, load_factor: 1, loads: [{down: 100 kN}]";
  EXPECT_EQ(unjudged(rope, "spar: {" + own + "}"), std::vector<std::string>{"spar"});
  const std::string beams =
      "  beams:\n"
      "    strong: {from: a, to: b, section: CHS 323.9x10, steel: S355}\n"
      "    weak: {from: c, to: d, section: CHS 139.7x6.3, steel: S355}\n"
      "  loads: [{at: strong.top, force: [2 kN, 0 kN, -20 kN]}, {at: weak.top, force: [2 kN, 0 kN, -20 kN]}]\n";
  EXPECT_EQ(unjudged(beams, "weak: {beams: [strong], load_factor: 1}"), std::vector<std::string>{"weak"});
  EXPECT_TRUE(unjudged(beams, "any: {beams: [strong], load_factor: 1}, weak: {load_factor: 1}").empty());
}

// A share of a recalled yield stress is no better than that.
TEST(MastChecks, StressOfARecalledSteelIsMarked) {
  const taut::Result r = run_text(case_a("section: CHS 508x16, steel: S355 product, safety: 2"));
  EXPECT_NE(check_of(r, "mast.allowable_stress").trust.find("UNVERIFIED"), std::string::npos);
  const taut::Result own = run_text(case_a("section: CHS 508x16, steel: S355 product, allowable_stress: 160 MPa"));
  EXPECT_EQ(check_of(own, "mast.allowable_stress").trust, "user");
}

TEST(MastChecks, FactorsRaiseTheUse) {
  const taut::Result r = run_text(hauled_in("section: CHS 508x16, steel: S355, load_factor: 1.5, dynamic_factor: 1.1"));
  EXPECT_NEAR(check_of(r, "mast.section").value, 1.069647, 2e-5);
  EXPECT_EQ(exit_code(r), 4);
}

TEST(MastChecks, ChoosesTheLightestOfEachShape) {
  const taut::Result r = run_text(
      hauled_in("section: CHS 508x16, steel: S355, load_factor: 1.35, choose: {forming: hot, standard: EN 10210}"));
  const auto& t = table_of(r, "mast_sections");
  ASSERT_EQ(t.rows.size(), 8U);  // of the squares two
  for (std::size_t i = 0; i < t.rows.size(); ++i) EXPECT_LE(cell(t, i, "utilisation"), 1);
  EXPECT_LE(cell(t, 0, "mass_per_length"), cell(t, 1, "mass_per_length"));
  // what it names passes when it is checked itself
  const std::string name = std::get<std::string>(t.rows[0][1]);
  const taut::Result again = run_text(hauled_in("section: " + name + ", steel: S355, load_factor: 1.35"));
  EXPECT_NEAR(value_of(again, "mast.utilisation"), cell(t, 0, "utilisation"), 1e-9);
  EXPECT_EQ(exit_code(again), 0);
}

TEST(MastChecks, ClassFourIsRefusedWithWords) {
  const taut::Result r = run_text(case_a("section: CHS 508x8, steel: S355"));
  EXPECT_EQ(exit_code(r), 4);
  EXPECT_FALSE(check_of(r, "mast.wall").passes);
  EXPECT_FALSE(has_check(r, "mast.member"));
  EXPECT_TRUE(std::any_of(r.warnings.begin(), r.warnings.end(),
                          [](const std::string& w) { return w.find("thicker wall") != std::string::npos; }));
}

const char* const pole = R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}
  beams:
    mast: {from: foot, to: head, section: CHS 508x16, steel: S355, mass: 0 kg/m}
  loads: [{at: mast.top, force: [106508.0225 N, 0 N, -162638.979 N]}]
checks:
  masts:
    mast: {allowable_stress: 400 MPa}
)";

// The machine's beam as a cantilever is the hand's: exact rotations instead of small ones cost 1e-3.
TEST(MastChecks, MachineBeamIsTheCantilever) {
  const taut::Result r = run_text(pole);
  EXPECT_NEAR(check_of(r, "mast.section").value, 0.634255, 1e-3);
  // its axial force falls towards the bent top by H times the turn there: 1 % on N_cr
  EXPECT_NEAR(check_of(r, "mast.buckling").value, 0.0350853, 5e-4);
  EXPECT_NEAR(check_of(r, "mast.member").value, 0.0350853 + 0.9252614 * 871.3685 / 1375.408, 1e-3);
  // turned by any angle about its axis: a tube has none
  const taut::Result turned = run_text(pole, {"machine.loads[0].force=[-63904.8135 N, 85206.418 N, -162638.979 N]"});
  EXPECT_NEAR(check_of(turned, "mast.section").value, check_of(r, "mast.section").value, 1e-6);
}

/// Bent by H = 16 kN and twisted by a couple of 25 kN on arms of 2 m.
const char* const twisted = R"(taut: 1
machine:
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, 5 m]
    a1: {body: b, at: [0 m, 2 m, 5 m]}
    a2: {body: b, at: [0 m, -2 m, 5 m]}
  beams:
    b: {from: foot, to: head, section: CHS 219.1x8, steel: S355}
  loads:
    - {at: a1, force: [25 kN, 0 kN, 0 kN]}
    - {at: a2, force: [-25 kN, 0 kN, 0 kN]}
    - {at: b.top, force: [16 kN, 0 kN, -10 kN]}
checks: {masts: {b: {load_factor: 1.0, allowable_stress: 320 MPa}}}
)";

// sigma about 302 MPa, tau = 99.4 kN m/(2 W_el) = 184 MPa; T_Rd = 2 A_m t f_y/sqrt(3) = 114.8 kN m.
TEST(MastChecks, TorsionCountsBesideBending) {
  const taut::Result r = run_text(twisted);
  EXPECT_NEAR(check_of(r, "b.torsion").value, 0.866, 2e-3);
  EXPECT_FALSE(check_of(r, "b.section").passes);
  EXPECT_NEAR(value_of(r, "b.stress_max") / 355e6, 1.24, 0.01);
  EXPECT_FALSE(check_of(r, "b.stress_max").passes);
  EXPECT_FALSE(check_of(r, "b.allowable_stress").passes);
  EXPECT_EQ(exit_code(r), 4);
  const taut::Result plain =
      run_text(twisted, {"machine.loads[0].force=[0 N, 0 N, 0 N]", "machine.loads[1].force=[0 N, 0 N, 0 N]"});
  EXPECT_FALSE(has_check(plain, "b.torsion")) << "rounding is no torsion";
  EXPECT_NEAR(check_of(plain, "b.section").value, 0.64, 0.01);
  EXPECT_TRUE(check_of(plain, "b.allowable_stress").passes);
  EXPECT_EQ(exit_code(plain), 0);
}

// Two places a hair apart are as good as one: a short piece of the beam must not spoil its critical load.
TEST(MastChecks, PlacesNearlyTogether) {
  const auto use = [](const std::string& second) {
    const taut::Result r = run_text(R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m], p1: {body: mast, at: [0 m, 0 m, 7 m]}, p2: {body: mast, at: [0 m, 0 m, )" +
                                    second + R"(]}}
  beams:
    mast: {from: foot, to: head, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}
  loads: [{at: mast.top, force: [5 kN, 0 N, -50 kN]}, {at: p1, force: [2 kN, 0 kN, -30 kN]}, {at: p2, force: [2 kN, 0 kN, -30 kN]}]
checks: {masts: {mast: {load_factor: 1.35}}}
)");
    EXPECT_EQ(r.status, taut::Status::ok) << r.message << second;
    return std::pair{check_of(r, "mast.buckling").value, check_of(r, "mast.section").value};
  };
  const auto one = use("7 m");
  for (const char* near : {"7.000001 m", "7.0001 m", "7.001 m", "6.997 m", "7.01 m"}) {
    const auto two = use(near);
    EXPECT_NEAR(two.first / one.first, 1, 2e-3) << near;
    EXPECT_NEAR(two.second / one.second, 1, 2e-3) << near;
  }
}

TEST(MastChecks, CombinationsNameAnalyses) {
  const std::string deck = std::string(pole) + "      combinations: {one: {equilibrium: 1.5}}\n";
  std::string text = deck;
  const auto at = text.find("{allowable_stress: 400 MPa}\n");
  text.replace(at, 28, "\n");
  const taut::Result r = run_text(text);
  const taut::Result plain = run_text(pole);
  // by hand: 1.5 H tan(kL)/k with 1.5 N is 1322.08 kN m over M_N = 1372.30 kN m; the estimate from alpha_cr is 0.3 %
  // above
  EXPECT_NEAR(check_of(r, "mast.section").value, 0.96340, 4e-3);
  EXPECT_GT(check_of(r, "mast.section").value, 1.5 * check_of(plain, "mast.section").value);
}

// Two beams, one upon the other, against the column of two pieces, which is factored before it bends.
TEST(MastChecks, BeamsUponEachOther) {
  const taut::Result r = run_text(R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], knee: [0 m, 0 m, 6 m], head: [0 m, 0 m, 12 m]}
  beams:
    lower: {from: foot, to: knee, section: CHS 508x16, steel: S355, mass: 0 kg/m}
    upper: {from: lower.top, to: head, section: CHS 323.9x10, steel: S355, mass: 0 kg/m}
  loads: [{at: upper.top, force: [20 kN, 0 N, -100 kN]}]
checks:
  masts:
    whole: {beams: [lower, upper], load_factor: 1.2}
    own:
      pieces: [{length: 6 m, section: CHS 508x16}, {length: 6 m, section: CHS 323.9x10}]
      steel: S355
      sway: 0
      bow: 0
      load_factor: 1.2
      loads: [{down: 100 kN, across: 20 kN}]
)");
  EXPECT_NEAR(check_of(r, "whole.section").value / check_of(r, "own.section").value, 1, 5e-3);
  // no other beam presses: the critical force is that of the whole
  EXPECT_NEAR(check_of(r, "whole.buckling").value / check_of(r, "own.buckling").value, 1, 5e-3);
}

TEST(MastChecks, BuiltCrookedNeedsNoMemberEquation) {
  // a pole with a free top bends away from the line between its ends to the other side
  const taut::Result r =
      run_text(pole, {"machine.beams.mast.imperfection={bow: -0.0034, sway: 0.0036, towards: [1, 0, 0]}"});
  EXPECT_FALSE(has_check(r, "mast.member"));
  EXPECT_TRUE(
      has_check(run_text(pole, {"machine.beams.mast.imperfection={bow: 0.0034, sway: 0.0036, towards: [1, 0, 0]}"}),
                "mast.member"));
  EXPECT_GT(check_of(r, "mast.section").value, 0.634255);
}

/// Hinged, 10 m, four guys, pushed aside at half its height; `imperfection` of its beam.
taut::Result guyed(const std::string& imperfection, const std::string& checks = "load_factor: 1.35") {
  std::string guys;
  const char* stakes[] = {"[10 m, 0 m, 0 m]", "[-10 m, 0 m, 0 m]", "[0 m, 10 m, 0 m]", "[0 m, -10 m, 0 m]"};
  std::string points = "foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 10 m], m: {body: mast, at: [0 m, 0 m, 5 m]}";
  for (int i = 0; i < 4; ++i) {
    points += fmt::format(", s{}: {}", i, stakes[i]);
    guys += fmt::format("g{0}: {{rope: r, from: mast.top, to: s{0}, install: {{tension: 10 kN}}}}, ", i);
  }
  return run_text(
      fmt::format("taut: 1\nmachine:\n  points: {{{}}}\n  guys: {{{}}}\n  ropes: {{r: {{mass: 0 kg/m, "
                  "stiffness: 2 MN, breaking_force: 300 kN}}}}\n  beams: {{mast: {{from: foot, to: head, "
                  "section: CHS 168.3x6.3, steel: EN 10210-1 S355H, base: hinge, mass: 0 kg/m{}}}}}\n  "
                  "loads: [{{at: m, force: [5 kN, 0 kN, 0 kN]}}, {{at: mast.top, force: [0 kN, 0 kN, -85 "
                  "kN]}}]\nanalyses: [equilibrium: {{motion: at_rest}}]\nchecks: {{ropes: {{r: "
                  "{{safety_factor: 3}}}}, masts: {{mast: {{{}}}}}}}\n",
                  points, guys, imperfection, checks));
}

// EN 1993-1-1, 5.3.1 (2): in the most unfavourable direction.
TEST(MastChecks, AnImperfectionThatHelpsOrIsTooSmallKeepsTheMemberEquation) {
  const auto crooked = [](const char* bow, const char* towards, const char* checks = "load_factor: 1.35") {
    return guyed(fmt::format(", imperfection: {{bow: {}, sway: 0.0046, towards: {}}}", bow, towards), checks);
  };
  // on its guys alone nothing moves its top in the direction of the sway; in the equilibrium something does
  const taut::Result right = crooked("0.0034", "[1, 0, 0]");
  EXPECT_TRUE(check_of(right, "mast.member").passes);
  EXPECT_NE(check_of(right, "mast.member").rule.find("on its guys alone"), std::string::npos);
  EXPECT_FALSE(check_of(right, "mast.section").passes);
  EXPECT_FALSE(check_of(crooked("-0.0034", "[1, 0, 0]"), "mast.member").passes);
  EXPECT_FALSE(check_of(crooked("0.0034", "[0, 1, 0]"), "mast.member").passes);
  // L/300 of curve a is not L/150 of curve d
  EXPECT_FALSE(check_of(crooked("0.0034", "[1, 0, 0]", "load_factor: 1.35, curve: d"), "mast.member").passes);
}

/// A clamped tube of 8 m with `head` kg whose centre of mass is 6 m above its top.
taut::Result headed(bool origin_at_top, const std::string& checks, double head) {
  return run_text(fmt::format(
      "taut: 1\nmachine:\n  points: {{foot: [0 m, 0 m, 0 m], joint: {{body: head, at: [0 m, 0 m, {}]}}}}\n  bodies: "
      "{{head: {{mass: {} kg, at: [0 m, 0 m, {}], centre: [0 m, 0 m, {}], free: [x, y, z, rx, ry, rz]}}}}\n  beams: "
      "{{mast: {{from: foot, to: joint, section: CHS 168.3x6.3, steel: EN 10210-1 S355H, mass: 0 kg/m}}}}\nanalyses: "
      "[equilibrium: {{motion: at_rest}}]\nchecks: {{masts: {{mast: {{{}}}}}}}\n",
      origin_at_top ? "0 m" : "-6 m", head, origin_at_top ? "8 m" : "14 m", origin_at_top ? "6 m" : "0 m", checks));
}

// cos kL = a k sin kL of a rigid piece a on a cantilever L: kL = 0.7609, P = 31.27 kN.
TEST(MastChecks, WhereTheOriginOfABodyIsDoesNotMatterForBuckling) {
  for (const bool origin_at_top : {true, false}) {
    const taut::Result r = headed(origin_at_top, "load_factor: 1.75", 2000);
    EXPECT_NEAR(value_of(r, "mast.alpha_cr"), 31.27e3 / (2000 * 9.80665), 2e-3) << origin_at_top;
    EXPECT_FALSE(check_of(r, "mast.section").passes);
    EXPECT_NEAR(value_of(headed(origin_at_top, "load_factor: 1.35", 1000), "mast.alpha_cr"), 31.27e3 / 9806.65, 4e-3);
  }
}

// The wall 12.5 % thinner: N_cr 75.69 instead of 85.29 kN.
TEST(MastChecks, AThinnerWallIsLessStiff) {
  const std::string pole_under =
      "taut: 1\nmachine:\n  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}\n  beams: {mast: {from: foot, to: "
      "head, section: CHS 168.3x6.3, steel: EN 10210-1 S355H, mass: 0 kg/m}}\n  loads: [{at: mast.top, force: [0 kN, 0 "
      "kN, -55 kN]}]\nanalyses: [equilibrium: {motion: at_rest}]\nchecks: {masts: {mast: {load_factor: 1.35, "
      "wall_tolerance: 0.125}, own: {section: CHS 168.3x6.3, steel: EN 10210-1 S355H, height: 8 m, base: clamped, "
      "loads: [{down: 55 kN}], load_factor: 1.35, wall_tolerance: 0.125, sway: 0}}}\n";
  const taut::Result r = run_text(pole_under);
  EXPECT_FALSE(check_of(r, "mast.buckling").passes);
  EXPECT_NEAR(check_of(r, "mast.buckling").value, check_of(r, "own.buckling").value, 2e-3);
}

// First order with alpha_cr/factor below 10 is magnified, EN 1993-1-1, (5.4): the witness is the same mast of second
// order. Of a cantilever with a force at its top (5.4) is right to 1 %.
TEST(MastChecks, MomentsOfFirstOrderAreMagnifiedByTheDesignLoad) {
  const auto section = [](const char* order, const char* factor) {
    const taut::Result r = run_text(fmt::format(
        "taut: 1\nmachine:\n  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}}\n  beams: {{mast: {{from: foot, "
        "to: head, section: CHS 168.3x6.3, steel: EN 10210-1 S355H, mass: 0 kg/m, order: {}}}}}\n  loads: [{{at: "
        "mast.top, force: [1 kN, 0 kN, -8 kN]}}]\nanalyses: [equilibrium: {{motion: at_rest}}]\nchecks: {{masts: "
        "{{mast: "
        "{{load_factor: {}}}}}}}\n",
        order, factor));
    return check_of(r, "mast.section").value;
  };
  EXPECT_NEAR(section("first", "1.5"), section("second", "1.5"), 0.02 * section("second", "1.5"));
  EXPECT_LT(section("first", "1"), 0.95 * section("second", "1"));  // 10.7 times: as it is
}

TEST(MastChecks, StatesThatNoCombinationNamesAreNotJudged) {
  const std::string sweep =
      ", sweep: {name: sw, parameter: \"loads.top.force.x\", from: -1 kN, to: -4.5 kN, steps: 2}]\nchecks: {masts: "
      "{mast: {combinations: {one: {";
  const std::string deck =
      "taut: 1\nmachine:\n  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}\n  beams: {mast: {from: foot, to: "
      "head, section: CHS 168.3x6.3, steel: EN 10210-1 S355H}}\n  loads: [{name: top, at: mast.top, force: [-2 kN, 0 "
      "kN, "
      "-10 kN]}]\nanalyses: [equilibrium: {motion: at_rest}" +
      sweep;
  const taut::Result one = run_text(deck + "equilibrium: 1.35}}}}}\n");
  EXPECT_TRUE(check_of(one, "mast.member").passes);
  ASSERT_EQ(one.unjudged.size(), 1U);
  EXPECT_NE(one.unjudged[0].find("'sw', which none of its combinations names"), std::string::npos);
  const taut::Result both = run_text(deck + "equilibrium: 1.35}, two: {sw: 1.35}}}}}\n");
  EXPECT_TRUE(both.unjudged.empty());
  EXPECT_FALSE(check_of(both, "mast.member").passes);
}

// 610/10 is over 90 * 235/355, 406.4/10 at its top is not.
TEST(MastChecks, ATaperedMastHasTheWallsOfItsFoot) {
  const taut::Result r = run_text(
      "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], b: [20 m, 0 m, 0 m]}\n  ropes: {r: {mass: 1 kg/m, stiffness: "
      "10 MN, breaking_force: 100 kN}}\n  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 20.1 "
      "m}]\nchecks: {ropes: {r: {safety_factor: 2}}, masts: {own: {pieces: [{length: 12 m, section: CHS 610x10, top: "
      "CHS 406.4x10}], steel: EN 10210-1 S355H, base: clamped, loads: [{down: 50 kN, across: 5 kN}], load_factor: "
      "1.5}}}\n");
  const taut::Check& c = check_of(r, "own.wall");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, 61, 1e-9);
}

TEST(MastChecks, SteppedMastWithTwoCasesTogether) {
  const taut::Result r = run_text(std::string(pole) + R"(    stepped:
      pieces: [{length: 6 m, section: CHS 508x16}, {length: 6 m, section: CHS 323.9x10}]
      steel: S355
      loads:
        - {case: dead, down: 30 kN}
        - {case: work, down: 100 kN, across: 20 kN}
        - {case: work, at: 6 m, across: 10 kN}
      combinations: {ULS: {dead: 1.35, work: 1.5}}
)");
  // first order at the base: 1.5 (20 x 12 + 10 x 6) = 450 kN m, at the step 180 kN m; the bent shape adds some
  const auto& t = table_of(r, "masts");
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_NEAR(cell(t, 1, "N"), 1.35 * 30e3 + 1.5 * 100e3, 1);
  EXPECT_GT(std::abs(cell(t, 1, "M_y")), 180e3);
  EXPECT_LT(std::abs(cell(t, 1, "M_y")), 280e3);
  EXPECT_NEAR(cell(t, 1, "height"), 6, 1e-9);
}

TEST(MastChecks, ExamplesDoWhatTheySay) {
  const auto run_example = [](const char* name) {
    const auto job = taut::app::read_job((source_dir() / "examples/design" / name).string());
    EXPECT_TRUE(job) << name;
    return job ? taut::app::run(*job) : taut::Result{};
  };
  const taut::Result yarder = run_example("yarder_mast.yaml");
  EXPECT_EQ(exit_code(yarder), 0) << yarder.message << to_text(yarder.errors);
  EXPECT_LT(check_of(yarder, "mast.section").value, 1);
  EXPECT_EQ(check_of(yarder, "return.spar_rating").part, "return");
  const taut::Result both = run_example("mast_case_a.yaml");
  EXPECT_EQ(exit_code(both), 4) << "with factors the tube is too small by either route";
  // at rest, the full force on both sides of the blocks
  const double alpha = 12 * std::numbers::pi / 180;
  const taut::Result own = run_text(
      case_a(fmt::format("section: CHS 508x16, steel: S355, height: 8 m, loads: [{{down: {:.9g} N, across: {:.9g} N}}]",
                         140e3 * (std::sin(alpha) + 1), 140e3 * std::cos(alpha))));
  EXPECT_NEAR(check_of(both, "plain.member").value, check_of(own, "mast.member").value, 1e-6);
}

TEST(MastChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(case_a("section: CHS 508x16")), "needs 'steel'");
  expect_mistake(run_text(case_a("section: CHS 508x17, steel: S355")), "CHS 508x1");
  expect_mistake(run_text(case_a("section: CHS 508x16, steel: S350")), "S355");
  expect_mistake(run_text(case_a("section: CHS 508x16, steel: S355, load_factor: -1")), "load_factor");
  expect_mistake(run_text(pole, {"checks.masts.mast.beams=[most]"}), "did you mean 'mast'");
  expect_mistake(run_text(pole, {"checks.masts.mast.combinations={a: {inhaul: 1.5}}"}), "inhaul");
  expect_mistake(run_text(pole, {"checks.masts.mast.height=8 m"}), "say it of the beam there");
  for (const char* own : {"base=hinge", "foot=[0 m, 0 m, 1 m]", "towards=[0, 1]"}) {
    expect_mistake(run_text(pole, {std::string("checks.masts.mast.") + own}), "say it of the beam there");
  }
  expect_mistake(
      run_text(pole, {"checks.masts.mast.load_factor=1.4", "checks.masts.mast.combinations={a: {equilibrium: 1.5}}"}),
      "have the partial factors already");
  expect_mistake(run_text(pole, {"checks.masts.other={steel: S355, section: CHS 508x16, height: 8 m}"}),
                 "give its 'loads'");
}

/// Four clamped legs under one platform that sways: pi^2 E I/(4 L^2) is 153.4 kN a leg, 613 kN of all. One leg alone,
/// the others as they are, would hold far more.
TEST(MastChecks, LegsThatBuckleTogether) {
  const auto legs = [](double load, double across, const std::string& order) {
    std::string points, beams, masts;
    for (int i = 1; i <= 4; ++i) {
      const int x = 2 * i - 5;
      points += fmt::format("    f{0}: [{1} m, 0 m, 0 m]\n    h{0}: {{body: head, at: [{1} m, 0 m, 0 m]}}\n", i, x);
      beams += fmt::format(
          "    leg{0}: {{from: f{0}, to: h{0}, section: CHS 219.1x8, steel: S355, base: clamped, top: hinge, order: "
          "{1}}}\n",
          i, order);
      masts += fmt::format("    leg{}: {{load_factor: 1.35}}\n", i);
    }
    return run_text(
        fmt::format("taut: 1\nmachine:\n  points:\n{}  bodies: {{head: {{at: [0 m, 0 m, 10 m], mass: 0 kg, "
                    "free: [x, z]}}}}\n  beams:\n{}  loads: [{{at: head, force: [{} kN, 0 kN, {} kN]}}]\n"
                    "analyses: [{{equilibrium: {{}}}}]\nchecks:\n  masts:\n{}",
                    points, beams, across, -load, masts));
  };
  const catalogue::SectionRow tube = *catalogue::find_section("CHS 219.1x8");
  const double all = 4 * std::pow(std::numbers::pi, 2) * 210e9 * tube.I_y / (4 * 100);
  const Result first = legs(178, 30, "first");
  EXPECT_NEAR(check_of(first, "leg1.alpha_cr").value, all / 178e3, 0.03 * all / 178e3);
  EXPECT_FALSE(check_of(first, "leg1.alpha_cr").passes);
  // 1.35 times 520 kN are more than 613 kN
  const Result second = legs(520, 0.5, "second");
  EXPECT_NEAR(check_of(second, "leg1.alpha_cr").value, all / 520e3, 0.03 * all / 520e3);
  EXPECT_NEAR(value_of(second, "leg1.N_cr"), all / 4, 0.03 * all / 4);
  EXPECT_EQ(verdict_of(second)->kind, VerdictKind::fails) << verdict_of(second)->reason;
  EXPECT_NE(verdict_of(second)->reason.find("the mast buckles, its critical factor is 1.1"), std::string::npos)
      << verdict_of(second)->reason;
}

}  // namespace taut::checks::mast_checks_test
