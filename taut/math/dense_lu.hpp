#pragma once
#include <Eigen/Core>
#include <Eigen/LU>

namespace taut {

/// LU factors with row pivoting of a dense square matrix. Eigen's, compiled once for the whole library: every file that
/// asks Eigen for them itself takes some seconds longer to compile.
class DenseLu {
 public:
  DenseLu() = default;
  explicit DenseLu(const Eigen::MatrixXd& A) { factor(A); }
  /// A of any size, of finite entries; the storage of the factors before is used again.
  void factor(const Eigen::MatrixXd& A);
  /// The smallest pivot by the largest: 0 (to rounding) where A is singular.
  double pivot_ratio() const;
  /// 1 or -1, the sign of the determinant of A; 0 where a pivot is exactly 0.
  int determinant_sign() const;
  /// A^-1 b; not finite where A is singular.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// The same for each column of B.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace taut
