#include "taut/app/method_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// The checks of `checks:` on the ropes of a published method.
namespace taut::app::method_checks_test {

using taut_test::check_of;
using taut_test::run_text;
using testing::HasSubstr;

std::string boom(const std::string& sliding, const std::string& checks) {
  return R"(taut: 1
method: boom_ropes
input:
  section_weight: 8.44 kN
  pad_friction: 0.15
  tackle_efficiency: 0.95
  extension_stiffness: 0.778 MN/m
  retraction_stiffness: 1.61 MN/m
  sliding: {S10: 95.5 kN, S20: 187 kN, boom_length: [9 m, 15 m, 21 m], luffing_angle: [19 deg],
    suspended_weight: [32.373 kN], )" +
         sliding + "}\nchecks: {ropes: {extension: {safety_factor: 3, breaking_force: 700 kN" + checks +
         "}, retraction: {safety_factor: 2, breaking_force: 700 kN}}}\n";
}

TEST(MethodChecks, NoPartOfAMethodIsExempt) {
  std::string deck = boom("operation: extend", "");
  deck.replace(deck.rfind("}}"), 2, "}, exempt: [extension]}");
  EXPECT_THAT(to_text(run_text(deck).errors), HasSubstr("checks.exempt: a published method judges all its parts"));
}

// Behind the sheave of section 3 the rope has the tension at section 3 over the efficiency: of the extension rope when
// the boom extends, of the retraction rope when it retracts.
TEST(MethodChecks, TheTightBranchOfABoomRopeCounts) {
  for (const bool extends : {true, false}) {
    const Result r = run_text(boom(std::string("sheave_efficiency_1: 0.9, sheave_efficiency_2: 0.8, operation: ") +
                                       (extends ? "extend" : "retract"),
                                   ""));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    const double S1 = r.find_value("S1_max")->value, S2 = r.find_value("S2_max")->value;
    // both have their pretension at least
    EXPECT_NEAR(check_of(r, "extension.safety_factor").value, 700e3 / std::max(95.5e3, extends ? S1 / 0.9 : S1), 1e-9);
    EXPECT_NEAR(check_of(r, "retraction.safety_factor").value, 700e3 / std::max(187e3, extends ? S2 : S2 / 0.8), 1e-9);
  }
}

// The overlap of 5.9 m is used up where the boom of 9 m has come to 21 m: (21 - 9)/2 = 6 m.
TEST(MethodChecks, ABoomThatComesApartSomewhereIsNotJudged) {
  const Result r = run_text(boom("overlap_23: 5.9 m", ""));
  ASSERT_EQ(r.missing.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_EQ(r.missing[0].missing, 1);
  EXPECT_EQ(r.missing[0].places, 3);
  EXPECT_THAT(r.missing[0].reason, HasSubstr("no overlap is left"));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_TRUE(run_text(boom("overlap_23: 6.1 m", "")).missing.empty());
}

// The method does not know the diameters of its sheaves.
TEST(MethodChecks, WhatNeedsASheaveIsNotJudged) {
  const Result r = run_text(boom("overlap_23: 7 m", ", diameter_ratio: 20"));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("extension: D/d is not checked"));
}

/// The saw rope runs over two sheaves: both bend it.
TEST(MethodChecks, TheIdlerOfADriveBendsItsRopeToo) {
  const auto saw = [](const std::string& idler) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 180 deg, rope_mass: 0.6 "
        "kg/m, speed: 15 m/s, sheave_radius: 250 mm, rope: 6x36-IWRC 12 mm 1960 MPa" +
        idler +
        "}\nchecks: {ropes: {rope: {safety_factor: 2, diameter_ratio: 30, duty: [{name: cut, cycles: 1000}]}}}\n");
  };
  const Result unknown = saw("");
  EXPECT_THAT(unknown.unmade, testing::Contains(HasSubstr("no diameter is known of its idler"))) << unknown.message;
  EXPECT_THAT(unknown.unmade, testing::Contains(HasSubstr("its life leaves out the bends over its idler")));
  const Result large = saw(", idler_radius: 250 mm"), small = saw(", idler_radius: 150 mm");
  EXPECT_TRUE(large.unmade.empty());
  EXPECT_NEAR(check_of(large, "rope.sheave_ratio").value, 500. / 12, 1e-9);
  EXPECT_NEAR(check_of(small, "rope.sheave_ratio").value, 300. / 12, 1e-9);
  EXPECT_FALSE(check_of(small, "rope.sheave_ratio").passes);
  EXPECT_NEAR(check_of(large, "rope.life").value, 2 * check_of(unknown, "rope.life").value, 1e-9);
  EXPECT_GT(check_of(small, "rope.life").value, check_of(large, "rope.life").value);
}

/// A loop uphill that is hauled in; with its ropes by weight, or by name with the same weight.
Result loop(const std::string& ropes) {
  return run_text(
      "taut: 1\nmethod: closed_loop\ninput: {span: 400 m, position: 200 m, sag: 24 m, gathering_force: 20 kN, "
      "gathering_angle: 40 deg, tail_efficiency: 0.9, slope: -40 deg, " +
      ropes + "}\nchecks: {ropes: {return: {safety_factor: 3" +
      (ropes.starts_with("return_w") ? ", breaking_force: 800 kN" : "") + "}}}\n");
}

TEST(MethodChecks, BothHaulsOfALoopCountWhateverItsRopesAreGivenBy) {
  const Result named = loop("return_rope: 6x36-IWRC 24 mm 1960 MPa, traction_rope: 6x36-IWRC 24 mm 1960 MPa");
  ASSERT_EQ(named.status, Status::ok) << named.message << to_text(named.errors);
  const double weight = named.find_value("q_b")->value;
  const Result by_weight =
      loop("return_weight: " + std::to_string(weight) + " N/m, traction_weight: " + std::to_string(weight) + " N/m");
  const Check &a = check_of(named, "return.safety_factor"), &b = check_of(by_weight, "return.safety_factor");
  EXPECT_THAT(b.rule, HasSubstr("hauled out"));
  const double strength = taut_test::cell(taut_test::table_of(named, "ropes"), 0, "breaking_force");
  EXPECT_NEAR(strength / a.value, 800e3 / b.value, 1e-6 * 800e3 / b.value);
}

// f_2 = 10 * 97/100 + 0.95 = 10.65 m: section 2, which carries the gathering line, hangs lower.
TEST(MethodChecks, TheLowerSectionOfACarriageHasTheClearance) {
  const Result r = run_text(
      "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, clearance: 10.3 m, "
      "gathering_force: "
      "3000 kgf, gathering_angle: 30 deg, tail_efficiency: 0.9, carriage: two_section, section_distance: 3 m, "
      "return_rope: 6x36-IWRC 20 mm 1960 MPa, traction_rope: 6x36-IWRC 24 mm 1960 MPa, safety_factor: 3.0}\n");
  const Check& c = check_of(r, "sag at the carriage");
  EXPECT_EQ(c.value, r.find_value("f_2")->value);
  EXPECT_NEAR(c.value, 10.65, 0.005);
  EXPECT_FALSE(c.passes);
}

/// A hinged mast of 14 m under 109.2 kN: pi^2 E I/L^2 of CHS 168.3x6.3 is 111.4 kN.
TEST(MethodChecks, AMastNearItsCriticalLoadFails) {
  const std::string guy = ", anchor_distance: 14 m, rope: 6x36-IWRC 20 mm 1960 MPa, install: {tension: 5 kN, at: top}}";
  const Result r = run_text(
      "taut: 1\nmethod: mast_section\ninput: {skyline_force: 57 kN, mainline_force: 0 kN, skyline_block_height: 14 m, "
      "block_friction: 0.12, branch_angle: 80 deg, steel: EN 10210-1 S355H, safety: 2.0, section: CHS 168.3x6.3, base: "
      "hinged, guys: [{plan_angle: 60 deg" +
      guy + ", {plan_angle: 180 deg" + guy + ", {plan_angle: 300 deg" + guy + "]}\n");
  const Check& c = check_of(r, "buckling of CHS 168.3x6.3, exact");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, 111.4 / 109.2, 0.03);
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_THAT(r.unsafe[0], HasSubstr("buckles at 1 times"));
}

// 1016/8 = 127 walls; up to 90 * 235/355 = 59.6 a tube of S355 reaches its yield stress.
TEST(MethodChecks, AMastWhoseWallBucklesFails) {
  const auto mast = [](const std::string& section) {
    return run_text(
        "taut: 1\nmethod: mast_section\ninput: {skyline_force: 10 kN, mainline_force: 1 kN, skyline_block_height: 8 m, "
        "block_friction: 0.12, branch_angle: 20 deg, steel: EN 10210-1 S355H, safety: 2.0, section: " +
        section + "}\n");
  };
  const Check& c = check_of(mast("CHS 1016x8"), "wall of CHS 1016x8");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, 127, 1e-9);
  EXPECT_NEAR(c.limit, 90 * 235 / 355.0, 1e-9);
  EXPECT_FALSE(taut_test::has_check(mast("CHS 610x25"), "wall of CHS 610x25"));
}

// The share of the extension rope is 0.245 by the printed stiffnesses and 1/2.6 by the measured ratio: the checks take
// the larger tension.
TEST(MethodChecks, ABoomRopeIsCheckedByEitherStiffness) {
  const auto with = [](const std::string& ratio) {
    return run_text(
        "taut: 1\nmethod: boom_ropes\ninput: {section_weight: 8.44 kN, pad_friction: 0.15, tackle_efficiency: 0.95, "
        "extension_stiffness: 0.778 MN/m, retraction_stiffness: 1.6 MN/m, S10: 95.5 kN, S20: 190 kN, cases: [{name: "
        "rated, operation: lift, luffing_angle: 77 deg, suspended_weight: 248.2 kN, falls: 8}]" +
        ratio + "}\nchecks: {ropes: {extension: {safety_factor: 3, breaking_force: 700 kN}}}\n");
  };
  const Result printed = with(""), measured = with(", stiffness_ratio: 0.6");
  ASSERT_EQ(measured.status, Status::ok) << measured.message << to_text(measured.errors);
  const double F = measured.find_value("F_1")->value, F_0 = measured.find_value("F0_set")->value;
  EXPECT_NEAR(check_of(measured, "extension.safety_factor").value, 700e3 / (95.5e3 + (F_0 - F) / 2.6), 1e-6);
  EXPECT_LT(check_of(measured, "extension.safety_factor").value,
            0.9 * check_of(printed, "extension.safety_factor").value);
  // a stiff extension rope: the printed shares are the larger ones
  EXPECT_NEAR(check_of(with(", stiffness_ratio: 6"), "extension.safety_factor").value,
              check_of(printed, "extension.safety_factor").value, 1e-9);
}

// 400 kN on the idler: about 200 kN in each branch, twice what the rope breaks at.
TEST(MethodChecks, ATakeUpThatTearsTheRopeFails) {
  const auto saw = [](const std::string& take_up) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 200 deg, rope_mass: 0.6 "
        "kg/m, speed: 15 m/s, sheave_radius: 250 mm, rope: 6x36-IWRC 12 mm 1960 MPa" +
        take_up + "}\n");
  };
  const Result torn = saw(", take_up: {weight: 400 kN}");
  const Check& c = check_of(torn, "rope does not break");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, 200e3, 0.06 * 200e3);
  EXPECT_EQ(c.value, torn.find_value("T_1_exact")->value);
  EXPECT_NEAR(torn.find_value("safety_factor")->value, c.limit / c.value, 1e-12);
  // the grip is that of the deck's pull, not of the paper's
  const auto judges_the_paper = [](const Result& r) {
    return std::any_of(r.checks.begin(), r.checks.end(), [](const Check& one) { return one.name == "no slip"; });
  };
  EXPECT_FALSE(judges_the_paper(torn));
  EXPECT_TRUE(judges_the_paper(saw("")));
  EXPECT_NE(verdict_of(saw(", take_up: {weight: 20 kN}"))->kind, VerdictKind::fails);
}

}  // namespace taut::app::method_checks_test
