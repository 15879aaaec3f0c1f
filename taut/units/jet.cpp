#include "taut/units/jet.hpp"

#include <cmath>

namespace taut {
namespace {

/// f(u) and its derivatives by what u depends on, from f' and f'' by u.
Jet chain(const Jet& u, double f, double by_u, double twice) {
  return {f, by_u * u.first, twice * u.first * u.first + by_u * u.second};
}

Jet quotient(const Jet& u, const Jet& v) {
  Jet q{u.value / v.value, 0, 0};
  q.first = (u.first - q.value * v.first) / v.value;
  q.second = (u.second - 2 * q.first * v.first - q.value * v.second) / v.value;
  return q;
}

Jet power_of(const Jet& u, double n) {
  const auto factor = [&](double of, double exponent) { return of == 0 ? 0 : of * std::pow(u.value, exponent); };
  return chain(u, std::pow(u.value, n), factor(n, n - 1), factor(n * (n - 1), n - 2));
}

Jet angle_between(const Jet& y, const Jet& x) {
  const double square = x.value * x.value + y.value * y.value;
  const double first = (x.value * y.first - y.value * x.first) / square;
  const double second =
      (x.value * y.second - y.value * x.second) / square - 2 * first * (x.value * x.first + y.value * y.first) / square;
  return {std::atan2(y.value, x.value), first, second};
}

Jet applied(const Operation& o, const Jet& a, const Jet& b) {
  const double u = a.value, root = std::sqrt(u), rest = 1 - u * u;
  switch (o.kind) {
    case Operation::Kind::plus:
      return {a.value + b.value, a.first + b.first, a.second + b.second};
    case Operation::Kind::minus:
      return {a.value - b.value, a.first - b.first, a.second - b.second};
    case Operation::Kind::times:
      return {a.value * b.value, a.first * b.value + a.value * b.first,
              a.second * b.value + 2 * a.first * b.first + a.value * b.second};
    case Operation::Kind::over:
      return quotient(a, b);
    case Operation::Kind::power:
      return power_of(a, o.constant);
    case Operation::Kind::root:
      return chain(a, root, 1 / (2 * root), -1 / (4 * u * root));
    case Operation::Kind::size:
      return u < 0 ? Jet{-a.value, -a.first, -a.second} : a;
    case Operation::Kind::least:
      return a.value <= b.value ? a : b;
    case Operation::Kind::most:
      return a.value >= b.value ? a : b;
    case Operation::Kind::sin:
      return chain(a, std::sin(u), std::cos(u), -std::sin(u));
    case Operation::Kind::cos:
      return chain(a, std::cos(u), -std::sin(u), -std::cos(u));
    case Operation::Kind::tan: {
      const double tan = std::tan(u);
      return chain(a, tan, 1 + tan * tan, 2 * tan * (1 + tan * tan));
    }
    case Operation::Kind::asin:
      return chain(a, std::asin(u), 1 / std::sqrt(rest), u / (rest * std::sqrt(rest)));
    case Operation::Kind::acos:
      return chain(a, std::acos(u), -1 / std::sqrt(rest), -u / (rest * std::sqrt(rest)));
    case Operation::Kind::atan:
      return chain(a, std::atan(u), 1 / (1 + u * u), -2 * u / ((1 + u * u) * (1 + u * u)));
    case Operation::Kind::atan2:
      return angle_between(a, b);
    case Operation::Kind::constant:
    case Operation::Kind::variable:
      break;
  }
  return a;
}

}  // namespace

Jet jet_at(const FormulaText& formula, double variable) {
  Array<Jet> values(formula.operations.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Operation& o = formula.operations[i];
    if (o.kind == Operation::Kind::constant) {
      values[i] = {o.constant, 0, 0};
    } else if (o.kind == Operation::Kind::variable) {
      values[i] = {variable, 1, 0};
    } else {
      values[i] = applied(o, values[o.a], values[o.b]);
    }
  }
  return values.back();
}

}  // namespace taut
