#pragma once
#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// A point of a solved rope: its place seen from the start, m, and the tension there, N.
struct RopePoint {
  double x = 0, z = 0;
  double H = 0, V = 0;
  double tension() const;
};

/// The point that lies `s` of the unstretched rope from its start, 0 <= s <= length.
RopePoint point_at(const CatenaryRope& rope, const CatenaryForce& force, double s);

/// The unstretched length from the start to where the rope passes over `x` (0 <= x <= its end). The rope hangs in no
/// vertical line.
double length_to(const CatenaryRope& rope, const CatenaryForce& force, double x);

/// Vertical distance of the rope below its chord at `x`, m. Negative only by rounding.
double sag_at(const CatenaryRope& rope, const CatenaryForce& force, double x);

/// Where the rope is parallel to its chord: the largest sag below it. For a vertical chord (steeper than 1000 : 1; the
/// stretch alone, larger where the rope carries more of itself, sets a point off it by metres) there is no such thing
/// as a distance below it; `depth` is then how far a loop hangs below the lower end, 0 for a taut rope.
struct Sag {
  double depth = 0;  ///< m
  double x = 0;      ///< m
  double s = 0;      ///< unstretched, m
};
Sag largest_sag(const CatenaryRope& rope, const CatenaryForce& force);

/// The unstretched length from the start to the lowest point, an end where the rope does not sag below it.
double lowest_point(const CatenaryRope& rope, const CatenaryForce& force);

/// Length under load: L + (1/EA) times the integral of T over the unstretched length, m.
double stretched_length(const CatenaryRope& rope, const CatenaryForce& force);

/// Elastic energy, the integral of T^2/(2 EA), J.
double elastic_energy(const CatenaryRope& rope, const CatenaryForce& force);

}  // namespace taut::rope
