#include "taut/calc/num.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/expects.hpp"

namespace taut {
namespace {

void expects_alike(const Num& a, const Num& b, const char* what) {
  if (a.dimension() == b.dimension()) return;
  expects(false, fmt::format("{} of [{}] and [{}] in {} , {}", what, to_text(a.dimension()), to_text(b.dimension()),
                             formula_text(a.formula()), formula_text(b.formula())));
}

void expects_plain(const Num& x, const char* function) {
  if (is_plain_number(x.dimension())) return;
  expects(false, fmt::format("{} of [{}]: {}", function, to_text(x.dimension()), formula_text(x.formula())));
}

Num binary(Op op, const Num& a, const Num& b, double value, Dimension d) {
  return {value, d, make_node(op, {a.formula(), b.formula()}, value)};
}

Num call(const char* name, const Num& x, double value, Dimension d = {}) {
  return {value, d, make_call(name, {x.formula()}, value)};
}

Num plain_call(const char* name, const Num& x, double value) {
  expects_plain(x, name);
  return call(name, x, value);
}

}  // namespace

Num Num::named(std::string symbol, const Unit& unit, double value) {
  return {value, unit.dimension, make_symbol(std::move(symbol), value)};
}

Num operator+(const Num& a, const Num& b) {
  expects_alike(a, b, "sum");
  return binary(Op::add, a, b, a.value() + b.value(), a.dimension());
}
Num operator-(const Num& a, const Num& b) {
  expects_alike(a, b, "difference");
  return binary(Op::subtract, a, b, a.value() - b.value(), a.dimension());
}
Num operator*(const Num& a, const Num& b) {
  return binary(Op::multiply, a, b, a.value() * b.value(), a.dimension() * b.dimension());
}
Num operator/(const Num& a, const Num& b) {
  return binary(Op::divide, a, b, a.value() / b.value(), a.dimension() / b.dimension());
}
Num operator-(const Num& a) { return {-a.value(), a.dimension(), make_node(Op::negate, {a.formula()}, -a.value())}; }

Num& Num::operator+=(const Num& b) { return *this = *this + b; }
Num& Num::operator-=(const Num& b) { return *this = *this - b; }
Num& Num::operator*=(const Num& b) { return *this = *this * b; }
Num& Num::operator/=(const Num& b) { return *this = *this / b; }

bool operator<(const Num& a, const Num& b) {
  expects_alike(a, b, "comparison");
  return a.value() < b.value();
}
bool operator>(const Num& a, const Num& b) { return b < a; }
bool operator<=(const Num& a, const Num& b) {
  expects_alike(a, b, "comparison");
  return a.value() <= b.value();
}
bool operator>=(const Num& a, const Num& b) { return b <= a; }

Num exp(const Num& x) { return plain_call("exp", x, std::exp(x.value())); }
Num log(const Num& x) { return plain_call("ln", x, std::log(x.value())); }
Num sin(const Num& x) { return plain_call("sin", x, std::sin(x.value())); }
Num cos(const Num& x) { return plain_call("cos", x, std::cos(x.value())); }
Num tan(const Num& x) { return plain_call("tan", x, std::tan(x.value())); }
Num asin(const Num& x) { return plain_call("asin", x, std::asin(x.value())); }
Num acos(const Num& x) { return plain_call("acos", x, std::acos(x.value())); }
Num atan(const Num& x) { return plain_call("atan", x, std::atan(x.value())); }
Num sinh(const Num& x) { return plain_call("sinh", x, std::sinh(x.value())); }
Num cosh(const Num& x) { return plain_call("cosh", x, std::cosh(x.value())); }
Num tanh(const Num& x) { return plain_call("tanh", x, std::tanh(x.value())); }
Num asinh(const Num& x) { return plain_call("asinh", x, std::asinh(x.value())); }
Num atanh(const Num& x) { return plain_call("atanh", x, std::atanh(x.value())); }
Num sqrt(const Num& x) { return call("sqrt", x, std::sqrt(x.value()), power(x.dimension(), 1, 2)); }
Num cbrt(const Num& x) { return call("cbrt", x, std::cbrt(x.value()), power(x.dimension(), 1, 3)); }
Num abs(const Num& x) { return call("abs", x, std::abs(x.value()), x.dimension()); }

Num atan2(const Num& y, const Num& x) {
  expects_alike(y, x, "atan2");
  const double v = std::atan2(y.value(), x.value());
  return {v, {}, make_call("atan2", {y.formula(), x.formula()}, v)};
}
Num hypot(const Num& x, const Num& y) {
  expects_alike(x, y, "hypot");
  const double v = std::hypot(x.value(), y.value());
  return {v, x.dimension(), make_call("hypot", {x.formula(), y.formula()}, v)};
}
Num min(const Num& a, const Num& b) {
  expects_alike(a, b, "min");
  const double v = std::min(a.value(), b.value());
  return {v, a.dimension(), make_call("min", {a.formula(), b.formula()}, v)};
}
Num max(const Num& a, const Num& b) {
  expects_alike(a, b, "max");
  const double v = std::max(a.value(), b.value());
  return {v, a.dimension(), make_call("max", {a.formula(), b.formula()}, v)};
}
Num pow(const Num& x, int exponent) {
  const double v = std::pow(x.value(), exponent);
  return {v, power(x.dimension(), exponent), make_node(Op::power, {x.formula(), make_number(exponent)}, v)};
}
Num square(const Num& x) {
  const double v = square(x.value());
  return {v, power(x.dimension(), 2), make_node(Op::power, {x.formula(), make_number(2)}, v)};
}
Num cube(const Num& x) {
  const double v = cube(x.value());
  return {v, power(x.dimension(), 3), make_node(Op::power, {x.formula(), make_number(3)}, v)};
}

}  // namespace taut
