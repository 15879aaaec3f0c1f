#pragma once
#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/values.hpp"

namespace taut::solve::dynamics {

/// What the bearings of spins take and drives of spins and tensioners give at one time, W.
struct Powers {
  double bearings = 0, supplied = 0;
  double running = 0;  ///< given to rope that runs over bends which move: thrust
};
Powers powers(const Mechanism& m, const Values& v);

/// What is stored at one time, J.
struct Stored {
  double kinetic = 0, elastic = 0, potential = 0;
};
Stored stored(const Mechanism& m, const Values& v);
/// The kinetic energy of all bodies and spins, and what their weights and dead loads hold.
Stored stored_in_bodies(const Mechanism& m, const Values& v);

/// What the energy of a contact depends on at one time, J/m.
struct Prices {
  double passed = 0, rolled = 0;     ///< lost, per metre passed and per metre rolled
  double laid_by = 0, supplied = 0;  ///< per metre passed
  double laid_at = 0;                ///< the same: height of the rope that is laid by
  double hung = 0;                   ///< the same: weight of slack rope that no tension carries
};

/// The ledger over a run.
struct Ledger {
  Stored start, now;
  double damped = 0, slipped = 0, bearings = 0, broken = 0, supplied = 0;
  double faces = 0;      ///< dashpots and friction of points on faces
  double laid_by = 0;    ///< of the rope on drums and arcs: its strain
  double laid_at = 0;    ///< and its height
  double running = 0;    ///< kinetic energy of rope that has run over bends which move
  double hung = 0;       ///< taken by the weight of rope that runs into slack branches and out of them
  double askew = 0;      ///< taken by flanges that lead ropes into their grooves at an angle
  double numerical = 0;  ///< by implicit Euler, and by joints laid out anew
  double turnover = 0;
  Powers last;
  Array<Prices> prices;  ///< by contact, at the time reached
};
/// Without what its dampers hold, N.
inline double elastic_tension(const Line& line, const LineValues& v) {
  return line.stiffness * v.gone * std::max(0.0, v.e);
}

/// What the turning of lines lays on rounds in a step, R d(phi): strain energy and height of the rope that is laid by;
/// and, where a line leaves the plane of its round by the angle d, the work of the force T (1 - cos d) along the groove
/// by which the rope on the round has the free rope's tension: that of the laws' own energy which no body is given.
/// `at_end`: by the tensions there.
void add_wound(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger, bool at_end);

Ledger open_ledger(const Mechanism& m, const Values& v);
/// After a step: forces by the mean of its ends. `at_end`: of implicit Euler, whose laws hold at its end.
void add_step(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger, bool at_end = false);
/// After a quasi-static step. Both its ends are in equilibrium, so the means of all forces over the ways of the step do
/// no work together, whatever laws have changed in it: what is left is of the third order of the ways.
void add_slow_step(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger);
/// After one that has fallen to where it rests: what is set free on the way goes to `where`.
void add_fall(const Mechanism& m, const Values& before, const Values& now, double& where, Ledger& ledger);
/// After a restart at one time: what light sheaves have passed at once, or a break has set free, goes to `where`.
void add_jump(const Mechanism& m, const Values& now, double& where, Ledger& ledger);
EnergyLedger told(const Ledger& ledger);
/// What a step of implicit Euler takes by itself, J: of bodies, straight lines and couples; of each one by its own.
double taken_by_euler(const Mechanism& m, const Values& before, const Values& now);

/// Power of a drive into its spin, and its torque.
double drive_moment(const Mechanism& m, int spin, const Values& v);

}  // namespace taut::solve::dynamics
