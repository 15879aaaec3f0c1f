#include "taut/math/eigen_symmetric.hpp"

#include <Eigen/Eigenvalues>

#include "taut/base/expects.hpp"

namespace taut {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  expects(A.rows() == A.cols(), "eigenvalues belong to a square matrix");
  if (A.rows() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  expects(solver.info() == Eigen::Success, "eigenvalues of a symmetric matrix of finite entries");
  SymmetricEigen eigen{.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
  for (Eigen::Index k = 0; k < eigen.vectors.cols(); ++k) {
    Eigen::Index largest = 0;
    eigen.vectors.col(k).cwiseAbs().maxCoeff(&largest);
    if (eigen.vectors(largest, k) < 0) eigen.vectors.col(k) *= -1;
  }
  return eigen;
}

}  // namespace taut
