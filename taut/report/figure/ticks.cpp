#include "taut/report/figure/ticks.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::report {

double nice_below(double x) {
  expects(x > 0 && std::isfinite(x), "a positive finite number");
  const double power = std::pow(10, std::floor(std::log10(x)));
  const double lead = x / power * (1 + 1e-12);
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

std::vector<double> nice_ticks(double low, double high, int count) {
  expects(low < high && std::isfinite(high - low), "an axis needs a finite range");
  double step = nice_below((high - low) / count);
  while ((high - low) / step > 1.6 * count) {  // the next nice step: 1 -> 2 -> 5 -> 10
    const double bigger = nice_below(step * 2.5);
    step = bigger > step ? bigger : step * 2;
  }
  std::vector<double> ticks;
  const double first = std::floor(low / step + 1e-9);
  const double last = std::ceil(high / step - 1e-9);
  for (double k = first; k <= last && ticks.size() < 100; ++k) ticks.push_back(k == 0 ? 0 : k * step);
  return ticks;
}

int tick_decimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 0;
  const double step = ticks[1] - ticks[0];
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
}

}  // namespace taut::report
