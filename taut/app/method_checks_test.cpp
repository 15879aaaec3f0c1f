#include "taut/app/method_checks.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

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

/// The factor of the input is one of the strength at the rope's temperature: EN 12385-3 leaves 0.65 of it at 350 degC,
/// and says nothing beyond 400 degC.
TEST(MethodChecks, TheFactorOfALoopIsThatOfItsHotRope) {
  const auto at = [](const std::string& temperature) {
    const std::string rope =
        "{breaking_force: 800 kN, diameter: 30 mm, construction: 6x36, core: IWRC" + temperature + "}";
    return run_text(
        "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, gathering_force: 20 kN, "
        "gathering_angle: 30 deg, tail_efficiency: 0.9, return_weight: 10 N/m, traction_weight: 15 N/m, "
        "safety_factor: 3, wire_strength: 1500 MPa}\nchecks: {ropes: {return: " +
        rope + ", traction: " + rope + "}}\n");
  };
  const Result cold = at(""), hot = at(", temperature: 350 degC"), unknown = at(", temperature: 410 degC");
  ASSERT_EQ(cold.status, Status::ok) << cold.message << to_text(cold.errors);
  const std::string name = "safety factor of the traction rope";
  EXPECT_NEAR(check_of(hot, name).value, 0.65 * check_of(cold, name).value, 1e-9);
  EXPECT_THAT(unknown.unmade, testing::Contains(HasSubstr(name + " is not checked: no strength is known")));
}

/// The deck asks a factor of ropes by their weight: `checks` may give their strength.
TEST(MethodChecks, AFactorOfALoopNeedsAStrength) {
  const auto loop_of_weights = [](const std::string& checks) {
    return run_text(
        "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, gathering_force: 20 kN, "
        "gathering_angle: 30 deg, tail_efficiency: 0.9, return_weight: 10 N/m, traction_weight: 15 N/m, "
        "safety_factor: 3, wire_strength: 1500 MPa}\n" +
        checks);
  };
  const Result open = loop_of_weights("");
  ASSERT_EQ(open.status, Status::ok) << open.message << to_text(open.errors);
  EXPECT_EQ(verdict_of(open)->verdict_class, "unmade");
  EXPECT_EQ(exit_code(open), 4);
  const std::string strong = "{safety_factor: 3, breaking_force: 800 kN}";
  const Result half = loop_of_weights("checks: {ropes: {return: " + strong + "}}\n");
  EXPECT_THAT(half.unmade, testing::ElementsAre(HasSubstr("the safety_factor of the traction rope")));
  const Result both = loop_of_weights("checks: {ropes: {return: " + strong + ", traction: " + strong + "}}\n");
  EXPECT_TRUE(both.unmade.empty());
  EXPECT_EQ(exit_code(both), 0) << verdict_of(both)->reason;
}

/// T is the largest tension of a rope of which the deck has the weight. A strength of 2.5 T has the factor 2.5: enough
/// for what `checks` ask, 2, and too little for the input's own 3. Both were asked, so it fails.
TEST(MethodChecks, TheFactorOfALoopCountsBesideThatOfChecks) {
  const auto loop_of_strength = [](double strength, const std::string& more) {
    const std::string ropes = strength > 0 ? "checks: {ropes: {return: {breaking_force: " + std::to_string(strength) +
                                                 " N" + more + "}, traction: {breaking_force: 900 kN" + more + "}}}\n"
                                           : "";
    return run_text(
        "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, gathering_force: 20 kN, "
        "gathering_angle: 30 deg, tail_efficiency: 0.9, return_weight: 10 N/m, traction_weight: 15 N/m, "
        "safety_factor: 3, wire_strength: 1500 MPa}\n" +
        ropes);
  };
  const double T = taut_test::cell(taut_test::table_of(loop_of_strength(0, ""), "ropes"), 0, "largest_tension");
  for (const std::string more : {", safety_factor: 2", ", field: skyline.ru", ""}) {
    const Result weak = loop_of_strength(2.5 * T, more);
    ASSERT_EQ(weak.status, Status::ok) << weak.message << to_text(weak.errors);
    const Check& own = check_of(weak, "safety factor of the return rope");
    EXPECT_NEAR(own.value, 2.5, 1e-6);
    EXPECT_EQ(own.limit, 3);
    EXPECT_FALSE(own.passes);
    EXPECT_EQ(own.trust, "user");
    EXPECT_EQ(verdict_of(weak)->kind, VerdictKind::fails) << more;
    EXPECT_EQ(exit_code(weak), 4);
  }
  const Result strong = loop_of_strength(3.2 * T, "");
  EXPECT_EQ(exit_code(strong), 0) << "its own factor is a limit: " << verdict_of(strong)->reason;
}

/// 300 kN on a weight strain 6 mm2 of wire by 150 kN/(100 GPa 6 mm2): no steel rope bears that, whatever strength the
/// deck says it has.
TEST(MethodChecks, ADriveWhoseRopeNoSteelBearsDoesNotPass) {
  const auto saw = [](const std::string& rope, const std::string& checks) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 90 kN, friction: 0.35, wrap: 200 deg, rope_mass: 0.6 "
        "kg/m, speed: 15 m/s, take_up: {weight: 300 kN}, " +
        rope + "}\n" + checks);
  };
  const std::string limit = "checks: {ropes: {rope: {safety_factor: 2, breaking_force: 900 kN}}}\n";
  EXPECT_EQ(verdict_of(saw("rope_area: 6 mm^2", ""))->verdict_class, "unasked");
  const Result wires = saw("rope_area: 6 mm^2", limit);
  EXPECT_EQ(verdict_of(wires)->kind, VerdictKind::passes_with_warnings) << verdict_of(wires)->reason;
  EXPECT_THAT(wires.unsafe, testing::Contains(HasSubstr("no steel rope bears that")));
  // by its stiffness alone it may be of fibre
  EXPECT_THAT(saw("rope_stiffness: 0.6 MN", limit).unsafe, testing::IsEmpty());
  EXPECT_THAT(saw("rope_area: 600 mm^2", limit).unsafe, testing::IsEmpty());
}

// 60 kN on the idler pull the tight branch with far more than the 4 kN of the cut ask for. The method's stress stays
// that of its formula.
TEST(MethodChecks, TheStressOfADriveIsThatOfItsTakeUp) {
  const auto saw = [](const std::string& more) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 200 deg, rope_mass: 0.6 "
        "kg/m, speed: 15 m/s, rope_area: 66.3 mm^2" +
        more + "}\n");
  };
  const Result heavy = saw(", take_up: {weight: 60 kN}"), plain = saw("");
  const auto value = [](const Result& r, const char* name) { return r.find_value(name)->value; };
  // T_2 = (60000 + 270 - 4000)/2.08 = 27.05 kN, T_1 = 1.08 T_2 + 4000 = 33.22 kN
  EXPECT_NEAR(value(heavy, "T_1_exact"), 33.22e3, 10);
  EXPECT_NEAR(value(heavy, "sigma_tight_exact"), 33.22e3 / 66.3e-6, 0.2e6);
  EXPECT_EQ(value(plain, "sigma_tight"), value(heavy, "sigma_tight"));
}

// A rope named in words is as much known as one by its id: no value of `checks` goes beside it unheard.
TEST(MethodChecks, AValueBesideThatOfARopeIsAMistake) {
  const auto with = [](const std::string& ropes, const std::string& value) {
    return to_text(
        run_text("taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, "
                 "gathering_force: 30 kN, gathering_angle: 30 deg, tail_efficiency: 0.9, safety_factor: 3, " +
                 ropes + "}\nchecks: {ropes: {return: {safety_factor: 3, " + value + "}}}\n")
            .errors);
  };
  const std::string named =
      "return_rope: 6x36-IWRC 20 mm 1960 MPa, traction_rope: 6x36-IWRC 22 mm 1960 MPa, clearance: 20 m";
  const std::string chosen = "choose_ropes: {construction: 6x36, core: IWRC, grade: 1960 MPa}";
  const std::string own_row = "\"EN 12385-4|6x36-IWRC|10|1960\"";
  for (const auto& [key, value] : {std::pair<std::string, std::string>{"breaking_force", "100 kN"},
                                   {"diameter", "10 mm"},
                                   {"area", "50 mm^2"},
                                   {"grade", "1570 MPa"},
                                   {"construction", "6x7"},
                                   {"construction", "6x36-FC"},
                                   {"core", "FC"},
                                   {"rope", own_row}}) {
    const std::string wrong = fmt::format("{}: {}", key, value), place = "checks.ropes.return." + key;
    EXPECT_THAT(with(named, wrong), HasSubstr(place));
    EXPECT_THAT(with(chosen, wrong), HasSubstr(place));
  }
  for (const std::string right : {"grade: 1960 MPa", "construction: 6x36WS", "core: IWRC"}) {
    EXPECT_EQ(with(named, right), "") << right;
    EXPECT_EQ(with(chosen, right), "") << right;
  }
  EXPECT_THAT(with("choose_ropes: {construction: 6x36, core: IWRC}", "grade: 1960 MPa"), HasSubstr("return.grade"));
}

// f_2 = 10 * 97/100 + 0.95 = 10.65 m: section 2, which carries the gathering line, hangs lower. Hauled out it hangs
// lower still, and the clearance has to be there too.
TEST(MethodChecks, TheLowerSectionOfACarriageHasTheClearance) {
  const auto hauled = [](const std::string& haul) {
    return run_text(
        "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, position: 100 m, sag: 10 m, clearance: 10.3 m, "
        "gathering_force: 3000 kgf, gathering_angle: 30 deg, tail_efficiency: 0.9, carriage: two_section, "
        "section_distance: 3 m, return_rope: 6x36-IWRC 20 mm 1960 MPa, traction_rope: 6x36-IWRC 24 mm 1960 MPa, "
        "safety_factor: 3.0, haul: " +
        haul + "}\n");
  };
  const Result in = hauled("in"), out = hauled("out");
  const double f_in = in.find_value("f_2")->value, f_out = out.find_value("f_2")->value;
  EXPECT_NEAR(f_in, 10.65, 0.005);
  EXPECT_GT(f_out, f_in);
  EXPECT_NEAR(check_of(in, "sag at the carriage").value, f_out, 1e-9);
  EXPECT_EQ(check_of(out, "sag at the carriage").value, f_out);
  EXPECT_FALSE(check_of(in, "sag at the carriage").passes);
}

/// A hinged mast of 14 m under 97.2 kN of a rope at rest, T (1 + sin(80 deg)), and the guys: pi^2 E I/L^2 of CHS
/// 168.3x6.3 is 111.4 kN.
TEST(MethodChecks, AMastNearItsCriticalLoadFails) {
  const std::string guy = ", anchor_distance: 14 m, rope: 6x36-IWRC 20 mm 1960 MPa, install: {tension: 5 kN, at: top}}";
  const Result r = run_text(
      "taut: 1\nmethod: mast_section\ninput: {skyline_force: 48.95 kN, mainline_force: 0 kN, skyline_block_height: 14 "
      "m, block_friction: 0.12, branch_angle: 80 deg, steel: EN 10210-1 S355H, safety: 2.0, section: CHS 168.3x6.3, "
      "base: hinged, guys: [{plan_angle: 60 deg" +
      guy + ", {plan_angle: 180 deg" + guy + ", {plan_angle: 300 deg" + guy + "]}\n");
  const Check& c = check_of(r, "buckling of CHS 168.3x6.3, exact");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, 111.4 / 109.2, 0.03);
  EXPECT_THAT(r.unsafe, testing::Contains(HasSubstr("buckles at 1 times")));
}

/// A mast of 12 m, CHS 406.4x20 unless told otherwise, with these guys.
Result guyed(const std::string& sky, const std::string& guys, const std::string& more = "",
             const std::string& section = "CHS 406.4x20") {
  return run_text("taut: 1\nmethod: mast_section\ninput: {skyline_force: " + sky +
                  ", skyline_block_height: 12 m, mainline_force: 10 N, branch_angle: 12 deg, steel: EN 10210-1 S355H, "
                  "safety: 1.5, section: " +
                  section + more + ", guys: [" + guys + "]}\n");
}

std::string guy(const char* angle, const char* put_up, const char* strength, const char* more = "") {
  return std::string("{stiffness: 40 MN, weight: 30 N/m, anchor_distance: 15 m, plan_angle: ") + angle +
         " deg, breaking_force: " + strength + " kN, install: {tension: " + put_up + " kN, at: top}" + more + "}";
}

bool is_slack(const Result& r) {
  return std::any_of(r.unsafe.begin(), r.unsafe.end(), [](const auto& w) { return w.starts_with("slack guys"); });
}

// One guy behind the mast bends it by its pull alone: the ropes are what holds it. It stands before they are laid.
TEST(MethodChecks, AMastIsJudgedWithoutItsLoadToo) {
  const std::string behind = guy("180", "600", "2500");
  const Result loaded = guyed("200 kN", behind), bare = guyed("10 N", behind);
  const Check &c = check_of(loaded, "strength of CHS 406.4x20, exact"),
              &alone = check_of(bare, "strength of CHS 406.4x20, exact");
  EXPECT_FALSE(c.passes);
  EXPECT_NEAR(c.value, alone.value, 1e-3 * alone.value);
  EXPECT_NEAR(c.value, 285e6, 3e6);
  EXPECT_LT(loaded.find_value("sigma_exact")->value, 0.8 * c.value) << "under the load it has less";
  EXPECT_GT(loaded.find_value("sigma_worst_exact")->value, 0.99 * c.value);
}

// The ropes take tension off the guy before the mast, and one guy alone pulls the mast over: it has the most as it is
// put up.
TEST(MethodChecks, AGuyIsJudgedAsItIsPutUp) {
  const Result both = guyed("140 kN", guy("180", "200", "1500") + ", " + guy("0", "200", "290"));
  const Check& c = check_of(both, "guylines do not break");
  EXPECT_NEAR(c.value, 290 / 200.0, 1e-9);
  EXPECT_FALSE(c.passes);
  EXPECT_EQ(c.where, "guy 2, as it is put up");
  EXPECT_NEAR(both.find_value("guy_safety_min_exact")->value, 1.45, 1e-9);
  const Result lone = guyed("140 kN", guy("180", "150", "900") + ", " + guy("-90", "500", "300"),
                            ", lateral_force: 40 kN", "CHS 323.9x12.5");
  EXPECT_NEAR(check_of(lone, "guylines do not break").value, 0.6, 1e-9);
  EXPECT_NEAR(lone.find_value("guy_tension_max_exact")->value, 500e3, 1);
}

TEST(MethodChecks, ASlackGuyIsUnsafeUnlessItIsDeclared) {
  const std::string behind = guy("180", "100", "3000"), before = guy("0", "100", "3000"),
                    declared = guy("0", "100", "3000", ", may_slack: true");
  const Result slack = guyed("190 kN", behind + ", " + before, "", "CHS 508x20");
  ASSERT_TRUE(is_slack(slack)) << slack.message;
  EXPECT_EQ(verdict_of(slack)->kind, VerdictKind::passes_with_warnings) << verdict_of(slack)->reason;
  EXPECT_THAT(slack.unsafe, testing::Contains(HasSubstr("slack guys: 2 (first: ropes paid out)")));
  const Result told = guyed("190 kN", behind + ", " + declared, "", "CHS 508x20");
  EXPECT_FALSE(is_slack(told));
  EXPECT_THAT(told.warnings, testing::Contains(HasSubstr("slack guys, as the deck declares: 2")));
  EXPECT_FALSE(is_slack(guyed("5 kN", behind + ", " + before, "", "CHS 508x20")));
}

// [sigma] alone does not say how much the steel yields at: 90 * 235 MPa/127 = 166.5 MPa is the most for this wall.
TEST(MethodChecks, AWallOfAnUnknownSteelIsNotJudged) {
  const auto mast = [](const std::string& section, const std::string& stress) {
    return run_text(
        "taut: 1\nmethod: mast_section\ninput: {skyline_force: 100 kN, mainline_force: 20 kN, skyline_block_height: 8 "
        "m, branch_angle: 12 deg, " +
        section + ", allowable_stress: " + stress + " MPa}\n");
  };
  const Result open = mast("section: CHS 1016x8", "160");
  EXPECT_EQ(verdict_of(open)->kind, VerdictKind::not_judged);
  EXPECT_THAT(verdict_of(open)->reason, HasSubstr("up to a yield stress of 166 MPa"));
  EXPECT_FALSE(taut_test::has_check(open, "wall of CHS 1016x8"));
  const Check& certain = check_of(mast("section: CHS 1016x8", "170"), "wall of CHS 1016x8");
  EXPECT_FALSE(certain.passes) << "no steel that is allowed 170 MPa yields below";
  // 33 walls: class 3 up to 641 MPa, more than any steel of EN 10210
  const Result stocky = mast("section: CHS 660x20", "160");
  EXPECT_TRUE(stocky.unmade.empty());
  EXPECT_EQ(verdict_of(stocky)->kind, VerdictKind::passes) << verdict_of(stocky)->reason;
  const Result chosen = mast("choose_section: {shape: CHS, standard: EN 10210, largest_slenderness: 130}", "160");
  EXPECT_TRUE(chosen.unmade.empty());
  const double slenderness = taut_test::cell(taut_test::table_of(chosen, "sections"), 0, "height/wall");
  EXPECT_LE(slenderness, 90 * 235 / 460.0);
  EXPECT_GT(slenderness, 30) << "it is what decides";
}

bool doubts(const Result& r, const std::string& words) {
  return std::any_of(r.unsafe.begin(), r.unsafe.end(),
                     [&](const auto& w) { return w.find(words) != std::string::npos; });
}

// The rows of the catalogue: 6x36-IWRC 1960 of 16, 24, 20 mm. A slip of a unit is no other rope.
TEST(MethodChecks, AValueThatNoRopeOfItsRowHasIsUnsafe) {
  const auto on_guy = [](const std::string& more) {
    return guyed(
        "30 kN",
        "{rope: 6x36-IWRC 16 mm 1960 MPa, plan_angle: 180 deg, anchor_distance: 15 m, may_slack: true, install: "
        "{tension: 20 kN, at: top}" +
            more + "}");
  };
  EXPECT_TRUE(doubts(on_guy(", breaking_force: 3000 kN"), "rope 'guy 1' has the breaking force 3000 kN"));
  EXPECT_TRUE(doubts(on_guy(", weight: 90 N/m"), "mass"));
  EXPECT_TRUE(doubts(on_guy(", stiffness: 1 MN"), "stiffness"));
  EXPECT_FALSE(doubts(on_guy(""), "rope 'guy"));
  const auto saw = [](const std::string& mass, const std::string& more) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 200 deg, "
        "rope_mass: " +
        mass +
        " kg/m, speed: 25 m/s, sheave_radius: 600 mm, rope: 6x36-IWRC 24 mm 1960 MPa, take_up: {screw: 30 "
        "kN}" +
        more + "}\nchecks: {ropes: {rope: {safety_factor: 5}}}\n");
  };
  EXPECT_TRUE(doubts(saw("0.1", ""), "mass 0.1 kg/m"));
  EXPECT_FALSE(doubts(saw("9", ""), "mass")) << "with its cutters";
  const Result soft = saw("2.4", ", rope_stiffness: 1 kN");
  EXPECT_TRUE(doubts(soft, "stiffness"));
  EXPECT_TRUE(doubts(soft, "no steel rope bears that"));
  EXPECT_EQ(verdict_of(soft)->kind, VerdictKind::passes_with_warnings) << verdict_of(soft)->reason;
  EXPECT_TRUE(saw("2.4", "").unsafe.empty());
  const auto loop_of = [](const std::string& stiffness) {
    return loop("return_rope: 6x36-IWRC 24 mm 1960 MPa, traction_rope: 6x36-IWRC 24 mm 1960 MPa, return_stiffness: " +
                stiffness);
  };
  EXPECT_TRUE(doubts(loop_of("25 kN"), "rope 'return' has the stiffness")) << loop_of("25 kN").message;
  EXPECT_FALSE(doubts(loop_of("25 MN"), "rope 'return'"));
}

// The screw of 30 kN lets 27 kN be while the rope runs; the sheave pulls the cut and the loss at the idler.
TEST(MethodChecks, TheAnswerOfADriveIsThatOfItsTakeUp) {
  const auto saw = [](const std::string& take_up) {
    return run_text(
        "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 200 deg, "
        "rope_mass: 2.4 kg/m, speed: 25 m/s, sheave_radius: 600 mm, rope: 6x36-IWRC 24 mm 1960 MPa" +
        take_up + "}\n");
  };
  const auto line = [](const Result& r, std::string_view label) {
    for (const Answer& a : r.answers) {
      if (a.label == label) return a.text;
    }
    return std::string();
  };
  const Result r = saw(", take_up: {screw: 30 kN}");
  const double pull = r.find_value("T_1_exact")->value - r.find_value("T_2_exact")->value;
  EXPECT_NEAR(pull, 5.0e3, 20);
  EXPECT_THAT(line(r, "Tension"), HasSubstr("tight branch 17.5 kN, slack branch 12.5 kN"));
  EXPECT_THAT(line(r, "Drive"), HasSubstr("torque 3 kN m; power 125 kW at the driving sheave; power 100 kW into"));
  EXPECT_THAT(line(r, "Take-up"), HasSubstr("the deck's screw, set to 30 kN at rest, pulls 27 kN while the rope runs"));
  EXPECT_THAT(line(saw(", take_up: {weight: 12 kN}"), "Take-up"), HasSubstr("the deck's 12 kN holds the rope"));
  EXPECT_THAT(line(saw(""), "Take-up"), HasSubstr("a pull of 8.597 kN on the idler holds the rope"));
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

/// A rope saw with two duties, the second of them over a round of this name.
Result saw_with_duty(const std::string& idler, const std::string& over, const std::string& more = "") {
  return run_text(
      "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.35, wrap: 200 deg, rope_mass: 0.6 "
      "kg/m, speed: 15 m/s, sheave_radius: 250 mm, rope: 6x36-IWRC 12 mm 1960 MPa" +
      idler +
      "}\nchecks: {ropes: {rope: {safety_factor: 2, duty: [{name: trial, cycles: 100, over: driving sheave}, {name: "
      "work, cycles: 1e9, over: " +
      over + "}]" + more + "}}}\n");
}

// A duty over a round that the rope does not have would do nothing, and the life of the others would pass.
TEST(MethodChecks, ADutyRunsOverRoundsOfItsMethod) {
  const std::string idler = ", idler_radius: 250 mm";
  EXPECT_FALSE(check_of(saw_with_duty(idler, "idler"), "rope.life").passes);
  taut_test::expect_mistake(saw_with_duty(idler, "drive sheave"), "did you mean 'driving sheave'");
  taut_test::expect_mistake(saw_with_duty("", "idler"), "the rope runs over no 'idler' with a diameter");
}

TEST(MethodChecks, NoSheaveOfAMethodCompensates) {
  taut_test::expect_mistake(saw_with_duty(", idler_radius: 250 mm", "idler", ", compensating: idler"),
                            "checks.ropes.rope.compensating: a published method has no such sheave");
}

/// Four guys at 10 m or at the top, the two before the mast declared.
std::string four_guys(const char* more) {
  std::string all;
  for (const char* angle : {"150", "210", "30", "-30"}) {
    all += std::string("{rope: 6x36-IWRC 36 mm 1960 MPa, anchor_distance: 14 m, may_slack: true, plan_angle: ") +
           angle + " deg" + more + "}, ";
  }
  return all;
}

// A rope that stands on its block has as much on both sides as its friction allows: no less than without friction.
TEST(MethodChecks, FrictionRelievesNoMast) {
  const auto stress = [](const std::string& friction, const std::string& mast) {
    const Result r = run_text(
        "taut: 1\nmethod: mast_section\ninput: {steel: EN 10210-1 S355H, safety: 2.0, block_friction: " + friction +
        ", " + mast + "}\n");
    double worst = 0;
    for (const Check& c : r.checks) {
      if (c.name.starts_with("strength of")) worst = std::max(worst, c.value);
    }
    return worst;
  };
  const std::string guyed =
      "skyline_force: 300 kN, mainline_force: 100 kN, skyline_block_height: 14 m, branch_angle: 45 deg, section: CHS "
      "323.9x12.5, guys: [" +
      four_guys(", install: {tension: 20 kN}") + "]";
  const std::string low =
      "skyline_force: 100 kN, mainline_force: 40 kN, skyline_block_height: 2.5 m, branch_angle: 75 deg, section: CHS "
      "273x12.5";
  for (const std::string& mast : {guyed, low}) {
    const double smooth = stress("0", mast);
    EXPECT_GT(smooth, 177.5e6) << mast;
    EXPECT_GE(stress("0.16", mast), (1 - 1e-9) * smooth) << mast;
  }
}

// The skyline at the top bends the mast against the mainline below: without it the mast has more.
TEST(MethodChecks, AGuyedMastIsJudgedWithEachRopeAlone) {
  const auto mast = [](const std::string& skyline) {
    return run_text(
        "taut: 1\nmethod: mast_section\ninput: {mainline_force: 215 kN, skyline_block_height: 16 m, "
        "mainline_block_height: 3.5 m, branch_angle: 10 deg, steel: EN 10210-1 S355H, safety: 2.0, section: CHS "
        "457x16, "
        "skyline_force: " +
        skyline + ", guys: [" + four_guys(", attachment_height: 10 m, install: {tension: 40 kN}") + "]}\n");
  };
  const Result both = mast("53 kN"), alone = mast("0.01 kN");
  const char* const strength = "strength of CHS 457x16, exact";
  EXPECT_FALSE(check_of(both, strength).passes);
  EXPECT_GE(check_of(both, strength).value, 0.999 * check_of(alone, strength).value);
  EXPECT_GE(both.find_value("M_worst_exact")->value, 0.999 * alone.find_value("M_worst_exact")->value);
}

}  // namespace taut::app::method_checks_test
