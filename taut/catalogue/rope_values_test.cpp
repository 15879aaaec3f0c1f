#include "taut/catalogue/rope_values.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"

namespace taut::catalogue::rope_values_test {

/// 6x36-IWRC of 20 mm and 1960 MPa: 1.636 kg/m, 279.1 kN, 184 mm2.
std::vector<ValueDoubt> doubts(const OwnValues& own) {
  const std::string id = "EN 12385-4|6x36-IWRC|20|1960";
  return doubts_of({.name = "sky", .row = *find_rope(id), .id = id, .mend = "look at the unit"}, own);
}

TEST(RopeValues, AFactorOfOneAndAHalfIsAnotherRope) {
  const RopeRow row = *find_rope("EN 12385-4|6x36-IWRC|20|1960");
  EXPECT_TRUE(doubts({}).empty());
  for (const double factor : {1 / 1.49, 1.0, 1.49}) {
    EXPECT_TRUE(doubts({.mass = factor * row.mass_per_length,
                        .diameter = factor * row.diameter,
                        .breaking_force = factor * row.breaking_force,
                        .stiffness = 0})
                    .empty())
        << factor;
  }
  EXPECT_TRUE(doubts({.mass = 1.51 * row.mass_per_length}).at(0).unsafe);
  EXPECT_TRUE(doubts({.mass = row.mass_per_length / 1.51}).at(0).unsafe);
  EXPECT_TRUE(doubts({.diameter = row.diameter / 1.51}).at(0).unsafe);
  EXPECT_TRUE(doubts({.breaking_force = 1.51 * row.breaking_force}).at(0).unsafe);
  EXPECT_FALSE(doubts({.breaking_force = row.breaking_force / 1.51}).at(0).unsafe) << "on the safe side";
}

// 184 mm2 of 0.6 x 95 GPa when new, and of 206 GPa, that of the wires: 10.49 and 37.9 MN.
TEST(RopeValues, TheStiffnessIsThatOfARopeBetweenNewAndItsWires) {
  EXPECT_EQ(doubts({.stiffness = 10.4e6}).size(), 1U);
  EXPECT_TRUE(doubts({.stiffness = 10.6e6}).empty());
  EXPECT_TRUE(doubts({.stiffness = 37.8e6}).empty());
  EXPECT_EQ(doubts({.stiffness = 38.0e6}).size(), 1U);
  EXPECT_TRUE(doubts({.stiffness = std::numeric_limits<double>::infinity()}).empty());
}

TEST(RopeValues, NoSteelRopeIsStrainedByMoreThanTwoPercent) {
  EXPECT_FALSE(doubt_of_strain("sky", 19.9e3, 1e6, Display()));
  EXPECT_TRUE(doubt_of_strain("sky", 20.1e3, 1e6, Display()));
  const auto words =
      doubt_of_strain("sky", 50e3, 1e6, Display(std::map<std::string, std::string>{{"force", "kgf"}}));  // 50e3/9.80665
  ASSERT_TRUE(words);
  EXPECT_NE(words->find("5099 kgf, strains it by 5 % at a stiffness of 101972 kgf"), std::string::npos) << *words;
  EXPECT_FALSE(doubt_of_strain("sky", 20e3, std::numeric_limits<double>::infinity(), Display()));
}

/// 6x36-IWRC of 12 mm and 1960 MPa breaks at 100.5 kN.
TEST(RopeValues, ARopeAboveItsBreakingForceFailsAndBelowItIsNotJudgedByThat) {
  const RopeRow rope = *find_rope_in_words("6x36-IWRC 12 mm 1960 MPa");
  const Check broken = breaking_check("return rope", rope, 101e3), holds = breaking_check("return rope", rope, 100e3);
  EXPECT_EQ(broken.name, "return rope does not break");
  EXPECT_FALSE(broken.passes);
  EXPECT_TRUE(holds.passes);
  EXPECT_EQ(holds.limit, rope.breaking_force);
  EXPECT_FALSE(judges(holds, "return rope"));
  Result r;
  r.checks = {holds};
  EXPECT_EQ(verdict_of(r)->verdict_class, "unasked");
  r.checks = {broken};
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
}

}  // namespace taut::catalogue::rope_values_test
