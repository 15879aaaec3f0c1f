#pragma once
#include <string>
#include <variant>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/units/unit.hpp"

namespace taut::machine {

/// A quantity over time, with its first two derivatives: how a drum is driven, a body moved, a rope let out. Times in
/// s from the start of the motion, values in SI of its unit.
struct SignalValue {
  double value = 0;
  double rate = 0;
  double acceleration = 0;
};

/// One change of a signal: from what it is to `to`, beginning at `at`, in the time `over`; 0: a jump. Linear, or
/// smooth: 10 s^3 - 15 s^4 + 6 s^5, rate and acceleration zero at both ends.
struct Move {
  double at = 0;
  double to = 0;
  double over = 0;
  bool smooth = false;
};

/// Changes one after the other, none beginning before the last has ended.
struct Moves {
  double from = 0;  ///< before the first
  Array<Move> moves;
};

/// Values at growing times, the first and the last one held before and after. Linear between them; with `slopes` (at
/// each time) the cubic that has them.
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

struct Signal {
  std::string name;  ///< empty: a constant written where it is used
  Unit unit;
  std::variant<double, Moves, Curve, Sine> law = 0.0;
};

/// Value and derivatives at t. Where they jump, what they are after the jump.
SignalValue at(const Signal& signal, double t);

/// Integral of the value over the time from `from` to `to` >= `from`: the rope that a drum driven by a speed takes in.
/// Exact but for rounding.
double integral(const Signal& signal, double from, double to);

/// The times at which the value or a derivative jumps, growing: where an integrator has to end a step.
Array<double> breakpoints(const Signal& signal);

/// A curve through the points with continuous second derivative, at rest at both ends (clamped cubic spline), as it
/// stands still before and after. `t` grows, at least two points.
Curve smooth_curve(Array<double> t, Array<double> value);

}  // namespace taut::machine
