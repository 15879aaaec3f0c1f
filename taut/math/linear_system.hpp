#pragma once
#include <memory>

#include "taut/math/entries.hpp"

namespace taut {

/// One square system of linear equations for many right sides, right also where it is singular: LU factors with
/// pivoting, of the full matrix where it is small, else of the sparse one. The largest entry of each row is scaled
/// to 1.
class LinearSystem {
 public:
  LinearSystem();
  ~LinearSystem();
  LinearSystem(const LinearSystem&) = delete;
  LinearSystem& operator=(const LinearSystem&) = delete;

  /// Factors A S, S = diag(scale): `scale` holds the unit in which each unknown is counted.
  void factor(const Entries& A, const Eigen::VectorXd& scale);
  /// Whether a pivot is 0 to rounding, 1e-14 of the largest.
  bool singular() const;
  /// x in A S x = b. Where the matrix is singular: of those x that come nearest the shortest, which leaves alone what
  /// no row determines.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// How much of each unknown is in what no row determines, from 0 to 1; empty where all are determined. Of a sparse
  /// matrix it costs far more than a solution.
  Eigen::VectorXd undetermined() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace taut
