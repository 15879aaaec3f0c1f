#pragma once
#include <optional>

#include "taut/math/vector.hpp"

namespace taut::rope {

/// How the rope moves along its path, from in to out: the direction decides on which side friction makes the tension
/// larger.
enum class Flow { in_to_out, out_to_in, at_rest };

/// What the rope does on a sheave or saddle.
enum class ContactState {
  turning,  ///< the sheave turns with the rope; its bearing takes the loss
  stuck,    ///< friction holds the rope (and the bearing the sheave)
  slipping  ///< the rope slides
};

/// One arc of a rope on a sheave or saddle. A saddle (block, tree shoe, drum on its brake) does not turn: efficiency is
/// of no account there.
struct Contact {
  double wrap = 0;           ///< rad, >= 0
  double friction = 0;       ///< rope on groove, effective (see v_groove_friction), >= 0
  double efficiency = 1;     ///< of the bearing: tension kept when passing the turning sheave, 0 < efficiency <= 1
  bool turns = true;         ///< false: saddle
  double momentum_flow = 0;  ///< m v^2, N: what a running rope's tension loses as pressure on the sheave, >= 0
};

/// A pair of bounds, and the derivatives of T_out at one bound.
struct Band {
  double low = 0, high = 0;
};
struct OutTension {
  double T = 0;         ///< N
  double dT_dT_in = 1;  ///< of T_out
  double dT_dwrap = 0;  ///< N/rad
};

/// Largest value of (T_out - c)/(T_in - c), c = m v^2: exp(mu theta) on a saddle (Euler, Eytelwein), and on a turning
/// sheave 1/efficiency, or exp(mu theta) where the groove slips before the bearing turns. The smallest one is its
/// inverse.
double largest_ratio(const Contact& contact);

/// T_out of a moving rope. in_to_out: the large one, T_in times largest_ratio; out_to_in: T_in over it. T_in >= c; not
/// at rest.
OutTension tension_out(const Contact& contact, double T_in, Flow flow);

/// The tensions T_out that a rope at rest can have with this T_in (c is 0 at rest).
Band band_at_rest(const Contact& contact, double T_in);

/// State for given tensions at both sides, by the largest ratio that either the groove or the bearing holds. A ratio
/// within `tolerance` (relative) of a bound counts as at the bound.
ContactState state_of(const Contact& contact, double T_in, double T_out, double tolerance = 1e-9);

/// Which way a rope moves, or starts to move, for these tensions; at rest inside the band.
Flow flow_of(const Contact& contact, double T_in, double T_out, double tolerance = 1e-9);

/// Share of the capstan's grip that the tensions use: ln(T_1/T_2)/(mu theta), 1 at the limit of slip; infinite without
/// friction.
double grip_used(const Contact& contact, double T_in, double T_out);

/// Force of the rope on the sheave, N: T_out along the leaving rope less T_in along the arriving one, both as unit
/// vectors in path direction, each tension less c. On a plane sheave with equal tensions: 2 T sin(theta/2) along the
/// bisector.
Vector3 resultant(const Contact& contact, double T_in, const Vector3& arrives, double T_out, const Vector3& leaves);

/// Line pressure of the rope on the round, N/m: (T - c)/R at the end with the tension T.
double line_pressure(const Contact& contact, double tension, double radius);

/// Friction that a groove makes of mu. V-groove: mu/sin(b), b half the groove's angle, rad, 0 < b <= pi/2. Undercut
/// round groove (EN 81-50's form): 4 mu (cos(g/2) - sin(b/2))/(pi - b - g - sin b + sin g), b undercut angle, g groove
/// angle, rad.
double v_groove_friction(double friction, double half_angle);
double undercut_groove_friction(double friction, double undercut_angle, double groove_angle);

/// An elastic rope on a driven or driving sheave (belt creep; Reynolds 1875, Grashof): it slips on the arc
/// `slip_arc = ln((T1 - c)/(T2 - c))/mu`, before it leaves, and rests on the remainder of the wrap.
struct BeltCreep {
  double slip_arc = 0;  ///< rad
  double rest_arc = 0;  ///< rad; negative: the drive slips as a whole
  double creep = 0;     ///< (T1 - T2)/EA: rope speed at the tight side less that at the slack side, over the rope speed
  bool holds = true;    ///< slip_arc <= wrap
};
/// T_1 >= T_2 > c, stiffness EA > 0 (infinite: no creep). Empty where T_2 <= c: the rope lifts off.
std::optional<BeltCreep> belt_creep(const Contact& contact, double T_1, double T_2, double stiffness);

}  // namespace taut::rope
