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

/// A machine as a deck describes it: plain values, references by name, one `describe` table each. SI, right-handed
/// axes, z up. A `describe` table checks single fields only; `compile` (compile.hpp) checks everything that needs
/// several.
namespace taut::machine::description {

/// A point of the ground frame, or of a body.
struct Point {
  std::string name;
  std::optional<std::string> body;
  Triple at{};
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  static const Description& describe();
};

/// Properties of a rope: a row of the catalogue, or single values. A single value replaces that of the catalogue.
struct Rope {
  std::string name;
  std::optional<std::string> rope;       ///< id in the catalogue
  std::optional<double> mass;            ///< kg/m, per unstretched metre
  std::optional<double> stiffness;       ///< EA, N; default: from the area and construction in the catalogue
  std::optional<double> breaking_force;  ///< N
  std::optional<double> diameter;        ///< m
  double expansion = 1.2e-5;             ///< 1/K
  /// Temperature at which lengths are given, K; default: that of the machine.
  std::optional<double> reference_temperature;
  std::optional<double> damping_ratio;  ///< for dynamics
  std::optional<double> damping_time;   ///< s, for dynamics
  static const Description& describe();
};

/// Rotations about the ground axes x, then y, then z, rad.
struct Turned {
  double rx = 0, ry = 0, rz = 0;
  static const Description& describe();
};

struct Body {
  std::string name;
  double mass = 0;                ///< kg
  Triple at{};                    ///< origin, m
  Triple centre{};                ///< centre of mass relative to the origin, m
  std::vector<std::string> free;  ///< degrees of freedom, of x y z rx ry rz
  std::optional<Triple> guide;    ///< direction of its only translation
  /// Moment of inertia about the centre of mass, kg m2: one value for all axes, or Ixx, Iyy, Izz; for dynamics.
  std::vector<double> inertia;
  std::optional<BodyMotion> motion;
  std::optional<Turned> turned = std::nullopt;   ///< how it stands at the start; of a free body a first guess
  std::optional<std::string> on = std::nullopt;  ///< the body in whose frame `at`, the axes and the guide are given
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  static const Description& describe();
};

/// `usual`: a sheave in the list `sheaves`, a saddle in the list `supports`.
enum class RoundLaw { usual, sheave, saddle };
/// What happens where the rope pulls a support upwards. hold: the rope is held down. report: it is held down, and the
/// result reports it. lift: it leaves the support. `usual`: report for a saddle, hold for a sheave.
enum class Uplift { usual, hold, report, lift };

/// Drive of a sheave. With a speed the torque follows; else the torque is given. Both are quantities or names of
/// signals (drive_value.hpp).
struct Motor {
  std::optional<std::string> speed;   ///< rim speed along the path: a signal, or a speed
  std::optional<std::string> torque;  ///< along the path: a signal, or a moment
  std::optional<double> working_arc;  ///< part of the wrap that transmits force, rad (Andreev); default: the whole wrap
  static const Description& describe();
};

/// A sheave, or a saddle that does not turn.
struct Round {
  std::string name;
  std::optional<std::string> body;
  Triple at{};          ///< centre, m
  double diameter = 0;  ///< pitch, at the rope's centre, m; 0: a point
  std::optional<Triple> axis;
  RoundLaw law = RoundLaw::usual;
  std::optional<double> friction;  ///< rope on groove; a sheave without it does not slip
  double efficiency = 1;           ///< of a turning sheave
  Uplift uplift = Uplift::usual;   ///< where the rope pulls it upwards
  std::optional<double> inertia;   ///< kg m2, for dynamics
  double drag = 0;                 ///< N m s, for dynamics
  std::optional<Motor> motor;
  bool one_wheel = false;                                ///< all ropes and turns of ropes over it turn one wheel
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  /// "ahead_of CARRIAGE": it is in the path of a rope that ends at this carriage only where it lies between the
  /// carriage and what the rope comes from.
  std::optional<std::string> holds = std::nullopt;
  static const Description& describe();
};

/// Drive of a drum: one of speed, torque, pull, as a signal or a constant. Statics takes the drum at the start of the
/// motion: a given pull is the tension of the rope, otherwise the rope keeps its length.
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
  double drag = 0;                        ///< N m s, for dynamics
  std::optional<double> brake_torque;     ///< N m, for dynamics; default: it holds anything
  double brake_delay = 0;                 ///< s
  double brake_rise = 0;                  ///< s
  std::optional<Layers> layers;           ///< automatic: the layer follows from the rope on the drum
  std::optional<double> length_on_drum;   ///< unstretched, m
  std::optional<double> wound_at;         ///< winding tension, N; default: 0, in motion the tension at the start
  std::optional<double> face_width;       ///< between the flanges, m
  std::optional<double> flange_diameter;  ///< m; default: not limited
  std::optional<double> pitch;            ///< from wrap to wrap, m; default: the rope's diameter
  std::optional<double> layer_height;     ///< m; default: the rope's diameter
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  static const Description& describe();
};

enum class Hold { rolling, clamped, fixed_to };

struct Carriage {
  std::string name;
  std::optional<std::string> library = std::nullopt;    ///< its name in the catalogue of carriages
  std::optional<std::string> catalogue = std::nullopt;  ///< a file of the user's in place of the built-in carriages
  double mass = 0;
  std::string rides;  ///< a reeving
  Hold hold = Hold::rolling;
  std::optional<std::string> fixed_to;  ///< a second, running reeving to which the carriage is also fixed: a haul rope
  std::optional<std::string> mainline;  ///< the reeving whose length determines its position
  std::optional<std::string> haulback;  ///< the reeving that pulls against the mainline
  double friction = 0;                  ///< rolling friction on the rope
  int rollers = 1;
  std::optional<double> wheelbase;      ///< first to last roller, m
  double inertia = 0;                   ///< about its pitch axis through the centre of mass, kg m^2
  double height = 0;                    ///< of the rollers above the origin, m; its mass acts at the origin
  std::optional<double> length_before;  ///< of a clamp: unstretched rope from the reeving's start, m
  std::optional<Triple> at;             ///< first guess of its place; default: between its neighbours
  std::optional<double> rated_payload = std::nullopt;  ///< kg
  std::vector<double> rope_diameters = {};             ///< least and largest, of the rope on which it rides, m
  /// Not of the deck: trust of the two, and what was taken from the catalogue, in words.
  std::string rating_trust = "user", from_library = {};
  std::optional<OverGround> over_ground = std::nullopt;  ///< in place of `at`
  static const Description& describe();
};

enum class Side { automatic, left, right };

/// One element of the path of a rope.
struct PathElement {
  std::optional<std::string> anchor;
  std::optional<std::string> over;
  std::optional<std::string> through;
  std::optional<std::string> drum;
  int parts = 1;
  std::vector<std::string> between;
  int turns = 0;  ///< whole ones round a sheave or support, besides the wrap between its neighbours
  Side side = Side::automatic;
  bool grip = false;  ///< an endless rope that passes a carriage twice is fixed to it at this element
  static const Description& describe();
};

enum class Haul { automatic, to_start, to_end };

/// Installation of a line: the tension at one end while it carries nothing except `with`. Its length is constant
/// afterwards.
enum class BaseTensionAt { start, end };
struct PutUp {
  double tension = 0;  ///< N
  BaseTensionAt at = BaseTensionAt::start;
  std::vector<std::string> with;  ///< carriages, bodies and loads that hang on it during installation
  static const Description& describe();
};

struct Reeving {
  std::optional<std::string> name;  ///< default: the name of its rope
  std::string rope;
  std::vector<PathElement> path;
  bool closed = false;  ///< endless: from the last element back to the first
  std::optional<double> length;
  std::optional<double> tension_at_start;
  std::optional<double> tension_at_end;
  std::optional<std::string> tension_equals;  ///< a rope: its length is found for equal tensions at both starts
  int copies = 1;
  Haul haul = Haul::automatic;
  int segments = 1;        ///< number of segments of each branch in motion
  bool may_slack = false;  ///< it may go slack: no unsafe warning
  std::optional<PutUp> install = std::nullopt;
  static const Description& describe();
};

/// By what a deck refers to it: its name, else that of its rope.
inline std::string name_of(const Reeving& reeving) { return reeving.name.value_or(reeving.rope); }

/// A bunch of logs: one end hangs on the carriage, the other is dragged over the ground.
struct Dragged {
  double ground_angle = 0;    ///< slope of the ground, rad, positive where it rises in the direction of travel
  double friction = 0;        ///< of the bunch on the ground
  double share = 0.5;         ///< part of its weight that the carriage carries on level ground
  double lift_angle = 0;      ///< between bunch and ground, rad
  std::vector<double> along;  ///< horizontal direction of travel, x and y
  static const Description& describe();
};

/// A load at a point of a body, constant in direction.
struct Load {
  std::string at;
  std::optional<double> mass;
  std::optional<Triple> force;
  std::optional<std::string> signal = std::nullopt;  ///< in motion: size of the force over time, N
  std::optional<Dragged> dragged = std::nullopt;
  std::optional<std::string> name = std::nullopt;
  static const Description& describe();
};

/// Direction of a force along a rope: by the motion of the rope (at rest: as if it hauled in), or by its path.
enum class RopeLoadDirection { against_motion, with_motion, along_path, against_path };

/// A force along the free rope, at one place of a branch or distributed over a part of it. Without `tangential` and
/// `rate` the force is the one that balances the given torque of the drive.
struct RopeLoad {
  std::optional<std::string> name;
  std::string rope;                  ///< a reeving
  std::vector<std::string> between;  ///< two neighbours of its path
  std::optional<double> tangential;  ///< N
  std::optional<double> rate;        ///< N per unstretched metre
  RopeLoadDirection direction = RopeLoadDirection::against_motion;
  std::optional<double> position;     ///< fraction of the unstretched length of the branch, from the first of `between`
  std::optional<double> from, to;     ///< fractions between which a rate acts
  std::optional<int> elements;        ///< number of parts into which a rate is divided
  std::optional<std::string> signal;  ///< in motion: force, N, or rate, N/m, over time
  static const Description& describe();
};

/// What a screw keeps in all states: its force, as a hydraulic ram or a long spring does, or the place where it was
/// set.
enum class ScrewKeeps { unsaid, force, place };

/// A take-up: a hanging weight over a deflection sheave, or a screw.
struct TakeUp {
  std::string body;
  std::optional<double> weight = std::nullopt;  ///< kg
  std::optional<double> screw = std::nullopt;   ///< N
  ScrewKeeps keeps = ScrewKeeps::unsaid;        ///< unsaid: its force, and the machine is not judged
  Triple along{1, 0, 0};
  static const Description& describe();
};

/// Installation of a guy: its tension while the machine is unloaded and its bodies are held at their given places. Its
/// length is constant afterwards.
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

/// Terrain under the line: a CSV file, or its columns. Without y: heights z over the chainage x, measured along a
/// horizontal direction. With y: a survey, x and y in the ground frame, projected on the line (terrain.hpp).
struct Terrain {
  std::optional<std::string> file;
  std::vector<double> x;
  std::vector<double> z;
  std::vector<double> from;   ///< x and y of the place with chainage 0, ground frame, m; default: the origin
  std::vector<double> along;  ///< direction of the chainage; default: the x axis
  std::vector<double> y = {};
  std::vector<std::string> between = {};  ///< two points: the line runs from the first to the second
  double corridor = 5;                    ///< a warning names surveyed rows farther off the line than this, m
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
