#include "taut/math/eigen_symmetric.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::eigen_symmetric_test {

// 2 on the diagonal and -1 beside it: the eigenvalues are 2 - 2 cos(k pi/(n + 1)).
TEST(EigenSymmetric, chain) {
  constexpr int n = 6;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    A(i, i) = 2;
    if (i > 0) A(i, i - 1) = A(i - 1, i) = -1;
  }
  const SymmetricEigen e = symmetric_eigen(A);
  for (int k = 0; k < n; ++k) {
    EXPECT_NEAR(e.values[k], 2 - 2 * std::cos((k + 1) * std::acos(-1) / (n + 1)), 1e-14);
    EXPECT_NEAR((A * e.vectors.col(k) - e.values[k] * e.vectors.col(k)).norm(), 0, 1e-14);
    EXPECT_EQ(e.vectors.col(k).maxCoeff(), e.vectors.col(k).cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(symmetric_eigen({}).values.size(), 0);
}

}  // namespace taut::eigen_symmetric_test
