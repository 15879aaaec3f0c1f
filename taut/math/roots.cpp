#include "taut/math/roots.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace taut {
namespace {

constexpr std::uintmax_t most_evaluations = 200;

bool opposite(double a, double b) { return (a < 0) != (b < 0); }

}  // namespace

std::optional<double> find_root(const std::function<double(double)>& f, double low, double high) {
  const double at_low = f(low);
  const double at_high = f(high);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  if (!(low < high) || !std::isfinite(at_low) || !std::isfinite(at_high) || !opposite(at_low, at_high))
    return std::nullopt;
  const auto close = [](double a, double b) {
    return std::abs(b - a) <= 2 * std::numeric_limits<double>::epsilon() * std::min(std::abs(a), std::abs(b));
  };
  if (close(low, high)) return std::abs(at_low) <= std::abs(at_high) ? low : high;
  std::uintmax_t evaluations = most_evaluations;
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, at_low, at_high, close, evaluations);
  return std::abs(f(a)) <= std::abs(f(b)) ? a : b;
}

std::optional<double> find_root_above(const std::function<double(double)>& f, double low, double high, int doublings) {
  const double at_low = f(low);
  if (at_low == 0) return low;
  double from = low;
  for (int i = 0; i <= doublings && std::isfinite(high); ++i) {
    const double at_high = f(high);
    if (std::isfinite(at_high) && (at_high == 0 || opposite(at_low, at_high))) return find_root(f, from, high);
    from = std::isfinite(at_high) ? high : from;
    high = low + 2 * (high - low);
  }
  return std::nullopt;
}

}  // namespace taut
