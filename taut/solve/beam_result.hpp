#pragma once
#include <limits>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"

namespace taut::solve {

/// A section of a loaded beam.
struct BeamPoint {
  double s = 0;                           ///< along the axis as built, m
  Vector3 place = Vector3::Zero();        ///< m
  double N = 0;                           ///< axial force, tension positive, N
  double V = 0;                           ///< shear, N
  double M = 0;                           ///< bending moment, whatever its direction, N m
  double torsion = 0;                     ///< N m
  double shear_x = 0, shear_y = 0;        ///< V along the section's x, in which its strong axis bends, and y, N
  double bends_to_x = 0, bends_to_y = 0;  ///< M towards them, N m
  double stress = std::numeric_limits<double>::quiet_NaN();  ///< largest |N|/A + M/W, Pa; NaN: W not known
  Vector3 deflection = Vector3::Zero();  ///< from where it would be as built on what its start stands on, m
  double w = 0;                          ///< the part of it across the chord, m
};

/// A beam in its state. Forces and moments on the beam by what it begins on, at its start.
struct BeamResult {
  int beam = 0;
  Array<BeamPoint> points;  ///< from its start to its end; two where something is fixed to it
  Vector3 base_force = Vector3::Zero(), base_moment = Vector3::Zero();
  std::size_t most_bent = 0, most_pressed = 0, most_stressed = 0;  ///< points of largest M, |N|, stress
  double top_displacement = 0;                                     ///< size of the last point's deflection, m
  double lean = 0;  ///< of the chord of a beam with a free top, against where it was built, rad
  double bend = 0;  ///< largest turn of a section against the first one, less that as built, rad
  /// What all its forces may be multiplied with, everything else as it is, before the machine's tangent stiffness is no
  /// longer positive: alpha_cr of EN 1993-1-1, 5.2.1. Infinite: it never is (tension), or above 1000.
  double critical_factor = std::numeric_limits<double>::infinity();
  double compression = 0;  ///< the largest, N; 0: none
};

/// Beyond this turn against its first section a beam counts as failed: elastic struts find equilibria beyond buckling;
/// beyond this lean one with a free top has fallen over, and hangs.
inline constexpr double most_bend = 0.5;  // rad
inline constexpr double most_lean = 0.5;  // rad

}  // namespace taut::solve
