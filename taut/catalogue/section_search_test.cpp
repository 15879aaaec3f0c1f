#include "taut/catalogue/section_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace taut::catalogue::section_search_test {

TEST(SectionSearch, names_are_forgiving) {
  const auto name = [](std::string_view text) {
    const auto row = find_section(text);
    return row ? row->name : row.error().message;
  };
  EXPECT_EQ(name("chs 508 X 16"), "CHS 508x16");
  EXPECT_EQ(name("CHS508\u00d716.0"), "CHS 508x16");
  EXPECT_EQ(name("SHS 100x5"), "SHS 100x100x5");
  EXPECT_EQ(name("RHS 100x200x8"), "RHS 200x100x8");
  EXPECT_EQ(name("RHS-C 100x200x8"), "RHS-C 200x100x8");
  EXPECT_EQ(name("CHS 219x8 gost8732"), "CHS 219x8 GOST 8732");
  EXPECT_EQ(name("CHS 508x16 EN 10219-2"), "CHS-C 508x16");
}

TEST(SectionSearch, unknown_and_ambiguous_names) {
  const auto unknown = find_section("CHS 508x17");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(to_text(unknown.error()).substr(0, 58), "no section 'CHS 508x17'; did you mean 'CHS 508x16' or 'CHS");
  const auto ambiguous = find_section("508x16");
  ASSERT_FALSE(ambiguous);
  EXPECT_EQ(ambiguous.error().message, "'508x16' may be any of 2 sections");
  EXPECT_EQ(ambiguous.error().candidates, (std::vector<std::string>{"CHS 508x16", "CHS-C 508x16"}));
  for (const char* text : {"", "CHS", "HEB 200", "CHS 508", "CHS x", "CHS 1x2x3x4", "CHS infx16", "CHS 1e999x16"}) {
    EXPECT_FALSE(find_section(text)) << text;
  }
}

TEST(SectionSearch, every_section_is_found_by_its_name) {
  for (std::size_t i = 0; i < sections().size(); i += 11) {
    EXPECT_EQ(find_section(sections()[i].name)->name, sections()[i].name);
  }
}

TEST(SectionSearch, lightest_first_within_the_filter) {
  SectionFilter filter;
  filter.shape = SectionShape::chs;
  filter.forming = Forming::hot;
  filter.standard = "EN";
  filter.min_W_el_y = 2900e-6;
  filter.min_height = 0.500;
  filter.max_height = 0.610;
  filter.min_thickness = 0.008;
  const auto rows = sections_by_mass(filter);
  ASSERT_FALSE(rows.empty());
  double last = 0.0;
  for (const SectionRow& row : rows) {
    EXPECT_EQ(row.shape, SectionShape::chs);
    EXPECT_EQ(row.standard, "EN 10210-2");
    EXPECT_GE(row.W_el_y, 2900e-6);
    EXPECT_GE(row.height, 0.4999);
    EXPECT_LE(row.height, 0.6101);
    EXPECT_GE(row.mass_per_length, last);
    last = row.mass_per_length;
  }
  std::vector<SectionRow> mixed = sections();
  std::reverse(mixed.begin(), mixed.end());
  const auto again = sections_by_mass(filter, mixed);
  ASSERT_EQ(rows.size(), again.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].name, again[i].name);

  SectionFilter trusted;
  trusted.min_trust = Trust::derived;
  for (const SectionRow& row : select_sections(trusted)) EXPECT_NE(row.trust, Trust::unverified) << row.name;
}

}  // namespace taut::catalogue::section_search_test
