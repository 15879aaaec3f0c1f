#pragma once
#include <functional>
#include <vector>

namespace taut::boom_ropes {

/// The roots of a continuous function that is linear between its breaks and beyond them.
struct Crossings {
  int count = 0;
  bool rising = false;  ///< at the last root found
  double low = 0;       ///< an interval with just that root in it
  double high = 0;
};

/// Finds every root of `f` exactly: `breaks` (any order, at least one) are the places where its slope may change.
/// A stretch on which f is zero throughout counts as two roots.
Crossings crossings(const std::function<double(double)>& f, std::vector<double> breaks);

}  // namespace taut::boom_ropes
