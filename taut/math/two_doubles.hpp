#pragma once
#include <cmath>

namespace taut::math {

/// An unevaluated sum of two doubles, with 100 bits and more: `low` is what rounding took from `high`. The same on
/// every machine, where `long double` is a double on one and slow software on another. Sums and products are not
/// brought back to |low| <= ulp(high)/2: a short formula does not need it. Dekker, A floating-point technique for
/// extending the available precision, Numer. Math. 18 (1971); Lange and Rump, Faithfully rounded floating-point
/// computations, ACM Trans. Math. Softw. 46 (2020). Magnitudes 1e-140 .. 1e290: outside them digits are lost, or the
/// result is no number.
struct TwoDoubles {
  double high = 0, low = 0;

  constexpr explicit operator double() const { return high + low; }
};

/// a + b without a rounding error.
constexpr TwoDoubles exact_sum(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {.high = sum, .low = (a - (sum - of_b)) + (b - of_b)};
}

/// a b without a rounding error.
constexpr TwoDoubles exact_product(double a, double b) {
  constexpr double splitter = 134217729;  // 2^27 + 1: halves of 26 bits, whose products are exact
  const double a_wide = splitter * a, b_wide = splitter * b;
  const double a_high = a_wide - (a_wide - a), b_high = b_wide - (b_wide - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  return {.high = product, .low = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// The same sum with |low| <= ulp(high)/2: for a difference that lost digits of `high`.
constexpr TwoDoubles normalized(const TwoDoubles& a) { return exact_sum(a.high, a.low); }

constexpr TwoDoubles operator-(const TwoDoubles& a) { return {.high = -a.high, .low = -a.low}; }

constexpr TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles sum = exact_sum(a.high, b.high);
  return {.high = sum.high, .low = sum.low + (a.low + b.low)};
}
constexpr TwoDoubles operator+(const TwoDoubles& a, double b) {
  const TwoDoubles sum = exact_sum(a.high, b);
  return {.high = sum.high, .low = sum.low + a.low};
}
constexpr TwoDoubles operator+(double a, const TwoDoubles& b) { return b + a; }

constexpr TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) { return a + -b; }
constexpr TwoDoubles operator-(const TwoDoubles& a, double b) { return a + -b; }
constexpr TwoDoubles operator-(double a, const TwoDoubles& b) { return -b + a; }

constexpr TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles product = exact_product(a.high, b.high);
  return {.high = product.high, .low = product.low + (a.high * b.low + a.low * b.high)};
}
constexpr TwoDoubles operator*(const TwoDoubles& a, double b) {
  const TwoDoubles product = exact_product(a.high, b);
  return {.high = product.high, .low = product.low + a.low * b};
}
constexpr TwoDoubles operator*(double a, const TwoDoubles& b) { return b * a; }

/// b: not 0 and finite.
constexpr TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b) {
  const double whole = a.high / b.high;
  const TwoDoubles back = exact_product(whole, b.high);
  const double left = ((a.high - back.high) - back.low) + (a.low - whole * b.low);
  return {.high = whole, .low = left / (b.high + b.low)};
}
constexpr TwoDoubles operator/(const TwoDoubles& a, double b) { return a / TwoDoubles{.high = b, .low = 0}; }
constexpr TwoDoubles operator/(double a, const TwoDoubles& b) { return TwoDoubles{.high = a, .low = 0} / b; }

/// a >= 0.
inline TwoDoubles sqrt(const TwoDoubles& a) {
  const double root = std::sqrt(a.high);
  if (root == 0) return {};
  const TwoDoubles back = exact_product(root, root);
  return {.high = root, .low = (((a.high - back.high) - back.low) + a.low) / (2 * root)};
}

/// atanh(u)/u = 1 + u^2/3 + u^4/5 + .. for |u| up to most_of_atanh_ratio: to 1e-22.
constexpr double most_of_atanh_ratio = 0.1;
TwoDoubles atanh_ratio(const TwoDoubles& u);

/// The natural logarithm of a > 0: to 1e-22 of the larger of it and 1. Of others what std::log gives.
TwoDoubles log(const TwoDoubles& a);

}  // namespace taut::math
