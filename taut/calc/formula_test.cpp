#include "taut/calc/formula.hpp"

#include <gtest/gtest.h>

#include "taut/calc/num.hpp"

namespace taut::formula_test {

const Num a = Num::named("a", si::one, 2);
const Num b = Num::named("b", si::one, -3);
const Num c = Num::named("c", si::one, 4);

TEST(Formula, WritesParenthesesOnlyWhereTheyMatter) {
  EXPECT_EQ(formula_text((a + b * c).formula()), "a + b*c");
  EXPECT_EQ(formula_text(((a + b) * c).formula()), "(a + b)*c");
  EXPECT_EQ(formula_text((a - (b - c)).formula()), "a - (b - c)");
  EXPECT_EQ(formula_text((a / (b * c)).formula()), "a/(b*c)");
  EXPECT_EQ(formula_text((a / b / c).formula()), "a/b/c");
  EXPECT_EQ(formula_text((a * (b / c)).formula()), "a*(b/c)");
  EXPECT_EQ(formula_text((-(a + b)).formula()), "-(a + b)");
  EXPECT_EQ(formula_text((a - -b).formula()), "a - (-b)");
  EXPECT_EQ(formula_text(pow(a + b, 2).formula()), "(a + b)^2");
  EXPECT_EQ(formula_text(pow(pow(a, 2), 3).formula()), "(a^2)^3");
  EXPECT_EQ(formula_text(exp(-a * b).formula()), "exp(-a*b)");
  EXPECT_EQ(formula_text(atan2(a, b).formula()), "atan2(a, b)");
}

TEST(Formula, PutsNumbersInWithNegativeOnesInParentheses) {
  EXPECT_EQ(numbers_text((a * b + c).formula()), "2*(-3) + 4");
  EXPECT_EQ(numbers_text(pow(b, 2).formula()), "(-3)^2");
  EXPECT_EQ(numbers_text((a - b).formula()), "2 - (-3)");
  EXPECT_EQ(numbers_text((1.27 * a).formula()), "1.27*2");
}

TEST(Formula, EmptyOneIsAnEmptyText) {
  EXPECT_EQ(formula_text({}), "");
  EXPECT_EQ(numbers_text({}), "");
}

TEST(Formula, NumbersHaveSixDigits) {
  EXPECT_EQ(number_text(138864.558), "138865");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0), "-0");
}

}  // namespace taut::formula_test
