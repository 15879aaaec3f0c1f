#include "taut/solve/definite.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut::solve {
namespace {

constexpr double neutral = 1e-13;       ///< of the scaled matrix: a pivot that counts as none
constexpr double coupled = 1e-7;        ///< what a row without pivot may have beside it
constexpr double undetermined = 1e-14;  ///< of the row as it was

}  // namespace

SkylineMatrix::SkylineMatrix(const Array<int>& first) : first_(first), start_(first.size() + 1, 0) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    expects(first[i] >= 0 && first[i] <= static_cast<int>(i), "a row of a skyline begins at or before its diagonal");
    start_[i + 1] = start_[i] + static_cast<int>(i) - first[i] + 1;
  }
  values_.assign(as_size(start_.back()), 0.0);
}

void SkylineMatrix::add(int row, int column, double value) {
  values_[as_size(start_[row] + column - first_[row])] += value;
}

std::optional<SkylineFactors> SkylineMatrix::factors() const {
  const std::size_t n = first_.size();
  SkylineFactors all{.first = first_,
                     .start = start_,
                     .L = Array<double>(values_.size()),
                     .pivot = Array<double>(n),
                     .scale = Array<double>(n)};
  Array<double>&scale = all.scale, &pivot = all.pivot;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = diagonal(i);
    if (!(d >= 0)) return std::nullopt;  // no number holds nothing
    scale[i] = d > 0 ? 1 / std::sqrt(d) : 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    // from the row's first column on
    const double* const value = values_.data() + start_[i] - first_[i];
    double* const L = all.L.data() + start_[i] - first_[i];
    double rest = diagonal(i) * scale[i] * scale[i];
    for (int j = first_[i]; j < static_cast<int>(i); ++j) {
      const double* const Lj = all.L.data() + start_[j] - first_[j];
      double u = value[j] * scale[i] * scale[j];
      for (int k = std::max(first_[i], first_[j]); k < j; ++k) u -= L[k] * pivot[k] * Lj[k];
      if (pivot[j] == 0) {
        if (std::abs(u) > coupled) return std::nullopt;
        L[j] = 0;
        continue;
      }
      L[j] = u / pivot[j];
      rest -= L[j] * u;
    }
    if (!(rest >= -neutral)) return std::nullopt;
    pivot[i] = rest <= neutral ? 0 : rest;
  }
  return all;
}

void SkylineFactors::solve(Eigen::Ref<Eigen::VectorXd> x) const {
  const auto n = static_cast<int>(pivot.size());
  for (int i = 0; i < n; ++i) {
    const double* const row = L.data() + start[i] - first[i];
    x[i] *= scale[i];
    for (int j = first[i]; j < i; ++j) x[i] -= row[j] * x[j];
  }
  for (int i = 0; i < n; ++i) x[i] = pivot[i] > 0 ? x[i] / pivot[i] : 0;
  for (int i = n - 1; i >= 0; --i) {
    const double* const row = L.data() + start[i] - first[i];
    for (int j = first[i]; j < i; ++j) x[j] -= row[j] * x[i];
  }
  for (int i = 0; i < n; ++i) x[i] *= scale[i];
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
