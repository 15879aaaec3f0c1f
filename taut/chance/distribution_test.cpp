#include "taut/chance/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/chance/standard_laws.hpp"

namespace taut::chance::distribution_test {

const std::vector<Distribution> all{{.law = Normal{.mean = 20, .sd = 1.2}},
                                    {.law = Lognormal{.mean = 400, .sd = 16}},
                                    {.law = Uniform{.low = -1, .high = 3}},
                                    {.law = Gumbel{.mode = 1.05, .scale = 0.03}},
                                    {.law = Weibull{.shape = 1.7, .scale = 3, .shift = 0.5}},
                                    {.law = Weibull{.shape = 0.8, .scale = 3}},
                                    {.law = Triangular{.low = 1, .mode = 2, .high = 5}},
                                    {.law = Triangular{.low = 1, .mode = 1, .high = 5}},
                                    {.law = Triangular{.low = 1, .mode = 5, .high = 5}},
                                    {.law = Normal{.mean = 20, .sd = 1.2}, .from = 18, .to = 25},
                                    {.law = Normal{.mean = 0, .sd = 1}, .from = 3, .to = {}},
                                    {.law = Normal{.mean = 0, .sd = 1}, .from = {}, .to = -3},
                                    {.law = Gumbel{.mode = 1.5, .scale = 0.2}, .from = 1, .to = 2.5},
                                    {.law = Weibull{.shape = 1.7, .scale = 3}, .from = {}, .to = 4}};

TEST(Distribution, score_and_value_are_inverse) {
  for (const Distribution& d : all) {
    ASSERT_EQ(mistake(d), "");
    for (const double z : {-6., -3., -1., -0.1, 0., 0.4, 2., 5.}) {
      const double x = value_at_score(d, z);
      const double width = sd(d);
      // a score is as good as the distance of neighbouring doubles lets it be
      const double slack = 1e-9 + 4e-16 * (std::abs(x) + width) * density(d, x) / normal_density(z);
      EXPECT_NEAR(score_of(d, x), z, slack) << law_name(d.law) << ' ' << z;
      EXPECT_NEAR(below(d, x) + above(d, x), 1, 1e-14);
      EXPECT_NEAR(value_at(d, normal_below(z)), x, 1e-7 * width) << law_name(d.law) << ' ' << z;
    }
  }
}

// The density is the slope of the chance, and mean and sd are its moments: two ways each, by sums over x.
TEST(Distribution, density_and_moments) {
  for (const Distribution& d : all) {
    const double low = value_at_score(d, -8);
    const double high = value_at_score(d, 8);
    constexpr int steps = 40000;
    double first = 0;
    double second = 0;
    for (int k = 0; k < steps; ++k) {
      const double a = low + (high - low) * k / steps;
      const double b = low + (high - low) * (k + 1) / steps;
      const double chance = above(d, a) - above(d, b);
      first += chance * (a + b) / 2;
      second += chance * (a * a + a * b + b * b) / 3;
      if (k % 1999 == 1000) {
        EXPECT_NEAR(density(d, (a + b) / 2) * (b - a), chance, 2e-5 * chance + 1e-15) << law_name(d.law);
      }
    }
    const double width = sd(d);
    EXPECT_NEAR(first, mean(d), 1e-5 * width) << law_name(d.law);
    EXPECT_NEAR(std::sqrt(second - first * first), width, 1e-4 * width) << law_name(d.law);
  }
}

TEST(Distribution, tails_keep_their_digits) {
  const Distribution gumbel{.law = Gumbel{.mode = 1, .scale = 0.1}};
  const double far = 1 + 0.1 * 27.631021115928547;  // above = 1e-12 (1 - 5e-13)
  EXPECT_NEAR(above(gumbel, far) / 1e-12, 1, 1e-9);
  EXPECT_NEAR(value_at_score(gumbel, normal_score_above(1e-12)), far, 1e-9);
  EXPECT_NEAR(below(gumbel, 1 - 0.1 * std::log(27.631021115928547)) / 1e-12, 1, 1e-9);
  EXPECT_NEAR(above({Normal{5, 2}}, 19) / 1.279812543885835e-12, 1, 1e-12);
  // what is cut off far out in a tail: P(X > 8 | X > 7.9)
  EXPECT_NEAR(above({Normal{0, 1}, 7.9, {}}, 8), normal_above(8) / normal_above(7.9), 1e-12);
}

TEST(Distribution, closed_forms) {
  EXPECT_NEAR(mean({Gumbel{1.05, 0.03}}), 1.05 + 0.03 * 0.5772156649, 1e-10);
  EXPECT_NEAR(sd({Gumbel{1.05, 0.03}}), 0.03 * 1.2825498302, 1e-10);
  EXPECT_NEAR(mean({Weibull{1, 3, 0.5}}), 3.5, 1e-14);
  EXPECT_NEAR(value_at({Lognormal{400, 16}}, 0.5), 400 / std::sqrt(1 + 0.04 * 0.04), 1e-10);
  // a normal cut at one sd on both sides keeps the variance 1 - 2 phi(1)/(Phi(1) - Phi(-1))
  EXPECT_NEAR(sd({Normal{0, 1}, -1, 1}), std::sqrt(1 - 2 * normal_density(1) / (1 - 2 * normal_above(1))), 1e-9);
  EXPECT_EQ(value_at_score({Normal{20, 1.2}, 18, 25}, 40), 25);
  EXPECT_EQ(below({Normal{20, 1.2}, 18, 25}, 17), 0);
  EXPECT_EQ(density({Normal{20, 1.2}, 18, 25}, 26), 0);
}

TEST(Distribution, list) {
  const Distribution d{.law = Listed{.values = {3, 1, 2}, .weights = {1, 2, 1}}};
  EXPECT_EQ(mistake(d), "");
  EXPECT_EQ(value_at(d, 0), 1);
  EXPECT_EQ(value_at(d, 0.5), 1);
  EXPECT_EQ(value_at(d, 0.51), 2);
  EXPECT_EQ(value_at(d, 0.76), 3);
  EXPECT_EQ(value_at_score(d, 8), 3);
  EXPECT_EQ(below(d, 2), 0.75);
  EXPECT_EQ(above(d, 2), 0.25);
  EXPECT_EQ(mean(d), 1.75);
  EXPECT_NEAR(sd(d), std::sqrt(0.6875), 1e-15);
  EXPECT_FALSE(continuous(d));
  EXPECT_EQ(value_at({Listed{{1, 2, 3}, {1, 1, 0}}}, 1), 2);
}

TEST(Distribution, mistakes_are_named) {
  EXPECT_EQ(mistake({Normal{1, 0}}), "sd must be above 0, not 0");
  EXPECT_EQ(mistake({Lognormal{-1, 1}}), "mean must be above 0, not -1");
  EXPECT_EQ(mistake({Gumbel{1, -2}}), "scale must be above 0, not -2");
  EXPECT_EQ(mistake({Uniform{2, 1}}), "low (2) must be below high (1)");
  EXPECT_NE(mistake({Triangular{1, 6, 5}}), "");
  EXPECT_NE(mistake({Listed{}}), "");
  EXPECT_NE(mistake({Listed{{1, 2}, {1}}}), "");
  EXPECT_NE(mistake({Listed{{1, 2}, {0, 0}}}), "");
  EXPECT_NE(mistake({Normal{std::nan(""), 1}}), "");
  EXPECT_EQ(mistake({Normal{0, 1}, 3, 2}), "truncated from 3 to 2: the first must be below the second");
  EXPECT_EQ(mistake({Uniform{0, 1}, 3, 4}), "nothing of the distribution lies from 3 to 4");
  EXPECT_NE(mistake({Listed{{1}}, 0, 2}), "");
  EXPECT_STREQ(law_name(Law(Gumbel{})), "gumbel");
  EXPECT_STREQ(law_name(Law(Listed{})), "list");
}

}  // namespace taut::chance::distribution_test
