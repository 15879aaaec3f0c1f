#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace taut::design {

/// What a point of the search gives.
struct ConstrainedPoint {
  double value = 0;          ///< of what is sought; NaN: there is none here (no equilibrium)
  std::vector<double> over;  ///< of each constraint, <= 0 where it is kept; as many at every point, all finite
};

/// What is sought within the constraints.
enum class Sought {
  least_value,  ///< of `value`
  most_reserve  ///< the least of the largest constraint; `value` does not count
};

struct ConstrainedOptions {
  double tolerance = 1e-4;  ///< last step, as a share of each range
  int most_evaluations = 200;
};

/// The unknowns: where the search begins, from where to where each may lie, and its first step (> 0). All have the
/// same length, which is not 0; an unknown with low = high stays.
struct ConstrainedUnknowns {
  std::vector<double> start, low, high, step;
};

struct ConstrainedAnswer {
  std::vector<double> x;
  ConstrainedPoint at;    ///< what x gives
  bool feasible = false;  ///< whether x keeps all constraints; else x comes nearest to it
  bool ended = false;     ///< f has ended the search
  int evaluations = 0;
};

/// The best x within low <= x <= high, from x = start on, for functions of a few unknowns whose derivatives are not
/// known: linear models of f and of every constraint over a simplex that shrinks (COBYLA: Powell 1994, as in NLopt),
/// then bisection between the last point and the best one that keeps all constraints. The minimum is a local one; the
/// same call gives the same bits. f: empty ends the search.
ConstrainedAnswer least_within(const std::function<std::optional<ConstrainedPoint>(const std::vector<double>&)>& f,
                               Sought sought, const ConstrainedUnknowns& unknowns,
                               const ConstrainedOptions& options = {});

}  // namespace taut::design
