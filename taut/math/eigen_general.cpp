#include "taut/math/eigen_general.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "taut/base/expects.hpp"
#include "taut/math/dense_lu.hpp"

namespace taut {

std::optional<Eigen::MatrixXd> solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  expects(A.rows() == A.cols() && A.rows() == B.rows(), "a square system");
  if (A.rows() == 0) return Eigen::MatrixXd(0, B.cols());
  const DenseLu lu(A);
  if (!(lu.pivot_ratio() > 0)) return std::nullopt;
  Eigen::MatrixXd x = lu.solve_columns(B);
  if (!x.allFinite()) return std::nullopt;
  return x;
}

std::optional<GeneralEigen> shifted_eigen(const Eigen::MatrixXd& F, const Eigen::MatrixXd& E, double shift) {
  const auto matrix = solved(F - shift * E, E);
  if (!matrix) return std::nullopt;
  GeneralEigen result;
  if (matrix->rows() == 0) return result;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(*matrix);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const auto& values = solver.eigenvalues();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return std::abs(values[a]) > std::abs(values[b]); });
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  result.vectors.resize(vectors.rows(), vectors.cols());
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.values.push_back(values[order[k]]);
    result.vectors.col(static_cast<Eigen::Index>(k)) = vectors.col(order[k]);
  }
  return result;
}

}  // namespace taut
