#include "taut/catalogue/modulus.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/rope_search.hpp"

namespace modulus_test {

using namespace taut::catalogue;

TEST(RopeModulus, EveryRopeOfTheCatalogueHasOneOfItsConstruction) {
  for (const RopeRow& rope : ropes()) {
    const auto s = stiffness_of(rope);
    ASSERT_TRUE(s) << rope.id;
    EXPECT_EQ(s->EA, s->area * s->modulus) << rope.id;
    EXPECT_GE(s->modulus, s->low);
    EXPECT_LE(s->modulus, s->high);
    EXPECT_FALSE(at_least(s->trust, Trust::verified) && rope.area_trust != Trust::verified) << rope.id;
  }
}

TEST(RopeModulus, GoesByStrandsAndCore) {
  const auto rule = [](const char* construction, const char* core, const char* standard = "EN 12385-4") {
    RopeRow rope;
    rope.standard = standard;
    rope.construction = construction;
    rope.core = core;
    const auto found = modulus_rule(rope);
    return found ? found->id : std::string("none");
  };
  EXPECT_EQ(rule("6x36WS", "IWRC"), "modulus.6_strand_iwrc");
  EXPECT_EQ(rule("6x7", "WSC"), "modulus.6_strand_iwrc");
  EXPECT_EQ(rule("6x19(1+6+6/6)", "FC"), "modulus.6_strand_fc");
  EXPECT_EQ(rule("8x36", "FC"), "modulus.8_strand_fc");
  EXPECT_EQ(rule("8x19S", "IWRC"), "modulus.8_strand_iwrc");
  EXPECT_EQ(rule("18x7", "WSC"), "modulus.rotation_resistant");
  EXPECT_EQ(rule("35x7", ""), "modulus.rotation_resistant");
  EXPECT_EQ(rule("compacted", ""), "modulus.compacted");
  EXPECT_EQ(rule("compacted", "", "SEILAPLAN"), "modulus.skyline_planning");
  EXPECT_EQ(rule("6x36", ""), "none");
  EXPECT_EQ(rule("4x26", "FC"), "none");
  EXPECT_EQ(rule("braided", ""), "none");
}

TEST(RopeModulus, SaysWhereItsStiffnessComesFrom) {
  const auto rope = find_rope("EN 12385-4|6x36-IWRC|20|1960");
  ASSERT_TRUE(rope);
  const auto s = stiffness_of(*rope);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->EA, 0.46 * 0.02 * 0.02 * 107.5e9, 1e-3 * s->EA);
  EXPECT_EQ(to_text(*s),
            "EA = 19.78 MN from area 184 mm^2 x modulus 107.5 GPa (6x36-IWRC: modulus.6_strand_iwrc, 95 to 120 GPa, "
            "UNVERIFIED)");
}

}  // namespace modulus_test
