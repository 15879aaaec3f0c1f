#include "taut/math/sparse_rows.hpp"

#include "taut/math/index.hpp"

namespace taut {

SparseRows::SparseRows(int rows, const Array<Eigen::Triplet<double, int>>& entries)
    : first_(as_size(rows) + 1, 0), entries_(entries.size()) {
  for (const auto& one : entries) ++first_[one.row() + 1];
  for (int i = 0; i < rows; ++i) first_[i + 1] += first_[i];
  Array<int> next = first_;
  for (const auto& one : entries) entries_[next[one.row()]++] = {one.col(), one.value()};
}

std::span<const SparseRows::Entry> SparseRows::row(int i) const {
  return std::span(entries_).subspan(as_size(first_[i]), as_size(first_[i + 1] - first_[i]));
}

Eigen::VectorXd SparseRows::times(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(rows());
  for (int i = 0; i < rows(); ++i) {
    for (const Entry& entry : row(i)) y[i] += entry.value * x[entry.column];
  }
  return y;
}

}  // namespace taut
