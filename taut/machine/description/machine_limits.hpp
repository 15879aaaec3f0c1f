#pragma once

namespace taut::machine::description {

/// No place of this earth has larger map coordinates (m: a northing reaches 1e7); no machine is heavier (kg, kg/m) or
/// pulled harder (N); beyond, numbers lose their meaning.
inline constexpr double farthest = 1e7;
inline constexpr double heaviest = 1e9;
inline constexpr double strongest = 1e12;
/// Nor does anything of it melt (K), or stretch by heat as no solid does (1/K; aramid and polyethylene shrink).
inline constexpr double hottest = 2000;
inline constexpr double most_expansion = 1e-4;

}  // namespace taut::machine::description
