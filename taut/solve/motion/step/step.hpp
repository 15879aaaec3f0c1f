#pragma once
#include <functional>

#include "taut/solve/motion/parts/values.hpp"

namespace taut::solve::dynamics {

/// What one iteration is trusted to leave before it has been seen; with which factors go on to do.
constexpr double first_contraction = 0.05;

/// How the solution of a step ended.
enum class StepEnd {
  ok,
  no_place,       ///< a line has no place: rounds inside each other, or a branch without rope
  singular,       ///< something is not held by anything
  not_converged,  ///< the laws of contacts found no common answer
  to_and_fro,     ///< laws change and change back without end
  interrupted
};

/// Newton's iteration for the state at t = before.t + s.h, from the guess in `now.rate` and the flows of `before`. All
/// laws of contacts are decided within it. `largest`: of the tensions, N; `tolerance`: relative, of tensions and
/// places.
struct Newton {
  double largest = 0;
  double tolerance = 1e-9;
  int most = 45;
  bool rough = false;  ///< a step of implicit Euler, where laws change
  int used = 0;
  int line = -1;                           ///< that has no place
  double contraction = first_contraction;  ///< what the first iteration of a step leaves, by those before
  int trusted = 0;                         ///< steps since that was seen
  void forget() {                          ///< what was seen: a run that goes on from here knows nothing of it
    contraction = first_contraction;
    trusted = 0;
  }
  std::function<bool(double)> ask = nullptr;  ///< false: interrupts; for what takes many steps at one time
};
StepEnd solve_step(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w, Newton& newton);

/// The same from star values that stand already.
StepEnd iterate(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w, Newton& newton);

/// One step of velocity Verlet of the size s.h (its reach is 0): half a kick, the way, the accelerations there, half a
/// kick. Light contacts find their flows in between.
StepEnd verlet_step(Mechanism& m, const Scheme& s, Values& before, double t, Values& now, Work& w, Newton& newton);

/// Largest step for which it is stable, s: 2/omega (sqrt(1 + zeta^2) - zeta), omega the highest frequency, zeta its
/// damping.
double stability_limit(const Mechanism& m, const Values& v);

/// Accelerations, and what light sheaves pass at once, at an unchanged time: after a start or an event.
StepEnd restart(Mechanism& m, Scheme s, Values& before, Values& now, Work& w, Newton& newton);

/// The machine's equilibrium: implicit steps from rest to rest that grow. Without friction.
StepEnd settle(Mechanism& m, Values& before, Values& now, Work& w, Newton& newton);

Work work_for(const Mechanism& m);

/// An upper bound of the largest natural frequency, 1/s: of the stiffest line with its share of the masses at its ends.
double highest_frequency(const Mechanism& m, const Values& v);

}  // namespace taut::solve::dynamics
