#include "taut/math/entries.hpp"

#include "taut/base/expects.hpp"

namespace taut {

void Entries::reset(int size) {
  expects(size >= 0, "a size of at least 0");
  size_ = size;
  all_.clear();
}

void Entries::add_below(int row, int column, const Eigen::Vector3d& values) {
  for (int i = 0; i < 3; ++i) add(row + i, column, values[i]);
}

void Entries::fill(Eigen::MatrixXd& full) const {
  full.setZero(size_, size_);
  for (const auto& one : all_) full(one.row(), one.col()) += one.value();
}

Eigen::MatrixXd Entries::dense() const {
  Eigen::MatrixXd full;
  fill(full);
  return full;
}

Eigen::SparseMatrix<double> Entries::columns() const {
  Eigen::SparseMatrix<double> matrix(size_, size_);
  matrix.setFromTriplets(all_.begin(), all_.end());
  return matrix;
}

}  // namespace taut
