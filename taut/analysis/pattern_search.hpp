#pragma once
#include <functional>
#include <vector>

namespace taut::analysis {

struct PatternOptions {
  double tolerance = 1e-3;  ///< the smallest step, as a share of each range
  int most_evaluations = 400;
};

struct PatternAnswer {
  std::vector<double> x;
  double value = 0;
  int evaluations = 0;
};

/// A low value of f within low <= x <= high, from x = start on: steps of `step` along each axis, both ways; the best
/// one that is lower is taken, else the steps are halved (compass search: Kolda, Lewis, Torczon, SIAM Review 45, 2003).
/// For a few unknowns and functions with kinks, such as the worst of several checks; the minimum found is a local one.
/// NaN counts as infinite. All vectors have the same length; a range without width stays where it is.
PatternAnswer pattern_search(const std::function<double(const std::vector<double>&)>& f, std::vector<double> start,
                             const std::vector<double>& low, const std::vector<double>& high, std::vector<double> step,
                             const PatternOptions& options = {});

}  // namespace taut::analysis
