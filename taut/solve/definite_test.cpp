#include "taut/solve/definite.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numeric>

#include "test/support/dice.hpp"

namespace taut::solve::definite_test {

using taut_test::Dice;

/// L D L' with a banded unit L: by Sylvester's law of inertia its signs are those of D.
Eigen::MatrixXd with_inertia(Dice& dice, const Eigen::VectorXd& D, int band) {
  const auto n = static_cast<int>(D.size());
  Eigen::MatrixXd L = Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - band); j < i; ++j) L(i, j) = dice.in(-0.8, 0.8);
  }
  return L * D.asDiagonal() * L.transpose();
}

/// Any lower half.
SkylineMatrix full(int size) { return SkylineMatrix(Array<int>(static_cast<std::size_t>(size), 0)); }

/// Each row from its first entry on.
SkylineMatrix skyline(const Eigen::MatrixXd& A) {
  Array<int> first;
  for (int i = 0; i < A.rows(); ++i) {
    first.push_back(0);
    while (first.back() < i && A(i, first.back()) == 0) ++first.back();
  }
  SkylineMatrix s(first);
  for (int i = 0; i < A.rows(); ++i) {
    for (int j = first[static_cast<std::size_t>(i)]; j <= i; ++j) {
      s.add(i, j, 0.25 * A(i, j));  // in two parts, as elements do
      s.add(i, j, 0.75 * A(i, j));
    }
  }
  return s;
}

TEST(Definite, TheSignOfOneDirectionDecides) {
  Dice dice{std::mt19937(5)};
  for (int i = 0; i < 300; ++i) {
    const int n = 2 + dice.below(30), band = 1 + dice.below(6);
    Eigen::VectorXd D(n);
    for (int k = 0; k < n; ++k) D[k] = dice.ten_to(-2, 3);
    EXPECT_TRUE(skyline(with_inertia(dice, D, band)).definite());
    const int one = dice.below(n);
    D[one] = -dice.ten_to(-2, 3);
    EXPECT_FALSE(skyline(with_inertia(dice, D, band)).definite()) << "size " << n << ", row " << one;
  }
}

TEST(Definite, ItsFactorsSolve) {
  Dice dice{std::mt19937(7)};
  for (int i = 0; i < 100; ++i) {
    const int n = 2 + dice.below(30);
    Eigen::VectorXd D(n), x(n);
    for (int k = 0; k < n; ++k) D[k] = dice.ten_to(-2, 3), x[k] = dice.in(-1, 1);
    const Eigen::MatrixXd A = with_inertia(dice, D, 1 + dice.below(6));
    const Eigen::VectorXd b = A * x;
    Eigen::VectorXd found = b;
    skyline(A).factors()->solve(found);
    // to the rounding of the matrix, whose condition is up to 1e5 times the square of that of its unit factor
    EXPECT_LT((A * found - b).norm(), 1e-10 * A.norm() * x.norm()) << n;
  }
}

TEST(Definite, ADirectionWithoutStiffnessPasses) {
  SkylineMatrix chain = full(3);  // two springs between three free masses
  for (int k = 0; k < 2; ++k) {
    chain.add(k, k, 1e6);
    chain.add(k + 1, k + 1, 1e6);
    chain.add(k + 1, k, -1e6);
  }
  EXPECT_TRUE(chain.definite());
  chain.add(1, 1, -1);
  EXPECT_FALSE(chain.definite()) << "a little less and it leaves";
  SkylineMatrix coupled = full(2);  // nothing on the diagonal, but a coupling: a saddle
  coupled.add(1, 0, 1);
  EXPECT_FALSE(coupled.definite());
}

TEST(Definite, WhatIsNoNumberHoldsNothing) {
  for (const auto& [row, column] : {std::pair{0, 0}, {1, 0}, {1, 1}}) {
    SkylineMatrix two = full(2);
    two.add(0, 0, 2);
    two.add(1, 1, 2);
    two.add(row, column, std::nan(""));
    EXPECT_FALSE(two.definite()) << row << column;
  }
}

TEST(Condense, LeavesTheSchurComplement) {
  Dice dice{std::mt19937(9)};
  for (int i = 0; i < 100; ++i) {
    const int n = 3 + dice.below(12), count = 1 + dice.below(n - 2);
    Eigen::MatrixXd A(n, n);
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) A(r, c) = dice.in(-1, 1) * (r < count ? 1e5 : 1);
    }
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (int k = n - 1; k > 0; --k) {
      std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(dice.below(k + 1))]);
    }
    Eigen::MatrixXd B(n, n);
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) B(r, c) = A(order[static_cast<std::size_t>(r)], order[static_cast<std::size_t>(c)]);
    }
    const auto found = condense(A, order, count);
    ASSERT_TRUE(found);
    const Eigen::Index m = n - count;
    const Eigen::MatrixXd schur =
        B.bottomRightCorner(m, m) -
        B.bottomLeftCorner(m, count) * B.topLeftCorner(count, count).partialPivLu().solve(B.topRightCorner(count, m));
    EXPECT_LT((*found - schur).norm(), 1e-8 * (1 + schur.norm())) << n << " " << count;
  }
}

TEST(Condense, SaysWhatIsUndetermined) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(4, 4);
  A(1, 1) = 0;
  EXPECT_FALSE(condense(A, {0, 1, 2, 3}, 2));
  EXPECT_TRUE(condense(A, {0, 2, 1, 3}, 2)) << "it is not among those eliminated";
}

}  // namespace taut::solve::definite_test
