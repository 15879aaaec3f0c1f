#pragma once
#include <optional>

#include "taut/math/vector.hpp"

namespace taut::rope {

/// Motion of the rope along its path from in to out. It determines on which side friction makes the tension larger.
enum class Flow { in_to_out, out_to_in, at_rest };

/// State of the rope on a sheave or saddle.
enum class ContactState {
  turning,  ///< the sheave turns with the rope; its bearing takes the loss
  stuck,    ///< friction holds the rope (and the bearing the sheave)
  slipping  ///< the rope slides
};

/// One arc of a rope on a sheave or saddle. A saddle (block, tree shoe, braked drum) does not turn; its efficiency is
/// not used.
struct Contact {
  double wrap = 0;      ///< rad, >= 0
  double friction = 0;  ///< rope on groove, effective (see v_groove_friction), >= 0
  /// Of the bearing: smaller over larger tension when the rope turns the sheave, 0 < efficiency <= 1.
  double efficiency = 1;
  bool turns = true;  ///< false: saddle
  /// m v^2, N: the part of the tension of a running rope that does not press on the sheave, >= 0.
  double momentum_flow = 0;
};

/// Bounds of a tension, N.
struct Band {
  double low = 0, high = 0;
};
struct OutTension {
  double T = 0;         ///< N
  double dT_dT_in = 1;  ///< of T_out
  double dT_dwrap = 0;  ///< N/rad
};

/// Largest value of (T_out - c)/(T_in - c), c = m v^2. On a saddle exp(mu theta) (Euler, Eytelwein). On a turning
/// sheave 1/efficiency, or exp(mu theta) where that is smaller: the groove then slips before the bearing turns. The
/// smallest value is the inverse of the largest.
double largest_ratio(const Contact& contact);

/// T_out of a moving rope, with r = largest_ratio. in_to_out: T_out - c = r (T_in - c), the larger tension; out_to_in:
/// T_out - c = (T_in - c)/r. Throws ContractViolation when flow is at_rest or T_in < c.
OutTension tension_out(const Contact& contact, double T_in, Flow flow);

/// The interval of T_out that a rope at rest can have with this T_in >= 0: from T_in/r to r T_in, r = largest_ratio (c
/// = 0 at rest).
Band band_at_rest(const Contact& contact, double T_in);

/// State for given tensions at both sides. At the bound the rope slips or turns, whichever of groove and bearing holds
/// less; inside the bounds it is stuck. A ratio within `tolerance` (relative) of a bound counts as at the bound.
ContactState state_of(const Contact& contact, double T_in, double T_out, double tolerance = 1e-9);

/// Direction in which a rope moves, or begins to move, for these tensions; at_rest inside the bounds.
Flow flow_of(const Contact& contact, double T_in, double T_out, double tolerance = 1e-9);

/// Utilisation of the grip on the groove: ln(T_1/T_2)/(mu theta), tensions less c, the larger over the smaller; 1 at
/// the limit of slip, infinite without friction.
double grip_used(const Contact& contact, double T_in, double T_out);

/// Force of the rope on the sheave, N: (T_out - c) leaves - (T_in - c) arrives, with `arrives`, `leaves` the unit
/// vectors of the rope in the direction of the path. With equal tensions: 2 T sin(theta/2) along the bisector.
Vector3 resultant(const Contact& contact, double T_in, const Vector3& arrives, double T_out, const Vector3& leaves);

/// Line pressure of the rope on the round, N/m: (T - c)/R, at the end with the tension T.
double line_pressure(const Contact& contact, double tension, double radius);

/// Effective friction coefficient of a groove. V-groove: mu/sin(b), b half the groove angle, rad, 0 < b <= pi/2.
/// Undercut round groove (form of EN 81-50): 4 mu (cos(g/2) - sin(b/2))/(pi - b - g - sin b + sin g), b undercut angle,
/// g groove angle, rad.
double v_groove_friction(double friction, double half_angle);
double undercut_groove_friction(double friction, double undercut_angle, double groove_angle);

/// Creep of an elastic rope on a driving or driven sheave (Reynolds 1875, Grashof). The rope slips on the arc
/// `slip_arc` = ln((T1 - c)/(T2 - c))/mu before it leaves the sheave, and sticks on the rest of the wrap.
struct BeltCreep {
  double slip_arc = 0;  ///< rad
  double rest_arc = 0;  ///< rad; negative: the drive slips as a whole
  /// (T1 - T2)/EA: difference of the rope speeds at the tight and the slack side, over the rope speed.
  double creep = 0;
  bool holds = true;  ///< slip_arc <= wrap
};
/// T_1 >= T_2, N; stiffness EA > 0, N (infinite: no creep). Empty where T_2 <= c: the rope lifts off.
std::optional<BeltCreep> belt_creep(const Contact& contact, double T_1, double T_2, double stiffness);

}  // namespace taut::rope
