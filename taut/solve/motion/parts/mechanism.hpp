#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/math/static_lu.hpp"
#include "taut/solve/motion/transient.hpp"

/// Inside of the transient analysis: the machine as arrays. docs/theory/motion.md.
namespace taut::solve::dynamics {

/// A body of the model, or an inner node of a rope in segments (model < 0: a point mass free in x, y, z). Columns
/// [first, first + count) of the unknowns are the accelerations of its freedoms.
struct Body {
  int model = -1;
  int first = 0, count = 0;
  std::array<Vector3, 6> along, about;  ///< of each freedom, unit velocities
  bool turns = false;                   ///< by a freedom
  bool point = false;                   ///< free in x, y, z, in this order, and without turning
  double mass = 0;                      ///< with the rope masses that lie on it, kg
  Vector3 centre = Vector3::Zero();     ///< of that mass, body frame, m
  Matrix3 inertia = Matrix3::Zero();    ///< about that centre, body frame, kg m2
  double own_mass = 0;                  ///< its weight acts at `own_centre`
  Vector3 own_centre = Vector3::Zero();
  bool driven = false;             ///< by signals
  Vector3 dead = Vector3::Zero();  ///< weight and dead loads of a body that does not turn, N
};

/// Where a body is and how it moves.
struct Motion3 {
  Vector3 x = Vector3::Zero();         ///< origin, m
  Matrix3 R = Matrix3::Identity();     ///< body to ground
  Vector3 v = Vector3::Zero();         ///< of the origin, m/s
  Vector3 w = Vector3::Zero();         ///< angular velocity, 1/s
  Vector3 driven_v = Vector3::Zero();  ///< the parts that signals give
  Vector3 driven_w = Vector3::Zero();
  Vector3 driven_a = Vector3::Zero();  ///< and their accelerations
  Vector3 driven_b = Vector3::Zero();
  Vector3 turned = Vector3::Zero();  ///< rotation since the start of the step, rad
};

/// How the free line between two rounds is found.
enum class LineKind {
  points,  ///< both radii 0
  planar,  ///< rounds with parallel axes that stay so, or a round and a point
  skew
};

/// One free branch of a rope, or one segment of it. Ends: 0 where the path enters it, 1 where it leaves it.
struct Line {
  int reeving = 0, from = 0, to = 0;        ///< nodes
  int segment = -1;                         ///< of a branch in segments
  std::array<bool, 2> inner{false, false};  ///< its ends that are joints between segments
  LineKind kind = LineKind::points;
  bool between_points = false;  ///< from a point body to another one, without flow
  std::array<int, 2> body{-1, -1};
  std::array<Vector3, 2> place;        ///< centre in the body's frame, m
  std::array<Vector3, 2> axis;         ///< body's frame
  std::array<Vector3, 2> zero;         ///< body's frame, for angles on skew rounds
  std::array<double, 2> radius{0, 0};  ///< at the start
  std::array<int, 2> side{1, 1};
  bool plain = false;             ///< between points of bodies that only shift
  std::array<Vector3, 2> offset;  ///< of a plain one: ends seen from the origins of their bodies, ground frame, m
  bool still = false;             ///< its ends never move
  // of a part between rope loads: both ends are those of the whole free line, of length l
  bool part = false;
  std::array<bool, 2> at_load{false, false};  ///< its ends that are not the free line's
  std::array<bool, 2> arcs{false, false};     ///< where half of the rope on the round is the line's own
  std::array<bool, 2> rim{false, false};      ///< where its rope runs with a round that has inertia, or a drive
  std::array<bool, 2> held{false, false};     ///< where its rope does not run: an anchor holds it, beyond other rounds
  std::array<bool, 2> along{false, false};  ///< where the inertia along itself of its half counts, there or farther on
  bool has_along = false;                   ///< it has a rim, or is held
  std::array<double, 2> carried{0, 0};      ///< mass of the half that goes with a body there that can move, kg
  double share = 1, more = 0;               ///< its length is share l + more
  double ahead = 0, ahead_more = 0;         ///< before it lies ahead l + ahead_more
  double middle = 0.5;                      ///< where its middle was at the start, as a share of l
  bool tensioned = false;                   ///< by a tensioner
  int sag = -1;                             ///< its place among the sagging lines; -1: straight
  std::array<int, 2> contact{-1, -1};
  double stiffness = 0;  ///< EA, N
  double damping = 0;    ///< beta, s
  double weight = 0;     ///< N per unstretched metre that hangs on its ends; 0: without
  double mass = 0;       ///< kg per unstretched metre
  double copies = 1;
  int columns = 0;                  ///< local unknowns: freedoms of body 0, of body 1, the flows of its contacts
  std::array<int, 14> column{};     ///< their columns
  std::array<int, 2> freedoms{};    ///< how many of them are body 0's and body 1's
  std::array<int, 2> flow{-1, -1};  ///< local index of the flow at each end
  Array<int> places;                ///< of the local matrix, row by row, in the values of the solver
};

/// Whether half of a line's weight is part of its tension at an end: there the tension is that of the rope itself; at
/// the joints of a chain it is the segment's.
inline bool bears_half(const Line& line, std::size_t end) { return !line.inner[end]; }

/// Length of a line, or of a part of one, where the free line has the length l.
inline double length_of(const Line& line, double l) { return line.share * l + line.more; }
/// What of a line's weight its end of the free line bears.
inline double borne(const Line& line, double l, std::size_t end) {
  if (!line.part) return 0.5;
  const double middle = line.ahead + (line.ahead_more + length_of(line, l) / 2) / l;
  return end == 0 ? 1 - middle : middle;
}

/// What turns: a sheave with inertia or a motor, a drum. Its angle is counted against the body that carries it, in path
/// sense (a sheave) or taking in (a drum).
struct Spin {
  int body = -1;
  Vector3 axis = Vector3::UnitY();  ///< body frame; in the sense of the angle
  double inertia = 0;
  double drag = 0;  ///< N m s
  int column = -1;  ///< -1: prescribed
  int drum = -1, motor = -1;
  Array<std::pair<int, double>> contacts;  ///< and their sense: +1 where the path runs with the angle
};

/// Of what a line has on its rounds, a share.
struct RopeShare {
  int line = 0;
  double share = 0;
};

/// What the rope meets at a node: a round it runs over, or a drum at its end (`in` or `out` < 0).
struct Contact {
  int reeving = 0, node = 0;
  int in = -1, out = -1;  ///< lines
  int body = -1;
  double radius = 0;
  int spin = -1;     ///< -1: light, turns with the rope or not at all
  double sense = 1;  ///< of the spin's angle along the path
  int column = -1;   ///< of the flow
  double friction = 0, efficiency = 1;
  bool round = false;   ///< has a wrap about its axis; else the angle between the directions
  bool driven = false;  ///< by a motor: its grip counts the wrap alone, as in statics,
  double working_arc = std::numeric_limits<double>::infinity();  ///< and of that no more than this, rad
  Vector3 support = Vector3::Zero();                             ///< as of a node of the model
  double mass = 0;  ///< kg per unstretched metre, for the pressure of a rope that runs over it
  double bearing_log = 0, bearing_ratio = 1;  ///< what the efficiency of a light one allows: -ln eta, 1/eta
  std::array<double, 2> beyond{0, 0};  ///< rope that goes with its rim beyond light rounds, on the side in, out, kg
  std::array<Array<RopeShare>, 2> beyond_arcs;  ///< the rope on rounds that belongs to it
  double copies = 1;
  int drum = -1;             ///< an end on a drum
  int on_drum = -1;          ///< its place among the ends on drums
  bool load = false;         ///< a force along the free rope acts there; `body`: its own, which has no freedoms
  double load_length = 0;    ///< unstretched rope of the span in which it lies, at the start, m
  Array<int> columns;        ///< all that its rows depend on
  Array<int> row, spin_row;  ///< places of those in the rows of its flow and of its spin
};

/// Two places that push or pull each other: a point on a face, the ends of an actuator. Side 0: the point, the end
/// `to`; side 1: the face, the end `from`.
struct Couple {
  std::array<int, 2> body{-1, -1};
  std::array<Vector3, 2> place;   ///< in the bodies' frames, m; of a face its end `from`
  std::array<int, 2> freedoms{};  ///< of the bodies
  std::array<int, 12> column{};   ///< theirs
  Array<int> places;              ///< of the local matrix, row by row, in the values of the solver
};

/// A force along a rope in segments: it acts at the place follows l + more of the chain, whose length is l.
struct ChainLoad {
  Contact as;        ///< its node, body, copies and load_length; no contact of the mechanism
  Array<int> lines;  ///< of the chain, along the path
  int count = 0;     ///< how many
  double follows = 0, more = 0;
  double bristle = 1;  ///< stiffness of its bristle, of a segment's
};

/// Lines of a rope in segments that meet at joints.
struct Chain {
  int first = 0, count = 0;
};

/// How a contact is in the step.
enum class Grip : std::int8_t {
  stuck,
  forward,  ///< the rope runs along the path faster than the rim, or is at that bound
  backward,
  equal  ///< both tensions are the same: no loss, or no pressure
};

/// The compiled machine.
struct Mechanism {
  const machine::Model* model = nullptr;
  Array<Body> bodies;
  Array<Line> lines;
  Array<Contact> contacts;
  Array<Spin> spins;
  Array<std::pair<int, int>> first_line;  ///< by reeving: first line and count
  Array<Array<int>> inside;               ///< by reeving: bodies that are inner nodes
  Array<std::pair<int, int>> tensioner;   ///< by tensioner: line and end
  Array<Chain> chains;                    ///< at whose ends rope runs on or off
  Array<ChainLoad> chain_loads;           ///< along ropes in segments
  Array<Couple> couples;                  ///< contacts of the model on faces, then its actuators, then `pushes`
  Array<int> pushes;                      ///< loads of the model whose size is a signal
  Array<int> body_place_first;            ///< by body: where its block begins in body_places
  Array<int> body_places;
  Array<int> spin_place_first, spin_places;  ///< a spin with the freedoms of its body, row by row
  int body_columns = 0;                      ///< the first ones
  double stiffest = 0;                       ///< of all lines, N
  bool simple = false;                       ///< point masses and lines between points alone
  bool rope_loads = false;                   ///< there are forces along its ropes
  bool lossless = false;                     ///< nothing in it takes or gives energy
  int on_drums = 0;                          ///< so many ends of ropes lie on drums
  int sagging = 0;                           ///< so many lines hang as catenaries
  int size = 0;
  double size_of_machine = 1;  ///< m
  StaticLu solver;
};

}  // namespace taut::solve::dynamics
