#pragma once

namespace taut::machine::description {

/// No machine of this earth is larger (m), heavier (kg, kg/m) or pulled harder (N); beyond, numbers lose their meaning.
inline constexpr double farthest = 1e6;
inline constexpr double heaviest = 1e9;
inline constexpr double strongest = 1e12;

}  // namespace taut::machine::description
