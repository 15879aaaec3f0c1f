#include "taut/catalogue/rope_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace taut::catalogue::rope_search_test {

using testing::HasSubstr;

TEST(RopeSearch, by_id) {
  const auto rope = find_rope("EN 12385-4|6x36-IWRC|16|1960");
  ASSERT_TRUE(rope);
  EXPECT_EQ(rope->diameter, 0.016);
  EXPECT_EQ(rope->grade, 1960e6);
  EXPECT_EQ(rope->breaking_force, 178600.0);  // 0.356 x 16^2 x 1960 N to four digits
  EXPECT_EQ(find_rope("en12385-4|6X36-iwrc|16|1960")->id, rope->id);
  EXPECT_EQ(find_rope("EN 12385-4|6\u00d736-IWRC|16|1960")->id, rope->id);
}

TEST(RopeSearch, an_unknown_id_suggests_its_neighbours) {
  const auto rope = find_rope("EN 12385-4|6x36-IWRC|16|1950");
  ASSERT_FALSE(rope);
  EXPECT_EQ(rope.error().candidates.front(), "EN 12385-4|6x36-IWRC|16|1960");
  EXPECT_THAT(to_text(rope.error()), HasSubstr("did you mean 'EN 12385-4|6x36-IWRC|16|1960'"));
  EXPECT_TRUE(find_rope("hemp").error().candidates.empty());
  EXPECT_FALSE(find_rope(""));
}

TEST(RopeSearch, every_row_is_found_by_its_id_and_by_its_properties) {
  for (std::size_t i = 0; i < ropes().size(); i += 7) {
    const RopeRow& row = ropes()[i];
    EXPECT_EQ(find_rope(row.id)->id, row.id);
    const auto rope = find_rope(RopeDescription{.construction = row.construction,
                                                .core = row.core,
                                                .diameter = row.diameter,
                                                .grade = row.grade,
                                                .standard = row.standard});
    ASSERT_TRUE(rope) << row.id << ": " << to_text(rope.error());
    EXPECT_EQ(rope->id, row.id);
  }
}

TEST(RopeSearch, by_properties) {
  EXPECT_EQ(find_rope({"6x36", "IWRC", 0.016, 1960e6, ""})->id, "EN 12385-4|6x36-IWRC|16|1960");
  EXPECT_EQ(find_rope({"6x36WS-IWRC", "", 0.016, 1960e6, ""})->id, "EN 12385-4|6x36-IWRC|16|1960");
  EXPECT_EQ(find_rope({"6x36", "FC", 0.020, 1770e6, "GOST"})->id, "GOST 7668-80|6x36(1+7+7/7+14)-FC|20|1770");
  EXPECT_EQ(find_rope({"compacted", "", 0.022, std::nullopt, ""})->id, "SEILAPLAN|compacted|22|-");
  // Both standards have it; the one that is called 6x36 goes first.
  EXPECT_EQ(find_rope({"6x36", "FC", 0.020, 1770e6, ""})->standard, "EN 12385-4");
}

TEST(RopeSearch, says_what_is_wrong_with_a_description) {
  const auto message = [](const RopeDescription& wanted) {
    const auto rope = find_rope(wanted);
    return rope ? "found " + rope->id : rope.error().message;
  };
  EXPECT_THAT(message({"6x37", "IWRC", 0.016, 1960e6, ""}),
              HasSubstr("no rope of construction '6x37'; there are 6x7, 6x19"));
  EXPECT_EQ(message({"6x36", "WSC", 0.016, 1960e6, ""}), "no 6x36 rope with core 'WSC'; the cores listed are FC, IWRC");
  EXPECT_EQ(message({"8x36", "FC", 0.016, 1770e6, "GOST"}), "no 8x36 rope to 'GOST'; 8x36 is listed to EN 12385-4");
  EXPECT_EQ(message({"6x36", "IWRC", 0.0165, 1960e6, ""}),
            "no 6x36 IWRC rope of 16.5 mm; the nearest are 16 mm, 18 mm, 19 mm, 14 mm");
  EXPECT_EQ(message({"6x36", "FC", 0.016, 2160e6, ""}),
            "no 6x36 FC rope of 16 mm in grade 2160 MPa; the grades listed are 1570 MPa, 1770 MPa, 1960 MPa");
  EXPECT_EQ(message({"6x36", "", 0.016, std::nullopt, ""}),
            "7 ropes are 6x36 of 16 mm: give the core (FC, IWRC), grade (1570 MPa, 1770 MPa, 1960 MPa, 2160 MPa)");
  EXPECT_EQ(message({"6x36WS", "FC", 0.020, 1770e6, ""}),
            "2 ropes are 6x36WS FC of 20 mm: give the standard (EN 12385-4, GOST 7668-80)");
  EXPECT_EQ(message({"", "", 0.016, 1960e6, ""}), "a rope needs its construction");
}

TEST(RopeSearch, filters) {
  RopeFilter filter;
  EXPECT_EQ(select_ropes(filter).size(), ropes().size());
  filter.construction = "6x36";
  filter.core = "IWRC";
  filter.grade = 1960e6;
  filter.min_breaking_force = 150e3;
  filter.max_diameter = 0.020;
  const auto rows = select_ropes(filter);
  ASSERT_FALSE(rows.empty());
  for (const RopeRow& row : rows) {
    EXPECT_EQ(row.construction, "6x36");
    EXPECT_EQ(row.core, "IWRC");
    EXPECT_EQ(row.grade, 1960e6);
    EXPECT_GE(row.breaking_force, 150e3);
    EXPECT_LE(row.diameter, 0.020);
  }
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const RopeRow& r) { return r.diameter == 0.020; }));

  RopeFilter trusted;
  trusted.min_trust = Trust::verified;
  for (const RopeRow& row : select_ropes(trusted)) EXPECT_EQ(row.trust, Trust::verified) << row.id;
  RopeFilter gost;
  gost.standard = "gost";
  EXPECT_EQ(select_ropes(gost).size(), 260U);
  RopeFilter steel_core;
  steel_core.construction = "6x36-IWRC";
  for (const RopeRow& row : select_ropes(steel_core)) EXPECT_EQ(row.core, "IWRC");
}

TEST(RopeSearch, smallest_first_whatever_the_order_of_the_table) {
  RopeFilter filter;
  filter.construction = "6x19";
  filter.min_area = 100e-6;
  std::vector<RopeRow> mixed = ropes();
  std::reverse(mixed.begin(), mixed.end());
  for (const RopeOrder order : {RopeOrder::breaking_force, RopeOrder::diameter, RopeOrder::area, RopeOrder::mass}) {
    const auto a = ropes_by(order, filter);
    const auto b = ropes_by(order, filter, mixed);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].id, b[i].id);
  }
  const auto rows = ropes_by(RopeOrder::area, filter);
  ASSERT_FALSE(rows.empty());
  EXPECT_GE(rows.front().area, 100e-6);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.area < b.area; }));
}

}  // namespace taut::catalogue::rope_search_test
