#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/line.hpp"

/// Branches that sag while the machine moves: the elastic catenary between the places where the rope leaves one round
/// and arrives at the next, at every moment the one at rest there (no transverse inertia). docs/theory/sagging.md.
///
/// The catenary's force follows from chord and unstretched length. Where an end has a radius, the tangent point follows
/// the rope's own direction there, and what lies on the round beyond that direction comes from the free length; both
/// are solved together, to rounding. Dampers and the momentum of a running rope add a tension along the chord: a
/// damper takes up the rate of (chord / unstretched length) by the share chi of it that the rope's stretch has in the
/// compliance along the chord, `EA beta chi^2 rate`, so that it is a dashpot, has nothing to do with how the whole rope
/// moves, becomes the straight branch's where the rope is taut, and fades where it hangs.
namespace taut::solve::dynamics {

/// A sagging line as it is at one time, beside its LineValues: there t and l are the chord's, e is the mean strain, T
/// the mean of the tensions at the ends.
struct SagValues {
  std::array<Vector3, 2> direction{Vector3::UnitX(), Vector3::UnitX()};  ///< of the rope at its ends, along the path
  std::array<Vector3, 2> seat{Vector3::UnitX(), Vector3::UnitX()};       ///< the same in the frames of its bodies
  std::array<Vector3, 2> pull{Vector3::Zero(), Vector3::Zero()};         ///< tension at its ends, along the path, N
  Vector3 along = Vector3::UnitX();                                      ///< horizontal, from start to end
  double H = 0, V = 0;      ///< tension in the middle of the unstretched length, along `along` and up, N
  double lowest = 0;        ///< least tension along it, N
  double stretches = 1;     ///< chi
  double chord_rate = 0;    ///< rate of chord over unstretched length, 1/s
  double damper = 0;        ///< tension of the damper, N
  double damper_rate = 0;   ///< its derivative by chord_rate, N s; 0 at a bound
  double damper_share = 0;  ///< its derivative by chi, N
  std::int8_t bounded = 0;  ///< the damper takes or gives all that there is: -1, 1
};

/// Whether the line hangs as a catenary: one that is broken does no more.
inline bool sags(const Line& line, const LineValues& now) { return line.sag >= 0 && now.gone > 0; }

/// Strain of a line if it were straight. Below 0 a line that sags bears nothing but its own weight: it is slack.
inline double strain_of_chord(const Line& line, const LineValues& now) {
  return sags(line, now) ? now.l / now.hung - 1 : now.e;
}

/// The catenary between the rounds of `now` (their centres and radii, and the rope on them as of `before`), with the
/// unstretched length `fed` (that rope's too) while the rope leaves and arrives as it did in `before`, seen from its
/// bodies; `winding`: stretch of what it leaves on a round where none stretches with it, infinite where the turning of
/// the line takes no rope. Fills touch, t, l, L, hung, arc, e, angle (from `angle`) and the shape.
/// False: there is none.
bool hang(const Line& line, const Array<Motion3>& bodies, const std::array<double, 2>& winding, const SagValues& before,
          double fed, const std::array<double, 2>& angle, LineValues& now, SagValues& is);

/// Tensions at its ends, with the damper's; `damping` beta, s.
void pull_sagging(const Line& line, double damping, LineValues& now, SagValues& is);

/// Force of the rope (one of its copies) on what holds an end, N.
Vector3 sagging_force(const Line& line, const LineValues& now, const SagValues& is, std::size_t end);

/// What the momentum of the running rope takes of that, N.
double sagging_thrust(const LineValues& now, const SagValues& is, std::size_t end);

/// How a sagging line follows one local unknown: a unit velocity of a freedom, or rope let in at its start (taken out
/// at its end).
struct SagColumn {
  std::array<Vector3, 2> pull{Vector3::Zero(), Vector3::Zero()};
  std::array<Vector3, 2> touch{Vector3::Zero(), Vector3::Zero()};  ///< seen from the origin of its own body
  Vector3 chord = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();  ///< of the touching point of the freedom's end, fixed to the body
  double L = 0, hung = 0;              ///< unstretched, with what stretches on its rounds, and without
  double e = 0, lowest = 0, stretches = 0;
  std::array<double, 2> T{0, 0}, angle{0, 0};
};
using SagColumns = std::array<SagColumn, 14>;
void sag_columns(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies,
                 const std::array<double, 2>& winding, const LineValues& now, const SagValues& is, SagColumns& columns);

/// The same for rope let in.
SagColumn sag_let_in(const Line& line, const Array<Motion3>& bodies, const std::array<double, 2>& winding,
                     const LineValues& now, const SagValues& is);

/// Elastic energy of one copy with what stretches on its rounds, and that of its weight against both halves hanging at
/// its ends, J.
struct SagEnergy {
  double elastic = 0, below = 0;
};
SagEnergy sag_energy(const Line& line, const LineValues& now, const SagValues& is);

/// Points on the rope between its ends, m, and its stretched length, m.
Array<Vector3> sag_curve(const Line& line, const LineValues& now, const SagValues& is, int parts);
double sag_stretched(const Line& line, const LineValues& now, const SagValues& is);

/// A round of another radius (a drum's next layer): the rope's force stays.
void hang_on_new_radius(const Line& line, const Array<Motion3>& bodies, std::size_t end, double radius, LineValues& of,
                        SagValues& is);

/// How a line begins. Directions of a saved state or of an equilibrium are kept with its length; without them
/// `now.L` is what is free along the straight line.
bool begin_to_hang(const Line& line, const Array<Motion3>& bodies, const DynamicState& start, int branch,
                   LineValues& now, SagValues& is);
/// Whether the weight of a branch is more than `light` times its tension where the motion begins, or whether it hung
/// where a saved one left off.
bool sags_by_weight(const Line& line, const DynamicState& start, int branch, double length, double light);

}  // namespace taut::solve::dynamics
