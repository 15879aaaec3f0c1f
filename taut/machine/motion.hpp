#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/machine/description/measure_keys.hpp"
#include "taut/machine/description/motion_keys.hpp"
#include "taut/machine/place.hpp"
#include "taut/machine/signal.hpp"
#include "taut/math/vector.hpp"

/// Parts of a compiled machine that matter when it moves: plain values and indices, as in model.hpp.
namespace taut::machine {

/// A motion of a body given by a signal: a displacement (m, from its place at the start) or a rotation (rad).
struct DrivenWay {
  Vector3 along = Vector3::Zero();  ///< unit vector in the ground frame, or 0
  Vector3 about = Vector3::Zero();  ///< unit vector in the ground frame through the body's origin, or 0
  Signal signal;
};

/// Kind of drive of a drum or driven sheave.
enum class DriveKind {
  held,    ///< does not turn
  free,    ///< turns without torque
  speed,   ///< given speed of the rope where it leaves the drum, m/s, taking in > 0; of a sheave: of its rim, along the
           ///< path > 0
  torque,  ///< given torque, N m, taking in > 0; of a sheave along the path > 0
  pull     ///< given tension of the rope where it leaves a drum, N
};
struct Drive {
  DriveKind kind = DriveKind::held;
  Signal signal;       ///< NaN: the deck has no signal of this speed, which only a motion needs
  bool brake = false;  ///< true: the brake is set: it holds, against any drive, up to its torque
  double brake_since = -std::numeric_limits<double>::infinity();  ///< time at which it was set, s
  std::optional<int> by = {};  ///< in a motion: the event of the model that has given kind and signal
};

/// A brake that holds a drum up to a torque.
struct Brake {
  double torque = 0;  ///< N m
  double delay = 0;   ///< from its setting until it begins to act, s
  double rise = 0;    ///< in which its torque then grows to the full one, linearly, s
};
/// Its torque at a time after it was set, N m.
inline double torque_of(const Brake& brake, double since_set) {
  const double acts = since_set - brake.delay;
  if (acts < 0) return 0;
  return brake.rise > 0 ? brake.torque * std::min(1.0, acts / brake.rise) : brake.torque;
}

/// A drum at the first or last node of one rope or several (Node::drum).
struct Drum {
  std::string name;
  double core_radius = 0;                ///< m
  int layer = 1;                         ///< from which the rope leaves at the start
  bool automatic_layers = false;         ///< the layer follows the rope on the drum
  double width = 0;                      ///< between the flanges, m; 0: not known
  std::optional<double> length_on_drum;  ///< at the start, m
  std::optional<double>
      wound_at;                ///< winding tension of the rope on it, N; none: 0, in motion the tension at the start
  double pitch = 0;            ///< from wrap to wrap, m; 0: the rope's diameter
  double layer_height = 0;     ///< m; 0: the rope's diameter
  double flange_diameter = 0;  ///< m; 0: not limited
  double inertia = 0;          ///< kg m2
  double drag = 0;             ///< moment against its angular velocity, N m s
  std::optional<Brake> brake;  ///< none: it holds anything
  Drive drive;
};

/// A sheave with a motor (Node::motor).
struct Motor {
  std::string name;
  Drive drive;
  std::optional<double> working_arc;  ///< part of the wrap that transmits force, rad; none: the whole wrap
};

/// A strip of a plane on a body, or of the ground.
struct Face {
  std::string name;
  int body = ground;
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< ends, in the body's frame, m
  Vector3 normal = Vector3::UnitZ();                     ///< unit, square to from -> to, out of the body
};

/// A point in contact with a face: unilateral, with Stribeck friction f(v) = f_inf + (f_0 - f_inf) exp(-|v|/v_s) and
/// true sticking.
struct FaceContact {
  std::string name;
  int body = ground;             ///< of the point
  Vector3 at = Vector3::Zero();  ///< in the body's frame, m
  int face = 0;
  double stiffness = 0;                                     ///< N/m
  double damping = 0;                                       ///< N s/m
  double tangential_stiffness = 0, tangential_damping = 0;  ///< of the bristle, N/m, N s/m
  double clearance = 0;                                     ///< m
  double static_friction = 0;                               ///< f_0
  double kinetic_friction = 0;                              ///< f_inf
  double stribeck_speed = 0.01;                             ///< v_s, m/s
};

using description::ActuatorMode;
enum class ActuatorKind { force, law, speed };

/// A cylinder between two points.
struct Actuator {
  std::string name;
  int from_body = ground, to_body = ground;
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< in the bodies' frames, m
  ActuatorKind kind = ActuatorKind::force;
  Signal signal;    ///< force, N; speed, m/s; of a law the reference speed, m/s
  double F0 = 0;    ///< of a law, N
  double gain = 0;  ///< of a law, N s/m
  ActuatorMode mode = ActuatorMode::extend;
  double lock_stiffness = 0;                                     ///< N/m; 0: rigid
  double lock_damping = 0;                                       ///< N s/m
  double force_limit = std::numeric_limits<double>::infinity();  ///< N
};

/// Changes the unstretched length of a rope at one of its ends.
struct Tensioner {
  int reeving = 0;
  bool at_start = true;
  Signal change;  ///< m, positive makes the rope longer
};

/// What can be observed of a moving machine.
enum class Observed {
  x,
  y,
  z,
  vx,
  vy,
  vz,  ///< of a place on a body, ground frame, m, m/s
  rx,
  ry,
  rz,
  wx,
  wy,
  wz,  ///< of a body: rotations as in the table `bodies`, rad; angular velocity about the axes, 1/s
  T_start,
  T_end,
  T_max,  ///< of a rope, N
  branch_T,
  branch_length,  ///< of one branch: its largest tension, N; its unstretched length, m
  length,         ///< of a rope: unstretched length from end to end, m, without what is on drums
  T_in,
  T_out,
  sheave_speed,
  sheave_omega,
  sheave_angle,
  sheave_torque,
  sheave_power,
  slip,  ///< N, N; of the sheave: rim speed along the path, m/s, angular velocity, 1/s, angle, rad, torque along the
         ///< path and power of its motor, N m, W; speed of the rope relative to the rim along the path, m/s
  drum_T,
  drum_speed,
  drum_length,
  drum_torque,
  drum_power,  ///< N; rope taken in, m/s; rope on the drum, m; torque and power of its drive, N m, W
  contact_N,
  contact_F,
  contact_speed,
  contact_state,  ///< normal force and friction, N; sliding speed, m/s; 0 open, 1 sliding, 2 sticking
  actuator_F,
  actuator_speed,
  actuator_length,
  actuator_power,  ///< N, m/s, m, W
  kinetic,
  elastic,
  potential,
  dissipated,
  supplied,
  residual,  ///< energies of the whole machine, J
  signal     ///< value of a signal
};

struct Observable {
  std::string name;  ///< as the deck writes it: "car.z"
  Observed quantity = Observed::x;
  Unit unit;
  int index = ground;  ///< body or ground, reeving, drum, contact, actuator or signal, as the quantity needs it
  std::optional<int> part = std::nullopt;  ///< of a rope: its branch, from 0; of a sheave: its node
  Vector3 at = Vector3::Zero();            ///< of a place: in its body's frame, m
  // of a measure
  int seen_from = ground;  ///< body in whose axes a place or a rotation is seen
  double factor = 1, offset = 0;
  double since = 0;  ///< s
  description::Relative relative = description::Relative::none;
  description::Taken taken = description::Taken::automatic;  ///< automatic: no result value of its own
  std::optional<int> slot = std::nullopt;                    ///< of a measure: its index in `observed`
  bool has_mean = false;  ///< mean while the quantity `mean_of` lies between mean_from and mean_to
  double mean_from = 0, mean_to = 0;
  std::optional<int> mean_of = std::nullopt;  ///< index in Model::mean_windows; empty: the time
  std::optional<int> joint = std::nullopt;    ///< of the branch `part` of the rope `index`, from 1: its place
};

struct Condition {
  Observable of;
  bool above = true;  ///< true: holds above the threshold; false: below it
  double threshold = 0;
};

enum class EventKind { breaks, stop, actuator, brake, drive };

struct Event {
  std::string words;  ///< "break ext"
  EventKind kind = EventKind::stop;
  std::optional<double> at;       ///< s
  std::optional<Condition> when;  ///< happens once, as soon as this holds
  double over = 0;                ///< s, of a break
  int index = 0;                  ///< reeving, actuator, drum
  std::optional<int> part;        ///< branch that breaks, from 0; empty: the one with the largest tension at that time
  bool brake_set = true;
  bool of_motor = false;  ///< a drive: `index` is a motor, not a drum
  ActuatorMode mode = ActuatorMode::lock;
  Drive drive;
};

}  // namespace taut::machine
