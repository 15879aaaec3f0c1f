#pragma once
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

/// A compiled machine: plain values and indices, checked by the compiler of descriptions, never changed by an analysis.
/// SI and radians, right-handed axes, z up. Names serve tables and messages; everything is found by index.

/// One way in which a body may move, as unit velocities in the ground frame: along x is {(1,0,0), 0}; a hinge at the
/// body's origin about y is {0, (0,1,0)}; a slide in any direction {unit vector, 0}. The body's origin is the centre of
/// its rotations. Two rotations about different axes are taken one after the other in small steps, each about its axis
/// in the ground frame: give one, or all three.
struct Freedom {
  Vector3 along = Vector3::Zero();
  Vector3 about = Vector3::Zero();
};

struct Body {
  std::string name;
  Vector3 position = Vector3::Zero();         ///< of its origin at the start, m; kept along what is not free
  Matrix3 orientation = Matrix3::Identity();  ///< body to ground at the start
  Array<Freedom> free;                        ///< none: fixed
  bool of_rope = false;                       ///< a point of a rope where a load acts: no body of the deck
  double mass = 0;                            ///< kg, >= 0; its weight acts at `centre`
  Vector3 centre = Vector3::Zero();           ///< of mass, in the body's frame, m
  Vector3 inertia = Vector3::Zero();          ///< Ixx, Iyy, Izz about `centre`, in the body's frame, kg m2
  Array<DrivenWay> driven;                    ///< what signals give; `position` and `orientation` are those at t = 0
  double counterweight = 0;  ///< kg: the inertia of take-up weights along its one way; their pull is among the loads
  int beam = -1;             ///< a section of this beam, not a body of its own; -1: none
};

/// A dead force on a body (keeps its direction in the ground frame).
struct Load {
  Place at;                         ///< on a body
  Vector3 force = Vector3::Zero();  ///< N
  double mass = 0;                  ///< kg, of what hangs there: its inertia in motion; its weight is the force
};

/// What happens to the rope at a node of its path.
enum class NodeKind {
  anchor,   ///< an end of the rope: a pin (radius 0) or a drum (pitch radius of the layer, axis, side)
  contact,  ///< the rope runs over it: a sheave, a saddle that does not turn, the wheels of a rolling carriage
  clamp,    ///< the rope is held there: `length_before` of it lies before; a clamped carriage, a locked capstan
  drive,    ///< a sheave with a motor: with whatever torque it needs, or a given one; at most one per rope, the first
            ///< node of a closed one
  load      ///< a point of the free rope on which a force acts along it; sits on a body of its own
};

/// The force at a node of kind load, along the rope.
struct RopeLoad {
  double share = 0.5;      ///< of the unstretched rope between the next nodes of other kinds, from the first of them on
  double force = 0;        ///< N
  double rate = 0;         ///< N per unstretched metre of that rope, on `part` of it
  double part = 0;         ///< share
  int sense = 1;           ///< +1: along the path; -1: against it; by_motion: times the flow, at rest the haul
  bool by_motion = false;  ///< along or against the rope's motion
  bool open = false;       ///< the force is unknown: what the given torque of the rope's drive overcomes
  std::optional<Signal> signal = std::nullopt;  ///< in motion the force over time, or, of a rate, N/m
};

/// Loss of tension at a contact, with the flow in the sense of growing tension: T_out = r T_in,
/// ln r = min(friction * wrap, -ln efficiency). Grip and bearing in series, without spin inertia. A saddle: efficiency
/// 0 (it does not turn). A sheave: its efficiency, and infinite friction where the rope can't slip. A rolling carriage:
/// efficiency 0 and its rolling friction. Without any loss: efficiency 1.
struct ContactLaw {
  double friction = std::numeric_limits<double>::infinity();  ///< of the rope on the groove, >= 0
  double efficiency = 1;                                      ///< of the turning sheave, 0 <= efficiency <= 1
};

struct Node {
  std::string name;  ///< of the point, sheave, drum, carriage: as the deck says it
  NodeKind kind = NodeKind::anchor;
  Place at;                         ///< the point; of a round its centre
  double radius = 0;                ///< at the rope's centre, m; 0: a point
  Vector3 axis = Vector3::UnitY();  ///< unit vector in the body's frame; used when radius > 0
  int side = 1;                     ///< +1: along its path the rope turns right-handed about `axis`; -1: left-handed
  bool side_open = false;  ///< of a round without a given side, other than a saddle that only bears: `side` is its
                           ///< first guess, the answer decides
  int turns = 0;           ///< the wrap lies in [-pi/2, 3 pi/2) + 2 pi turns; below 0 the rope has left the sheave
  ContactLaw law;          ///< of a contact
  Vector3 support = Vector3::Zero();  ///< 0: holds the rope either way (a sheave with a guard, a carriage). Else the
                                      ///< unit vector from the support to the rope, in the ground frame (a saddle: 0,
                                      ///< 0, 1): the rope may lift off that way
  bool may_lift = false;              ///< lifting: true: the rope leaves the support; false: reported as pulling it up
  /// Of a clamp: unstretched length from the start of the rope (closed: from where it arrives at its drive), at the
  /// rope's reference temperature, m.
  double length_before = 0;
  double inertia = 0;  ///< of a sheave that turns, kg m2
  int drum = -1;       ///< of an anchor: the drum it is; -1: none
  int motor = -1;      ///< of a sheave: the motor that drives it; -1: none
  RopeLoad load;       ///< of a load
  /// Of a drive: T_in - T_out by its given torque, of one copy, N; empty: whatever comes. The torque of a closed rope
  /// that is given by its length needs an open load.
  std::optional<double> tension_drop;
};

/// What is known of a rope besides its path.
enum class Given {
  length,            ///< `value`: unstretched length at the rope's reference temperature, m, arcs on contacts counted;
                     ///< at a drum it starts where the rope leaves the drum
  tension_at_start,  ///< `value`: N; the length follows
  tension_at_end,    ///< `value`: N
  torque             ///< of a closed rope: its drive's tension_drop; the length follows
};

/// How a rope that has a length is put up to find it: with this tension at one end of its path, without what hangs on
/// it but for these bodies and loads (indices in the model).
struct PutUp {
  double tension = 0;  ///< N
  bool at_end = false;
  Array<int> bodies;
  Array<int> loads;
};

/// One rope on its path, in the order of which "in" and "out" speak. Parallel parts are already written out: a tackle
/// of n falls is n branches with a contact at each turn.
struct Reeving {
  std::string name;
  Array<Node> nodes;  ///< open: first and last are anchors, none between; closed: the first is the drive, then
                      ///< contacts and clamps, and the rope runs from the last back to the first
  bool closed = false;
  Given given = Given::length;  ///< a closed rope: length or torque
  double value = 0;
  /// Of a rope with ends over a drive without a given torque: what is known of it besides.
  std::optional<std::pair<Given, double>> also;
  double weight = 0;          ///< per unstretched length at the reference temperature, N/m, >= 0
  double stiffness = 0;       ///< EA, N, > 0; infinite: it does not stretch
  double breaking_force = 0;  ///< N; 0: not known, no safety factor
  double thermal_strain = 0;  ///< expansion times temperature above the reference
  int copies = 1;             ///< equal ropes beside each other; every force on the machine counts so often
  double damping_ratio = 0;   ///< zeta of the lowest mode in which the rope stretches; 0: not given
  double damping_time = 0;    ///< beta, s: T = EA (e + beta e'); 0: not given
  int segments = 1;     ///< > 1: in motion each branch is a chain of so many, with the rope's mass at their joints
  double speed = 0;     ///< of the running rope, m/s, >= 0: its centrifugal tension is mass speed^2
  double mass = 0;      ///< per unstretched length, kg/m
  double diameter = 0;  ///< m; 0: not known
  int haul = -1;        ///< flow along the path (+1) or against it (-1) when the motion is hoist or in
  /// Until the rope has been put up, `value` is the straight length of its path and no answer of an analysis.
  std::optional<PutUp> put_up = std::nullopt;
};

/// A carriage that a load path moves along its line.
struct Carriage {
  std::string name;
  int body = 0;
  int reeving = 0, node = 0;  ///< the rope it rides on, and where: a contact (rolling) or a clamp
  int mainline = -1;          ///< the reeving whose length sets its place; -1: none. A rolling carriage without one is
                              ///< held by a force along its track, a clamped one by where it is clamped
  int rollers = 1;            ///< nodes node .. node + rollers - 1
  int grip_reeving = -1, grip_node = -1;  ///< a running rope that carries it along, and the clamp there; -1: none
  int haulback = -1;                      ///< the reeving that pulls it against the mainline; -1: none
};

/// The ground under the line: a polyline, x growing. x is the distance from `Model::terrain_from` along
/// `Model::terrain_along`.
struct GroundPoint {
  double x = 0, z = 0;  ///< m
};

/// Rows of a survey that lie off the line by more than the deck's corridor.
struct OffLine {
  int rows = 0;
  int farthest = 0;     ///< row of the survey, from 1 on
  double distance = 0;  ///< of that one, in plan, m
  double chainage = 0;  ///< of that one, m
};

struct Model {
  double gravity = standard_gravity;  ///< m/s^2, along -z
  Array<Body> bodies;
  Array<Load> loads;
  Array<Reeving> reevings;
  Array<Carriage> carriages;
  Array<GroundPoint> terrain;
  Vector3 terrain_from = Vector3::Zero();    ///< where the terrain's x is 0, m
  Vector3 terrain_along = Vector3::UnitX();  ///< horizontal unit vector
  OffLine terrain_off_line;                  ///< of a survey
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
  Array<Observable> measures;      ///< by their names; each is observed too
  Array<Observable> mean_windows;  ///< quantities that say where means are taken
  Array<Beam> beams;
};

/// The terrain's x of a place, m.
double terrain_x(const Model& model, const Vector3& place);

/// Number of branches of a reeving before any contact is left: nodes - 1, closed: nodes. Branch k starts at node k.
int branch_count(const Reeving& reeving);

}  // namespace taut::machine
