#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "taut/catalogue/section_search.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::design_sections_test {

using taut_test::expect_mistake;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::text_cell;
using taut_test::value_of;

std::string pole(const std::string& section, const std::string& more) {
  return R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 6 m]}
  beams:
    mast: {from: foot, to: head, section: )" +
         section + R"(, steel: S355}
  loads: [{at: mast.top, force: [12 kN, 3 kN, -60 kN]}]
checks: {masts: {mast: {load_factor: 1.5}}}
)" + more;
}

// Each tube of the range run alone, the lightest that passes: what the search finds.
TEST(DesignSections, LightestMastAsByTryingAll) {
  const Result r = run_text(pole("CHS 219.1x10",
                                 "design: {sections: {mast: {shape: chs, forming: hot, standard: EN 10210, "
                                 "least_height: 160 mm, most_height: 200 mm}}}\n"));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "design_sections");
  const std::string found = text_cell(t, 0, "section");
  catalogue::SectionFilter filter;
  filter.shape = catalogue::SectionShape::chs;
  filter.forming = catalogue::Forming::hot;
  filter.standard = "EN 10210";
  filter.max_height = 0.2;
  std::string lightest;
  for (const auto& row : catalogue::sections_by_mass(filter)) {
    if (row.height < 0.16) continue;
    if (exit_code(run_text(pole(row.name, ""))) != 0) continue;
    lightest = row.name;
    EXPECT_NEAR(value_of(r, "design_cost"), 6 * row.mass_per_length, 1e-9 * row.mass_per_length);
    break;
  }
  EXPECT_EQ(found, lightest);
}

/// A mast under a load of its own, free at its top.
std::string random_mast(double height, double down, double across, const std::string& section,
                        const std::string& more) {
  return fmt::format(R"(taut: 1
machine:
  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, {} m]}}
  beams: {{mast: {{from: foot, to: head, section: {}, steel: S355, elements: 4}}}}
  loads: [{{at: mast.top, force: [{} kN, 0 kN, -{} kN]}}]
checks: {{masts: {{mast: {{load_factor: 1.5, gamma_M1: 1.1}}}}}}
{})",
                     height, section, across, down, more);
}

// Every section of the filter run alone, the lightest that passes: the same as the search finds. So it passes alone.
TEST(DesignSections, agree_with_brute_force_on_200_random_cases) {
  std::mt19937 random(9);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const std::pair<const char*, catalogue::SectionShape> shapes[] = {{"chs", catalogue::SectionShape::chs},
                                                                    {"shs", catalogue::SectionShape::shs},
                                                                    {"rhs", catalogue::SectionShape::rhs}};
  int found = 0;
  const int cases = taut_test::watched ? 15 : 200;
  for (int i = 0; i < cases; ++i) {
    const double height = between(3, 8);
    const double down = between(10, 120);
    const double across = between(1, 14);
    const auto& [word, shape] = shapes[random() % 3];
    catalogue::SectionFilter filter;
    filter.shape = shape;
    filter.forming = random() % 2 == 0 ? catalogue::Forming::hot : catalogue::Forming::cold;
    filter.min_height = between(0.1, 0.3);
    filter.max_height = *filter.min_height + 0.03;
    const auto rows = catalogue::sections_by_mass(filter);
    if (rows.empty()) continue;
    const auto alone = [&](const catalogue::SectionRow& row) {
      return exit_code(run_text(random_mast(height, down, across, row.name, ""))) == 0;
    };
    const auto first = std::find_if(rows.begin(), rows.end(), alone);
    const Result r = run_text(
        random_mast(height, down, across, rows.front().name,
                    fmt::format("design: {{sections: {{mast: {{shape: {}, forming: {}, least_height: {:.17g} m, "
                                "most_height: {:.17g} m}}}}}}",
                                word, catalogue::to_text(*filter.forming), *filter.min_height, *filter.max_height)));
    if (first == rows.end()) {
      EXPECT_EQ(r.status, Status::infeasible) << i << r.message << to_text(r.errors);
      continue;
    }
    ++found;
    EXPECT_EQ(exit_code(r), 0) << i << r.message << to_text(r.errors);
    EXPECT_EQ(text_cell(table_of(r, "design_sections"), 0, "section"), first->name) << i;
  }
  EXPECT_GT(found, cases / 4);  // enough of the cases have an answer
}

TEST(DesignSections, MistakesHaveTheirPlace) {
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {sections: {most: {}}}\n")), "did you mean 'mast'");
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {sections: {mast: {least_height: 3 m}}}\n")),
                 "drop a condition");
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {seek: cheapest, sections: {mast: {}}}\n")), "no price");
}

}  // namespace taut::app::design_sections_test
