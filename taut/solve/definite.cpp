#include "taut/solve/definite.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"

namespace taut::solve {
namespace {

constexpr double neutral = 1e-13;       ///< of the scaled matrix: a pivot that counts as none
constexpr double coupled = 1e-7;        ///< what a row without pivot may have beside it
constexpr double undetermined = 1e-14;  ///< of the row as it was

}  // namespace

SkylineMatrix::SkylineMatrix(int size)
    : values_(decltype(values_)::Zero(size, size)), first_(static_cast<std::size_t>(size), size) {}

void SkylineMatrix::add(int row, int column, double value) {
  if (value == 0) return;
  values_(row, column) += value;
  int& first = first_[row];
  first = std::min(first, column);
}

bool SkylineMatrix::definite() const {
  const int n = static_cast<int>(first_.size());
  Eigen::VectorXd scale(n);
  for (int i = 0; i < n; ++i) {
    const double d = values_(i, i);
    if (d < 0) return false;
    scale[i] = d > 0 ? 1 / std::sqrt(d) : 1;
  }
  // rows of L, with L D L' = the scaled matrix
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> L(n, n);  // the rest is never read
  Eigen::VectorXd pivot(n);
  for (int i = 0; i < n; ++i) {
    const int from = std::min(first_[i], i);
    double rest = values_(i, i) * scale[i] * scale[i];
    for (int j = from; j < i; ++j) {
      const int both = std::max(from, std::min(first_[j], j));
      double u = values_(i, j) * scale[i] * scale[j];
      for (int k = both; k < j; ++k) u -= L(i, k) * pivot[k] * L(j, k);
      if (pivot[j] == 0) {
        if (std::abs(u) > coupled) return false;
        L(i, j) = 0;
        continue;
      }
      L(i, j) = u / pivot[j];
      rest -= L(i, j) * u;
    }
    if (rest < -neutral) return false;
    pivot[i] = rest <= neutral ? 0 : rest;
  }
  return true;
}

std::optional<Eigen::MatrixXd> condense(const Eigen::MatrixXd& matrix, const Array<int>& order, int count) {
  const auto n = static_cast<Eigen::Index>(order.size());
  Eigen::MatrixXd A(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = matrix(order[i], order[j]);
    }
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const double size = A.row(i).cwiseAbs().maxCoeff();
    if (size > 0) A.row(i) /= size;
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::Index best = k;
    for (Eigen::Index i = k + 1; i < count; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(best, k))) best = i;
    }
    if (!(std::abs(A(best, k)) > undetermined)) return std::nullopt;
    if (best != k) A.row(k).swap(A.row(best));
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const double factor = A(i, k) / A(k, k);
      if (factor != 0) A.row(i).tail(n - k) -= factor * A.row(k).tail(n - k);
    }
  }
  return Eigen::MatrixXd(A.bottomRightCorner(n - count, n - count));
}

}  // namespace taut::solve
