#pragma once

/// Beyond these an input of an analysis is a mistake.
namespace taut::study {

inline constexpr double farthest = 1e6;      // m
inline constexpr double strongest = 1e12;    // N
inline constexpr double heaviest = 1e9;      // kg
inline constexpr double longest_pull = 1e4;  // m

}  // namespace taut::study
