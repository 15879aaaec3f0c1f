#pragma once
#include <cmath>

#include "taut/calc/num.hpp"

/// Laws for the strength of a wire rope in use. `T` is double or Num. docs/theory/rope-checks.md
namespace taut::rope {

/// Share of the breaking force that is left where a rope at rest is bent over a sheave: 1 - 0.5/sqrt(D/d), without
/// unit. `ratio` = D/d > 0.25. A handbook form (unverified); a sheave maker's public table lies within 0.006 of it or
/// above (D/d 6 to 40).
template <class T>
T sheave_strength(const T& ratio) {
  using std::sqrt;
  return 1.0 - 0.5 / sqrt(ratio);
}

/// Bending stress in an outer wire, Pa: E_r delta/D (Shigley, Mechanical Engineering Design, wire rope). `modulus` of
/// the rope, Pa; `wire` diameter, m; `sheave` pitch diameter, m. An upper bound: the wires of a rope slide.
template <class T>
T bending_stress(const T& modulus, const T& wire, const T& sheave) {
  return modulus * wire / sheave;
}

/// The pull that would stress the whole metallic area `area` (m2) as much as the bending: E_r delta A/D, N.
template <class T>
T bending_pull(const T& modulus, const T& wire, const T& area, const T& sheave) {
  return modulus * wire * area / sheave;
}

/// Nominal pressure of a rope in its groove, Pa: 2 F/(d D). `sheave` pitch diameter, m.
template <class T>
T groove_pressure(const T& force, const T& rope, const T& sheave) {
  return 2.0 * force / (rope * sheave);
}

/// Least D/d of resistance_factor: below it the denominator is not positive.
inline constexpr double least_ratio_en13001 = 5.657;

/// Rope resistance factor of a running rope, static proof: gamma_rb = max(2.07, 1.35 + 5/((D/d)^0.8 - 4)), EN 13001-3-2
/// as recalled (unverified). `ratio` = D/d > 5.66.
template <class T>
T resistance_factor(const T& ratio) {
  using std::exp, std::log, std::max;
  return max(T(2.07), 1.35 + 5.0 / (exp(0.8 * log(ratio)) - 4.0));
}

/// Rope force history parameter s_r = k_r w_tot/5e5, EN 13001-3-2 as recalled (unverified). `spectrum` k_r of the
/// force, 0 to 1; `bends` w_tot in the rope's design life.
template <class T>
T force_history(const T& spectrum, const T& bends) {
  return spectrum * bends / 5e5;
}

/// Largest pull of the fatigue proof, N: F_u f_f/(7 s_r^(1/3)), EN 13001-3-2 as recalled (unverified). `factor` f_f:
/// D/d, grade, fleet angle, groove.
template <class T>
T fatigue_pull(const T& breaking_force, const T& factor, const T& history) {
  using std::cbrt;
  return breaking_force * factor / (7.0 * cbrt(history));
}

/// Smallest diameter of a rope of the breaking force factor K (F_min = K d^2 R_r) in grade R_r (Pa) that carries the
/// pull S (N) with the factor Z_p, m: sqrt(Z_p S/(K R_r)), ISO 4308-1.
template <class T>
T least_diameter(const T& safety_factor, const T& pull, const T& breaking_factor, const T& grade) {
  using std::sqrt;
  return sqrt(safety_factor * pull / (breaking_factor * grade));
}

}  // namespace taut::rope
