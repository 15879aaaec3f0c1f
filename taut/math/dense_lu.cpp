#include "taut/math/dense_lu.hpp"

#include "taut/base/expects.hpp"

namespace taut {

void DenseLu::factor(const Eigen::MatrixXd& A) {
  expects(A.rows() == A.cols(), "a square matrix");
  factors_.compute(A);
}

double DenseLu::pivot_ratio() const {
  const auto pivots = factors_.matrixLU().diagonal().cwiseAbs();
  return pivots.minCoeff() / pivots.maxCoeff();
}

int DenseLu::determinant_sign() const {
  double sign = factors_.permutationP().determinant() > 0 ? 1 : -1;
  for (const double pivot : factors_.matrixLU().diagonal()) sign *= pivot > 0 ? 1 : pivot < 0 ? -1 : 0;
  return static_cast<int>(sign);
}

Eigen::VectorXd DenseLu::solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

Eigen::MatrixXd DenseLu::solve_columns(const Eigen::MatrixXd& B) const { return factors_.solve(B); }

}  // namespace taut
