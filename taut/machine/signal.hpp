#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/units/unit.hpp"

namespace taut {
struct FormulaText;
}

namespace taut::machine {

/// Value of a signal and its first two time derivatives. Time in s from the start of the motion, values in the SI unit
/// of the signal.
struct SignalValue {
  double value = 0;
  double rate = 0;
  double acceleration = 0;
};

/// How a value changes with the share s of the time that has passed.
enum class Change {
  linear,      ///< s
  smooth,      ///< 10 s^3 - 15 s^4 + 6 s^5: rate and acceleration zero at both ends
  half_cosine  ///< (1 - cos(pi s))/2: rate zero at both ends
};

/// One change of a signal: from its value at the time `at` to `to`, within the time `over`; 0: a jump.
struct Move {
  double at = 0;
  double to = 0;
  double over = 0;
  Change change = Change::linear;
};

/// Successive changes; none begins before the last one has ended.
struct Moves {
  double from = 0;  ///< value before the first change
  Array<Move> moves;
};

/// Values at increasing times t; constant before the first and after the last. Linear between them, or, with `slopes`
/// (one for each time), the cubic with these slopes.
struct Curve {
  Array<double> t;
  Array<double> value;
  Array<double> slopes;
};

/// mean + amplitude sin(omega t + phase)
struct Sine {
  double mean = 0;
  double amplitude = 0;
  double omega = 0;  ///< rad/s
  double phase = 0;  ///< rad
};

/// Of the time t in s, units/expression.hpp.
using TimeFormula = std::shared_ptr<const FormulaText>;

struct Signal {
  std::string name;  ///< empty: a constant written where it is used
  Unit unit;
  std::variant<double, Moves, Curve, Sine, TimeFormula> law = 0.0;
};

/// Value and derivatives at t. At a jump: those after the jump.
SignalValue at(const Signal& signal, double t);

/// The least and the largest value from the start on. None of a sine or a formula, which swing without end, and of a
/// constant that is not known (NaN).
struct SignalRange {
  double least = 0, most = 0;
  double kept = 0;  ///< the least size from the time of the largest size on: the end of a ramp, up or down
};
std::optional<SignalRange> range_of(const Signal& signal);

/// Integral of the value from `from` to `to`, `to` >= `from`; exact except for rounding, of a formula to 1e-12 of its
/// largest value. It is the rope that a drum with a given speed takes in.
double integral(const Signal& signal, double from, double to);

/// The times at which the value or a derivative jumps, increasing; without those of a formula.
Array<double> breakpoints(const Signal& signal);

/// The same between `from` and `to`, those of a formula too (units/formula_turns.hpp). An integrator has to end a step
/// there.
Array<double> breakpoints(const Signal& signal, double from, double to);

/// The times between `from` and `to` at which a signal may have an extreme: between these and its breakpoints it only
/// rises or only falls; of a sine 1e5 at most. An integrator that steps over one may not see that anything has changed.
Array<double> extremes(const Signal& signal, double from, double to);

/// The cubic spline through the points with a continuous second derivative and slope zero at both ends (clamped
/// spline), because the value is constant before and after. `t` increasing, at least two points.
Curve smooth_curve(Array<double> t, Array<double> value);

}  // namespace taut::machine
