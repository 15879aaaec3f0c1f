#include "taut/math/two_doubles.hpp"

#include <array>
#include <numbers>

namespace taut::math {
namespace {

constexpr TwoDoubles log_2{.high = std::numbers::ln2, .low = 2.3190468138462996e-17};

/// 1/7 + s/9 + s^2/11 + .. + s^7/21.
constexpr double late_terms(double s) {
  const double last = 1 / 15. + s * (1 / 17. + s * (1 / 19. + s / 21));
  return 1 / 7. + s * (1 / 9. + s * (1 / 11. + s * (1 / 13. + s * last)));
}

/// The middle of one of the equal pieces of 1/2 .. 1, and its logarithm.
struct KnownLog {
  double of = 0;
  TwoDoubles log;
};

constexpr int known_per_unit = 64;

/// log(c) = 2 atanh((c - 1)/(c + 1)) by its whole series, of each piece.
constexpr auto known_logs = [] {
  std::array<KnownLog, known_per_unit / 2> known{};
  for (int i = 0; i < known_per_unit / 2; ++i) {
    const double c = 0.5 + (i + 0.5) / known_per_unit;
    const TwoDoubles u = exact_sum(c, -1) / (c + 1), square = u * u;
    TwoDoubles sum;
    for (int power = 71; power > 0; power -= 2) sum = sum * square + 2 / TwoDoubles{.high = 1.0 * power, .low = 0};
    known[static_cast<std::size_t>(i)] = {.of = c, .log = u * sum};
  }
  return known;
}();

}  // namespace

TwoDoubles atanh_ratio(const TwoDoubles& u) {
  constexpr TwoDoubles third = 1 / TwoDoubles{.high = 3, .low = 0}, fifth = 1 / TwoDoubles{.high = 5, .low = 0};
  const TwoDoubles square = u * u;
  // the terms from u^6 on need no more than a double's digits
  return square * (third + square * (fifth + square.high * late_terms(square.high))) + 1;
}

TwoDoubles log(const TwoDoubles& a) {
  if (!(a.high > 0 && std::isfinite(a.high))) return {.high = std::log(a.high), .low = 0};
  int exponent = 0;
  const double high = std::frexp(a.high, &exponent);
  const TwoDoubles part{.high = high, .low = std::ldexp(a.low, -exponent)};
  const KnownLog& known = known_logs[static_cast<std::size_t>((high - 0.5) * known_per_unit)];
  const TwoDoubles u = (part - known.of) / (part + known.of);
  return exponent * log_2 + (known.log + 2 * u * atanh_ratio(u));
}

}  // namespace taut::math
