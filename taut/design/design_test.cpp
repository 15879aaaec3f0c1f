#include "taut/design/design.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "taut/catalogue/rope_search.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::design::design_test {

using namespace taut_test;
using testing::HasSubstr;

/// A line of one span with a load, whose rope is chosen or given.
std::string line_deck(double span, double load, double sag, const std::string& rope, const std::string& tail) {
  return fmt::format(R"(taut: 1
machine:
  points: {{head: [0 m, 0 m, 0 m], tail: [{} m, 0 m, {} m]}}
  ropes: {{skyline: {}}}
  carriages: {{car: {{mass: 100 kg, rides: skyline, hold: clamped}}}}
  reevings: [{{rope: skyline, path: [{{anchor: head}}, {{through: car}}, {{anchor: tail}}], length: {:.6g} m}}]
  loads: [{{at: car, mass: {} kg}}]
analyses: [equilibrium: {{carriage: car, x: {} m, given: {{reeving: skyline, sag: {} m}}}}]
checks: {{ropes: {{skyline: {{safety_factor: 3, elastic_limit: 0.5}}}}}}
{})",
                     span, span / 10, rope, 1.02 * span, load, span / 2, sag, tail);
}

std::string figures_of(const catalogue::RopeRow& row) {
  return fmt::format("{{mass: {:.17g} kg/m, stiffness: {:.17g} N, breaking_force: {:.17g} N, diameter: {:.17g} m}}",
                     row.mass_per_length, 100e9 * row.area, row.breaking_force, row.diameter);
}

std::vector<catalogue::RopeRow> by_mass(const catalogue::RopeFilter& filter) {
  std::vector<catalogue::RopeRow> rows = catalogue::select_ropes(filter);
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.mass_per_length, a.breaking_force, a.id) <
           std::tuple(b.mass_per_length, b.breaking_force, b.id);
  });
  return rows;
}

// The tables have no groove pressure of a rope of class 8x36, which would be the lightest.
TEST(Design, a_rope_without_a_limit_that_is_asked_for_is_not_chosen) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {pin: [-0.2 m, 0 m, 0 m]}
  ropes: {line: {}}
  bodies: {load: {mass: 900 kg, at: [0.2 m, 0 m, 0 m], free: [z]}}
  sheaves: {top: {at: [0 m, 0 m, 10 m], diameter: 400 mm}}
  reevings: [{rope: line, path: [{anchor: pin}, {over: top}, {anchor: load}], length: 18 m}]
analyses: [equilibrium: {}]
checks: {ropes: {line: {safety_factor: 5, groove: wood, diameter_ratio: 12}}}
design: {ropes: {line: {least_diameter: 6 mm, most_diameter: 30 mm}}}
)");
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_TRUE(check_of(r, "line.groove_pressure").passes) << text_cell(table_of(r, "design"), 0, "designation");
}

// Every rope of the filter run alone, the lightest that passes: the same as the search finds, and it passes when it is
// run alone.
TEST(Design, agrees_with_brute_force_on_200_random_cases) {
  std::mt19937 random(5);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const char* const classes[][2] = {
      {"6x7", "FC"}, {"6x19", "FC"}, {"6x19", "IWRC"}, {"6x36", "IWRC"}, {"8x36", "IWRC"}};
  int found = 0;
  const int cases = taut_test::watched ? 25 : 200;
  for (int i = 0; i < cases; ++i) {
    const double span = between(80, 400);
    const double load = between(500, 4000);
    const double sag = span * between(0.03, 0.08);
    const auto& [construction, core] = classes[random() % 5];
    catalogue::RopeFilter filter;
    filter.construction = construction;
    filter.core = core;
    filter.min_diameter = between(0.008, 0.02);
    filter.max_diameter = *filter.min_diameter + 0.006;
    filter.grade = random() % 2 == 0 ? 1770e6 : 1960e6;
    const auto rows = by_mass(filter);
    if (rows.empty()) continue;
    const auto alone = [&](const catalogue::RopeRow& row) {
      return exit_code(run_text(line_deck(span, load, sag, figures_of(row), ""))) == 0;
    };
    const auto first = std::find_if(rows.begin(), rows.end(), alone);
    const std::string design = fmt::format(
        "design: {{ropes: {{skyline: {{construction: {}, core: {}, grade: {} MPa, least_diameter: {:.17g} m, "
        "most_diameter: {:.17g} m}}}}}}",
        construction, core, *filter.grade / 1e6, *filter.min_diameter, *filter.max_diameter);
    const Result r = run_text(line_deck(span, load, sag, "{}", design));
    if (first == rows.end()) {
      EXPECT_EQ(r.status, Status::infeasible) << i << r.message << to_text(r.errors);
      continue;
    }
    ++found;
    EXPECT_EQ(exit_code(r), 0) << i << r.message << to_text(r.errors);
    EXPECT_EQ(text_cell(table_of(r, "design"), 0, "designation"), first->id) << i;
  }
  EXPECT_GT(found, cases / 8);  // enough of the cases have an answer
}

TEST(Design, tells_its_neighbours_and_what_governs) {
  const Result r =
      run_text(line_deck(300, 2000, 15, "{}", "design: {ropes: {skyline: {construction: 6x36, core: IWRC}}}"));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "design_runner_ups");
  const auto chosen = taut_test::row_of(t, "outcome", "chosen");
  ASSERT_GT(chosen, 0U);
  EXPECT_EQ(text_cell(t, chosen - 1, "outcome"), "fails");
  EXPECT_THAT(text_cell(t, chosen - 1, "governs"), HasSubstr("skyline."));
  EXPECT_EQ(text_cell(t, chosen + 1, "outcome"), "passes");
  EXPECT_FALSE(table_of(r, "design_active").rows.empty());
  EXPECT_GE(value_of(r, "design_trials"), static_cast<double>(chosen) + 1);
}

// The deeper the line hangs, the lighter its rope: the last of the sags is chosen, and each place of the grid has the
// rope that a design of its own finds.
TEST(Design, trade_off_over_an_unknown) {
  const std::string ropes = "ropes: {skyline: {construction: 6x36, core: IWRC, grade: 1960 MPa}}";
  const auto deck = [&](double x, const std::string& unknowns) {
    std::string text = line_deck(300, 2000, 15, "{}", "design: {" + ropes + unknowns + "}");
    const std::string old = "analyses: [equilibrium: {carriage: car, x: 150 m, given: {reeving: skyline, sag: 15 m}}]";
    text.replace(text.find(old), old.size(), "analyses: [equilibrium: {carriage: car, x: 150 m}]");
    const std::string pull = "length: 306 m";
    return text.replace(text.find(pull), pull.size(), fmt::format("tension_at_start: {} kN", x));
  };
  const Result r = run_text(deck(60,
                                 ", unknowns: {pull: {parameter: \"reevings.skyline.tension_at_start\", from: 60 kN, "
                                 "to: 120 kN, steps: 3}}"));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "design_trade_off");
  ASSERT_EQ(t.rows.size(), 4U);
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const Result alone = run_text(deck(taut_test::cell(t, i, "pull") / 1e3, ""));
    EXPECT_EQ(taut_test::cell(t, i, "cost"), value_of(alone, "design_cost")) << i;
  }
  EXPECT_EQ(value_of(r, "design_pull"), 60e3);
  EXPECT_EQ(value_of(r, "design_cost"), taut_test::cell(t, 0, "cost"));
}

TEST(Design, no_rope_is_strong_enough) {
  const Result r =
      run_text(line_deck(300, 200000, 3, "{}", "design: {ropes: {skyline: {construction: 6x7, core: FC}}}"));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_THAT(r.message, HasSubstr("no choice passes all checks; the nearest, skyline: "));
}

// A thin rope fails the light case by little; the heavy one, which a quick look leaves out then, by far.
TEST(Design, the_nearest_is_that_of_all_load_cases) {
  const auto with = [](const std::string& design) {
    return run_text(line_deck(300, 2000, 15, "{}",
                              "design:\n  ropes: {skyline: {construction: 6x36, core: IWRC, grade: 1960 MPa, "
                              "least_diameter: 12 mm, most_diameter: 26 mm}}\n" +
                                  design));
  };
  const Result light = with("");
  ASSERT_EQ(exit_code(light), 0) << light.message << to_text(light.errors);
  EXPECT_GT(table_of(light, "design_runner_ups").rows.size(), 1U) << "some fail the light case";
  const Result r = with("  cases: {light: {'loads[0].mass': 2 t}, heavy: {'loads[0].mass': 60 t}}\n");
  EXPECT_EQ(exit_code(r), 3) << r.message << to_text(r.errors);
  EXPECT_THAT(r.message, HasSubstr("the nearest, skyline: EN 12385-4|6x36-IWRC|26|1960, fails by "));
  EXPECT_THAT(r.message, HasSubstr("[heavy]"));
}

// A case that no choice has an answer in is named, not the choice that another check fails by least.
TEST(Design, a_case_without_any_answer_is_the_obstacle) {
  const auto with = [](const std::string& far, const std::string& heavy) {
    return run_text(line_deck(300, 2000, 15, "{}",
                              "design:\n  ropes: {skyline: {construction: 6x36, core: IWRC, grade: 1960 MPa}}\n"
                              "  cases:\n    mid: {'loads[0].mass': " +
                                  heavy + "}\n    beyond: {'analyses[0].equilibrium.x': " + far + "}\n"));
  };
  const Result r = with("310 m", "2 t");
  EXPECT_EQ(exit_code(r), 3) << r.message << to_text(r.errors);
  EXPECT_THAT(r.message, HasSubstr("no choice passes all checks; load case beyond has no answer for any choice: "));
  EXPECT_THAT(r.message, HasSubstr("; nothing else stands against skyline: "));
  EXPECT_THAT(r.message, testing::Not(HasSubstr("fails by")));
  // a check that fails first is told as it was
  const Result both = with("310 m", "2000 t");
  EXPECT_THAT(both.message, HasSubstr("fails by skyline.safety_factor [mid]"));
  EXPECT_THAT(both.message, testing::Not(HasSubstr("nothing else")));
  EXPECT_EQ(exit_code(with("140 m", "2 t")), 0);
}

// What rests on recalled numbers passes nothing then, and the message says so.
TEST(Design, refused_as_unverified) {
  std::string deck = line_deck(300, 2000, 15, "{}", "design: {ropes: {skyline: {construction: 6x36, core: IWRC}}}");
  deck.insert(deck.find("checks: {") + 9, "refuse_unverified: true, ");
  const std::string own = "elastic_limit: 0.5";
  deck.replace(deck.find(own), own.size(), "termination: socket");
  const Result r = run_text(deck);
  EXPECT_EQ(exit_code(r), 3) << to_text(r.errors);
  EXPECT_THAT(r.message, HasSubstr("refused as unverified"));
}

TEST(Design, mistakes) {
  const auto deck = [](const std::string& tail) { return line_deck(300, 2000, 15, "{}", tail); };
  expect_mistake(run_text(deck("design: {ropes: {skylin: {}}}")), "did you mean 'skyline'");
  expect_mistake(run_text(deck("design: {seek: lightest}")), "says nothing that is free");
  expect_mistake(run_text(deck("design: {ropes: {skyline: {construction: 7x77}}}")), "no rope of the catalogue is so");
  expect_mistake(run_text(deck("design: {seek: cheapest, ropes: {skyline: {}}}")), "price_per_m");
  expect_mistake(run_text(deck("design: {unknowns: {x: {parameter: ropes.skyline.nonsense, from: 1 m, to: 2 m}}}")),
                 "is not a number");
  expect_mistake(run_text(deck("design: {unknowns: {x: {parameter: \"points.tail.z\", from: 1 kN, to: 2 m}}}")),
                 "is a unit of force");
  expect_mistake(run_text(deck("design: {catalogue: none.csv, ropes: {skyline: {}}}")), "can't be read");
}

/// A deck beside a catalogue of the user's.
class UserCatalogue : public testing::Test {
 protected:
  Result run_with(const std::string& csv, const std::string& seek = "lightest") {
    std::ofstream(folder_ / "mine.csv") << csv;
    const std::string deck = line_deck(
        300, 2000, 15, "{}", fmt::format("design: {{catalogue: mine.csv, seek: {}, ropes: {{skyline: {{}}}}}}", seek));
    return app::run(app::Job{.text = deck, .name = (folder_ / "deck.yaml").string(), .set = {}});
  }
  taut_test::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
};

constexpr const char* header =
    "id,standard,construction,core,d_mm,area_mm2,mass_kg_per_m,grade_MPa,mbf_kN,trust,price_per_m\n";

TEST_F(UserCatalogue, cheapest_is_not_lightest) {
  const std::string csv = std::string(header) +
                          "light,mine,6x36,IWRC,26,311,2.8,1960,480,verified,9\n"
                          "cheap,mine,6x36,IWRC,28,360,3.2,1770,500,verified,7\n"
                          "thin,mine,6x36,IWRC,8,29,0.26,1960,45,verified,1\n";
  EXPECT_EQ(text_cell(table_of(run_with(csv), "design"), 0, "designation"), "light");
  EXPECT_EQ(text_cell(table_of(run_with(csv, "cheapest"), "design"), 0, "designation"), "cheap");
}

TEST_F(UserCatalogue, mistakes_have_their_place) {
  expect_mistake(run_with("id,standard,construction,d_mm\nx,y,6x36,12\n"), "column 'core' is missing");
  expect_mistake(run_with(std::string(header) + "a,mine,6x36,IWRC,26,-311,2.8,1960,480,verified,9\n"), "area_mm2");
  const std::string row = "a,mine,6x36,IWRC,26,311,2.8,1960,480,verified,9\n";
  expect_mistake(run_with(header + row + row), "mine.csv:3");
  expect_mistake(run_with(std::string(header) + "a,mine,6x36,IWRC,26,311,2800,1960,480,verified,9\n"), "units");
  expect_mistake(run_with(std::string(header) + "a,mine,6x36,IWRC,26,311,2.8,,48,verified,9\n"), "units");
  expect_mistake(run_with(std::string(header) + "a,mine,6x36,IWRC,0.026,311,2.8,1960,480,verified,9\n"),
                 "does not fit");
}

// A million ropes are 70 MB: refused at once, not cut in silence.
TEST_F(UserCatalogue, too_large_a_file) {
  std::string rows = header;
  while (rows.size() < (17U << 20U)) rows += "a,mine,6x36,IWRC,26,311,2.8,1960,480,verified,9\n";
  expect_mistake(run_with(rows), "has more than 16 MB");
}

class DesignExamples : public testing::TestWithParam<const char*> {};

// A rope that a design has chosen passes everything when it stands in the deck by itself.
TEST_P(DesignExamples, run_and_pass) {
  const auto job = app::read_job((taut_test::source_dir() / "examples/design" / GetParam()).string());
  ASSERT_TRUE(job.has_value());
  const Result r = app::run(*job);
  EXPECT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_FALSE(r.checks.empty());
}

INSTANTIATE_TEST_SUITE_P(All, DesignExamples,
                         testing::Values("crane_hoist.yaml", "swiss_skyline.yaml", "rope_saw_life.yaml",
                                         "saw_take_up.yaml", "loop_by_cases.yaml"));

}  // namespace taut::design::design_test
