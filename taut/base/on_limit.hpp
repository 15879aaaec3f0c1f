#pragma once
#include <cmath>

namespace taut {

/// How far beyond a limit a value still counts as on it, in the unit of both. A value that lies on its limit comes out
/// of a calculation with so much rounding: a rope with a given tension of a third of its breaking force has a factor of
/// 2.9999999999999996, or of 3. Checks, counts of cases and comparisons all take this one.
inline double rounding_on(double limit) {
  constexpr double share = 1e-9;
  return share * std::abs(limit);
}

}  // namespace taut
