#include "taut/app/exact/rope_doubts.hpp"

#include <gtest/gtest.h>

namespace taut::app::rope_doubts_test {

/// 6x36-IWRC of 20 mm and 1960 MPa breaks at 279 kN and has some 18 MN.
MethodRope rope(std::optional<std::string> row, const catalogue::OwnValues& own, double tension) {
  return {.name = "guy", .rope = std::move(row), .own = own, .tension = tension};
}

Result told(const MethodRope& one) {
  Result r;
  warn_of_rope(one, Display(), r);
  return r;
}

TEST(RopeDoubts, ValuesThatNoRopeOfTheRowHasAreUnsafe) {
  const std::string row = "6x36-IWRC 20 mm 1960 MPa";
  EXPECT_TRUE(told(rope(row, {}, 50e3)).warnings.empty());
  EXPECT_EQ(told(rope(row, {.breaking_force = 3e6}, 50e3)).unsafe.size(), 1U);
  EXPECT_EQ(told(rope("no such rope", {.breaking_force = 3e6}, 50e3)).warnings.size(), 0U);
}

/// 50 kN stretch 1 MN by 5 %. Without a row it may be no steel rope.
TEST(RopeDoubts, AStrainThatNoSteelRopeBearsIsUnsafeWithARow) {
  const catalogue::OwnValues soft{.stiffness = 1e6};
  EXPECT_EQ(told(rope("6x36-IWRC 20 mm 1960 MPa", soft, 50e3)).unsafe.size(), 2U);  // too soft for it, and the strain
  const Result plain = told(rope(std::nullopt, soft, 50e3));
  EXPECT_EQ(plain.warnings.size(), 1U);
  EXPECT_TRUE(plain.unsafe.empty());
  EXPECT_TRUE(told(rope(std::nullopt, soft, 19e3)).warnings.empty());
}

/// A metallic area is one of wires, whoever gives it.
TEST(RopeDoubts, ARopeOfAMetallicAreaIsOfSteel) {
  MethodRope own = rope(std::nullopt, {.stiffness = 1e6}, 50e3);
  own.metal = true;
  own.stiffness_key = "rope_area";
  const Result r = told(own);
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_NE(r.unsafe[0].find("look at the unit of its 'rope_area'"), std::string::npos) << r.unsafe[0];
}

}  // namespace taut::app::rope_doubts_test
