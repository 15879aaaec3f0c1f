#pragma once
#include <Eigen/Core>
#include <span>

#include "taut/math/entries.hpp"

namespace taut {

/// A sparse matrix row by row. What was added to one place apart stays apart: it counts as its sum.
class SparseRows {
 public:
  struct Entry {
    int column = 0;
    double value = 0;
  };

  SparseRows() = default;
  /// Of entries in any order.
  SparseRows(int rows, const Array<Eigen::Triplet<double, int>>& entries);

  int rows() const { return static_cast<int>(first_.size()) - 1; }
  std::span<const Entry> row(int i) const;
  Eigen::VectorXd times(const Eigen::VectorXd& x) const;

 private:
  Array<int> first_ = {0};
  Array<Entry> entries_;
};

}  // namespace taut
