#include "taut/chance/inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/chance/point_set.hpp"

namespace taut::chance::inputs_test {

/// Independent inputs: the median at 1/2, and each by its own law.
TEST(Inputs, values_at_a_point_of_the_unit_cube) {
  const Inputs in{.of = {{.law = Normal{.mean = 5, .sd = 2}}, {.law = Uniform{.low = -1, .high = 3}}}};
  const Point middle = values_at(in, {0.5, 0.5});
  EXPECT_NEAR(middle[0], 5, 1e-12);
  EXPECT_NEAR(middle[1], 1, 1e-12);
  // Phi(1) = 0.841344746068543, Phi(-2) = 0.0227501319481792
  const Point x = values_at(in, {0.841344746068543, 0.0227501319481792});
  EXPECT_NEAR(x[0], 7, 1e-12);
  EXPECT_NEAR(x[1], -1 + 4 * 0.0227501319481792, 1e-12);
  const Point u = scores_of(in, x);
  EXPECT_NEAR(u[0], 1, 1e-12);
  EXPECT_NEAR(u[1], -2, 1e-11);
}

/// z = L u with L = (1, 0; r, sqrt(1 - r^2)).
TEST(Inputs, scores_of_correlated_inputs) {
  Inputs in{.of = {{.law = Normal{.mean = 10, .sd = 3}}, {.law = Normal{.mean = -4, .sd = 0.5}}}};
  in.correlation = *correlation(std::vector<CorrelatedPair>{{.first = 0, .second = 1, .r = -0.28}},
                                std::vector<std::string>{"a", "b"});
  const Point x = values_at_scores(in, {1, 2});
  EXPECT_NEAR(x[0], 13, 1e-12);
  EXPECT_NEAR(x[1], -4 + 0.5 * (-0.28 + 0.96 * 2), 1e-12);
}

// The scores of a sample have the correlation asked for; the values keep their own laws.
TEST(Inputs, sample_is_correlated) {
  Inputs in{.of = {{.law = Lognormal{.mean = 400, .sd = 160}}, {.law = Gumbel{.mode = 1, .scale = 0.2}}}};
  in.correlation = *correlation(std::vector<CorrelatedPair>{{.first = 0, .second = 1, .r = 0.6}},
                                std::vector<std::string>{"a", "b"});
  const PointSet points(PointKind::sobol, 2, 16384, 3);
  double product = 0;
  double first = 0;
  for (std::uint64_t k = 0; k < points.size(); ++k) {
    const Point x = values_at(in, points.at(k));
    product += score_of(in.of[0], x[0]) * score_of(in.of[1], x[1]);
    first += x[0];
  }
  EXPECT_NEAR(product / static_cast<double>(points.size()), 0.6, 5e-3);
  EXPECT_NEAR(first / static_cast<double>(points.size()), 400, 0.5);
  const Point u{1.3, -2};
  const Point back = scores_of(in, values_at_scores(in, u));
  EXPECT_NEAR(back[0], 1.3, 1e-12);
  EXPECT_NEAR(back[1], -2, 1e-12);
}

}  // namespace taut::chance::inputs_test
