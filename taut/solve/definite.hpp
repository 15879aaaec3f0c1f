#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"

namespace taut::solve {

/// A symmetric matrix, its lower half by rows, whose rows are empty up to some column: elements along a beam.
class SkylineMatrix {
 public:
  explicit SkylineMatrix(int size);
  /// row >= column.
  void add(int row, int column, double value);
  /// Whether no direction has negative stiffness; those of none at all (to rounding, of the scaled matrix) pass.
  bool definite() const;

 private:
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values_;
  Array<int> first_;  ///< column with something in it, by row
};

/// Eliminates the first `count` of the unknowns in `order`, with the rows of the same numbers, from a matrix; what is
/// left, in the order given. Empty where they are undetermined.
std::optional<Eigen::MatrixXd> condense(const Eigen::MatrixXd& matrix, const Array<int>& order, int count);

}  // namespace taut::solve
