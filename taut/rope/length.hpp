#pragma once
#include <span>
#include <vector>

#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// A piece of a rope's path and the tension in it: the tension varies linearly along its material, which is exact on a
/// straight piece and, for the stretch, within (T1 - T0)^2/(12 T EA) of the capstan law on an arc; for a span use
/// `stretched_span`.
struct TensionPiece {
  double unstretched = 0;       ///< m, at the reference temperature, >= 0
  double T_from = 0, T_to = 0;  ///< N
};

/// The three lengths of a rope that must never be mixed up, m.
struct RopeLengths {
  double unstretched = 0;  ///< at the reference temperature, no tension: what a catalogue's EA and mass refer to
  double installed = 0;    ///< at the temperature, no tension: what is cut, L (1 + a dT)
  double stretched = 0;    ///< at the temperature, under load: what lies between the ends
};
RopeLengths operator+(const RopeLengths& a, const RopeLengths& b);

/// Expansion of steel wire rope, 1/K.
inline constexpr double steel_expansion = 1.2e-5;

/// Lengths of a path: the sum of L (1 + thermal_strain) (1 + (T_from + T_to)/(2 EA)). EA > 0, infinity allowed.
RopeLengths path_lengths(std::span<const TensionPiece> path, double stiffness, double thermal_strain = 0);

/// Unstretched length of a piece that measures `stretched` under these tensions and temperature: the inverse, m.
double unstretched_length(double stretched, double T_from, double T_to, double stiffness, double thermal_strain = 0);

/// Lengths of a solved span; `rope` at the reference temperature, `force` of its heated self.
RopeLengths stretched_span(const CatenaryRope& rope, const CatenaryForce& force, double thermal_strain = 0);

/// Stretched length of an arc of a sheave on which the tension runs by the capstan law from T_from to T_to, for the
/// length of the arc R theta under load: the unstretched length on it, m. L = R theta [1 - ln((1 + T_to/EA)/(1 +
/// T_from/EA))/ln(T_to/T_from)].
double unstretched_on_arc(double arc, double T_from, double T_to, double stiffness);

/// Mean stretch per unit: (T_from + T_to)/(2 EA), and the tension at which a rope measured `stretched` has
/// `unstretched` in it, with its middle at that tension, N: EA (stretched/unstretched - 1).
double tension_of_stretch(double unstretched, double stretched, double stiffness);

}  // namespace taut::rope
