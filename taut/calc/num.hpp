#pragma once
#include <cmath>
#include <string>

#include "taut/calc/formula.hpp"
#include "taut/units/unit.hpp"

namespace taut {

/// A number that records how it was computed: value (SI), dimension and formula. A formula written over a number type
/// `T` gives bit-identical values for `T = double` and `T = Num`. Num throws ContractViolation where dimensions do not
/// fit (the sum of a force and a length, the sine of a length).
class Num {
 public:
  Num() : Num(0.0) {}
  Num(double plain) : value_(plain), formula_(make_number(plain)) {}  // a bare constant in a formula is a plain number
  Num(double value, Dimension d, Formula f) : value_(value), dimension_(d), formula_(std::move(f)) {}

  /// A named quantity: a leaf of later formulas.
  static Num named(std::string symbol, const Unit& unit, double value);

  double value() const { return value_; }
  const Dimension& dimension() const { return dimension_; }
  const Formula& formula() const { return formula_; }

  Num& operator+=(const Num& b);
  Num& operator-=(const Num& b);
  Num& operator*=(const Num& b);
  Num& operator/=(const Num& b);

 private:
  double value_ = 0;
  Dimension dimension_;
  Formula formula_;
};

Num operator+(const Num& a, const Num& b);
Num operator-(const Num& a, const Num& b);
Num operator*(const Num& a, const Num& b);
Num operator/(const Num& a, const Num& b);
Num operator-(const Num& a);

/// Comparisons of the values; throws ContractViolation when the dimensions differ.
bool operator<(const Num& a, const Num& b);
bool operator>(const Num& a, const Num& b);
bool operator<=(const Num& a, const Num& b);
bool operator>=(const Num& a, const Num& b);

Num exp(const Num& x);
Num log(const Num& x);
Num sqrt(const Num& x);
Num cbrt(const Num& x);
Num sin(const Num& x);
Num cos(const Num& x);
Num tan(const Num& x);
Num asin(const Num& x);
Num acos(const Num& x);
Num atan(const Num& x);
Num atan2(const Num& y, const Num& x);
Num sinh(const Num& x);
Num cosh(const Num& x);
Num tanh(const Num& x);
Num asinh(const Num& x);
Num atanh(const Num& x);
Num hypot(const Num& x, const Num& y);
Num abs(const Num& x);
Num min(const Num& a, const Num& b);
Num max(const Num& a, const Num& b);
Num pow(const Num& x, int exponent);

/// x^2 and x^3 by multiplication, because pow costs ten times as much and root searches call these often.
inline double square(double x) { return x * x; }
inline double cube(double x) { return x * x * x; }
Num square(const Num& x);
Num cube(const Num& x);

/// The value as a double, for either number type.
inline double value(double x) { return x; }
inline double value(const Num& x) { return x.value(); }

}  // namespace taut
