#pragma once
#include <utility>
#include <vector>

#include "taut/base/array.hpp"

namespace taut {

/// Gauss elimination for one sparse pattern and many matrices: ordering, fill and the list of all operations are found
/// once. No pivoting: for matrices that are (nearly) symmetric in structure and whose pivots stay away from zero, as
/// those of mechanics with masses. Nothing is allocated after the construction.
class StaticLu {
 public:
  StaticLu() = default;
  /// `cliques`: sets of unknowns that all depend on each other (those of one element). Every diagonal entry is there.
  StaticLu(int size, const Array<Array<int>>& cliques);

  int size() const { return size_; }
  /// Where the entry of a row and a column lies in `values`; both have to be in one clique.
  int place(int row, int column) const;
  /// Its columns, with their places in `values`; those that fill in are among them.
  const Array<std::pair<int, int>>& row(int i) const { return places_[i]; }
  void set_zero();
  Array<double>& values() { return held_ ? spare_ : values_; }
  const Array<double>& values() const { return values_; }
  /// What is in `values` as a full matrix, row by row.
  Array<double> dense() const;

  /// While held, `values` gives a spare array that nobody reads: the factors stay for more right sides.
  void hold(bool factors);
  /// Factors what is in `values`, in place. False where a pivot is zero or not finite.
  bool factor();
  /// Solves for one right side, in place.
  void solve(Array<double>& x);

 private:
  struct Pivot {
    int diagonal = 0, first = 0, count = 0, operations = 0;
  };
  void order(Array<Array<int>>& neighbours);
  void list_operations();

  int size_ = 0;
  Array<int> order_;                          // unknown eliminated at each step
  Array<Array<int>> upper_;                   // by step: unknowns that remain beside it
  Array<Array<std::pair<int, int>>> places_;  // by row: column and place, sorted
  Array<Pivot> pivots_;
  Array<int> unknowns_;  // of the pivots' rows, one after the other, by their step of elimination
  Array<int> targets_;   // of each product, row by row
  Array<double> values_;
  Array<double> spare_;
  bool held_ = false;
  Array<double> ordered_;  // of the right side, by step
};

}  // namespace taut
