#include "taut/chance/standard_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace taut::chance::standard_laws_test {

// Printed values: Abramowitz & Stegun, tables 26.1, 26.8, 26.10.
TEST(StandardLaws, printed_values) {
  EXPECT_NEAR(normal_below(1), 0.841344746069, 1e-12);
  EXPECT_NEAR(normal_density(0), 0.398942280401, 1e-12);
  EXPECT_NEAR(normal_score(0.975), 1.959963984540, 1e-12);
  EXPECT_NEAR(student_value(0.975, 10), 2.228138852, 1e-8);
  EXPECT_NEAR(student_value(0.025, 10), -2.228138852, 1e-8);
  EXPECT_NEAR(student_value(0.975, 15), 2.131449546, 1e-8);
  EXPECT_EQ(student_value(0.5, 3), 0);
  EXPECT_NEAR(chi_squared_above(18.307038, 10), 0.05, 1e-8);
}

TEST(StandardLaws, tails_keep_their_digits) {
  EXPECT_NEAR(normal_above(7) / 1.279812543885835e-12, 1, 1e-12);
  EXPECT_EQ(normal_above(7), normal_below(-7));
  for (const double p : {1e-300, 1e-12, 0.3, 0.5}) {
    EXPECT_NEAR(normal_below(normal_score(p)) / p, 1, 1e-11);
    EXPECT_NEAR(normal_above(normal_score_above(p)) / p, 1, 1e-11);
  }
  EXPECT_EQ(normal_score(0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(normal_score_above(0), std::numeric_limits<double>::infinity());
}

// The binomial law is a sum of its terms; the beta law turns it round.
TEST(StandardLaws, binomial_and_beta) {
  double sum = 0;
  double term = std::pow(0.7, 12);
  for (int k = 0; k <= 4; ++k) {
    sum += term;
    term *= (12. - k) / (k + 1) * 0.3 / 0.7;
  }
  EXPECT_NEAR(binomial_below(4, 12, 0.3), sum, 1e-14);
  EXPECT_EQ(binomial_below(-1, 12, 0.3), 0);
  EXPECT_EQ(binomial_below(12, 12, 0.3), 1);
  EXPECT_NEAR(1 - binomial_below(4, 12, beta_value(0.1, 5, 8)), 0.1, 1e-12);
}

}  // namespace taut::chance::standard_laws_test
