#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/run/ledger.hpp"

/// Points on faces, actuators and loads over time of a machine in motion: forces between two places, each with its
/// derivatives.
/// docs/theory/faces.md.
namespace taut::solve::dynamics {

/// Numbers them; before the pattern of the solver is made.
void add_couples(Mechanism& m);
/// What they begin with; their size counts as the machine's.
void fill_couples(const DynamicState& start, Mechanism& m, Values& v);
void keep_couples(const Values& v, DynamicState& state);
/// Modes that events have set, from one time to the other.
void take_modes(const Values& before, Values& now);
/// Not ok: an actuator that can't be computed.
Outcome check_couples(const Mechanism& m, const Values& v);

/// Forces by the poses and velocities in `now`.
void follow_couples(const Mechanism& m, const Scheme& s, const Values& before, Values& now);
void assemble_couples(Mechanism& m, const Scheme& s, const Values& now, Work& w);
/// Since the last iteration: the largest change of a force, N; the largest force; whether a contact follows another
/// law.
struct CoupleChange {
  double force = 0, largest = 0;
  bool turned = false;
};
CoupleChange change_of_couples(Work& w, const Values& now);
/// Upper bounds for what couples add: to the square of a natural frequency, 1/s2; of the decay that dampers give, 1/s.
struct CoupleBounds {
  double square = 0, rate = 0;
};
CoupleBounds bounds_of_couples(const Mechanism& m, const Values& v);

/// Work in a step: what dashpots and friction take, what actuators and loads over time give, J.
struct CoupleWork {
  double lost = 0, supplied = 0;
};
CoupleWork work_of_couples(const Mechanism& m, const Values& before, const Values& now);
/// What a step of implicit Euler takes, whose forces are those of its end while their work is booked by the mean, J.
double taken_by_couples(const Mechanism& m, const Values& before, const Values& now);
/// Elastic energy of contacts and their bristles, J.
double energy_of_faces(const Mechanism& m, const Values& v);
/// What they give a body that moves so: velocities of its origin and about it, W, or ways, J.
double power_of_couples(const Mechanism& m, int body, const Values& v, const Vector3& along, const Vector3& about);

double observe_couple(const Mechanism& m, const Values& v, const machine::Observable& what);
TransientFrame::FaceContact face_frame(const Mechanism& m, const Values& v, std::size_t i);
Array<TransientFrame::Actuator> actuator_frames(const Values& v);

/// An event: an actuator's mode. A lock keeps the force that there is.
void set_mode(const Mechanism& m, Values& v, int actuator, machine::ActuatorMode mode);

/// How a couple follows one freedom of one of its bodies.
struct CoupleColumn {
  int side = 0, freedom = 0;
  Vector3 a, b;      ///< the freedom: along, about
  Vector3 lever;     ///< of its side, from the body's origin
  Vector3 velocity;  ///< of the place on its body, - on side 1: power of the force on side 0
  Vector3 force;     ///< to fill: derivative of the force on side 0 by the unknown, N
};
using CoupleColumns = std::array<CoupleColumn, 12>;

/// Columns for forces that act at `at[0]` and `at[1]`.
int couple_columns(const Mechanism& m, const Couple& couple, const Values& now, const std::array<Vector3, 2>& at_place,
                   CoupleColumns& columns);
/// Into the residual and the solver: `force` on side 0, its opposite on side 1. `together`: both act where the place
/// of side 0 is.
void add_force(Mechanism& m, const Scheme& s, const Couple& couple, const Vector3& force, bool together, int count,
               const CoupleColumns& columns, Work& w);
const Motion3& motion_of(const Values& v, int body);

/// The law of one contact: friction coefficient at a speed of sliding, and its slope, s/m.
struct Friction {
  double f = 0, slope = 0;
};
Friction friction_at(const machine::FaceContact& law, double speed);

void follow_face(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now);
void assemble_face(Mechanism& m, const Scheme& s, std::size_t i, const Values& now, Work& w);
void follow_actuator(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now);
void assemble_actuator(Mechanism& m, const Scheme& s, std::size_t i, const Values& now, Work& w);
/// Whether a point that is pressed comes over the end of its face in the step: the force jumps then.
bool meets_an_edge(const Mechanism& m, const Values& now);
/// Whether the point is between the ends of its face; `arm`: in the frame of the face's body.
bool is_over(const machine::Face& face, const Vector3& arm);

}  // namespace taut::solve::dynamics
