#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"

namespace taut::solve {

/// Results at one section of a loaded beam.
struct BeamPoint {
  bool listed = true;               ///< in tables: one of the sections that the beam's `elements` ask for
  double s = 0;                     ///< along the axis as built, from the start, m
  Vector3 place = Vector3::Zero();  ///< m
  double N = 0;                     ///< axial force, tension positive, N
  double V = 0;                     ///< shear, N
  double M = 0;                     ///< bending moment, resultant of both directions, N m
  double torsion = 0;               ///< N m
  double shear_x = 0, shear_y = 0;  ///< components of V along x (bending about the strong axis) and y of the section, N
  double bends_to_x = 0, bends_to_y = 0;                     ///< components of M, bending towards x and y, N m
  double stress = std::numeric_limits<double>::quiet_NaN();  ///< largest equivalent, Pa; NaN: W not known
  Vector3 deflection = Vector3::Zero();  ///< from its position as built, carried along with the body at the start, m
  double w = 0;                          ///< the component of the deflection normal to the chord, m
};

/// Results of a beam. Base force and moment act on the beam at its start, exerted by its support.
struct BeamResult {
  int beam = 0;
  Array<BeamPoint> points;  ///< of each step from start to end; two points where something is fixed to it
  Vector3 base_force = Vector3::Zero(), base_moment = Vector3::Zero();
  /// Indices of the points with the largest M, |N| and stress.
  std::size_t most_bent = 0, most_pressed = 0, most_stressed = 0;
  double top_displacement = 0;  ///< magnitude of the deflection of the last point, m
  double lean = 0;  ///< inclination of the chord against its direction as built, of a beam with a free top, rad
  double bend = 0;  ///< largest rotation of a section against the first one, less that as built, rad
  /// Critical factor of its own forces: the factor on all internal forces of this beam, and on what acts on the bodies
  /// at its ends, at which the tangent stiffness of the machine is no longer positive definite; the stiffness of ropes
  /// and other beams unchanged. Infinite: no such factor (tension), or above 1000.
  double critical_factor = std::numeric_limits<double>::infinity();
  /// The same with the forces of all beams of the machine growing alike: several legs buckle together before one would
  /// with the others as they are.
  double critical_together = std::numeric_limits<double>::infinity();
  /// The same where the machine swings away instead, as a pendulum upside down: the tensions of ropes, as they are,
  /// hold more there than all that is elastic. Then the factors above are those with which the beams buckle while the
  /// tensions grow with them, as they do where they carry the same load.
  double swing_factor = std::numeric_limits<double>::infinity();
  /// alpha_cr of EN 1993-1-1, 5.2.1: the least factor on the loading at which it buckles, alone or with the others;
  /// of what is not pressed anywhere that of its own forces.
  double least_factor() const {
    return compression > 0 ? std::min(critical_factor, critical_together) : critical_factor;
  }
  double compression = 0;       ///< largest compression, N; 0: none
  double stress_in_corner = 0;  ///< largest, see largest_stress_in_corner, Pa
  double torsion_left_out = 0;  ///< the largest that its stresses don't contain because W_t is not known, N m
};

/// A beam counts as failed when `bend` exceeds most_bend, because elastic struts have equilibria beyond buckling; or
/// when `lean` of a free top exceeds most_lean, because it has then fallen over and hangs.
inline constexpr double most_bend = 0.5;  // rad
inline constexpr double most_lean = 0.5;  // rad

}  // namespace taut::solve
