#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/gravity.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/beam_keys.hpp"
#include "taut/machine/description/measure_keys.hpp"
#include "taut/machine/description/motion_keys.hpp"

/// A machine as a deck describes it: plain values, names as links, one `describe` table each. SI, right-handed axes, z
/// up. Nothing is checked here that needs more than one field; `compile` does that (compile.hpp).
namespace taut::machine::description {

/// A point of the ground frame, or of a body.
struct Point {
  std::string name;
  std::optional<std::string> body;
  Triple at{};
  static const Description& describe();
};

/// A rope's properties: a row of the catalogue, or figures; figures go before the catalogue's.
struct Rope {
  std::string name;
  std::optional<std::string> rope;              ///< id in the catalogue
  std::optional<double> mass;                   ///< kg/m, per unstretched metre
  std::optional<double> stiffness;              ///< EA, N; none: by the catalogue's area and construction
  std::optional<double> breaking_force;         ///< N
  std::optional<double> diameter;               ///< m
  double expansion = 1.2e-5;                    ///< 1/K
  std::optional<double> reference_temperature;  ///< K, at which lengths are given
  std::optional<double> damping_ratio;          ///< for dynamics
  std::optional<double> damping_time;           ///< s, for dynamics
  static const Description& describe();
};

struct Body {
  std::string name;
  double mass = 0;                ///< kg
  Triple at{};                    ///< of its origin, m
  Triple centre{};                ///< of mass, seen from the origin, m
  std::vector<std::string> free;  ///< of x y z rx ry rz
  std::optional<Triple> guide;    ///< direction of the one slide it moves on
  std::vector<double> inertia;    ///< about the centre of mass: one for all axes, or Ixx, Iyy, Izz, kg m2; for dynamics
  std::optional<BodyMotion> motion;
  std::optional<std::string> on = std::nullopt;  ///< the body in whose frame `at`, the axes and the guide are given
  static const Description& describe();
};

/// `usual`: a sheave among `sheaves`, a saddle among `supports`.
enum class RoundLaw { usual, sheave, saddle };
/// `usual`: a saddle reports, a sheave holds.
enum class Uplift { usual, hold, report, lift };

/// What drives a sheave: whatever torque it takes, or a given one. Speed and torque are quantities, or names of
/// signals (drive_value.hpp).
struct Motor {
  std::optional<std::string> speed;   ///< of the rim, along the path: a signal, or a speed
  std::optional<std::string> torque;  ///< along the path: a signal, or a moment
  std::optional<double> working_arc;  ///< part of the wrap that can pull, rad (Andreev); default: all of it
  static const Description& describe();
};

/// A sheave, or a saddle that does not turn.
struct Round {
  std::string name;
  std::optional<std::string> body;
  Triple at{};          ///< centre, m
  double diameter = 0;  ///< pitch, at the rope's centre, m; 0: a point
  Triple axis{0, 1, 0};
  RoundLaw law = RoundLaw::usual;
  std::optional<double> friction;  ///< of the rope on it; a sheave without it grips whatever comes
  double efficiency = 1;           ///< of a turning sheave
  Uplift uplift = Uplift::usual;   ///< what happens when the rope pulls it upwards
  std::optional<double> inertia;   ///< kg m2, for dynamics
  std::optional<Motor> motor;
  static const Description& describe();
};

/// What drives a drum: one of speed, torque, pull, as a signal or a constant. In statics a drum holds its rope's
/// length, or its pull, as it is at the start, where that is given.
enum class Brake { unsaid, open, set };
struct Drive {
  std::optional<std::string> speed, torque, pull;
  Brake brake = Brake::unsaid;
  static const Description& describe();
};

enum class Layers { automatic };

struct Drum {
  std::string name;
  std::optional<std::string> body;
  Triple at{};
  Triple axis{0, 1, 0};
  double core_diameter = 0;  ///< m
  std::optional<int> layer;
  std::optional<Drive> drive;
  double inertia = 0;                     ///< kg m2, for dynamics
  std::optional<Layers> layers;           ///< automatic: by the rope on the drum
  std::optional<double> length_on_drum;   ///< unstretched, m
  std::optional<double> wound_at;         ///< tension at which it was wound, N; default: 0
  std::optional<double> face_width;       ///< between the flanges, m
  std::optional<double> flange_diameter;  ///< m; default: not limited
  std::optional<double> pitch;            ///< from wrap to wrap, m; default: the rope's diameter
  std::optional<double> layer_height;     ///< m; default: the rope's diameter
  static const Description& describe();
};

enum class Hold { rolling, clamped, fixed_to };

struct Carriage {
  std::string name;
  double mass = 0;
  std::string rides;  ///< a reeving
  Hold hold = Hold::rolling;
  std::optional<std::string> fixed_to;  ///< a second reeving, which carries it along: a running haul rope
  std::optional<std::string> mainline;  ///< the reeving whose length sets its place
  std::optional<std::string> haulback;  ///< the reeving that pulls against the mainline
  double friction = 0;                  ///< of rolling, on the rope
  int rollers = 1;
  std::optional<double> wheelbase;      ///< first to last roller, m
  double inertia = 0;                   ///< about the axis of its pitching, at the centre of mass, kg m^2
  double height = 0;                    ///< of the rollers over the origin, where its mass hangs, m
  std::optional<double> length_before;  ///< of a clamp: unstretched rope from the reeving's start, m
  std::optional<Triple> at;             ///< where to look for it first; default: between its neighbours
  static const Description& describe();
};

enum class Side { automatic, left, right };

/// One stop of a rope's path.
struct PathElement {
  std::optional<std::string> anchor;
  std::optional<std::string> over;
  std::optional<std::string> through;
  std::optional<std::string> drum;
  int parts = 1;
  std::vector<std::string> between;
  Side side = Side::automatic;
  bool grip = false;  ///< where an endless rope passes a carriage twice: here it is fixed to it
  static const Description& describe();
};

enum class Haul { automatic, to_start, to_end };

/// How a line is put up: by its tension at one end, empty but for what is named. Then its length is frozen.
enum class BaseTensionAt { start, end };
struct PutUp {
  double tension = 0;  ///< N
  BaseTensionAt at = BaseTensionAt::start;
  std::vector<std::string> with;  ///< carriages, bodies and loads that hang on it meanwhile
  static const Description& describe();
};

struct Reeving {
  std::optional<std::string> name;  ///< default: its rope's
  std::string rope;
  std::vector<PathElement> path;
  bool closed = false;  ///< endless: from the last element back to the first
  std::optional<double> length;
  std::optional<double> tension_at_start;
  std::optional<double> tension_at_end;
  int copies = 1;
  Haul haul = Haul::automatic;
  int segments = 1;        ///< of each free part, in motion
  bool may_slack = false;  ///< it is meant to go slack: no unsafe warning
  std::optional<PutUp> install = std::nullopt;
  static const Description& describe();
};

/// A bunch of logs that hangs with one end on the load's place and drags the other one over the ground.
struct Dragged {
  double ground_angle = 0;             ///< rad, positive where the ground rises in the direction of the way
  double friction = 0;                 ///< of the bunch on the ground
  double share = 0.5;                  ///< of its weight that hangs on the carriage on level ground
  double lift_angle = 0;               ///< of the bunch against the ground, rad
  std::vector<double> along = {1, 0};  ///< horizontal direction of the way, x and y
  static const Description& describe();
};

/// A dead load at a point of a body.
struct Load {
  std::string at;
  std::optional<double> mass;
  std::optional<Triple> force;
  std::optional<Dragged> dragged = std::nullopt;
  std::optional<std::string> name = std::nullopt;
  static const Description& describe();
};

/// Which way a force along a rope points: by the rope's motion (at rest: as if it hauled in), or by its path.
enum class RopeLoadDirection { against_motion, with_motion, along_path, against_path };

/// A force along the free rope, at a place of a span or spread over a part of it. Without `tangential` and `rate`: as
/// much as the motor's given torque overcomes.
struct RopeLoad {
  std::optional<std::string> name;
  std::string rope;                  ///< a reeving
  std::vector<std::string> between;  ///< two neighbours of its path
  std::optional<double> tangential;  ///< N
  std::optional<double> rate;        ///< N per unstretched metre
  RopeLoadDirection direction = RopeLoadDirection::against_motion;
  std::optional<double> position;     ///< share of the span's unstretched rope, from the first of `between` on
  std::optional<double> from, to;     ///< shares between which a rate acts
  std::optional<int> elements;        ///< parts into which a rate is divided
  std::optional<std::string> signal;  ///< in motion: force, N, or rate, N/m, over time
  static const Description& describe();
};

/// A force that keeps a rope tight: a weight over a deflection, or a screw.
struct TakeUp {
  std::string body;
  std::optional<double> weight;  ///< kg
  std::optional<double> screw;   ///< N
  Triple along{1, 0, 0};
  static const Description& describe();
};

/// How a guy is put up: on the unloaded machine, its bodies held where they are given. Then its length is frozen.
enum class InstallAt { top, anchor };
struct Install {
  double tension = 0;  ///< N
  InstallAt at = InstallAt::top;
  static const Description& describe();
};

struct Guy {
  std::string name;
  std::string rope;
  std::string from;
  std::string to;
  std::optional<Install> install;
  std::optional<double> length;
  static const Description& describe();
};

/// Ground under the line: a CSV file, or its columns written out. Without y: heights over chainage, x runs along a
/// horizontal direction. With y: a survey, x and y of the ground frame, projected on the line (terrain.hpp).
struct Terrain {
  std::optional<std::string> file;
  std::vector<double> x;
  std::vector<double> z;
  std::vector<double> from;   ///< where x is 0: x and y of the ground frame, m; none: the origin
  std::vector<double> along;  ///< the direction of x; none: that of the ground frame's x
  std::vector<double> y = {};
  std::vector<std::string> between = {};  ///< two points: the line runs from the first to the second
  double corridor = 5;                    ///< surveyed rows farther off the line are warned of, m
  static const Description& describe();
};

}  // namespace taut::machine::description

namespace taut::machine {

struct Machine {
  double gravity = standard_gravity;  ///< m/s2
  std::optional<double> temperature;  ///< K
  std::vector<description::Point> points;
  std::vector<description::Rope> ropes;
  std::vector<description::Body> bodies;
  std::vector<description::Round> sheaves;
  std::vector<description::Round> supports;
  std::vector<description::Drum> drums;
  std::vector<description::Carriage> carriages;
  std::vector<description::Reeving> reevings;
  std::vector<description::Load> loads;
  std::vector<description::RopeLoad> rope_loads;
  std::vector<description::TakeUp> take_up;
  std::vector<description::Guy> guys;
  std::vector<description::Beam> beams;
  std::optional<description::Terrain> terrain;
  std::vector<description::Signal> signals;
  std::vector<description::Marker> markers;
  std::vector<description::Face> faces;
  std::vector<description::FaceContact> contacts;
  std::vector<description::Actuator> actuators;
  std::vector<description::Tensioner> tensioners;
  std::vector<description::Event> events;
  std::vector<std::string> observe;
  std::vector<description::Measure> measures;
  static const Description& describe();
};

}  // namespace taut::machine
