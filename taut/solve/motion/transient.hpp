#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// implicit: generalised-alpha, adaptive. verlet: explicit, for waves and breaks; its step is one for the whole motion,
/// stable and as short as the tolerance asks. reference: another integrator (IDA of SUNDIALS, variable order) of the
/// same laws, slow and exact, to judge the other two by.
enum class TimeMethod { implicit, verlet, reference };

/// The free rope between two neighbours of its path. straight: half of its weight hangs on each end. catenary: at every
/// moment the elastic catenary at rest between its moving ends, where the rope has weight, is in one piece and no force
/// acts along it. by_weight: so where its weight is more than `light` of its tension when the motion begins. Inertia:
/// half of its mass at each end in any case.
enum class Branches { straight, catenary, by_weight };

/// Rope on rounds between two branches. stretch: half of it with the branch at either side. rigid: it keeps the
/// strain with which it came there, as on a drum.
enum class Arcs { stretch, rigid };

/// Where the motion begins. assembled: bodies and lengths as described, at rest. settled: at the equilibrium at rest of
/// the same machine. sliding: there too, but with all friction as it is when the machine has come slowly from a little
/// before, as `slid` says: at rest and about to go on the same way.
enum class Start { assembled, settled, sliding };

/// What has moved slowly into its place before a motion begins: a cylinder (by > 0: it has extended) or the rope of a
/// drum that is held (by > 0: taken in), m.
struct Slid {
  bool drum = false;  ///< `index` of a drum, else of an actuator
  int index = 0;
  double by = 0;
};

/// What a moving machine remembers: a value that can be kept, written down and started from. Ropes: by reeving; a
/// branch runs from node k to node k + 1.
struct DynamicState {
  struct Body {
    Vector3 position = Vector3::Zero();         ///< of its origin, m
    Matrix3 orientation = Matrix3::Identity();  ///< body to ground
    Vector3 velocity = Vector3::Zero();         ///< of its origin, m/s
    Vector3 spin = Vector3::Zero();             ///< angular velocity, ground frame, 1/s
  };
  struct Rope {
    Array<double> length;       ///< by branch (of a rope in segments: by segment): unstretched, m
    Array<std::uint8_t> whole;  ///< by the same: 0 where it is broken
    Array<double> angle;        ///< by node: of the sheave or drum in path sense, rad
    Array<double> spin;         ///< by node: its rate against the body that carries it, 1/s
    Array<double> passed;       ///< by node: unstretched rope that ran over it along the path, m
    Array<double> wrap;         ///< by node: beyond 2 pi counted, rad
    Array<Vector3> inside;      ///< of a rope in segments: places of its inner nodes, m
    Array<Vector3> inside_velocity;
    Array<Vector3> leaves, arrives;  ///< by branch: directions of one that sags; 0: straight, or not known
    Array<double> on_rounds;         ///< by the same, two each: on the rounds at its ends, what stretches with it, m
    Array<double> lumped;            ///< by branch or segment: length whose mass was shared out, m; empty: `length`
    /// RopeExtreme::T_static of the motion that led here, N; NaN: not known
    double T_static = std::numeric_limits<double>::quiet_NaN();
  };
  /// The end of a rope that lies on a drum.
  struct OnDrum {
    double content = 0;  ///< unstretched, m
    int layer = 1;
    Array<double> strain;  ///< by layer: of the rope that lies there
  };
  /// A branch or segment that breaks: what is left of its stiffness falls from 1 to 0 from `from` on, within `over`.
  struct Tear {
    int reeving = 0, part = 0;
    double from = 0, over = 0;  ///< s
  };
  double t = 0;  ///< s
  Array<Body> bodies;
  Array<Rope> ropes;
  Array<Tear> tears;             ///< those under way at t
  Array<OnDrum> on_drums;        ///< by reeving, its start before its end
  Array<double> force;           ///< state variables of force elements (bristles of contacts), in their order
  Array<std::uint8_t> happened;  ///< by event of the model
  Array<std::string> done;       ///< the others that have happened, of decks before, by their words
  bool begins_anew = false;      ///< drives or cylinders do from here on what they did not do up to here
  Array<machine::Drive> drum_drive, motor_drive;  ///< as events have left them
  Array<machine::ActuatorMode> actuator_mode;
  Array<double> damping_time;  ///< by reeving, s, found at the start
  Array<double> memory;        ///< of the integrator; empty: it begins anew from the above
};

struct TransientFrame;
struct TransientResult;

struct TransientOptions {
  double duration = 0;     ///< s, from `start` or the time of `from`
  double output_step = 0;  ///< s; 0: duration/1000
  /// Of the error that the steps of the whole run leave: tensions by the largest of the rope, places by the machine's
  /// size. A kink (slack, stick) may cost as much once more. Verlet: `TransientResult::tension_error` and `open`.
  double tolerance = 1e-6;
  double step = 0;  ///< > 0: this step throughout, no control of the error, s
  TimeMethod method = TimeMethod::implicit;
  double rho = 0.9;          ///< of generalised-alpha: what a step leaves of the fastest motions, 0 .. 1
  double damping_ratio = 0;  ///< of ropes that give none
  Start start = Start::settled;
  Array<Slid> slid;  ///< of a sliding start; its ways there are gone back and come again together
  /// So slow that nothing has inertia, and dampers do nothing: an equilibrium at the end of every step, with friction
  /// carried on from one to the next, by the speed at which it slid in the step before. Steps of `step`, else of
  /// `output_step`. Cylinders with a law follow their reference speed. Where a state can't be held any more the machine
  /// goes, without swinging, to the next one that can.
  bool quasi_static = false;
  Branches branches = Branches::straight;
  Arcs arcs = Arcs::stretch;
  double light = 0.05;               ///< of `by_weight`: m g l/T up to which a branch is straight
  bool rope_mass = true;             ///< false: ropes have neither weight nor inertia
  std::optional<DynamicState> from;  ///< go on from there
  long most_steps = 50'000'000;
  /// Called at each output step and often in between with the time reached; false interrupts.
  std::function<bool(double)> progress;
  /// Called after each output step with the result so far: its last frame is that step, the one before it the step
  /// before. The result then keeps only the first and the last frame, so that its size does not grow with the motion.
  std::function<void(const TransientResult&)> take;
  /// Called between output steps with the result so far and a moment, without its energy: where the tension at an end
  /// of a branch, or the largest of a rope, has a peak larger than at the output before and all peaks since, and where
  /// `moment_step`, s, have passed without one.
  std::function<void(const TransientResult&, const TransientFrame&)> moment;
  double moment_step = 0;  ///< s; 0: each step is a moment
  /// For who judges forces of several ropes together, which peak where none of them does: a moment is each step, too,
  /// at whose end the tension at an end of a branch is no more what it was in the last moment, but for 1/100 of the
  /// rope's largest so far.
  bool closely = false;
  /// With `take`: called before the motion begins, and again where Verlet begins it anew with shorter steps. What was
  /// taken until then does not count.
  std::function<void()> anew;
};

/// Work and energy since the start, J. kinetic + elastic + potential = at the start + supplied - dissipated + residual.
struct EnergyLedger {
  double kinetic = 0, elastic = 0;
  double potential = 0;  ///< of a machine far from the origin: sideways from machine::far_middle
  double damped = 0;     ///< in the ropes
  double slipped = 0;    ///< rope on rounds, creep included
  double bearings = 0;   ///< of sheaves, or of light sheaves the whole loss
  double broken = 0;     ///< elastic energy of branches at their break
  double contacts = 0;   ///< dashpots and friction of faces
  double slack = 0;      ///< by the weight of rope that runs into slack branches (lost) and out of them (< 0)
  double flanges = 0;    ///< of rounds that ropes leave out of their plane: T (1 - cos d) R d(phi); a gain is < 0
  double numerical = 0;  ///< by the Euler steps over kinks (impacts of ropes without mass) and by joints laid out anew
  double supplied = 0;   ///< by all drives, tensioners, driven bodies, actuators
  double residual = 0;
  double turnover = 0;  ///< largest of what was stored, supplied and dissipated: a scale for the residual

  /// All that is neither stored nor supplied and has a name.
  double dissipated() const { return damped + slipped + bearings + broken + contacts + slack + flanges + numerical; }
};

/// The machine at one output step.
struct TransientFrame {
  struct Body {
    Vector3 position, velocity, acceleration;  ///< of its origin
    Matrix3 orientation;
    Vector3 spin;
  };
  struct Branch {
    int reeving = 0, from = 0, to = 0;      ///< nodes
    double T_from = 0, T_to = 0;            ///< N
    double unstretched = 0, stretched = 0;  ///< m
    Vector3 start, end;                     ///< m
    Vector3 leaves, arrives;                ///< directions along the path there
    bool whole = true;
    /// Speed along itself of the half there that its inertia does not count with, m/s: all, or what it slips on a rim.
    std::array<double, 2> uncounted{0, 0};
    Array<Vector3> curve;  ///< of one that sags: points between start and end, m
  };
  struct Contact {
    int reeving = 0, node = 0;
    double T_in = 0, T_out = 0;  ///< N, by the order of the path
    double centrifugal = 0;      ///< m v^2, what the momentum of its rope takes of both, N
    double wrap = 0;             ///< rad
    double angle = 0, spin = 0;  ///< of the sheave against its body, path sense, rad, 1/s
    double flow = 0;             ///< stretched rope along the path relative to the body, m/s
    double slip = 0;             ///< rope less rim, m/s
    ContactState state = ContactState::stuck;
    int side = 1;                     ///< machine::Node::side, as found where the motion begins
    Vector3 force = Vector3::Zero();  ///< of the rope (one copy) on it, N
  };
  struct Drum {
    double T = 0, speed = 0;       ///< N, largest of its ropes; taken in of the first one, m/s
    double torque = 0, power = 0;  ///< of its drive, N m, W
    bool held = false;             ///< stands by a drive that does not turn it, or by none; no brake is set
    bool braked = false;           ///< stands in its brake, which is set and acts in full
    bool by_torque = false;        ///< its drive gives a torque, or none; its brake is not set
  };
  /// The end of a rope that lies on a drum.
  struct OnDrum {
    int reeving = 0, drum = 0;
    bool at_end = false;
    double content = 0;  ///< unstretched, m
    int layer = 1;
  };
  struct FaceContact {
    double N = 0, F = 0, speed = 0;  ///< N; of friction on the point and of the point, > 0 from `from` to `to`, N, m/s
    bool closed = false, sticks = false;
    Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();  ///< m; of the face
    Vector3 force = Vector3::Zero();                             ///< on the point, N
  };
  struct Actuator {
    double F = 0, length = 0, speed = 0, power = 0;  ///< N, pushing apart; m, m/s, W
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();
  };
  double t = 0;
  Array<Body> bodies;
  Array<Branch> branches;        ///< by reeving, along its path; of a rope in segments: each segment
  Array<Array<Vector3>> inside;  ///< by reeving: nodes of a rope in segments
  Array<Contact> contacts;       ///< by reeving, nodes between the ends
  Array<Drum> drums;
  Array<OnDrum> on_drums;  ///< by reeving, its start before its end
  Array<Drum> motors;
  Array<FaceContact> faces;
  Array<Actuator> actuators;
  EnergyLedger energy;
};

/// What happened: "slack", "taut", "stick", "slip", "break", "run_off", "stop", "lift_off", "length_zero", "layer",
/// "drive", "brake", "actuator", "contact", "apart"; "coarser": a run of very many steps resolves what shakes fast and
/// undamped within each of its swings from here on, no more to its tolerance over all of them.
struct TransientEvent {
  double t = 0;
  std::string what;
  std::string where;                             ///< the rope, sheave, contact by name
  Array<std::pair<std::string, double>> values;  ///< with their symbols, SI
  std::optional<int> reeving = {};               ///< of "slack", "taut" and "break": the rope
};

struct Extreme {
  double min = 0, max = 0, t_min = 0, t_max = 0, end = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();  ///< of a measure that has one, over its window
};

/// A rope over the whole run, at every step of the integrator.
struct RopeExtreme {
  /// N; min: the least tension anywhere in it, of one that breaks up to then; max, end: the largest at a time.
  Extreme T;
  /// The least mean of the tensions at the ends of a branch, as long as the rope is whole, N, and when that was, s.
  double T_loosest = 0, t_loosest = 0;
  int branch = 0;       ///< where max was
  double T_static = 0;  ///< largest tension at the start, of the first part of a motion in parts, N; NaN: not known
};

/// Ways over the whole run, at every step of the integrator, m: of the rope against a contact's rim, and of the rim.
struct ContactWays {
  double slipped = 0, rim = 0;
};

/// What a drum does in its brake while that acts in full.
struct BrakeWay {
  bool acted = false;         ///< in some step
  bool acts = false;          ///< in the last step
  bool stood = false;         ///< since it acts
  double way = 0, since = 0;  ///< of the rope after the drum had stood, m; when it began to slip, s
  /// The first time that it acted no more while the drum had not stood in it, s, and how fast the rope ran then, m/s.
  std::optional<double> let_go;
  double speed = 0;
};

/// `outcome` not ok: the frames up to `t_end` are a result, the message says what happened there.
struct TransientResult {
  Outcome outcome;
  bool interrupted = false;
  double t_end = 0;
  Array<TransientFrame> frames;
  Array<Array<double>> observed;  ///< [model.observed][frame]
  Array<Extreme> extremes;        ///< [model.observed]
  Array<RopeExtreme> ropes;       ///< by reeving
  Array<ContactWays> ways;        ///< by contact of a frame, those of chains left out
  Array<BrakeWay> brake_ways;     ///< by drum
  Array<TransientEvent> events;
  DynamicState state;  ///< at t_end: go on from there
  long steps = 0, rejected = 0, iterations = 0;
  double smallest_step = 0, largest_step = 0;  ///< s
  double stability_limit = 0;                  ///< of Verlet at the start, s
  /// What the errors of implicit steps add up to, as a share of the tolerance; those with a kink and Euler's left out.
  double spent = 0;
  double open = 0, t_open = 0;  ///< largest residual of the ledger at an output step, of the turnover; when, s
  /// Of equal steps: the error of the tensions within each of their swings, as a share of the rope's largest.
  /// docs/theory/motion-steps.md.
  double tension_error = 0;
  Array<double> damping_time;  ///< by reeving: beta, s
  Array<double> frequency;     ///< by reeving: omega_1 from which it follows, 1/s; 0: beta was given or none
  Array<int> sagging;          ///< by reeving: so many of its branches hang as catenaries
  Array<bool> mass_lumped;     ///< by reeving: half of each branch's mass at each end; false: none
};

/// The equilibrium at rest of statics, where a settled motion begins: all ropes hang as catenaries, friction is none,
/// loads over time are as they begin. None where statics does not know one; it knows neither faces nor cylinders.
std::optional<EquilibriumResult> rest_before_motion(const machine::Model& model);

/// The machine in motion. docs/theory/motion.md.
TransientResult transient(const machine::Model& described, const TransientOptions& given);

}  // namespace taut::solve
