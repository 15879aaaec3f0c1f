#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>

#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/section_search.hpp"
#include "test/support/machine_decks.hpp"
#include "test/support/scratch_folder.hpp"

/// `design:` beside the published methods.
namespace taut::app::design_method_test {

using namespace taut_test;
using testing::HasSubstr;

std::string loop(double span, double sag, double pull, const std::string& ropes, const std::string& more) {
  return fmt::format(R"(taut: 1
method: closed_loop
input:
  span: {} m
  slope: -8 deg
  position: [{} m, {} m]
  sag: {} m
  gathering_force: {} kN
  gathering_angle: 30 deg
  tail_efficiency: 0.95
  {}
checks: {{ropes: {{return: {{safety_factor: 3.5}}, traction: {{safety_factor: 3}}}}}}
{})",
                     span, 0.2 * span, 0.5 * span, sag, pull, ropes, more);
}

std::string named(const catalogue::RopeRow& b, const catalogue::RopeRow& t) {
  return fmt::format("return_rope: \"{}\"\n  traction_rope: \"{}\"", b.id, t.id);
}

// Every pair of the candidates run alone: the lightest that passes is what the design finds, and it passes alone.
TEST(DesignMethod, loop_agrees_with_brute_force) {
  std::mt19937 random(11);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  catalogue::RopeFilter filter;
  filter.construction = "6x36";
  filter.core = "IWRC";
  filter.grade = 1960e6;
  filter.min_diameter = 0.010;
  filter.max_diameter = 0.020;
  const auto rows = catalogue::select_ropes(filter);
  ASSERT_GT(rows.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const double span = between(120, 250);
    const double sag = span * between(0.04, 0.07);
    const double pull = between(8, 28);
    const double chord = span / std::cos(8 * M_PI / 180);
    double least = HUGE_VAL;
    std::string best;
    for (const auto& b : rows) {
      for (const auto& t : rows) {
        const double mass = chord * (2 * b.mass_per_length + t.mass_per_length);
        if (mass >= least || exit_code(run_text(loop(span, sag, pull, named(b, t), ""))) != 0) continue;
        least = mass;
        best = b.id + t.id;
      }
    }
    const std::string few =
        "{construction: 6x36, core: IWRC, grade: 1960 MPa, least_diameter: 10 mm, most_diameter: 20 mm}";
    const Result r =
        run_text(loop(span, sag, pull, "", fmt::format("design: {{ropes: {{return: {0}, traction: {0}}}}}", few)));
    if (best.empty()) {
      EXPECT_EQ(exit_code(r), 3) << r.message;
      continue;
    }
    ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
    const Table& t = table_of(r, "design");
    EXPECT_EQ(text_cell(t, 0, "designation") + text_cell(t, 1, "designation"), best);
    EXPECT_NEAR(value_of(r, "design_cost"), least, 1e-9 * least);
    EXPECT_NE(r.find_value("T_lA"), nullptr);  // the whole result of the method is there
  }
}

// Ropes of the user's own file, which no name of the input could call.
TEST(DesignMethod, loop_with_an_own_catalogue_and_prices) {
  const taut_test::ScratchFolder scratch;
  const auto& folder = scratch.path();
  std::ofstream(folder / "mine.csv")
      << "id,standard,construction,core,d_mm,area_mm2,mass_kg_per_m,grade_MPa,mbf_kN,trust,price_per_m\n"
         "light,mine,6x36,IWRC,26,311,2.8,1960,480,verified,9\n"
         "cheap,mine,6x36,IWRC,28,360,3.2,1770,500,verified,7\n"
         "thin,mine,6x36,IWRC,8,29,0.26,1960,45,verified,1\n";
  const std::string deck =
      loop(200, 10, 20, "", "design: {catalogue: mine.csv, seek: cheapest, ropes: {return: {}, traction: {}}}");
  const Result r = run(Job{.text = deck, .name = (folder / "deck.yaml").string(), .set = {}, .progress = {}});
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_EQ(text_cell(table_of(r, "design"), 0, "designation"), "cheap");
}

// Load cases: the rope that holds each of them; and a sag of least tension within its range.
TEST(DesignMethod, loop_with_cases_and_sag) {
  const std::string few = "{construction: 6x36, core: IWRC, grade: 1960 MPa}";
  const auto cost_of = [&](double pull, const std::string& cases) {
    const Result r =
        run_text(loop(200, 10, pull, "", "design: {ropes: {return: " + few + ", traction: " + few + "}" + cases + "}"));
    EXPECT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
    return value_of(r, "design_cost");
  };
  const double heavy = cost_of(25, "");
  EXPECT_LT(cost_of(10, ""), heavy);
  EXPECT_EQ(cost_of(10, ", cases: {light: {gathering_force: 5 kN}, heavy: {input.gathering_force: 25 kN}}"), heavy);
  const Result r = run_text(
      loop(200, 10, 20, "return_weight: 20 N/m\n  traction_weight: 15 N/m",
           "design: {seek: least_tension, of: return, unknowns: {sag: {parameter: sag, from: 6 m, to: 14 m}}}"),
      {"checks.ropes.return.breaking_force=900 kN", "checks.ropes.traction.breaking_force=900 kN"});
  EXPECT_NEAR(value_of(r, "design_sag"), 14, 0.01) << r.message << to_text(r.errors);
}

// The section of the method's own mast, each tube run alone.
TEST(DesignMethod, mast_section_agrees_with_trying_all) {
  catalogue::SectionFilter filter;
  filter.shape = catalogue::SectionShape::chs;
  filter.forming = catalogue::Forming::hot;
  filter.standard = "EN 10210";
  filter.min_height = 0.45;
  filter.max_height = 0.52;
  std::string lightest;
  for (const auto& row : catalogue::sections_by_mass(filter)) {
    if (exit_code(run_text(mast_deck("section: " + row.name, ""))) != 0) continue;
    lightest = row.name;
    break;
  }
  const Result r = run_text(mast_deck("",
                                      "design: {sections: {mast: {shape: chs, forming: hot, standard: EN 10210, "
                                      "least_height: 450 mm, most_height: 520 mm}}}"));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_EQ(text_cell(table_of(r, "design_sections"), 0, "section"), lightest);
  expect_mistake(run_text(mast_deck("choose_section: {shape: CHS}", "design: {sections: {mast: {}}}")),
                 "choose_section");
  // its ropes are chosen by their checks, under the deck's forces
  const Result rope = run_text(mast_deck("section: " + lightest,
                                         "checks: {ropes: {skyline: {safety_factor: 3}}}\ndesign: {ropes: {skyline: "
                                         "{construction: 6x36, core: IWRC, grade: 1960 MPa}}}"));
  ASSERT_EQ(exit_code(rope), 0) << rope.message << to_text(rope.errors);
  const Table& chosen = table_of(rope, "design");
  EXPECT_GE(taut_test::cell(chosen, 0, "breaking_force"), 300e3);
  EXPECT_LT(taut_test::cell(chosen, 0, "breaking_force"), 360e3);
}

// A mast that stands in the checks alone, under the method's forces.
TEST(DesignMethod, section_of_a_mast_in_the_checks) {
  const std::string input = R"(taut: 1
method: mast_section
input: {skyline_force: 100 kN, mainline_force: 40 kN, skyline_block_height: 8 m, branch_angle: 12 deg, allowable_stress: 160 MPa}
checks: {masts: {tube: {section: CHS 508x16, steel: S355, load_factor: 1.35}}}
)";
  const Result r = run_text(input +
                            "design: {sections: {tube: {shape: chs, forming: hot, standard: EN 10210, least_height: "
                            "300 mm, most_height: 420 mm}}}");
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const std::string found = text_cell(table_of(r, "design_sections"), 0, "section");
  EXPECT_EQ(exit_code(run_text(input, {"checks.masts.tube.section=" + found})), 0);
  const auto& below = table_of(r, "design_runner_ups");
  EXPECT_THAT(text_cell(below, 0, "governs"), HasSubstr("tube."));
}

std::string drive(const std::string& more) {
  return R"(taut: 1
method: friction_drive
input:
  cutting_force: 4 kN
  friction: 0.35
  wrap: 200 deg
  rope_mass: 0.9 kg/m
  speed: 15 m/s
  section_factor: 0.126
  sheave_radius: 250 mm
  rope: 6x36-IWRC 12 mm 1960 MPa
  take_up: {mass: 2 t}
  rope_stiffness: 6 MN
  centre_distance: 6 m
checks: {ropes: {rope: {safety_factor: 6}}}
)" + more;
}

// Rope and take-up weight are found by the deck's own grip; the published pretension, which slips, is not what is
// built.
TEST(DesignMethod, drive_with_its_take_up) {
  const Result r = run_text(
      drive("design: {disregard: [no grip], ropes: {rope: {construction: 6x36, core: IWRC, grade: 1960 MPa, "
            "least_diameter: 8 mm, most_diameter: 16 mm}}, unknowns: {weight: {parameter: take_up.mass, from: 200 kg, "
            "to: 3 t}}}"));
  EXPECT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_TRUE(std::none_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name == "no slip"; }));
  EXPECT_THAT(r.warnings, testing::Contains(HasSubstr("there is no check 'no grip'")));
  // a hundredth less lets it slip in earnest, or no rope is lighter: one of the checks is at its limit
  double most = 0;
  for (const Check& c : r.checks) most = std::max(most, c.utilisation);
  EXPECT_GT(most, 0.98);
}

// Without a take-up the published pretension is judged, which lets the rope slip: no rope passes that check.
// Disregarded, the rope is found by all others, and the check still stands in the result.
TEST(DesignMethod, what_is_disregarded_stays_in_the_result) {
  const auto with = [](const std::string& disregard) {
    std::string deck = drive("design: {" + disregard +
                             "ropes: {rope: {construction: 6x36, core: IWRC, grade: 1960 MPa, least_diameter: 8 mm, "
                             "most_diameter: 16 mm}}}");
    const std::string take_up = "  take_up: {mass: 2 t}\n";
    deck.erase(deck.find(take_up), take_up.size());
    return run_text(deck);
  };
  const Result none = with("");
  EXPECT_EQ(exit_code(none), 3);
  EXPECT_THAT(none.message, HasSubstr("fails by no slip"));
  const Result r = with("disregard: [no slip], ");
  EXPECT_EQ(exit_code(r), 4) << r.message << to_text(r.errors);
  EXPECT_TRUE(
      std::none_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return !c.passes && c.name != "no slip"; }));
}

// The ropes of the boom, their stiffness by their lengths.
TEST(DesignMethod, boom_needs_lengths) {
  const std::string deck = R"(taut: 1
method: boom_ropes
input:
  section_weight: 8.44 kN
  pad_friction: 0.15
  tackle_efficiency: 0.95
  extension_stiffness: 2.72 MN/m
  retraction_stiffness: 1.61 MN/m
  cases: [{name: lift, operation: lift, luffing_angle: 77 deg, suspended_weight: 248.2 kN, falls: 8}]
checks: {ropes: {extension: {safety_factor: 3}}}
design: {ropes: {extension: {construction: 6x36, core: IWRC, grade: 1960 MPa}}}
)";
  expect_mistake(run_text(deck), "give 'sliding' with the lengths");
}

// The pretension is the deck's, the ropes are what is built.
TEST(DesignMethod, the_boom_is_built_with_the_ropes_that_are_chosen) {
  const Result r = run_text(R"(taut: 1
method: boom_ropes
input:
  section_weight: 8.44 kN
  pad_friction: 0.15
  tackle_efficiency: 0.95
  extension_stiffness: 0.778 MN/m
  retraction_stiffness: 1.61 MN/m
  S10: 90 kN
  S20: 180 kN
  cases: [{name: lift, operation: lift, luffing_angle: 77 deg, suspended_weight: 250 kN, falls: 8}]
  sliding: {boom_length: [9 m, 21 m], luffing_angle: [20 deg], suspended_weight: [2.943 kN]}
checks: {ropes: {extension: {safety_factor: 3}, retraction: {safety_factor: 3}}}
design:
  seek: lightest
  ropes:
    extension: {construction: 6x36, core: IWRC, grade: 1960 MPa}
    retraction: {construction: 6x36, core: IWRC, grade: 1960 MPa}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  std::string build, given;
  for (const Answer& a : r.answers) {
    if (a.label == "Build") build += a.text;
    if (a.label == "Given") given += a.text;
  }
  EXPECT_THAT(build, HasSubstr("extension EN 12385-4 6x36-IWRC"));
  EXPECT_THAT(build, HasSubstr("retraction EN 12385-4 6x36-IWRC"));
  EXPECT_THAT(build, testing::Not(HasSubstr("pretension")));
  EXPECT_THAT(given, HasSubstr("pretension of the extension rope 90 kN"));
}

// A mast that is chosen buckles at no less than 3 times its axial force, as by `choose_section`; its stress alone would
// let one pass that buckles at 1.26 times. By hand: N = 8 (1 + sin 80 deg) = 15.88 kN, N_cr = pi^2 E I/(4 14^2 m2).
TEST(DesignMethod, a_mast_that_may_buckle_is_not_chosen) {
  const std::string deck = R"(taut: 1
method: mast_section
input:
  skyline_force: 8 kN
  mainline_force: 0 kN
  skyline_block_height: 14 m
  branch_angle: 80 deg
  steel: EN 10219-1 S355H
  safety: 1.05
)";
  const Result r =
      run_text(deck + "design: {sections: {mast: {shape: rhs, least_height: 150 mm, most_height: 300 mm}}}");
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.unsafe.empty());
  const std::string chosen = text_cell(table_of(r, "design_sections"), 0, "section");
  EXPECT_GE(value_of(r, "buckling_factor_exact"), 3) << chosen;
  const auto row = catalogue::find_section(chosen);
  ASSERT_TRUE(row);
  const double N = 8e3 * (1 + std::sin(80 * std::numbers::pi / 180));
  const double alpha = std::pow(std::numbers::pi / 28, 2) * 210e9 * std::min(row->I_y, row->I_z) / N;
  EXPECT_NEAR(value_of(r, "buckling_factor_exact"), alpha, 0.02 * alpha);
}

}  // namespace taut::app::design_method_test
