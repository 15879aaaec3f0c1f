#include "taut/catalogue/rope_factor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace taut::catalogue::rope_factor_test {

using testing::Contains;
using testing::HasSubstr;

// The metallic area C d^2 over the circle's pi d^2/4; a strand of steel weighs between 7.85 t/m3 and a fifth more for
// its grease and core.
TEST(RopeFactor, FactorsOfAClassAgreeWithEachOther) {
  ASSERT_FALSE(rope_factors().empty());
  std::set<std::string> names;
  for (const RopeFactorRow& row : rope_factors()) {
    const std::string name = row.construction + "-" + row.core;
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    EXPECT_NEAR(row.fill_factor, 4 * row.area_factor / std::numbers::pi, 2e-3) << name;
    EXPECT_LT(row.breaking_factor, row.area_factor) << name;
    EXPECT_GT(row.mass_factor, 0.98 * 7850 * row.area_factor) << name;
    EXPECT_LT(row.mass_factor, 1.25 * 7850 * row.area_factor) << name;
  }
}

// EN 12385-4, table of 6x36: K = 0.356 with a core of steel, 0.330 with one of fibre.
TEST(RopeFactor, AClassIsFoundByOneOfItsConstructions) {
  const auto steel = find_rope_factors("6x36WS", "IWRC");
  ASSERT_TRUE(steel) << steel.error().message;
  EXPECT_EQ(steel->construction, "6x36");
  EXPECT_EQ(steel->breaking_factor, 0.356);
  const auto fibre = find_rope_factors("6x36", "FC");
  ASSERT_TRUE(fibre) << fibre.error().message;
  EXPECT_EQ(fibre->breaking_factor, 0.330);
}

TEST(RopeFactor, AnUnknownClassIsToldWithItsNeighbours) {
  const auto found = find_rope_factors("6x37", "IWRC");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("no factors for a rope 6x37-IWRC; there are 6x7-FC"));
  EXPECT_THAT(found.error().candidates, Contains("6x36-IWRC"));
}

TEST(RopeFactor, ATableWithAFactorThatIsNotPositiveIsRefused) {
  const std::string head =
      "construction,core,standard,mass_factor_kg_per_100m_per_mm2,area_factor,breaking_factor,fill_factor,trust\n";
  const auto good = read_rope_factors(head + "6x7,FC,EN 12385-4,0.345,0.369,0.332,0.4698,verified\n", "own.csv");
  ASSERT_TRUE(good) << to_text(good.error());
  EXPECT_EQ(good->at(0).trust, Trust::verified);
  const auto bad = read_rope_factors(head + "6x7,FC,EN 12385-4,0.345,0.369,-0.332,0.4698,verified\n", "own.csv");
  ASSERT_FALSE(bad);
  EXPECT_THAT(to_text(bad.error()), HasSubstr("own.csv:2"));
}

}  // namespace taut::catalogue::rope_factor_test
