#pragma once
#include <Eigen/Core>

namespace taut {

/// Eigenvalues of a symmetric matrix, rising, and their unit eigenvectors as columns, each with its component of
/// largest magnitude positive, so that the sign says nothing about the order of operations.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// A is square, of finite entries; its lower triangle is read. Size 0 gives empty results.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

}  // namespace taut
