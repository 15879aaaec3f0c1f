#include "taut/analysis/pattern_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/base/expects.hpp"

namespace taut::analysis {

PatternAnswer pattern_search(const std::function<double(const std::vector<double>&)>& f, std::vector<double> start,
                             const std::vector<double>& low, const std::vector<double>& high, std::vector<double> step,
                             const PatternOptions& options) {
  const std::size_t n = start.size();
  expects(low.size() == n && high.size() == n && step.size() == n, "bounds and steps belong to each unknown");
  PatternAnswer best;
  const auto value_at = [&](const std::vector<double>& x) {
    ++best.evaluations;
    const double value = f(x);
    return std::isnan(value) ? HUGE_VAL : value;
  };
  best.x = std::move(start);
  best.value = value_at(best.x);
  const auto fine = [&] {
    for (std::size_t i = 0; i < n; ++i) {
      if (step[i] > options.tolerance * (high[i] - low[i])) return false;
    }
    return true;
  };
  while (!fine() && best.evaluations < options.most_evaluations) {
    std::vector<double> next;
    double least = best.value;
    for (std::size_t i = 0; i < n; ++i) {
      for (const double way : {1.0, -1.0}) {
        std::vector<double> x = best.x;
        x[i] = std::clamp(x[i] + way * step[i], low[i], high[i]);
        if (x[i] == best.x[i]) continue;
        const double value = value_at(x);
        if (!(value < least)) continue;
        least = value;
        next = std::move(x);
      }
    }
    if (next.empty()) {
      for (double& one : step) one /= 2;
    } else {
      best.x = std::move(next);
      best.value = least;
    }
  }
  return best;
}

}  // namespace taut::analysis
