#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "taut/checks/rope/rope_life.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::rope_discard_test {

using taut_test::cell;
using taut_test::row_of;
using taut_test::text_cell;
using testing::HasSubstr;

Table discard(const std::string& construction, const std::string& core, const std::string& group, int layers = 1) {
  rope::RopeUse use;
  use.name = "hoist";
  use.rope.construction = construction;
  use.rope.core = core;
  use.rope.diameter = 16e-3;
  use.drums = {
      {.name = "winch", .tension = 1e3, .fleet_angle = {}, .layers = layers, .first_radius = {}, .last_radius = {}}};
  Result r;
  add_discard(group, use, r);
  return r.tables.at(0);
}

// ISO 4309 as recalled: 216 wires in the outer strands are of the category 201 to 220.
TEST(RopeDiscard, broken_wires_by_length_lay_and_class) {
  const Table t = discard("6x36WS", "IWRC", "M4");
  ASSERT_EQ(t.rows.size(), 10U);
  const double most[] = {9, 18, 4, 9};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(cell(t, i, "on_length"), (i % 2 == 0 ? 6 : 30) * 16e-3, 1e-12);
    EXPECT_EQ(cell(t, i, "broken_wires"), most[i]);
    EXPECT_THAT(text_cell(t, i, "trust"), HasSubstr("UNVERIFIED"));
  }
  EXPECT_THAT(text_cell(t, 0, "criterion"), HasSubstr("ordinary lay"));
  EXPECT_THAT(text_cell(t, 2, "criterion"), HasSubstr("lang lay"));
  EXPECT_EQ(cell(discard("6x36WS", "IWRC", "M5"), 0, "broken_wires"), 18);
  // twice only where it lies in layers: over the sheaves the lower number holds
  const Table layered = discard("6x36WS", "IWRC", "M4", 2);
  EXPECT_EQ(cell(layered, 1, "broken_wires"), 18);
  EXPECT_THAT(text_cell(layered, 1, "limit"), HasSubstr("36 on the part that lies in layers"));
  EXPECT_EQ(cell(discard("6x36WS", "IWRC", ""), 0, "broken_wires"), 9);
  const Table turns = discard("35x7", "WSC", "M3");
  EXPECT_EQ(cell(turns, 0, "broken_wires"), 4);
  EXPECT_EQ(cell(turns, 1, "broken_wires"), 8);
}

// Filler wires do not count, and Seale strands of 19 wires stand two rows up: 8x19S with 152 wires in the row of 114.
TEST(RopeDiscard, wires_that_bear_and_thick_ones) {
  for (const auto& [construction, on_6_d, on_30_d] :
       {std::tuple{"6x25F", 5, 10}, std::tuple{"6x25", 5, 10}, std::tuple{"8x25F", 6, 13}, std::tuple{"6x29F", 6, 11},
        std::tuple{"6x19S", 3, 6}, std::tuple{"6x19", 3, 6}, std::tuple{"6x19W", 5, 10}, std::tuple{"8x19S", 5, 10},
        std::tuple{"6x7", 2, 4}, std::tuple{"6x36", 9, 18}}) {
    const Table t = discard(construction, "IWRC", "M1");
    EXPECT_EQ(cell(t, 0, "broken_wires"), on_6_d) << construction;
    EXPECT_EQ(cell(t, 1, "broken_wires"), on_30_d) << construction;
  }
  EXPECT_THAT(text_cell(discard("6x25F", "IWRC", "M1"), 0, "limit"), HasSubstr("114 wires that bear"));
  EXPECT_THAT(text_cell(discard("6x19S", "IWRC", "M1"), 0, "limit"), HasSubstr("Seale: two rows up"));
}

TEST(RopeDiscard, lost_diameter_by_core) {
  const auto least = [](const Table& t) {
    return cell(t, row_of(t, "criterion", "diameter less than nominal"), "least_diameter");
  };
  EXPECT_NEAR(least(discard("6x36WS", "FC", "M4")), 14.4e-3, 1e-12);
  EXPECT_NEAR(least(discard("6x36WS", "IWRC", "M4")), 14.8e-3, 1e-12);
  EXPECT_NEAR(least(discard("6x36WS", "", "M4")), 14.8e-3, 1e-12);
  EXPECT_NEAR(least(discard("18x7", "WSC", "M4")), 15.2e-3, 1e-12);
}

TEST(RopeDiscard, an_unknown_rope_is_told) {
  rope::RopeUse use;
  use.name = "hoist";
  Result r;
  add_discard("", use, r);
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_EQ(r.tables.at(0).rows.size(), 6U);  // what needs no number, and the diameter's share
}

// As recalled: RCN 13 gives 0.04 n and 0.08 n above 300 wires, half of it in lang lay; RCN 21 and 22 are of 4 strands.
TEST(RopeDiscard, many_wires_and_few_strands) {
  const Table many = discard("8x41WS", "IWRC", "M1");
  const double most[] = {13, 26, 6, 13};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cell(many, i, "broken_wires"), most[i]) << i;
  const Table few = discard("4x36WS", "FC", "M1");
  EXPECT_EQ(cell(few, 0, "broken_wires"), 2);
  EXPECT_EQ(cell(few, 1, "broken_wires"), 4);
  EXPECT_THAT(text_cell(few, 0, "criterion"), HasSubstr("rotation-resistant"));
}

}  // namespace taut::checks::rope_discard_test
