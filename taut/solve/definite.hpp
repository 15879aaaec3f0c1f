#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"

namespace taut::solve {

/// A factored SkylineMatrix.
struct SkylineFactors {
  Array<int> first, start;  ///< as in the matrix
  Array<double> L;          ///< row by row
  Array<double> pivot;      ///< 0: a direction without stiffness
  Array<double> scale;
  /// Solves K x = b in place; what has no stiffness stays where it is.
  void solve(Eigen::Ref<Eigen::VectorXd> x) const;
};

/// A symmetric matrix, its lower half by rows, whose rows are empty up to some column: elements along a beam.
class SkylineMatrix {
 public:
  /// `first`: by row the first column that may have something in it, at most the row itself.
  explicit SkylineMatrix(const Array<int>& first);
  /// row >= column >= its first one.
  void add(int row, int column, double value);
  /// L D L' of the matrix scaled to ones on its diagonal. Empty where a direction has negative stiffness; those of none
  /// at all (to rounding) pass.
  std::optional<SkylineFactors> factors() const;
  bool definite() const { return factors().has_value(); }

 private:
  double diagonal(std::size_t row) const { return values_[start_[row + 1] - 1]; }

  Array<int> first_;
  Array<int> start_;      ///< by row: where its values begin
  Array<double> values_;  ///< row by row, each from its first column to the diagonal
};

/// Eliminates the first `count` of the unknowns in `order`, with the rows of the same numbers, from a matrix; what is
/// left, in the order given. Empty where they are undetermined.
std::optional<Eigen::MatrixXd> condense(const Eigen::MatrixXd& matrix, const Array<int>& order, int count);

}  // namespace taut::solve
