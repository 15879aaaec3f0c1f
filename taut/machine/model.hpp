#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/base/gravity.hpp"
#include "taut/machine/beam.hpp"
#include "taut/machine/motion.hpp"
#include "taut/machine/place.hpp"
#include "taut/math/vector.hpp"

namespace taut::machine {

/// A compiled machine: plain values and indices, checked by `compile`, never changed by an analysis. SI and radians,
/// right-handed axes, z up. Names serve tables and messages; parts refer to each other by index.

/// A degree of freedom of a body, as unit velocities in the ground frame: a translation along x is {(1,0,0), 0}, a
/// hinge about y {0, (0,1,0)}, a slide {unit vector, 0}. Rotations are about the origin of the body. Give one rotation
/// or all three: two rotations about different axes are applied one after the other, in small steps, each about its
/// axis in the ground frame.
struct Freedom {
  Vector3 along = Vector3::Zero();
  Vector3 about = Vector3::Zero();
};

struct Body {
  std::string name;
  Vector3 position = Vector3::Zero();  ///< of its origin at the start, m; constant in directions that are not free
  Matrix3 orientation = Matrix3::Identity();  ///< body to ground at the start
  Array<Freedom> free;                        ///< none: fixed
  bool of_rope = false;                       ///< a point of a rope where a load acts, not a body of the deck
  double mass = 0;                            ///< kg, >= 0; its weight acts at `centre`
  Vector3 centre = Vector3::Zero();           ///< centre of mass, in the body frame, m
  Vector3 inertia = Vector3::Zero();          ///< Ixx, Iyy, Izz about `centre`, in the body's frame, kg m2
  Array<DrivenWay> driven;  ///< motions given by signals; `position` and `orientation` are those at t = 0
  /// Mass of take-up weights, kg: inertia along its only degree of freedom. Their weight is one of the loads.
  double counterweight = 0;
  std::optional<int> beam;  ///< index of the beam of which this body is a section
};

/// Whether it stays where it is whatever pulls: no rope feels what hangs on it.
inline bool stands_fast(const Body& body) {
  return body.free.empty() && body.driven.empty() && !body.beam && !body.of_rope;
}

/// A screw that pulls a body with one degree of freedom. It is set while the machine stands unloaded
/// (study/put_up.hpp): until then its force is one of the loads, from there on its body is fixed.
struct Screw {
  int body = 0, load = 0;
};

/// A force on a body, constant in direction in the ground frame.
struct Load {
  Place at;                         ///< on a body
  Vector3 force = Vector3::Zero();  ///< N
  double mass = 0;                  ///< kg, of the hanging mass: its inertia in motion; `force` contains its weight
  std::optional<Signal> over_time = std::nullopt;  ///< N: in motion the size of the force, in the direction of `force`
  bool tightens = false;                           ///< of a take-up: it is there while the machine stands unloaded
};

/// Kind of a node on the path of a rope.
enum class NodeKind {
  anchor,   ///< an end of the rope: a pin (radius 0) or a drum (pitch radius of the layer, axis, side)
  contact,  ///< the rope runs over it: a sheave, a saddle that does not turn, the wheels of a rolling carriage
  clamp,  ///< the rope is fixed there, with `length_before` of it before the node: a clamped carriage, a locked capstan
  drive,  ///< a driven sheave, whose torque follows or is given; at most one for each rope; the first node of a closed
          ///< rope
  load    ///< a point of the free rope at which a force acts along the rope; on a body of its own
};

/// The force at a node of kind load, along the rope.
struct RopeLoad {
  /// Place, as a fraction of the unstretched rope between the neighbouring nodes of other kinds, from the first of
  /// them.
  double share = 0.5;
  double force = 0;  ///< N
  double rate = 0;   ///< N per unstretched metre, over the fraction `part` of that rope
  double part = 0;   ///< fraction
  int sense = 1;     ///< +1: along the path, -1: against it; with by_motion multiplied by the flow, at rest by the haul
  bool by_motion = false;  ///< along or against the rope's motion
  bool open = false;       ///< the force is unknown: it balances the given torque of the drive of this rope
  std::optional<Signal> signal = std::nullopt;  ///< in motion: the force, N, or the rate, N/m, over time
};

/// Loss of tension at a contact. In the sense of growing tension T_out = r T_in, ln r = min(friction * theta, -ln
/// efficiency) with theta by which the rope turns there, out of the plane of a round too (mechanics/bend.hpp): groove
/// and bearing act in series, and the weaker one gives way. The inertia of rotation is not included. A saddle:
/// efficiency 0 (it does not turn). A sheave: its efficiency, and infinite friction where the rope cannot slip. A
/// rolling carriage: efficiency 0 and its rolling friction. No loss: efficiency 1.
struct ContactLaw {
  double friction = std::numeric_limits<double>::infinity();  ///< of the rope on the groove, >= 0
  double efficiency = 1;                                      ///< of the turning sheave, 0 <= efficiency <= 1
};

struct Node {
  std::string name;  ///< of the point, sheave, drum or carriage, as in the deck
  NodeKind kind = NodeKind::anchor;
  Place at;                         ///< the point; of a round its centre
  double radius = 0;                ///< to the centre of the rope, m; 0: a point
  Vector3 axis = Vector3::UnitY();  ///< unit vector in the body's frame; used when radius > 0
  int side = 1;                     ///< +1: along its path the rope turns right-handed about `axis`; -1: left-handed
  bool side_open = false;  ///< no side is given (except at a saddle that can only push): `side` is a first guess, the
                           ///< equilibrium decides
  bool side_by_place = false;  ///< of an end on a drum: no side is given, `side` follows from the places
  int turns = 0;   ///< the wrap lies in [-pi/2, 3 pi/2) + 2 pi turns; a wrap below 0: the rope has left the sheave
  ContactLaw law;  ///< of a contact
  Vector3 support = Vector3::Zero();  ///< 0: holds the rope in both directions (a sheave with a guard, a carriage).
                                      ///< Else the unit vector from the support to the rope, in the ground frame (a
                                      ///< saddle: 0, 0, 1), in which the rope can lift off
  /// Where the rope pulls away from the support: true: it lifts off; false: it is held, and this is reported.
  bool may_lift = false;
  /// Of a clamp: unstretched length from the start of the rope to the clamp, at the reference temperature, m. Of a
  /// closed rope the length starts where the rope arrives at its drive.
  double length_before = 0;
  double inertia = 0;        ///< of a sheave that turns, kg m2; without `wheel` each copy of the rope has one
  double drag = 0;           ///< of such a sheave: moment against its angular velocity, N m s
  std::optional<int> drum;   ///< of an anchor: index of its drum; empty: a pin
  std::optional<int> motor;  ///< of a sheave: index of the motor that drives it
  std::optional<int> wheel;  ///< of a sheave: nodes with the same number turn together; empty: by itself
  RopeLoad load;             ///< of a load
  /// Of a driven sheave: T_in - T_out by its given torque, of one copy, N; empty: the torque follows. A closed rope
  /// with a given length and a given torque of its drive needs an open load. A contact with it helps the drive.
  std::optional<double> tension_drop;
};
/// Whether a rope slides over it: it does not turn, or has no friction at all.
inline bool is_saddle(const Node& node) {
  return node.kind == NodeKind::contact && (node.law.efficiency == 0 || node.law.friction == 0);
}

/// The given quantity of a rope.
enum class Given {
  length,  ///< `value`: unstretched length at the reference temperature, m, including the arcs on contacts; at a drum
           ///< it begins where the rope leaves the drum
  tension_at_start,  ///< `value`: N; the length follows
  tension_at_end,    ///< `value`: N
  torque,            ///< of a closed rope: its drive's tension_drop; the length follows
  equal  ///< the tension at its start is that of the rope `equal_to` at its start; until the length is found, as with
         ///< `put_up`
};

/// Installation of a rope: its length is found from this tension at one end of its path. Only these bodies and loads
/// hang on it meanwhile (indices in the model).
struct PutUp {
  double tension = 0;  ///< N
  bool at_end = false;
  Array<int> bodies;
  Array<int> loads;
};

/// Guides that hold a rope only ahead of the carriage at one of its ends: between it and what the rope comes from.
/// Beside that end the path has the first `held` of them, counted from the other end of the rope.
struct Guides {
  Array<Node> all;                  ///< in the order of the path
  bool at_end = false;              ///< the carriage is at the end of the path, else at its start
  int held = 0;                     ///< how many are in the path
  Vector3 away = Vector3::UnitX();  ///< horizontal unit vector from what the rope comes from along the line
};

/// One rope along its path; "in" and "out" follow the order of the path. Parallel parts are written out: a tackle of n
/// falls is n branches with a contact at each turn.
struct Reeving {
  std::string name;
  Array<Node> nodes;  ///< open: the first and the last are anchors, no other is. closed: the first is the drive, the
                      ///< others are contacts and clamps; the rope runs from the last back to the first
  bool closed = false;
  Given given = Given::length;  ///< a closed rope: length or torque
  double value = 0;
  int equal_to = -1;  ///< of Given::equal: a reeving
  /// Unstretched free length beside which its drums hold their `length_on_drum`, m: as described, as put up, or as its
  /// given tension leaves it in the machine as described; none: that is `value`, where it is a length. An analysis that
  /// changes `value` leaves it, so that the rest of the rope is on the drums.
  std::optional<double> described_length = std::nullopt;
  /// Of an open rope over a drive without given torque: the second given quantity.
  std::optional<std::pair<Given, double>> also;
  double weight = 0;          ///< per unstretched length at the reference temperature, N/m, >= 0
  double stiffness = 0;       ///< EA, N, > 0; infinite: it does not stretch
  double breaking_force = 0;  ///< N; 0: not known, no safety factor
  double thermal_strain = 0;  ///< expansion coefficient times (temperature - reference temperature)
  int copies = 1;             ///< number of equal parallel ropes; every force on the machine is multiplied by it
  double damping_ratio = 0;   ///< zeta of the lowest mode that stretches the rope; 0: not given
  double damping_time = 0;    ///< beta, s: T = EA (e + beta e'); 0: not given
  /// Number of segments of each branch in motion. > 1: a chain with the mass of the rope at its joints.
  int segments = 1;
  double speed = 0;     ///< of the running rope, m/s, >= 0; its centrifugal tension is mass * speed^2
  double mass = 0;      ///< per unstretched length, kg/m
  double diameter = 0;  ///< m; 0: not known
  int haul = -1;        ///< direction of flow when the motion is hoist or in: +1 along the path, -1 against it
  /// Of `haul`, by the deck or by who built the machine: no carriage has a say then (docs/theory/senses.md).
  bool haul_is_told = true;
  /// Set until the rope has been put up. `value` is then only the straight length of its path, and no analysis may use
  /// it.
  std::optional<PutUp> put_up = std::nullopt;
  /// A guy that is installed with the tension `value`, until it has been put up (study/put_up.hpp): no equilibrium
  /// before that, as its tension would be the same under any load.
  bool is_to_install = false;
  Array<Guides> guides = {};
};

/// A clamp on a running rope.
struct Grip {
  int reeving = 0, node = 0;
};

/// A carriage that a load path moves along its line.
struct Carriage {
  std::string name;
  int body = 0;
  int reeving = 0, node = 0;  ///< the rope on which it rides, and its node: a contact (rolling) or a clamp
  /// The reeving whose length determines its position. Without one a force along the track holds a rolling carriage,
  /// and its clamp a clamped one.
  std::optional<int> mainline;
  int rollers = 1;                                     ///< number of its nodes: node ... node + rollers - 1
  std::optional<Grip> grip = std::nullopt;             ///< where it is also fixed to a running rope
  std::optional<int> haulback = std::nullopt;          ///< the reeving that pulls it against the mainline
  double mass = 0;                                     ///< its own, kg; that of its body may have a payload in it
  std::optional<double> rated_payload = std::nullopt;  ///< kg
};

/// A point of the terrain, a polyline with x increasing. x is the distance from `Model::terrain_from` along
/// `Model::terrain_along`.
struct GroundPoint {
  double x = 0, z = 0;  ///< m
};

/// Rows of a survey that are farther off the line than the corridor in the deck.
struct OffLine {
  int rows = 0;
  int farthest = 0;     ///< number of the farthest row in the survey, from 1
  double distance = 0;  ///< of that row from the line, in plan, m
  double chainage = 0;  ///< of that row, m
};

/// A place that the deck gives by its height over the ground.
struct PlaceOverGround {
  std::string kind;  ///< "support", "point"
  std::string name;
  Vector3 at = Vector3::Zero();                                ///< m
  double ground = 0;                                           ///< height of the terrain at its foot, m
  double chainage = 0, offset = 0, over_ground = 0, lean = 0;  ///< m; rad (description::OverGround)
};

struct Model {
  double gravity = standard_gravity;  ///< m/s^2, along -z
  /// Of the frame in which all places are given, as the deck counts, m: a message that names a place adds it.
  Vector3 origin = Vector3::Zero();
  Array<Body> bodies;
  Array<Load> loads;
  Array<Screw> screws;
  Array<Reeving> reevings;
  Array<Carriage> carriages;
  Array<GroundPoint> terrain;
  Vector3 terrain_from = Vector3::Zero();    ///< place with chainage 0, m
  Vector3 terrain_along = Vector3::UnitX();  ///< horizontal unit vector
  OffLine terrain_off_line;                  ///< of a survey
  Array<PlaceOverGround> over_ground;        ///< in the order of the deck's lists
  // of a machine in motion
  Array<Signal> signals;
  Array<Drum> drums;
  Array<Motor> motors;
  Array<Face> faces;
  Array<FaceContact> contacts;
  Array<Actuator> actuators;
  Array<Tensioner> tensioners;
  Array<Event> events;
  Array<Observable> observed;
  Array<Observable> measures;      ///< named quantities; each is observed too
  Array<Observable> mean_windows;  ///< quantities that bound the intervals of means
  Array<Beam> beams;
  Array<NamedPlace> places;  ///< that can be observed

  /// Whether a screw holds the body, which bears what pulls there.
  bool is_on_screw(int body) const {
    return std::any_of(screws.begin(), screws.end(), [&](const Screw& one) { return one.body == body; });
  }
};

/// Whether it is on a carriage.
bool rides(const Model& model, const Node& node);

/// The weight of a body, and the sizes of the forces of the loads on it, N.
double weight_on(const Model& model, int body);

/// Chainage of a place: its x in the terrain, m.
double terrain_x(const Model& model, const Vector3& place);

/// Number of branches of a reeving while the rope touches all its nodes: nodes - 1, closed: nodes. Branch k starts at
/// node k.
int branch_count(const Reeving& reeving);

}  // namespace taut::machine
