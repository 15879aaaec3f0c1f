#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "taut/base/array.hpp"

namespace taut {

/// A square matrix as the list of what is added to its entries: an element of a system adds what it knows, whatever is
/// there already.
class Entries {
 public:
  /// An empty list for a matrix of `size` rows; the storage is used again.
  void reset(int size);
  int size() const { return size_; }
  void add(int row, int column, double value) {
    if (value != 0) all_.emplace_back(row, column, value);
  }
  /// A column of a vector's components, from `row` down.
  void add_below(int row, int column, const Eigen::Vector3d& values);

  Eigen::MatrixXd dense() const;
  void fill(Eigen::MatrixXd& full) const;  ///< the same in storage that is used again
  Eigen::SparseMatrix<double> columns() const;
  const Array<Eigen::Triplet<double, int>>& all() const { return all_; }

 private:
  int size_ = 0;
  Array<Eigen::Triplet<double, int>> all_;
};

}  // namespace taut
