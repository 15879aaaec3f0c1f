#include "taut/methods/boom_ropes/piecewise.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::boom_ropes {
namespace {

void found(Crossings& c, bool rising, double low, double high) {
  c = {.count = c.count + 1, .rising = rising, .low = low, .high = high};
}

/// The ray from the outermost break outward; `side` -1 to the left, +1 to the right. A root on the break itself
/// belongs to the break.
void search_ray(Crossings& c, const std::function<double(double)>& f, double end, double step, int side) {
  const double at_end = f(end);
  const double slope = (f(end + side * step) - at_end) / (side * step);
  const double x = end - at_end / slope;
  if (at_end == 0) {
    if (slope == 0) c.count += 2;
    return;
  }
  if (!std::isfinite(x) || side * (x - end) <= 0) return;
  const double beyond = x + (x - end) + side * step;
  found(c, slope > 0, std::min(end, beyond), std::max(end, beyond));
}

}  // namespace

Crossings crossings(const std::function<double(double)>& f, std::vector<double> breaks) {
  expects(!breaks.empty(), "a piecewise linear function needs a break");
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  const double step = std::max(breaks.back() - breaks.front(), 1e-3 * std::max(1.0, std::abs(breaks.front())));
  Crossings c;
  search_ray(c, f, breaks.front(), step, -1);
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const double here = f(breaks[i]);
    if (here == 0) {
      const double before = i == 0 ? breaks[i] - step : breaks[i - 1];
      const double after = i + 1 == breaks.size() ? breaks[i] + step : breaks[i + 1];
      found(c, f(after) > f(before), before, after);
    } else if (i + 1 < breaks.size()) {
      const double next = f(breaks[i + 1]);
      if (next != 0 && (here < 0) != (next < 0)) found(c, next > here, breaks[i], breaks[i + 1]);
    }
  }
  search_ray(c, f, breaks.back(), step, +1);
  return c;
}

}  // namespace taut::boom_ropes
