#pragma once
#include "taut/machine/description/machine_limits.hpp"

/// Beyond these an input of an analysis is a mistake.
namespace taut::study {

inline constexpr double farthest = machine::description::farthest;  // m: lengths and heights
/// m: places along a horizontal direction. On the map both coordinates may reach `farthest`, and a slanting direction
/// adds them up: sqrt(2) times that.
inline constexpr double farthest_along = 2 * farthest;
inline constexpr double strongest = 1e12;    // N
inline constexpr double heaviest = 1e9;      // kg
inline constexpr double longest_pull = 1e4;  // m

}  // namespace taut::study
