#pragma once
#include "taut/solve/motion/run/run.hpp"

/// Motion so slow that nothing has inertia: equilibria one after the other, with friction carried on.
namespace taut::solve::dynamics {

/// One step of the time `elapsed` to t: drives and signals go on by it, then everything is in equilibrium there. It is
/// looked for from where the machine was, at once. Not converged where there is none within a twentieth of the
/// machine's size: then `fall_to_rest` finds where the machine goes.
StepEnd quasi_static_step(Mechanism& m, double elapsed, Values& before, double t, Values& now, Work& w, Newton& newton);

/// The same in so many steps from rest to rest as it takes, the first as long as there is an answer near by, and
/// growing: the way that the machine takes when all its motion is damped away at once. `before` is lost. It ends on the
/// way where `until` says so.
StepEnd fall_to_rest(Mechanism& m, double elapsed, Values& before, double t, Values& now, Work& w, Newton& newton,
                     const std::function<bool(const Values&)>& until = {});

/// Mean velocities of an accepted step, for what observes them; nothing else uses them.
void set_mean_velocities(const Mechanism& m, double elapsed, const Values& before, Values& now);

/// Largest way of a body, or of rope over a contact, between two states, m; and of which body (-1: rope).
struct LargestWay {
  double way = 0;
  int body = -1;
};
LargestWay largest_way(const Mechanism& m, const Values& before, const Values& now);

/// Rest at an unchanged time, after a start or an event.
StepEnd rest_again(Run& run);

/// A step of h to the time t. Where the way on is not found, in steps that have become short, the machine falls to
/// where it rests: event "fall" with the body that goes farthest.
StepEnd try_slowly(Run& run, double h, double t);

/// The energy of an accepted step, into the ledger.
void book_slow_step(Run& run);

/// From a settled machine to one that has come into its place slowly: goes back by what the options say and comes
/// again. Infeasible where there is no equilibrium on the way.
Outcome slide_into_place(Run& run);

}  // namespace taut::solve::dynamics
