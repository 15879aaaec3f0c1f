#include "taut/machine/signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/units/expression.hpp"
#include "taut/units/formula_turns.hpp"
#include "taut/units/jet.hpp"

namespace taut::machine {
namespace {

SignalValue value_of(double constant, double /*t*/) { return {.value = constant, .rate = 0, .acceleration = 0}; }

SignalValue value_of(const Moves& law, double t) {
  double from = law.from;
  for (const Move& move : law.moves) {
    if (t < move.at) break;
    if (t >= move.at + move.over) {
      from = move.to;
      continue;
    }
    const double s = (t - move.at) / move.over;
    const double step = move.to - from;
    if (move.change == Change::linear) return {.value = from + step * s, .rate = step / move.over, .acceleration = 0};
    if (move.change == Change::half_cosine) {
      const double angle = std::numbers::pi * s, speed = std::numbers::pi / move.over;
      return {.value = from + step * (1 - std::cos(angle)) / 2,
              .rate = step * speed * std::sin(angle) / 2,
              .acceleration = step * speed * speed * std::cos(angle) / 2};
    }
    const double s2 = s * s;
    return {.value = from + step * s2 * s * (10 + s * (6 * s - 15)),
            .rate = step * 30 * s2 * (1 + s * (s - 2)) / move.over,
            .acceleration = step * 60 * s * (1 + s * (2 * s - 3)) / (move.over * move.over)};
  }
  return {.value = from, .rate = 0, .acceleration = 0};
}

/// The cubic between two points with given slopes (Hermite), at the share s of the way.
SignalValue hermite(double h, double y0, double y1, double m0, double m1, double s) {
  const double d = (y1 - y0) / h;
  const double a = m0 - d, b = m1 - d;  // deviation of the slopes from the straight line
  const double r = 1 - s;
  return {.value = y0 + s * (y1 - y0) + h * s * r * (r * a - s * b),
          .rate = d + a * r * (1 - 3 * s) - b * s * (2 - 3 * s),
          .acceleration = (a * (6 * s - 4) + b * (6 * s - 2)) / h};
}

SignalValue value_of(const Curve& law, double t) {
  if (t < law.t.front()) return {.value = law.value.front(), .rate = 0, .acceleration = 0};
  if (t >= law.t.back()) return {.value = law.value.back(), .rate = 0, .acceleration = 0};
  const auto after = std::upper_bound(law.t.begin(), law.t.end(), t);
  const auto i = static_cast<std::size_t>(after - law.t.begin()) - 1;
  const double h = law.t[i + 1] - law.t[i];
  const double s = (t - law.t[i]) / h;
  const double step = law.value[i + 1] - law.value[i];
  if (law.slopes.empty()) return {.value = law.value[i] + s * step, .rate = step / h, .acceleration = 0};
  return hermite(h, law.value[i], law.value[i + 1], law.slopes[i], law.slopes[i + 1], s);
}

SignalValue value_of(const Sine& law, double t) {
  const double angle = law.omega * t + law.phase;
  const double s = law.amplitude * std::sin(angle);
  return {.value = law.mean + s,
          .rate = law.amplitude * law.omega * std::cos(angle),
          .acceleration = -law.omega * law.omega * s};
}

SignalValue value_of(const TimeFormula& law, double t) {
  const Jet jet = jet_at(*law, t);
  return {.value = jet.value, .rate = jet.first, .acceleration = jet.second};
}

/// Of the cubics of a smooth curve, whose tops need not lie at its points.
Array<double> extremes_of(const Curve& law, double from, double to) {
  Array<double> times;
  for (std::size_t i = 0; i < law.slopes.size() && i + 1 < law.t.size(); ++i) {
    const double h = law.t[i + 1] - law.t[i], d = (law.value[i + 1] - law.value[i]) / h;
    const double a = law.slopes[i] - d, b = law.slopes[i + 1] - d;
    // the rate (hermite): 3 (a + b) s^2 - 2 (2 a + b) s + a + d
    const double half = 2 * a + b, inside = half * half - 3 * (a + b) * (a + d);
    if (inside < 0) continue;
    const double q = half + std::copysign(std::sqrt(inside), half);
    std::array<double, 2> roots = {(a + d) / q, q / (3 * (a + b))};
    std::sort(roots.begin(), roots.end());
    for (const double s : roots) {
      const double t = law.t[i] + s * h;
      if (s > 0 && s < 1 && t > from && t < to) times.push_back(t);
    }
  }
  return times;
}

/// Beyond `most_extremes` only every n-th, n odd: a highest and a lowest one in turn.
Array<double> extremes_of(const Sine& law, double from, double to) {
  constexpr double most_extremes = 1e5;
  Array<double> times;
  if (law.amplitude == 0 || law.omega == 0) return times;
  const double omega = std::abs(law.omega), phase = std::copysign(1.0, law.omega) * law.phase;
  const auto number = [&](double t) { return (omega * t + phase) / std::numbers::pi - 0.5; };
  const double first = std::ceil(number(from)), more = std::floor(number(to)) - first;
  const double every = 2 * std::ceil(std::max(more / most_extremes - 1, 0.0) / 2) + 1;
  for (double k = 0; k <= more; k += every) {
    const double t = ((first + k + 0.5) * std::numbers::pi - phase) / omega;
    if (t > from && t < to) times.push_back(t);
  }
  return times;
}

/// The half cosine in which `signal` is at the time t; none otherwise.
const Move* half_cosine_at(const Signal& signal, double t) {
  const auto* law = std::get_if<Moves>(&signal.law);
  if (law == nullptr) return nullptr;
  for (const Move& move : law->moves) {
    if (move.change == Change::half_cosine && t > move.at && t < move.at + move.over) return &move;
  }
  return nullptr;
}

/// Between two breakpoints: a polynomial of degree 5 at most, for which three points of Gauss are exact, or a half
/// cosine.
double integral_of_piece(const Signal& signal, double from, double to) {
  if (const Move* move = half_cosine_at(signal, (from + to) / 2)) {
    const double speed = std::numbers::pi / move->over, half = speed * (to - from) / 2;
    const double middle = speed * ((from + to) / 2 - move->at);
    const double start = at(signal, move->at).value, step = move->to - start;
    // the cosine's integral 2 cos(middle) sin(half)/speed, without cancellation
    return (start + step / 2) * (to - from) - step * std::cos(middle) * std::sin(half) / speed;
  }
  static const std::array<double, 3> place = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
  static constexpr std::array<double, 3> weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  const double half = (to - from) / 2, middle = (from + to) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += weight[i] * at(signal, middle + half * place[i]).value;
  return half * sum;
}

/// Four points of Lobatto: exact for a polynomial of degree 5 too, and the ends see a kink that no inner point sees.
double integral_with_ends(const Signal& signal, double from, double to) {
  static const double place = std::sqrt(0.2);
  const double half = (to - from) / 2, middle = (from + to) / 2;
  const auto value = [&](double x) { return at(signal, middle + half * x).value; };
  return half * (value(-1) + value(1) + 5 * (value(-place) + value(place))) / 6;
}

/// Of a formula: halved until both rules agree, at a kink at most 40 times.
double integral_by_halves(const Signal& signal, double from, double to, double enough, int halvings) {
  const double by_gauss = integral_of_piece(signal, from, to);
  if (halvings == 0 || std::abs(by_gauss - integral_with_ends(signal, from, to)) <= enough) return by_gauss;
  const double middle = (from + to) / 2;
  return integral_by_halves(signal, from, middle, enough / 2, halvings - 1) +
         integral_by_halves(signal, middle, to, enough / 2, halvings - 1);
}

/// Between two turns of the formula: it only rises or only falls.
double integral_between_turns(const Signal& signal, double from, double to) {
  constexpr double share = 1e-12;
  constexpr int pieces = 16, most_halvings = 40;
  const auto place = [&](int i) { return from + (to - from) * i / pieces; };
  double largest = 0, sum = 0;
  for (int i = 0; i <= pieces; ++i) largest = std::max(largest, std::abs(at(signal, place(i)).value));
  for (int i = 0; i < pieces; ++i) {
    const double a = place(i), b = place(i + 1);
    sum += integral_by_halves(signal, a, b, share * largest * (b - a), most_halvings);
  }
  return sum;
}

double integral_of_formula(const Signal& signal, double from, double to) {
  double sum = 0, last = from;
  for (const Turn& turn : turns(*std::get<TimeFormula>(signal.law), from, to)) {
    sum += integral_between_turns(signal, last, turn.at);
    last = turn.at;
  }
  return sum + integral_between_turns(signal, last, to);
}

}  // namespace

SignalValue at(const Signal& signal, double t) {
  return std::visit([&](const auto& law) { return value_of(law, t); }, signal.law);
}

std::optional<SignalRange> range_of(const Signal& signal) {
  if (std::holds_alternative<Sine>(signal.law) || std::holds_alternative<TimeFormula>(signal.law)) return std::nullopt;
  const double first = at(signal, 0).value;
  SignalRange range{.least = first, .most = first, .kept = std::abs(first)};
  double largest = range.kept;
  Array<double> times = breakpoints(signal);
  if (const auto* curve = std::get_if<Curve>(&signal.law)) {
    for (const double t : extremes_of(*curve, curve->t.front(), curve->t.back())) times.push_back(t);
    std::sort(times.begin(), times.end());
  }
  for (const double t : times) {
    const double value = at(signal, t).value, size = std::abs(value);
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
    range.kept = size >= largest ? size : std::min(range.kept, size);
    largest = std::max(largest, size);
  }
  return std::isfinite(first) ? std::optional(range) : std::nullopt;
}

double integral(const Signal& signal, double from, double to) {
  if (const auto* sine = std::get_if<Sine>(&signal.law); sine != nullptr && sine->omega != 0) {
    // cos a - cos b = 2 sin((a + b)/2) sin((b - a)/2), without cancellation
    const double half = sine->omega * (to - from) / 2;
    const double middle = sine->omega * (from + to) / 2 + sine->phase;
    return sine->mean * (to - from) + 2 * sine->amplitude / sine->omega * std::sin(middle) * std::sin(half);
  }
  if (std::holds_alternative<TimeFormula>(signal.law)) return integral_of_formula(signal, from, to);
  double sum = 0;
  double last = from;
  for (const double t : breakpoints(signal)) {
    if (t <= from) continue;
    if (t >= to) break;
    sum += integral_of_piece(signal, last, t);
    last = t;
  }
  return sum + integral_of_piece(signal, last, to);
}

Array<double> breakpoints(const Signal& signal) {
  Array<double> times;
  if (const auto* law = std::get_if<Moves>(&signal.law)) {
    for (const Move& move : law->moves) {
      times.push_back(move.at);
      times.push_back(move.at + move.over);
    }
  } else if (const auto* curve = std::get_if<Curve>(&signal.law)) {
    times = curve->t;
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Array<double> breakpoints(const Signal& signal, double from, double to) {
  Array<double> times;
  if (const auto* formula = std::get_if<TimeFormula>(&signal.law)) {
    for (const Turn& turn : turns(**formula, from, to)) {
      if (turn.kink) times.push_back(turn.at);
    }
    return times;
  }
  for (const double t : breakpoints(signal)) {
    if (t > from && t < to) times.push_back(t);
  }
  return times;
}

Array<double> extremes(const Signal& signal, double from, double to) {
  if (const auto* curve = std::get_if<Curve>(&signal.law)) return extremes_of(*curve, from, to);
  if (const auto* sine = std::get_if<Sine>(&signal.law)) return extremes_of(*sine, from, to);
  Array<double> times;
  if (const auto* formula = std::get_if<TimeFormula>(&signal.law)) {
    for (const Turn& turn : turns(**formula, from, to)) {
      if (!turn.kink) times.push_back(turn.at);
    }
  }
  return times;
}

Curve smooth_curve(Array<double> t, Array<double> value) {
  expects(t.size() >= 2 && t.size() == value.size(), "a curve goes through two points or more");
  const std::size_t last = t.size() - 1;
  // m[i-1]/h[i-1] + 2 m[i] (1/h[i-1] + 1/h[i]) + m[i+1]/h[i] = 3 (d[i-1]/h[i-1] + d[i]/h[i]); m = 0 at both ends
  Array<double> slopes(last + 1, 0.0), upper(last + 1, 0.0);
  for (std::size_t i = 1; i < last; ++i) {
    const double before = 1 / (t[i] - t[i - 1]), after = 1 / (t[i + 1] - t[i]);
    const double right = 3 * ((value[i] - value[i - 1]) * before * before + (value[i + 1] - value[i]) * after * after);
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    slopes[i] = (right - before * slopes[i - 1]) / pivot;
  }
  for (std::size_t i = last; i-- > 1;) slopes[i] -= upper[i] * slopes[i + 1];
  return {.t = std::move(t), .value = std::move(value), .slopes = std::move(slopes)};
}

}  // namespace taut::machine
