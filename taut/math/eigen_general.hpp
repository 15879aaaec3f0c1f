#pragma once
#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

namespace taut {

/// Eigenvalues mu and eigenvectors (columns) of a square matrix that need not be symmetric, |mu| falling.
struct GeneralEigen {
  std::vector<std::complex<double>> values;
  Eigen::MatrixXcd vectors;
};

/// Those of (F - shift E)^-1 E: with F y = lambda E y the eigenvalues are 1/(lambda - shift), so those nearest to the
/// shift come first and infinite ones (E singular) last, as 0. Empty where shift itself is an eigenvalue, or where the
/// iteration fails.
std::optional<GeneralEigen> shifted_eigen(const Eigen::MatrixXd& F, const Eigen::MatrixXd& E, double shift);

/// A^-1 B; empty where A is singular to rounding.
std::optional<Eigen::MatrixXd> solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace taut
