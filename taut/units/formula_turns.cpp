#include "taut/units/formula_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace taut {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double endless = std::numeric_limits<double>::infinity();

/// All numbers from lo to hi.
struct Range {
  double lo = 0, hi = 0;
  constexpr Range() = default;
  constexpr Range(double least, double most) : lo(least), hi(most) {}
  bool has_zero() const { return !(lo > 0 || hi < 0); }  // nor without bounds
  bool is_zero() const { return lo == 0 && hi == 0; }
};

constexpr Range anything{-endless, endless};

Range operator-(const Range& a) { return {-a.hi, -a.lo}; }
Range operator+(const Range& a, const Range& b) { return {a.lo + b.lo, a.hi + b.hi}; }
Range operator-(const Range& a, const Range& b) { return a + -b; }
Range operator*(const Range& a, const Range& b) {
  if (a.is_zero() || b.is_zero()) return {};
  const auto times = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const auto [least, most] = std::minmax({times(a.lo, b.lo), times(a.lo, b.hi), times(a.hi, b.lo), times(a.hi, b.hi)});
  return {least, most};
}
Range operator/(const Range& a, const Range& b) {
  if (a.is_zero() && !b.is_zero()) return {};
  return b.has_zero() ? anything : a * Range{1 / b.hi, 1 / b.lo};
}
Range hull(const Range& a, const Range& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
Range square(const Range& a) {
  const double x = a.lo * a.lo, y = a.hi * a.hi;
  return {a.has_zero() ? 0 : std::min(x, y), std::max(x, y)};
}

Range power(const Range& a, double n) {
  if (n == 0) return {1, 1};
  if (n < 0) return Range{1, 1} / power(a, -n);
  const double x = std::pow(a.lo, n), y = std::pow(a.hi, n);
  if (std::fmod(n, 2) != 0) return {x, y};
  return {a.has_zero() ? 0 : std::min(x, y), std::max(x, y)};
}

/// Whether `range` has the place `first` + k `period`, k whole.
bool has_place(const Range& range, double first, double period) {
  return std::floor((range.hi - first) / period) >= std::ceil((range.lo - first) / period);
}

Range sine(const Range& a) {
  if (!std::isfinite(a.lo) || !std::isfinite(a.hi)) return {-1, 1};
  const double x = std::sin(a.lo), y = std::sin(a.hi);
  return {has_place(a, -half_turn / 2, 2 * half_turn) ? -1 : std::min(x, y),
          has_place(a, half_turn / 2, 2 * half_turn) ? 1 : std::max(x, y)};
}

Range cosine(const Range& a) { return sine(a + Range{half_turn / 2, half_turn / 2}); }

/// Bounds of a part of a formula and of its slope.
struct Bounds {
  Range value, slope;
  Bounds() = default;
  Bounds(const Range& of_value, const Range& of_slope) : value(of_value), slope(of_slope) {}
};

Bounds root(const Bounds& a) {
  const Range value{std::sqrt(std::max(0.0, a.value.lo)), std::sqrt(std::max(0.0, a.value.hi))};
  return {value, a.slope.is_zero() ? Range{} : a.slope / (value + value)};
}

Bounds tangent(const Bounds& a) {
  if (!std::isfinite(a.value.lo + a.value.hi) || has_place(a.value, half_turn / 2, half_turn))
    return {anything, anything};
  const Range value{std::tan(a.value.lo), std::tan(a.value.hi)};
  return {value, (Range{1, 1} + square(value)) * a.slope};
}

Bounds arc_of(const Bounds& a, bool cosine) {
  const auto within = [](double x) { return std::clamp(x, -1.0, 1.0); };
  const Range sine{std::asin(within(a.value.lo)), std::asin(within(a.value.hi))};
  const Range rest = Range{1, 1} - square({within(a.value.lo), within(a.value.hi)});
  const Range root{std::sqrt(std::max(0.0, rest.lo)), std::sqrt(std::max(0.0, rest.hi))};
  const Range slope = a.slope.is_zero() ? Range{} : a.slope / root;
  return cosine ? Bounds{Range{half_turn / 2, half_turn / 2} - sine, -slope} : Bounds{sine, slope};
}

/// At the origin, and where the angle jumps from pi to -pi.
bool angle_jumps(const Bounds& y, const Bounds& x) { return y.value.has_zero() && x.value.lo <= 0; }

Bounds angle_between(const Bounds& y, const Bounds& x) {
  if (angle_jumps(y, x)) return {{-half_turn, half_turn}, anything};
  const auto [least, most] = std::minmax({std::atan2(y.value.lo, x.value.lo), std::atan2(y.value.lo, x.value.hi),
                                          std::atan2(y.value.hi, x.value.lo), std::atan2(y.value.hi, x.value.hi)});
  return {{least, most}, (x.value * y.slope - y.value * x.slope) / (square(x.value) + square(y.value))};
}

Bounds applied(const Operation& o, const Bounds& a, const Bounds& b) {
  using Kind = Operation::Kind;
  const Range one{1, 1};
  switch (o.kind) {
    case Kind::plus:
      return {a.value + b.value, a.slope + b.slope};
    case Kind::minus:
      return {a.value - b.value, a.slope - b.slope};
    case Kind::times:
      return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    case Kind::over: {
      const Range value = a.value / b.value;
      return {value, (a.slope - value * b.slope) / b.value};
    }
    case Kind::power:
      return {power(a.value, o.constant),
              o.constant == 0 ? Range{} : Range{o.constant, o.constant} * power(a.value, o.constant - 1) * a.slope};
    case Kind::root:
      return root(a);
    case Kind::size:
      if (a.value.lo >= 0) return a;
      if (a.value.hi <= 0) return {-a.value, -a.slope};
      return {{0, std::max(-a.value.lo, a.value.hi)}, hull(a.slope, -a.slope)};
    case Kind::least:
      if (a.value.hi <= b.value.lo) return a;
      if (b.value.hi <= a.value.lo) return b;
      return {{std::min(a.value.lo, b.value.lo), std::min(a.value.hi, b.value.hi)}, hull(a.slope, b.slope)};
    case Kind::most:
      if (a.value.lo >= b.value.hi) return a;
      if (b.value.lo >= a.value.hi) return b;
      return {{std::max(a.value.lo, b.value.lo), std::max(a.value.hi, b.value.hi)}, hull(a.slope, b.slope)};
    case Kind::sin:
      return {sine(a.value), cosine(a.value) * a.slope};
    case Kind::cos:
      return {cosine(a.value), -sine(a.value) * a.slope};
    case Kind::tan:
      return tangent(a);
    case Kind::asin:
      return arc_of(a, false);
    case Kind::acos:
      return arc_of(a, true);
    case Kind::atan:
      return {{std::atan(a.value.lo), std::atan(a.value.hi)}, a.slope / (one + square(a.value))};
    case Kind::atan2:
      return angle_between(a, b);
    case Kind::constant:
    case Kind::variable:
      break;
  }
  return a;
}

/// Whether an operation on such parts may make a kink or a jump.
bool may_kink(const Operation& o, const Bounds& a, const Bounds& b) {
  using Kind = Operation::Kind;
  switch (o.kind) {
    case Kind::size:
    case Kind::root:
      return a.value.has_zero() && !a.value.is_zero();
    case Kind::least:
    case Kind::most: {
      const Range apart = a.value - b.value;
      return apart.has_zero() && !apart.is_zero();
    }
    case Kind::over:
      return b.value.has_zero();
    case Kind::power:
      return o.constant < 0 && a.value.has_zero();
    case Kind::tan:
      return has_place(a.value, half_turn / 2, half_turn);
    case Kind::asin:
    case Kind::acos:
      return !a.slope.is_zero() && (a.value.lo <= -1 || a.value.hi >= 1);
    case Kind::atan2:
      return angle_jumps(a, b);
    default:
      return false;
  }
}

class Search {
 public:
  explicit Search(const FormulaText& formula)
      : operations_(formula.operations),
        bounds_(operations_.size()),
        counts_(operations_.size()),
        signs_(operations_.size()) {
    for (std::size_t i = 0; i < operations_.size(); ++i) signs_[i] = is_sign(operations_[i]) ? 1 : 0;
  }

  Array<Turn> between(double from, double to) {
    if (!(to > from) || !std::isfinite(from) || !std::isfinite(to)) return {};
    Array<Turn> all;
    for (const Range& part : search(from, to, true)) add(part, from, to, true, all);
    const Array<Turn> kinks = all;
    for (const Range& part : search(from, to, false)) {
      const auto near = [&](const Turn& kink) {
        return part.lo - 2 * of_extremes <= kink.at && kink.at <= part.hi + 2 * of_extremes;
      };
      if (std::none_of(kinks.begin(), kinks.end(), near)) add(part, from, to, false, all);
    }
    std::sort(all.begin(), all.end(), [](const Turn& a, const Turn& b) { return a.at < b.at; });
    return all;
  }

 private:
  static void add(const Range& part, double from, double to, bool kink, Array<Turn>& all) {
    const double at = part.lo + (part.hi - part.lo) / 2;
    if (at > from && at < to) all.push_back({at, kink});
  }

  /// The shortest parts, one for each kink or each extreme.
  Array<Range> search(double from, double to, bool kinks) {
    constexpr std::size_t most_parts = 1U << 17U;
    double size = std::exp2(std::ceil(std::log2(to - from)));
    Array<double> parts;  // each from k to k + 1 times the size
    for (double k = std::floor(from / size); k * size < to; ++k) parts.push_back(k);
    Array<Range> found;
    for (; !parts.empty(); size /= 2) {
      Array<double> halves;
      for (const double k : parts) {
        const Range part{k * size, (k + 1) * size};
        if (part.hi <= from || part.lo >= to) continue;
        bound(part);
        const Range& slope = bounds_.back().slope;
        if (kinks ? !may_kink_there() : !slope.has_zero() || slope.is_zero()) continue;
        if (size <= shortest(part, kinks)) {
          found.push_back(part);
        } else {
          halves.push_back(2 * k);
          halves.push_back(2 * k + 1);
        }
      }
      if (halves.size() > most_parts) {
        for (const double k : halves) found.push_back({k * size / 2, k * size / 2});
        halves.clear();
      }
      parts = std::move(halves);
    }
    return side_by_side(std::move(found));
  }

  static double shortest(const Range& part, bool kinks) {
    constexpr double digits = 46;  // binary, of the place of a kink
    const double largest = std::max(std::abs(part.lo), std::abs(part.hi));
    const double resolved = std::exp2(std::ceil(std::log2(largest)) - digits);
    return kinks ? resolved : std::max(resolved, of_extremes);
  }

  /// Parts that lie side by side hold one turn.
  static Array<Range> side_by_side(Array<Range> found) {
    std::sort(found.begin(), found.end(), [](const Range& a, const Range& b) { return a.lo < b.lo; });
    Array<Range> all;
    for (const Range& part : found) {
      const bool goes_on = !all.empty() && part.hi > part.lo && part.lo - all.back().hi <= part.hi - part.lo;
      if (goes_on) {
        all.back().hi = part.hi;
      } else {
        all.push_back(part);
      }
    }
    return all;
  }

  /// Bounds of all operations over a part.
  void bound(const Range& part) {
    for (std::size_t i = 0; i < operations_.size(); ++i) {
      const Operation& o = operations_[i];
      if (o.kind == Operation::Kind::constant) {
        bounds_[i] = {{o.constant, o.constant}, {}};
      } else if (o.kind == Operation::Kind::variable) {
        bounds_[i] = {part, {1, 1}};
      } else if (signs_[i] != 0) {
        const Range &a = of(o.a).value, &b = of(o.b).value;
        bounds_[i] = b.has_zero() ? Bounds{{-1, 1}, anything} : Bounds{sign_of(a) * sign_of(b), {}};
      } else {
        bounds_[i] = applied(o, of(o.a), of(o.b));
      }
    }
  }

  static Range sign_of(const Range& a) { return a.lo >= 0 ? Range{1, 1} : Range{-1, -1}; }

  /// |x|/x and x/|x|, the way to write a jump: bounds alone do not tell that it is a constant beside it.
  bool is_sign(const Operation& o) const {
    if (o.kind != Operation::Kind::over) return false;
    const Operation &a = operation(o.a), &b = operation(o.b);
    return (a.kind == Operation::Kind::size && same(a.a, o.b)) || (b.kind == Operation::Kind::size && same(o.a, b.a));
  }

  /// Whether two operations are the same formula.
  bool same(int i, int k) const {
    if (i == k) return true;
    const Operation &a = operation(i), &b = operation(k);
    if (a.kind != b.kind || a.constant != b.constant) return false;
    if (a.kind == Operation::Kind::constant || a.kind == Operation::Kind::variable) return true;
    const bool of_one = a.kind == Operation::Kind::power || (a.a == a.b && b.a == b.b);
    return same(a.a, b.a) && (of_one || same(a.b, b.b));
  }

  /// Whether one of the operations that count may make a kink: what a minimum or maximum leaves out does not.
  bool may_kink_there() {
    using Kind = Operation::Kind;
    std::fill(counts_.begin(), counts_.end(), char{0});
    counts_.back() = 1;
    for (std::size_t i = operations_.size(); i-- > 0;) {
      const Operation& o = operations_[i];
      if (counts_[i] == 0 || o.kind == Kind::constant || o.kind == Kind::variable) continue;
      const Bounds &a = of(o.a), &b = of(o.b);
      if (may_kink(o, a, b)) return true;
      const bool chooses = o.kind == Kind::least || o.kind == Kind::most;
      const bool first = o.kind == Kind::least ? a.value.hi <= b.value.lo : a.value.lo >= b.value.hi;
      if (!chooses || first) counts_[static_cast<std::size_t>(o.a)] = 1;
      if (!chooses || !first) counts_[static_cast<std::size_t>(o.b)] = 1;
    }
    return false;
  }

  const Bounds& of(int operation) const { return bounds_[static_cast<std::size_t>(operation)]; }
  const Operation& operation(int i) const { return operations_[static_cast<std::size_t>(i)]; }

  static constexpr double of_extremes = 0x1p-30;  ///< size of the part in which an extreme is
  const Array<Operation>& operations_;
  Array<Bounds> bounds_;
  Array<char> counts_, signs_;
};

}  // namespace

Array<Turn> turns(const FormulaText& formula, double from, double to) { return Search(formula).between(from, to); }

}  // namespace taut
