#include "taut/calc/shown.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::shown_test {

TEST(Shown, OnlyADifferenceThatIsSeenCounts) {
  EXPECT_TRUE(shown_below(1.2345, 1.2346));
  EXPECT_FALSE(shown_below(1.2346, 1.2345));
  EXPECT_FALSE(shown_below(162638.979, 162638.981));
  EXPECT_FALSE(shown_below(1.23451, 1.23454));
  EXPECT_TRUE(shown_below(-2, 1));
  EXPECT_FALSE(shown_below(std::nan(""), 1));
  EXPECT_FALSE(shown_below(1, std::nan("")));
  EXPECT_FALSE(shown_below(3, 3));
}

// "fails 5.509 >= 5.509" tells nobody why.
TEST(Shown, AFailingValueReadsOtherThanItsLimit) {
  const Display display;
  Check c =
      make_check("factor", 5.50911, si::one, {.sense = Sense::at_least, .limit = 5.5092, .rule = "", .trust = ""});
  ASSERT_FALSE(c.passes);
  EXPECT_EQ(digits_apart(c, display, 4), 5);  // 5.5091 and 5.5092
  c.value = 5.4;
  EXPECT_EQ(digits_apart(c, display, 4), 4);
  c.value = std::nextafter(c.limit, 0);
  EXPECT_EQ(digits_apart(c, display, 4), 16);
  c.value = std::nan("");
  EXPECT_EQ(digits_apart(c, display, 4), 4);
  const Check passing =
      make_check("factor", 5.50921, si::one, {.sense = Sense::at_least, .limit = 5.5092, .rule = "", .trust = ""});
  EXPECT_EQ(digits_apart(passing, display, 4), 4);
}

TEST(Shown, TheUnitOfTheDeckElseTheUnitOfPrint) {
  Result r;
  r.display = {{"force", "N"}, {"length", "kN"}, {"nonsense", "m"}};
  const Display display = display_of(r);
  EXPECT_EQ(shown_unit(si::N, display).name, "N");
  EXPECT_EQ(shown_unit(si::m.in("mm"), display).name, "mm") << "a unit that does not fit is left out";
  EXPECT_DOUBLE_EQ(shown_unit(si::m.in("mm"), display).of(0.016), 16);
  EXPECT_EQ(shown_unit(si::one, display).name, "");
}

}  // namespace taut::shown_test
