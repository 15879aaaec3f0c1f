#include "taut/math/static_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace {

using taut::StaticLu;

/// Random cliques, a matrix with a strong diagonal: against a dense solution.
TEST(StaticLu, SolvesWhatADenseEliminationSolves) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int round = 0; round < 50; ++round) {
    const int n = 1 + static_cast<int>(random() % 30);
    taut::Array<taut::Array<int>> cliques;
    for (int c = 0; c < n; ++c) {
      std::vector<int> clique;
      clique.reserve(4);
      for (int k = 0; k < 4; ++k) clique.push_back(static_cast<int>(random() % static_cast<unsigned>(n)));
      std::sort(clique.begin(), clique.end());
      clique.erase(std::unique(clique.begin(), clique.end()), clique.end());
      cliques.push_back(clique);
    }
    StaticLu lu(n, cliques);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (const auto& clique : cliques) {
      for (const int i : clique) {
        for (const int j : clique) {
          const double x = value(random) + (i == j ? 12 : 0);
          lu.values()[static_cast<std::size_t>(lu.place(i, j))] += x;
          dense(i, j) += x;
        }
      }
    }
    for (int i = 0; i < n; ++i) {
      lu.values()[static_cast<std::size_t>(lu.place(i, i))] += 5;
      dense(i, i) += 5;
    }
    taut::Array<double> x(static_cast<std::size_t>(n));
    for (double& one : x) one = value(random);
    const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(x.data(), n);
    ASSERT_TRUE(lu.factor());
    lu.solve(x);
    const Eigen::VectorXd expected = dense.partialPivLu().solve(right);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], expected[i], 1e-13);
  }
}

TEST(StaticLu, TellsAZeroPivot) {
  StaticLu lu(2, {{0, 1}});
  EXPECT_FALSE(lu.factor());
}

}  // namespace
