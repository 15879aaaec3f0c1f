#include <gtest/gtest.h>

#include <cmath>

#include "taut/app/machine_decks_test.hpp"
#include "taut/catalogue/section_search.hpp"

namespace design_sections_test {

using namespace taut_test;

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
  const taut::Result r = run_text(pole("CHS 219.1x10",
                                       "design: {sections: {mast: {shape: chs, forming: hot, standard: EN 10210, "
                                       "least_height: 160 mm, most_height: 200 mm}}}\n"));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "design_sections");
  const std::string found = text_cell(t, 0, "section");
  taut::catalogue::SectionFilter filter;
  filter.shape = taut::catalogue::SectionShape::chs;
  filter.forming = taut::catalogue::Forming::hot;
  filter.standard = "EN 10210";
  filter.max_height = 0.2;
  std::string lightest;
  for (const auto& row : taut::catalogue::sections_by_mass(filter)) {
    if (row.height < 0.16) continue;
    if (exit_code(run_text(pole(row.name, ""))) != 0) continue;
    lightest = row.name;
    EXPECT_NEAR(value_of(r, "design_cost"), 6 * row.mass_per_length, 1e-9 * row.mass_per_length);
    break;
  }
  EXPECT_EQ(found, lightest);
}

TEST(DesignSections, MistakesHaveTheirPlace) {
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {sections: {most: {}}}\n")), "did you mean 'mast'");
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {sections: {mast: {least_height: 3 m}}}\n")),
                 "drop a condition");
  expect_mistake(run_text(pole("CHS 219.1x10", "design: {seek: cheapest, sections: {mast: {}}}\n")), "no price");
}

}  // namespace design_sections_test
