#include "taut/chance/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::chance::least_squares_test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Residuals batch_of(const std::function<VectorXd(const VectorXd&)>& r) {
  return [r](const std::vector<VectorXd>& points) {
    std::vector<VectorXd> rows;
    for (const VectorXd& t : points) rows.push_back(r(t));
    return rows;
  };
}

VectorXd vector(std::initializer_list<double> numbers) {
  VectorXd v(static_cast<Eigen::Index>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), v.begin());
  return v;
}

const MatrixXd A = (MatrixXd(3, 2) << 1, 2, 3, -1, 0.5, 1).finished();

/// Three equations, two unknowns: A^T A t = A^T b.
TEST(LeastSquares, of_a_line) {
  const VectorXd b = A * vector({0.3, 0.6}) + vector({0.05, -0.02, 0.01});
  const LeastSquares s =
      least_squares(batch_of([&](const VectorXd& t) { return VectorXd(A * t - b); }), vector({0.9, 0.1}), {});
  ASSERT_TRUE(s.converged) << s.reason;
  const VectorXd exact = (A.transpose() * A).ldlt().solve(A.transpose() * b);
  EXPECT_NEAR((s.t - exact).norm(), 0, 1e-6);
  EXPECT_NEAR((s.J - A).norm(), 0, 1e-9);
  EXPECT_NEAR((s.r - (A * s.t - b)).norm(), 0, 1e-12);
  EXPECT_EQ(s.held, (std::vector<int>{0, 0}));
}

/// The least value outside the cube: one unknown is held at its bound, the other one has the best value beside it.
TEST(LeastSquares, held_at_a_bound) {
  for (const bool high : {false, true}) {
    const VectorXd b = A * vector({high ? 1.4 : -0.4, 0.5});
    const LeastSquares s =
        least_squares(batch_of([&](const VectorXd& t) { return VectorXd(A * t - b); }), vector({0.5, 0.5}), {});
    ASSERT_TRUE(s.converged) << s.reason;
    const double at = high ? 1 : 0;
    EXPECT_EQ(s.t[0], at);
    // it ends where no step promises more than 1e-10 of the squares
    const double near = 1e-5 * s.r.norm() / A.col(1).norm();
    EXPECT_NEAR(s.t[1], A.col(1).dot(b - at * A.col(0)) / A.col(1).squaredNorm(), near);
    EXPECT_EQ(s.held, (std::vector<int>{high ? 1 : -1, 0}));
  }
}

/// Rosenbrock's valley: r = (10 (y - x^2), 1 - x) with x, y from -2 to 2.
TEST(LeastSquares, a_curved_valley) {
  const LeastSquares s = least_squares(batch_of([](const VectorXd& t) {
                                         const double x = 4 * t[0] - 2, y = 4 * t[1] - 2;
                                         return vector({10 * (y - x * x), 1 - x});
                                       }),
                                       vector({0.2, 0.75}), {});
  ASSERT_TRUE(s.converged) << s.reason;
  EXPECT_NEAR(4 * s.t[0] - 2, 1, 1e-4);
  EXPECT_NEAR(4 * s.t[1] - 2, 1, 2e-4);
}

TEST(LeastSquares, an_unknown_without_effect_stays) {
  const LeastSquares s =
      least_squares(batch_of([](const VectorXd& t) { return vector({t[0] - 0.25}); }), vector({0.8, 0.4}), {});
  ASSERT_TRUE(s.converged) << s.reason;
  EXPECT_NEAR(s.t[0], 0.25, 1e-8);
  EXPECT_EQ(s.t[1], 0.4);
}

TEST(LeastSquares, failed_cases) {
  const auto r = [](const VectorXd& t) { return vector({t[0] < 0.3 ? std::nan("") : t[0] * t[0] - 0.16}); };
  const LeastSquares beside = least_squares(batch_of(r), vector({0.95}), {});
  ASSERT_TRUE(beside.converged) << beside.reason;
  EXPECT_NEAR(beside.t[0], 0.4, 1e-6);
  const LeastSquares there = least_squares(batch_of(r), vector({0.1}), {});
  EXPECT_FALSE(there.converged);
  EXPECT_EQ(there.reason, "the case at the start failed");
}

TEST(LeastSquares, says_that_it_has_run_out_of_steps) {
  const LeastSquares s = least_squares(batch_of([](const VectorXd& t) { return vector({std::exp(3 * t[0]) - 2}); }),
                                       vector({1}), {.most_iterations = 1});
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(s.reason, "not converged after 1 steps");
}

}  // namespace taut::chance::least_squares_test
