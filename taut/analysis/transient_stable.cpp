#include "taut/analysis/transient_stable.hpp"

#include <cmath>

namespace taut::analysis::dynamics {

double equal_step(const TransientOptions& options, double step) {
  constexpr double rounding = 1e-9;
  const double lines = options.output_step > 0 ? options.output_step : options.duration / 1000;
  const double parts = std::ceil(lines / step * (1 - rounding));
  const bool fits = std::abs(parts * step - lines) <= rounding * lines;
  return fits || step >= lines ? step : lines / parts;
}

double stable_step(const Run& run) {
  constexpr double near_the_limit = 0.95;
  const double step = run.options.step;
  if (run.options.method != TimeMethod::verlet || run.m.simple) return step;
  const double limit = stability_limit(run.m, run.before);
  return step > near_the_limit * limit ? equal_step(run.options, verlet_share * limit) : step;
}

}  // namespace taut::analysis::dynamics
