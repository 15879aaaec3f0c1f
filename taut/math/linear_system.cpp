#include "taut/math/linear_system.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseLU>
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/expects.hpp"
#include "taut/math/dense_lu.hpp"

namespace taut {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int most_dense = 128;  ///< rows: up to here the full matrix is quicker
constexpr double singular_below = 1e-14;
constexpr double rank_threshold = 1e-12;
constexpr double ridge =
    1e-8;  ///< of the largest entries: what a singular sparse matrix holds less than this is nothing

/// Eigen's factors, which tell their determinant and not their pivots.
class SparseFactors : public Eigen::SparseLU<Sparse, Eigen::COLAMDOrdering<int>> {
 public:
  /// The smallest pivot by the largest: 0 (to rounding) where the matrix is singular.
  double pivot_ratio() const {
    if (info() != Eigen::Success) return 0;
    double least = HUGE_VAL, most = 0;
    for (int column = 0; column < cols(); ++column) {
      for (SCMatrix::InnerIterator entry(m_Lstore, column); entry; ++entry) {
        if (entry.index() != column) continue;
        least = std::min(least, std::abs(entry.value()));
        most = std::max(most, std::abs(entry.value()));
        break;
      }
    }
    return least / most;
  }
};

using SparseOrthogonal = Eigen::SparseQR<Sparse, Eigen::COLAMDOrdering<int>>;

/// [d I, A; A', -d I]: its solution for the right side [b; 0] is the x of the least |A x - b|^2 + d^2 |x|^2, d the
/// ridge. Its factors have the cost of those of A, where an orthogonal decomposition of A takes the square of its size.
Sparse with_ridge(const Sparse& A) {
  Array<Eigen::Triplet<double, int>> all;
  all.reserve(static_cast<std::size_t>(2 * (A.nonZeros() + A.cols())));
  const int n = static_cast<int>(A.cols());
  for (int column = 0; column < n; ++column) {
    all.emplace_back(column, column, ridge);
    all.emplace_back(n + column, n + column, -ridge);
    for (Sparse::InnerIterator entry(A, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      all.emplace_back(row, n + column, entry.value());
      all.emplace_back(n + column, row, entry.value());
    }
  }
  const Eigen::Index rows = 2 * A.cols();
  Sparse wide(rows, rows);
  wide.setFromTriplets(all.begin(), all.end());
  return wide;
}

/// What the matrix takes to nothing, as columns: R [z; -I] = 0.
Eigen::MatrixXd null_space(const SparseOrthogonal& orthogonal) {
  const Eigen::Index n = orthogonal.cols(), rank = orthogonal.rank();
  const auto& R = orthogonal.matrixR();
  Eigen::MatrixXd z = R.topRightCorner(rank, n - rank);
  R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(z);
  Eigen::MatrixXd all(n, n - rank);
  all << z, -Eigen::MatrixXd::Identity(n - rank, n - rank);
  return orthogonal.colsPermutation() * all;
}

}  // namespace

struct LinearSystem::Factors {
  Eigen::VectorXd rows;  ///< by which each row is multiplied
  Eigen::MatrixXd matrix;
  DenseLu dense;
  std::optional<Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>> dense_orthogonal;
  std::optional<SparseFactors> sparse;
  Sparse scaled;                        ///< the sparse matrix itself
  std::optional<SparseFactors> ridged;  ///< of a singular one
  Array<int> columns, entries;          ///< the pattern for which `sparse` has its order
  bool full = true, singular = false;

  bool same_pattern(const Sparse& A) const {
    return std::equal(columns.begin(), columns.end(), A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1) &&
           std::equal(entries.begin(), entries.end(), A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
  }

  /// The ridge shortens by (d/s)^2 what the matrix holds with s; the second pass leaves the square of that.
  Eigen::VectorXd shortest(const Eigen::VectorXd& right) const {
    const Eigen::Index n = right.size();
    Eigen::VectorXd wide = Eigen::VectorXd::Zero(2 * n), x = Eigen::VectorXd::Zero(n);
    for (int pass = 0; pass < 2; ++pass) {
      wide.head(n) = right - scaled * x;
      x += ridged->solve(wide).tail(n);
    }
    return x;
  }

  void factor_full(const Entries& A, const Eigen::VectorXd& scale) {
    A.fill(matrix);
    for (Eigen::Index j = 0; j < scale.size(); ++j) matrix.col(j) *= scale[j];
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const double size = matrix.row(i).cwiseAbs().maxCoeff();
      rows[i] = size > 0 && std::isfinite(size) ? 1 / size : 1;
      matrix.row(i) *= rows[i];
    }
    dense.factor(matrix);
    singular = !(dense.pivot_ratio() > singular_below);
    if (!singular) return;
    dense_orthogonal.emplace();
    dense_orthogonal->setThreshold(rank_threshold);
    dense_orthogonal->compute(matrix);
  }

  void factor_sparse(const Entries& A, const Eigen::VectorXd& scale) {
    scaled = A.columns() * scale.asDiagonal();
    rows.setZero();
    for (int column = 0; column < scaled.cols(); ++column) {
      for (Sparse::InnerIterator entry(scaled, column); entry; ++entry) {
        rows[entry.row()] = std::max(rows[entry.row()], std::abs(entry.value()));
      }
    }
    rows = rows.unaryExpr([](double size) { return size > 0 && std::isfinite(size) ? 1 / size : 1; });
    scaled = rows.asDiagonal() * scaled;
    if (!sparse) sparse.emplace();
    if (!same_pattern(scaled)) {
      sparse->analyzePattern(scaled);
      columns.assign(scaled.outerIndexPtr(), scaled.outerIndexPtr() + scaled.cols() + 1);
      entries.assign(scaled.innerIndexPtr(), scaled.innerIndexPtr() + scaled.nonZeros());
    }
    sparse->factorize(scaled);
    singular = !(sparse->pivot_ratio() > singular_below);
    if (!singular) return;
    ridged.emplace();
    ridged->compute(with_ridge(scaled));
  }
};

LinearSystem::LinearSystem() : factors_(std::make_unique<Factors>()) {}
LinearSystem::~LinearSystem() = default;

void LinearSystem::factor(const Entries& A, const Eigen::VectorXd& scale) {
  expects(A.size() == scale.size(), "a scale for each unknown");
  factors_->full = A.size() <= most_dense;
  factors_->rows.resize(A.size());
  factors_->full ? factors_->factor_full(A, scale) : factors_->factor_sparse(A, scale);
}

bool LinearSystem::singular() const { return factors_->singular; }

Eigen::VectorXd LinearSystem::solve(const Eigen::VectorXd& b) const {
  const Eigen::VectorXd right = factors_->rows.cwiseProduct(b);
  if (!factors_->singular) return factors_->full ? factors_->dense.solve(right) : factors_->sparse->solve(right).eval();
  if (factors_->full) return factors_->dense_orthogonal->solve(right);
  return factors_->shortest(right);
}

Eigen::VectorXd LinearSystem::undetermined() const {
  const Eigen::Index n = factors_->rows.size();
  if (!factors_->singular) return {};
  if (!factors_->full) {
    SparseOrthogonal orthogonal;
    orthogonal.setPivotThreshold(rank_threshold);
    orthogonal.compute(factors_->scaled);
    if (orthogonal.rank() == n) return {};
    Eigen::MatrixXd open = null_space(orthogonal);
    open.colwise().normalize();
    return open.rowwise().norm().cwiseMin(1.0);
  }
  const auto& orthogonal = *factors_->dense_orthogonal;
  if (orthogonal.rank() == n) return {};
  const Eigen::MatrixXd open = orthogonal.matrixZ().adjoint().rightCols(n - orthogonal.rank());
  return (orthogonal.colsPermutation() * open).rowwise().norm();
}

}  // namespace taut
