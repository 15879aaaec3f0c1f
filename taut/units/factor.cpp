#include "taut/units/factor.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace taut {
namespace {

/// A number of 106 bits: the sum of two doubles, the second below the last digit of the first.
struct Wide {
  double high = 1;
  double low = 0;
};

constexpr Wide pi{.high = std::numbers::pi, .low = 1.2246467991473532e-16};

/// The sum of two doubles as it is; |a| >= |b|.
Wide sum(double a, double b) {
  const double high = a + b;
  return {.high = high, .low = b - (high - a)};
}

Wide times(Wide a, Wide b) {
  const double high = a.high * b.high;
  const double rest = std::fma(a.high, b.high, -high);
  return sum(high, rest + (a.high * b.low + a.low * b.high));
}

/// The double nearest to a/b.
double ratio(Wide a, Wide b) {
  const double first = a.high / b.high;
  const Wide taken = times({.high = first, .low = 0}, b);
  return first + ((a.high - taken.high) + (a.low - taken.low)) / b.high;
}

void multiply(Wide& product, Wide by, int often) {
  for (int i = 0; i < often; ++i) product = times(product, by);
}

}  // namespace

double factor_of(const std::vector<UnitPower>& product) {
  Wide over, under;
  for (const UnitPower& unit : product) {
    const UnitScale& scale = unit.row->scale;
    const int often = std::abs(unit.exponent);
    Wide& above = unit.exponent > 0 ? over : under;
    multiply(above, {.high = scale.over, .low = 0}, often);
    multiply(unit.exponent > 0 ? under : over, {.high = scale.under, .low = 0}, often);
    if (scale.times_pi) multiply(above, pi, often);
  }
  return ratio(over, under);
}

}  // namespace taut
