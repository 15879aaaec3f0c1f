#include "taut/chance/correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::chance::correlation_test {

const std::vector<std::string> names{"a", "b", "c"};

std::string refusal(const std::vector<CorrelatedPair>& pairs) {
  const auto c = correlation(pairs, names);
  return c ? std::string() : c.error();
}

TEST(Correlation, factor_gives_the_matrix) {
  const auto c = correlation(
      std::vector<CorrelatedPair>{{.first = 0, .second = 1, .r = 0.5}, {.first = 2, .second = 1, .r = -0.3}}, names);
  ASSERT_TRUE(c);
  const double R[3][3] = {{1, 0.5, 0}, {0.5, 1, -0.3}, {0, -0.3, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += c->lower[3 * i + k] * c->lower[3 * j + k];
      EXPECT_NEAR(sum, R[i][j], 1e-15);
    }
  }
  const std::vector<double> u{0.3, -1.2, 2};
  const std::vector<double> back = uncorrelated(*c, correlated(*c, u));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], u[i], 1e-15);
  // v.u = (L^-T v).(L u)
  const std::vector<double> v{1, 2, -1};
  const auto w = gradient_by_scores(*c, v);
  const auto z = correlated(*c, u);
  EXPECT_NEAR(w[0] * z[0] + w[1] * z[1] + w[2] * z[2], v[0] * u[0] + v[1] * u[1] + v[2] * u[2], 1e-14);
}

TEST(Correlation, none_is_independent) {
  EXPECT_TRUE(independent(*correlation({}, names)));
  EXPECT_TRUE(independent(*correlation(std::vector<CorrelatedPair>{{0, 1, 0}}, names)));
  EXPECT_EQ(correlated({}, {1, 2}), (std::vector<double>{1, 2}));
}

TEST(Correlation, mistakes_are_named) {
  EXPECT_EQ(refusal({{1, 1, 0.5}}), "'b' is correlated with itself: name two inputs");
  EXPECT_EQ(refusal({{0, 1, 1}}), "the correlation of 'a' and 'b' (r = 1) must lie between -1 and 1");
  EXPECT_EQ(refusal({{0, 1, 0.5}, {1, 0, 0.4}}), "the correlation of 'b' and 'a' (r = 0.4) is given twice");
  // a with b, b with c, but a against c: r = 0.9, 0.9, -0.9 has the least eigenvalue 1 - 2 0.9
  const std::string text = refusal(
      {{.first = 0, .second = 1, .r = 0.9}, {.first = 1, .second = 2, .r = 0.9}, {.first = 0, .second = 2, .r = -0.9}});
  EXPECT_NE(text.find("'a' and 'b' (r = 0.9)"), std::string::npos) << text;
  EXPECT_NE(text.find("'a' and 'c' (r = -0.9)"), std::string::npos) << text;
  EXPECT_NE(text.find("least eigenvalue -0.8"), std::string::npos) << text;
  EXPECT_NE(text.find("less than 0.556"), std::string::npos) << text;
  const double s = 0.55 / 0.9;
  EXPECT_EQ(refusal({{0, 1, 0.9 * s}, {1, 2, 0.9 * s}, {0, 2, -0.9 * s}}).empty(), 1.8 * s < 1);
  EXPECT_EQ(refusal({{0, 1, 0.499}, {1, 2, 0.499}, {0, 2, -0.499}}), "");
}

}  // namespace taut::chance::correlation_test
