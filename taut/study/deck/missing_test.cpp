#include "taut/study/deck/missing.hpp"

#include <gtest/gtest.h>

namespace taut::study::missing_test {

// Every place that is missing is named, those beside each other as one range.
TEST(Missing, AllPlacesAreNamed) {
  Missing missing;
  const Outcome no = infeasible("the rope does not reach");
  for (const double x : {10.0, 12.0, 14.0, 16.0, 18.0}) missing.take(x == 12 || x == 14 || x == 18 ? no : Outcome{}, x);
  Result r;
  missing.note(r, "payload, in", true);
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_EQ(r.warnings[0],
            "payload, in: no equilibrium at 3 of 5 places, x = 12 m to x = 14 m (2 states); x = 18 m; the first: the "
            "rope does not reach");
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].first, "x = 12 m");
}

TEST(Missing, OnePlaceHasItsOwnReason) {
  Missing missing;
  missing.take(infeasible("no room"), 10);
  missing.take(Outcome{}, 12);
  Result r;
  missing.note(r, "envelope", false);
  EXPECT_EQ(r.warnings[0], "envelope: no equilibrium at 1 of 2 places, x = 10 m: no room");
  EXPECT_TRUE(r.missing.empty());
}

}  // namespace taut::study::missing_test
