#include "taut/math/dense_lu.hpp"

#include <gtest/gtest.h>

namespace taut::dense_lu_test {

TEST(DenseLu, SolvesInvertsAndTellsSingular) {
  Eigen::MatrixXd A(3, 3);
  A << 0, 2, 1, 1, 1, 1, 4, 0, -1;  // zero where the first pivot would be
  const DenseLu lu(A);
  const Eigen::VectorXd x = lu.solve(Eigen::Vector3d(7, 6, 1));
  EXPECT_LT((x - Eigen::Vector3d(1, 2, 3)).norm(), 1e-14);
  EXPECT_LT((A * lu.solve_columns(Eigen::MatrixXd::Identity(3, 3)) - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-14);
  EXPECT_GT(lu.pivot_ratio(), 0.1);

  A.row(2) = A.row(0) + A.row(1);
  const DenseLu singular(A);
  EXPECT_LT(singular.pivot_ratio(), 1e-15);
}

}  // namespace taut::dense_lu_test
