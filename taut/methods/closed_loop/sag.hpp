#pragma once
#include "taut/methods/closed_loop/engine.hpp"

namespace taut::closed_loop {

/// The sag that a mode other than `sag` asks for, with its bracket (m).
struct FoundSag {
  double low = 0;
  double high = 0;
  double second = Output::none;  ///< a deeper sag with the same tension, if there is one
};

/// What the wanted sag does not yet balance, N: T_lA - winch_pull head_efficiency, or the tension of the return rope at
/// the carriage - S. NaN where the case is infeasible.
double excess_of(const Input& in, const Case<double>& c, double sag);

/// Searches from small sags up, in steps of 4 %, to the first that is infeasible after a feasible one. Infeasible: no
/// sag gives the tension asked for; the message says what range is possible.
Outcome find_sag(const Input& in, const Case<double>& c, FoundSag& found);

/// Sets c.f: the sag given; or what the engine finds; or, without one, the root of excess_of in [found.low,
/// found.high], for a single carriage whose tension is given. Infeasible: no such sag, or only an engine could find it.
template <class T>
Outcome set_sag(const Input& in, const Case<double>& plain, const Engine& engine, Sheet<T>& s, Case<T>& c, Output& out);

}  // namespace taut::closed_loop
