#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

/// The keys of a machine in motion: plain values, references by name, one `describe` table each. A text described as "a
/// signal, or a ..." is the name of a signal, or a constant with its unit.
namespace taut::machine::description {

/// One change of a value.
struct Move {
  double at = 0;    ///< s
  std::string to;   ///< with its unit
  double over = 0;  ///< s
  bool smooth = false, half_cosine = false;
  static const Description& describe();
};

struct Ramp {
  std::optional<std::string> from;  ///< default: 0
  std::string to;
  double start = 0;     ///< s
  double duration = 0;  ///< s
  bool smooth = false, half_cosine = false;
  static const Description& describe();
};

enum class Interpolation { linear, cubic };
struct SignalTable {
  std::vector<double> t;           ///< s
  std::vector<std::string> value;  ///< with their units
  Interpolation interpolation = Interpolation::linear;
  static const Description& describe();
};

struct Sine {
  std::optional<std::string> mean;  ///< default: 0
  std::string amplitude;
  std::optional<double> frequency;  ///< 1/s
  std::optional<double> period;     ///< s
  double phase = 0;                 ///< rad
  static const Description& describe();
};

/// A quantity over time; exactly one of its laws is given.
struct Signal {
  std::string name;
  std::optional<std::string> constant;
  std::optional<Ramp> ramp;
  std::optional<SignalTable> table;
  std::optional<Sine> sine;
  std::vector<Move> sequence;
  std::optional<std::string> formula = std::nullopt;  ///< of t
  static const Description& describe();
};

/// Given motion of a body: displacements from its `at` along the ground axes, and rotations about them; each a signal.
struct BodyMotion {
  std::optional<std::string> x, y, z, rx, ry, rz;
  static const Description& describe();
};

/// A place of the ground frame by its height over the ground: a support of the length `over_ground` stands on the
/// terrain's line at `chainage` and leans towards growing chainage. With the terrain's heights z_ground the place is at
/// the chainage `chainage + over_ground sin(lean)` and the height `z_ground(chainage) + over_ground cos(lean)`.
struct OverGround {
  double chainage = 0;     ///< of the foot along the terrain's line, m
  double offset = 0;       ///< to the left of the line, seen towards growing chainage, m; the height of the ground is
                           ///< that of the line
  double over_ground = 0;  ///< from the foot, along the support, m
  double lean = 0;         ///< from the vertical towards growing chainage, rad
  static const Description& describe();
};

/// A place on a body or of the ground, for contacts and observed quantities.
struct Marker {
  std::string name;
  std::optional<std::string> body;
  Triple at{};
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  static const Description& describe();
};

/// A plane strip between two places of a body. `normal` points out of the body, towards the other body.
struct Face {
  std::string name;
  std::optional<std::string> body;
  Triple from{};
  Triple to{};
  Triple normal{0, 0, 1};
  static const Description& describe();
};

/// A point of one body on a face of another.
struct FaceContact {
  std::optional<std::string> name;  ///< default: the name of its point
  std::string point;
  std::string face;
  double stiffness = 0;                        ///< N/m
  double damping = 0;                          ///< N s/m
  std::optional<double> tangential_stiffness;  ///< N/m; default: half of `stiffness`
  std::optional<double> tangential_damping;    ///< N s/m; default: half of `damping`
  double clearance = 0;                        ///< m
  double static_friction = 0;
  std::optional<double> kinetic_friction;  ///< default: the static one
  std::optional<double> stribeck_speed;    ///< m/s
  static const Description& describe();
};

enum class ActuatorMode { extend, retract, lock, free };

/// A force that decreases with the speed: F = F0 + gain (reference - speed).
struct ActuatorLaw {
  double F0 = 0;          ///< N
  double gain = 0;        ///< N s/m
  std::string reference;  ///< a signal, or a speed
  static const Description& describe();
};

/// A cylinder between two points.
struct Actuator {
  std::string name;
  std::string from;
  std::string to;
  std::optional<std::string> force;  ///< a signal, or a force; positive pushes the points apart
  std::optional<ActuatorLaw> law;
  std::optional<std::string> speed;  ///< a signal, or a speed; positive moves them apart
  ActuatorMode mode = ActuatorMode::extend;
  std::optional<double> lock_stiffness;  ///< N/m
  std::optional<double> lock_damping;    ///< N s/m
  std::optional<double> force_limit;     ///< N
  static const Description& describe();
};

enum class RopeEnd { start, end };

/// A given change of the unstretched length of a rope at one of its ends.
struct Tensioner {
  std::string reeving;  ///< its name, or its number among the reevings, from 1
  RopeEnd end = RopeEnd::start;
  std::string change;  ///< a signal, or a length; positive makes the rope longer
  static const Description& describe();
};

/// An event: what happens at a given time, or as soon as a condition holds.
struct Event {
  std::optional<double> at;           ///< s
  std::optional<std::string> when;    ///< "car.z > 12 m"
  double over = 0;                    ///< s
  std::optional<std::string> breaks;  ///< a reeving, or one of its branches, "ext[2]"
  bool stop = false;
  std::optional<std::string> actuator;
  std::optional<std::string> brake;                ///< a drum
  std::optional<std::string> drive;                ///< a drum or a driven sheave
  std::optional<std::string> mode;                 ///< of an actuator, or of a brake: set, open
  std::optional<std::string> speed, torque, pull;  ///< of a drive
  static const Description& describe();
};

}  // namespace taut::machine::description
