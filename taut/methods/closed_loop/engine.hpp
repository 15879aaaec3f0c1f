#pragma once
#include <functional>

#include "taut/methods/closed_loop/case.hpp"

namespace taut::closed_loop {

/// The sag at which exact catenaries have what the mode gives, m, and the next deeper one, NaN when there is none.
struct ExactSag {
  double sag = Output::none;
  double second = Output::none;
};

/// Exact catenaries for this loop, from outside: the published calculation does not know how they are made. Whoever has
/// them hands them in; either function may be empty, and both answer for one position `c` of the deck.
struct Engine {
  /// Modes winch_pull, loop_length and free_running. c.f is not read.
  std::function<Outcome(const Input& in, const Case<double>& c, ExactSag& found)> sag;
  /// Fills the values of `out` that end in _exact, at the sag c.f. Infeasible: lift-off or a slack rope.
  std::function<Outcome(const Input& in, const Case<double>& c, Output& out)> solve;
};

/// No exact values.
inline const Engine no_engine{};

}  // namespace taut::closed_loop
