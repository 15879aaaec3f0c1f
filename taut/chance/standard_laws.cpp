#include "taut/chance/standard_laws.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::chance {
namespace {

// double is enough; what overflows or has no limit is infinite, not an exception.
using InDouble =
    boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                  boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::underflow_error<boost::math::policies::ignore_error>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double normal_density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

double normal_below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

double normal_above(double z) { return std::erfc(z / std::numbers::sqrt2) / 2; }

double normal_score(double p) {
  expects(p >= 0 && p <= 1, "a chance lies from 0 to 1");
  if (p == 0) return -infinity;
  if (p == 1) return infinity;
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, InDouble());
}

double normal_score_above(double q) { return -normal_score(q); }

double student_value(double p, double freedom) {
  expects(p > 0 && p < 1 && freedom > 0, "a chance within 0 and 1, degrees of freedom above 0");
  if (p == 0.5) return 0;
  // P(|T| > t) = I_x(freedom/2, 1/2) with x = freedom/(freedom + t^2)
  const double both = 2 * std::min(p, 1 - p);
  double y = 0;  // 1 - x
  const double x = boost::math::ibeta_inv(freedom / 2, 0.5, both, &y, InDouble());
  const double t = std::sqrt(freedom * y / x);
  return p < 0.5 ? -t : t;
}

double chi_squared_above(double x, double freedom) {
  expects(x >= 0 && freedom > 0, "chi squared and its degrees of freedom are not negative");
  return boost::math::gamma_q(freedom / 2, x / 2, InDouble());
}

double beta_value(double p, double a, double b) {
  expects(p >= 0 && p <= 1 && a > 0 && b > 0, "a chance from 0 to 1, shapes above 0");
  return boost::math::ibeta_inv(a, b, p, InDouble());
}

double binomial_below(double k, double n, double p) {
  if (k < 0) return 0;
  if (k >= n) return 1;
  return boost::math::ibetac(k + 1, n - k, p, InDouble());
}

}  // namespace taut::chance
