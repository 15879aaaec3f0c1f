#pragma once
#include <limits>
#include <set>
#include <string>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/run/ledger.hpp"
#include "taut/solve/motion/step/step.hpp"

namespace taut::solve::dynamics {

/// A run under way.
struct Run {
  const machine::Model& model;
  const TransientOptions& options;
  Mechanism m{};
  Values before{}, now{};  ///< at the start and at the end of the step
  Work w{};
  Newton newton{};
  Scheme scheme{};
  Ledger ledger{};
  TransientResult result{};
  DynamicState origin{};     ///< what the state is completed from
  Array<double> stops{};     ///< times to step onto, growing
  Array<double> extremes{};  ///< the same, where nothing begins anew
  Array<char> happened{};    ///< by event
  struct Breaking {
    int line = 0;
    double from = 0, over = 0;  ///< s
  };
  Array<Breaking> breaking{};
  double end = 0;
  double h = 0;
  double floor = 0;                     ///< where a law changes no step need be shorter, s
  bool fresh = false;                   ///< what slips does not go on as it did: after a start, an event, an Euler step
  int rough_left = 0, rough_more = 1;   ///< Euler steps to go on with; how many were asked for last
  bool rough_next = false;              ///< the next step is an implicit Euler step
  bool begins_anew = false;             ///< something has happened at the end of the run: what goes on has to begin so
  bool fell = false;                    ///< a quasi-static step has ended where the machine came to rest again
  double grid_from = 0, grid_step = 0;  ///< of the outputs, s
  std::set<std::string> noted{};        ///< slack and lift-off, with their places
  bool cut = false;                     ///< not all events are in the list any more
  bool unstable = false;                ///< an equilibrium that the machine does not stay in has been noted
  bool resumed = false;                 ///< from the memory of an earlier run
  int since_asked = 0;                  ///< tries of a step since `progress` was asked
  // what the control of the error looks back on
  int known = 0;                       ///< steps since the last restart
  Array<double> nu_old{}, rate_old{};  ///< at the start of the last step
  Array<double> T_old{}, T_older{};    ///< by line
  double h_last = 0, h_older = 0;
  int careful = 0;            ///< steps that still grow a little at a time
  Array<double> T_largest{};  ///< by reeving, N
  struct Watched {
    double last = 0, now = 0;  ///< at the start and at the end of the step
    double low = 0, high = 0;  ///< of what was shown since the last output step
    double shown = 0;          ///< what was shown last
    double largest = 0;        ///< of the rope, or of the load, so far
  };
  Array<Watched> watched{};  ///< the largest tension of each reeving, those at the ends of branches, loads over time, N
  double shown = 0;          ///< time of what was shown last, s
  Array<double> L_first{};   ///< by line, m
  Array<double> tight_first{};  ///< by line: strain_of_chord
  double lacks = 0;             ///< largest residual of the ledger at an output step, J
  // of Verlet's steps
  Array<double> T_rate{};      ///< by line: change of its tension in the last step over that step, N/s; NaN: none
  Array<double> T_error{};     ///< by reeving: largest error of its tensions, N
  Array<double> T_expected{};  ///< by reeving: largest tension in an earlier, coarser run, N; empty: there is none
  // of measures
  struct Measured {
    double integral = 0, duration = 0;                    ///< of its mean: of the value over time, s
    double t = std::numeric_limits<double>::quiet_NaN();  ///< of the step before, s; NaN: there is none
    double value = 0;                                     ///< then, not yet relative to its reference
    double window = 0;                                    ///< then: what bounds its mean
    double now = 0;                                       ///< as `value`, at the end of the step
  };
  Array<double> reference{};  ///< by what is observed; NaN: none yet
  Array<Measured> measured{};
};

/// The machine as it moves: with the sides that its sheaves without a given side have where it comes to rest (not where
/// the motion begins as described); one that lies far from the origin counts from its middle in plan (Model::origin).
/// Frames, observed places and the state that is kept count as the deck does.
machine::Model ready_to_move(const machine::Model& described, Start start);

/// Builds the mechanism where the motion begins, settles it where the options say so, finds the damping. False with an
/// outcome in the result.
bool open_run(Run& run);

/// The value of an observable now; of a measure as its deck wants it seen.
double observe(const Run& run, const Values& v, const machine::Observable& what);
double observe_as_it_is(const Run& run, const Values& v, const machine::Observable& what);
/// Adds the step that ends with `v` to the extremes and means of what is observed. Where a window or `since` begins or
/// ends within the step, values run straight from its start to its end.
void measure(Run& run, const Values& v);
void extend(Extreme& e, double value, double t, bool first);

/// Writes down one output step; extremes at every step.
void record_frame(Run& run, const Values& v);
void record_extremes(Run& run, const Values& v);
/// The least tension in a rope at t, and the least mean of a branch's ends.
void keep_least(double least, double loosest, double t, RopeExtreme& of);
/// Whether a part of a rope tears, or is torn: its least tension is that up to then.
bool is_broken(const Mechanism& m, const Values& v, std::size_t reeving);
/// Adds the step to the ways of rope and rims.
void add_ways(Run& run);
/// Shows a moment between output steps: the start of the last step, where a tension or a load turned there, or its end.
void show_moment(Run& run, const Values& before, const Values& now);
TransientFrame frame_of(const Mechanism& m, const Values& v);

/// Notes what has changed in a step: slack and taut, stick and slip, lift-off.
void note_changes(Run& run);
/// A line that became slack or taut in the step of h from t.
void note_slack(Run& run, std::size_t line, double e_before, double e_now, double t, double h);
void note(Run& run, double t, std::string what, std::string where, Array<std::pair<std::string, double>> values = {},
          std::optional<int> reeving = {});

/// What of its rope lies on a drum at `v`, which is the step's start or is tried for its end: what has passed, and what
/// the turning of the free rope about the drum lays on. m, unstretched; from 0 where the description does not say it.
double content_at(const Run& run, const Contact& contact, const Values& v);

/// Events of the model: those due at t happen. Whether any did (a restart is needed); `stop`: the run is over.
bool happen(Run& run, Values& v, bool& stop);
/// Whether a condition of an event not yet happened holds.
bool comes_true(const Run& run, const Values& v);
/// Drums whose rope has come onto another layer take its radius; whether any did.
bool change_layers(Run& run, Values& v);
/// Joints of a chain that run up to one of its ends are laid out anew along it; whether any were. What that takes of
/// the stored energy is booked with the scheme's own.
bool lay_out_joints(Run& run, Values& v);
/// Ends the run where a drum has let out all the rope that the description gives it, or an actuator has gone through
/// itself. Whether one has.
bool run_out(Run& run);
/// Times of events and breakpoints of signals, without those before `from`.
Array<double> stops_of(const Run& run, double from, double to);
/// Where signals may have an extreme, as what peaks within a step leaves no trace at its end; and where `measures`
/// begin or end.
Array<double> extremes_of(const machine::Model& model, double from, double to, bool measures);
/// Whether an event is due at t or a signal jumps there.
bool jumps_at(const Run& run, double t);

/// Sets what is left of breaking lines at t.
void fade(const Run& run, double t, Values& v);
/// The longest step that follows the breaks under way: a rope whose stiffness fades stretches ever faster, s.
double step_of_fading(const Run& run);

/// How many times longer the steps of fast motions may be than their errors say: 1, until a run has taken many.
double impatience(const Run& run);
/// Notes when that begins.
void note_impatience(Run& run);
/// The step's energy; `rough`: by implicit Euler.
void book_step(Run& run, bool rough);
/// Whether a line gets slack or taut in the step and its books do not close, by more than a thousandth of what is
/// turned over; not where a step of half the size would be one of implicit Euler.
bool snatches_too_far(const Run& run);
/// Where a law changes no step need be shorter, s.
double floor_of(const Run& run);
/// A step that resolves the fastest motion, s.
double resolving_step(const Run& run);
/// Of all ropes so far, N.
double largest_tension(const Run& run);
/// The error of the step by what it may be: 1 is as much as is allowed. `kink`: per step, not per time.
double error_of(const Run& run, bool kink);
/// What it may be, as a share of the tolerance.
double allowed_share(const Run& run, bool kink);
/// Whether no rope is left of line `i`.
bool used_up(Run& run, std::size_t i);
/// Of a dead end: then nothing is left of it for good.
void mark_run_off(Run& run, std::size_t i);
/// Why the run can't go on at t.
Outcome failure(Run& run, StepEnd end, double t);

/// Keeps what the next one needs.
void keep_history(Run& run);

/// Steps until the end. Fills the outcome.
void march(Run& run);

}  // namespace taut::solve::dynamics
