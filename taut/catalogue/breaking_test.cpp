#include "taut/catalogue/breaking.hpp"

#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/rope_words.hpp"

namespace taut::catalogue::breaking_test {

/// 6x36-IWRC of 12 mm and 1960 MPa breaks at 100.5 kN.
TEST(Breaking, ARopeAboveItsBreakingForceFailsAndBelowItIsNotJudgedByThat) {
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

}  // namespace taut::catalogue::breaking_test
