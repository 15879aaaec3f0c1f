#pragma once
#include <algorithm>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/line.hpp"
#include "taut/solve/motion/parts/mechanism.hpp"
#include "taut/solve/motion/parts/sag.hpp"

namespace taut::solve::dynamics {

/// A contact as it is at one time. Flows are unstretched rope along the path, m/s, without what the turning of the
/// line's direction winds on or off.
struct ContactValues {
  double rolled = 0;     ///< rope passed by the rim's own turning, m
  double slipped = 0;    ///< beyond that, m: passed = rolled + slipped
  double flow = 0;       ///< m/s
  double steady = 0;     ///< the same without what comes and goes at once: for the rope's momentum, m/s
  double roll_rate = 0;  ///< of the rim: R omega/lambda, m/s
  double slip_rate = 0;  ///< of `slipped`, m/s
  double slip_mean = 0;  ///< the same, mean of the last step
  double wrap = 0;       ///< rad
  double log_ratio = 0;  ///< what the tensions' logarithms can differ by
  double log_by_wrap = 0;
  double ratio = 1;    ///< exp(log_ratio)
  double lambda = 1;   ///< stretch of the rope that arrives
  int entry = 0;       ///< its line; -1: from a drum
  double drop = 0;     ///< of a rope load: RopeLoadStep::drop, N
  bool holds = true;   ///< and RopeLoadStep::holds
  double winding = 1;  ///< the stretch that counts for winding on and off in this step
  Grip grip = Grip::stuck;
};

struct SpinValues {
  double angle = 0, omega = 0, alpha = 0;
  double bearing = 0;     ///< its moment against the turning, N m
  double capacity = 0;    ///< the largest that it can have
  double torque = 0;      ///< of the drive, N m
  double speed = 0;       ///< prescribed, of the rope, m/s
  std::int8_t turns = 0;  ///< the sense in which the bearing slides; 0: it sticks
};

/// A point and its face at one time. Ground frame where nothing else is said.
struct FaceValues {
  bool over = true;  ///< between the ends of the face when the step began
  bool closed = false, sticks = false;
  double pace = 0;      ///< of a quasi-static step: at which it slid in it, m/s
  double gone = 0;      ///< of such steps: how far it has slid since it stuck, m
  double held_by = -1;  ///< of the same: its coefficient of friction, by the pace of the step before; < 0: by its speed
  double pen = 0, pen_rate = 0;        ///< how deep the point is, m, m/s
  double N = 0, limit = 0;             ///< pressure and the most that friction can be, N
  Vector3 normal = Vector3::UnitZ();   ///< of the face
  Vector3 point = Vector3::Zero();     ///< m
  Vector3 arm = Vector3::Zero();       ///< the same in the frame of the face's body, m
  Vector3 slide = Vector3::Zero();     ///< velocity of the point along the face, seen from it, m/s
  Vector3 bristle = Vector3::Zero();   ///< strain of the contact along the face, frame of the face's body, m
  Vector3 pull = Vector3::Zero();      ///< what friction would have to hold if it stuck, N
  Vector3 friction = Vector3::Zero();  ///< on the point, N
};

struct ActuatorValues {
  machine::ActuatorMode mode = machine::ActuatorMode::extend;
  double hold = 0;                  ///< length of its spring: locked, or driven by a speed, m
  double length = 1, speed = 0;     ///< m (< 0: it has gone through itself, which ends the motion), m/s
  double F = 0, F_l = 0, F_v = 0;   ///< N; derivatives by length and speed
  Vector3 t = Vector3::UnitX();     ///< from `from` to `to`
  std::array<Vector3, 2> end;       ///< `to`, `from`, ground frame, m
  Vector3 apart = Vector3::Zero();  ///< velocity of `to` seen from `from`, m/s
};

/// A load whose size is a signal.
struct PushValues {
  Vector3 at = Vector3::Zero();     ///< where it acts, ground frame, m
  Vector3 force = Vector3::Zero();  ///< N
};

/// A force along a rope in segments at one time.
struct ChainLoadValues {
  int line = 0;                               ///< the segment that encloses its place
  double share = 0;                           ///< of that segment, before the place
  double force = 0;                           ///< on the rope, along its path, N
  double speed = 0;                           ///< of the rope, seen from the place, m/s
  double bristle = 0;                         ///< how far the rope has gone on since it stuck, m
  double stiffness = 0;                       ///< of the bristle while it sticks, else 0, N/m
  bool holds = true;                          ///< friction
  std::array<double, 2> on_end{0, 0};         ///< what the ends of the segment get along it, N
  std::array<bool, 2> bounded{false, false};  ///< a round there gets less: its rope is slack
};

/// The end of a rope that lies on a drum: each has its own part of it.
struct OnDrumValues {
  double content = 0;  ///< unstretched rope on it, m
  int layer = 1;
  Array<double> strain;  ///< of the rope in each layer
};

/// All that changes, at one time. By column: q position (of a flow: rope passed), nu velocity (of a flow: roll_rate),
/// rate acceleration.
struct Values {
  double t = 0;
  double when = 0;  ///< for signals: just before t at the end of a step, t itself after a restart
  Array<Motion3> bodies;
  Array<double> q, nu, rate;
  Array<LineValues> lines;
  Array<SagValues> sags;  ///< of the lines that hang as catenaries
  Array<ContactValues> contacts;
  Array<SpinValues> spins;
  Array<OnDrumValues> on_drums;  ///< by Contact::on_drum
  Array<ChainLoadValues> chain_loads;
  Array<FaceValues> faces;                ///< by contact of the model
  Array<ActuatorValues> actuators;        ///< by actuator of the model
  Array<PushValues> pushes;               ///< by Mechanism::pushes
  Array<double> tensioned, tension_rate;  ///< by tensioner: length let in since the start, m, m/s
  Array<machine::Drive> drum_drive, motor_drive;
  const machine::Drive& drive(const Spin& spin) const {
    return spin.drum >= 0 ? drum_drive[spin.drum] : motor_drive[spin.motor];
  }
};

/// One step of the generalised-alpha method for first-order equations (Jansen, Whiting, Hulbert 2000), written for the
/// end of the step: x = x_star + reach x', for positions, velocities and rolled rope alike.
struct Scheme {
  double h = 0;      ///< s; 0: nothing moves, only accelerations and what slips at once are found
  double reach = 0;  ///< h gamma alpha_f/alpha_m
  double alpha_m = 0.5, alpha_f = 0.5, gamma = 0.5;
  double slip_now = 0, slip_before = 0;  ///< slip_rate = slip_now * (slipped since the start of the step) + slip_before
                                         ///< * slip_mean of the step before
  bool lossless = false;                 ///< no friction, and rims that turn with the rope: looking for the start
  double losses = 1;                     ///< share of their losses that contacts have in an iteration
  bool at_rest = false;                  ///< without velocities: looking for the start, or quasi-static
  bool creeps = false;                   ///< quasi-static: from rest to rest, with friction
  double elapsed = 0;                    ///< then: the time in which drives and signals go on, s
  bool only_rates = false;  ///< at an unchanged time: ropes with dampers begin to slip, none has slipped yet
  bool fresh = false;       ///< what lies loose does not go on as it went before
};
Scheme scheme_of(double rho);
/// Implicit Euler: first order, and nothing fast is left of what a step can't follow.
Scheme scheme_of_euler();

/// Line's derivatives by its local columns.
struct LineTangent {
  std::array<std::array<double, 14>, 2> end_T{};
  std::array<std::array<double, 14>, 2> angle{};
  std::array<double, 14> e{};
  std::array<std::array<double, 14>, 2> end_e{};  ///< of a sagging line: strain at its ends
};

/// One freedom of a body at an end of a plain line: its direction, and how the line follows it.
struct PlainColumn {
  const Vector3* along = nullptr;  ///< of the freedom
  double sign = 1;                 ///< of the length: the end moves away or comes near
  double share = 0;                ///< of the direction in the line's
};

/// Room to work in.
struct Work {
  Array<double> q_star, nu_star;  ///< by column
  Array<double> q_mean, nu_mean;  ///< the method's auxiliary rates at the start of the step
  double mean_step = 0;           ///< the step to which they belong, s; 0: they are the rates
  Array<double> residual;         ///< by column, N, N m
  Array<LineTangent> tangents;
  Array<char> hangs;  ///< of each sagging line: whether its tangent is that of a catenary
  std::array<LineColumn, 14> columns;
  std::array<PlainColumn, 12> plain;
  std::array<double, 14> T_slope{}, L_slope{};  ///< of a line by its local unknowns
  Array<double> tension;                        ///< by line, of the last iteration
  bool tangent = true;                          ///< derivatives are wanted too
  Array<double> push;                           ///< forces of couples, of the last iteration
  Array<std::uint8_t> push_state;               ///< of contacts on faces: 0 apart, 1 slides, 2 sticks
  Array<Vector3> slid;                          ///< of points on faces, beyond their bristle, in the last iteration
};

/// Direction of the rope at an end of a line, along the path.
inline const Vector3& direction(const Mechanism& m, const Values& v, int line, std::size_t end) {
  const LineValues& is = v.lines[line];
  return sags(m.lines[line], is) ? v.sags[m.lines[line].sag].direction[end] : is.t;
}
/// Strain of the rope there, without what dampers hold.
inline double end_strain(const Mechanism& m, const Values& v, int line, std::size_t end) {
  const LineValues& is = v.lines[line];
  if (!sags(m.lines[line], is)) return is.e;
  return v.sags[m.lines[line].sag].pull[end].norm() / m.lines[line].stiffness;
}
/// Of the rope that comes to a contact.
inline double entry_strain(const Mechanism& m, const Values& v, const Contact& contact, int entry) {
  return end_strain(m, v, entry, entry == contact.in ? 1 : 0);
}
/// The line whose rope the turning of a line lays on a round, or takes off it. On a drum that of the free rope there:
/// what swings onto it comes off again as it was laid on. Else the line from which the rope comes.
inline int winding_line(const Contact& contact, const ContactValues& is) {
  return contact.drum >= 0 ? std::max(contact.in, contact.out) : is.entry;
}
/// The stretch of that rope.
inline double winding_stretch(const Mechanism& m, const Values& v, const Contact& contact, const ContactValues& is) {
  if (contact.drum < 0) return is.lambda;
  return 1 + std::max(0.0, entry_strain(m, v, contact, winding_line(contact, is)));
}
/// Stretch of what lies on the rounds at its ends, as of the start of the step.
std::array<double, 2> windings_of(const Line& line, const Values& before);
/// Its rows.
void assemble_sagging(Mechanism& m, const Scheme& s, const Values& before, std::size_t i, const Values& now, Work& w);

/// Rope that an end of a sagging line lays on its round by the turning of its direction, m/s.
double sag_winding_rate(const Mechanism& m, std::size_t line, std::size_t end, const Values& now);

/// Whether the end of a rope has run off a round: the rim that turns there passes nothing any more.
inline bool has_no_rope(const Contact& contact, const Array<LineValues>& lines) {
  return contact.in >= 0 && contact.out >= 0 && (has_run_off(lines[contact.in]) || has_run_off(lines[contact.out]));
}

/// Puts the star values of a step from `before` into the work.
void begin_step(const Mechanism& m, const Scheme& s, const Values& before, Work& w);
/// The auxiliary rates at the end of an accepted step.
void end_step(const Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w);

/// From the rates of freedoms and spins and the rope passed at each contact: poses, lines, strains, tensions, bounds.
/// False where a line has no place.
bool follow(const Mechanism& m, const Scheme& s, const Values& before, const Work& w, double t, Values& now);

/// Geometry and strain of a line between points of bodies that only shift. False: it has no length.
bool follow_plain(const Mechanism& m, std::size_t line, Values& now);
/// Its rows.
void assemble_plain(Mechanism& m, const Scheme& s, std::size_t line_index, const Values& values_now, Work& w);

/// Angle of the rope about what it runs over, rad.
double wrap_of(const Mechanism& m, std::size_t contact, const Values& v);

/// Decides how each contact and each bearing is, by what they carry and how they move (semismooth Newton). Whether any
/// has changed.
bool decide(const Mechanism& m, const Scheme& s, const Values& before, Values& now);

/// Where a contact's tensions stand against its law; T less thrust.
struct Pressure {
  double in = 0, out = 0;
};
/// Of its stiffness that a slack branch keeps in derivatives where ropes have to find their places anew.
constexpr double rough_slack_share = 1e-4;
/// Whether the rope has no tension on either side of a contact.
bool loose(const Contact& contact, const Values& now);
/// With which flow a rope goes on that nothing holds: as it went, but where it lies slack on both sides, m/s.
double loose_flow(const Contact& contact, const ContactValues& was, const Values& before);

inline Pressure pressure(const Contact& of, const Values& now) {
  Pressure p;
  if (of.in >= 0) {
    const LineValues& line = now.lines[of.in];
    p.in = line.end_T[1] - line.thrust[1];
  }
  if (of.out >= 0) {
    const LineValues& line = now.lines[of.out];
    p.out = line.end_T[0] - line.thrust[0];
  }
  return p;
}
inline Pressure pressure(const Mechanism& m, int contact, const Values& now) {
  return pressure(m.contacts[contact], now);
}

/// Rope between slack branches that an iteration has moved farther from where it lay than need be goes back, as long as
/// both stay slack: their lengths have no other law. Whether any did.
bool put_loose_back(const Mechanism& m, const Values& before, Values& now);

/// Takes the slack lines of a run of rope together with its taut ones, before an iteration: where all of the run will
/// be taut, or none of it, they pull as springs that may push. docs/theory/motion-steps.md.
void decide_runs(const Mechanism& m, const Values& before, Values& now);

/// Keeps the rope that an iteration lets run round a closed rope (`step`, by column, to be taken off) within bounds.
void hold_circulation(const Mechanism& m, const Scheme& s, const Values& before, const Values& now,
                      Array<double>& step);
/// Whether contacts that slip do so by their laws, to `share` of the largest tension or to `floor`, N: an iteration may
/// stand still without an answer, where laws contradict each other or a damper keeps a line without tension.
bool laws_hold(const Mechanism& m, const Values& now, double share, double floor);

/// Stiffness of both its lines, N/m.
inline double stiffness_at(const Mechanism& m, const Contact& contact, const Values& now) {
  const auto of = [&](int i) { return i < 0 ? 0 : m.lines[i].stiffness / some_length(now.lines[i]); };
  return of(contact.in) + of(contact.out);
}

/// The residual of every row and its derivatives by the unknowns, into the work and the solver.
void assemble(Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w);

/// Adds the rows of contacts and spins.
void assemble_contacts(Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w);

/// What the inertia and the dead forces of a body ask of a virtual velocity (along, about): N or W.
double inertia_power(const Mechanism& m, int body, const Values& now, const Vector3& along, const Vector3& about);
/// Dead loads on a body of the model, N.
Vector3 dead_load(const Mechanism& m, int model_body);
/// Acceleration of a body's origin, and its angular acceleration.
std::pair<Vector3, Vector3> acceleration(const Mechanism& m, int body, const Values& now);

/// At an unchanged time: whether the rate of a contact's slip is found with the tensions (its rope has dampers), by the
/// slip in 1/slip_now. Else the rope slips at once, and goes on with the rate that it had.
bool slips_in_a_moment(const Mechanism& m, const Scheme& s, const Contact& contact);
/// Whether such a rope stays where it is, and its rate alone is found (Scheme::only_rates); not one that sags.
bool slips_later(const Mechanism& m, const Scheme& s, const Contact& contact);

/// Radius of the rope on a round; of a drum that of the layer being wound, m.
double working_radius(const Mechanism& m, const Contact& contact, const Values& v);

/// How a spin turns where its drive prescribes that (held, braked, by speed); and the torque of one that has it.
struct Turning {
  double omega = 0, alpha = 0;
};
std::optional<Turning> prescribed(const Mechanism& m, const Spin& spin, const Values& v, double t);
double drive_torque(const Mechanism& m, const Spin& spin, const Values& v, double t);
/// What a brake that is set takes at most from a drum that turns in it, N m; 0 for one that holds anything.
double brake_torque(const Mechanism& m, const Spin& spin, const Values& v, double t);
/// The same of its bearings and its brake together: Coulomb friction against the carrying body, N m.
double friction_of_spin(const Mechanism& m, const Spin& spin, const Values& before, const Values& now);
/// The tension that a drum without inertia, or one that pulls, gives its rope: none to one that is broken somewhere,
/// and less to one that breaks, by what is left of it in `rope`.
std::optional<double> given_tension(const Mechanism& m, const Contact& contact, const Values& v, double t,
                                    const Values& rope);
inline std::optional<double> given_tension(const Mechanism& m, const Contact& contact, const Values& v, double t) {
  return given_tension(m, contact, v, t, v);
}

/// Moment of the ropes on a spin, in its sense, N m.
double rope_moment(const Mechanism& m, const Spin& spin, const Values& before, const Values& now);

/// Moment that ropes and drive have on a spin, less what its inertia takes: what its bearing holds while it rests, N m.
double held_moment(const Mechanism& m, const Spin& spin, const SpinValues& is, const Values& before, const Values& now);

/// Largest moment of a bearing at one contact, R (1 - eta)/(1 + eta) |F|, N m, and its derivatives by the tensions.
struct BearingSlope {
  double capacity = 0, in = 0, out = 0;
};
BearingSlope bearing_slope(const Mechanism& m, const Contact& contact, const Values& before, const Values& now);

}  // namespace taut::solve::dynamics
