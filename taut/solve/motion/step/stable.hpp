#pragma once
#include <cmath>

#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {

/// Verlet's step where none is given, as a share of the stability limit.
constexpr double verlet_share = 0.8;

/// The step, shortened so that the lines written down are a whole number of steps apart, s: one shorter step at each of
/// them, again and again, would excite the fastest vibrations though every step is below the stability limit.
double equal_step(const TransientOptions& options, double step);

/// Verlet's step now, s: the fixed one of the options (any other method's too), shorter where branches have become so
/// short that it would not be stable any more.
double stable_step(const Run& run);

/// The error of a line's tension in one of equal steps, N: `change` in the step, `change_before` in the one before (of
/// the same size), `damper`: of Verlet, change of the part that its damper holds. A swing of the frequency omega keeps
/// by Verlet the energy of one whose spring is softer by the share (omega h)^2/4: its amplitude is off by half of that,
/// an eighth of the tension's second difference; so far it may pass its top between two steps. The damper goes by the
/// velocity of half a step before, which acts as a mass: the amplitude is off by zeta omega h/2, a quarter of the
/// change of the damper's force. docs/theory/motion-steps.md.
inline double step_error(double change, double change_before, double damper) {
  return std::abs(change - change_before) / 8 + std::abs(damper) / 4;
}

/// Notes the errors of the tensions in the step that is just done, from `before` to `now`.
void note_tension_errors(Run& run);
/// What comes next does not go on as it went.
void forget_tension_rates(Run& run);
/// The largest of them so far, of the largest tension of the rope (in an earlier run of the same motion, too).
double tension_error(const Run& run);

/// The larger one of the errors of a Verlet run, in its tensions and in its energy; infinite where it has run away.
double largest_error(const TransientResult& result);
/// A run by Verlet: its step, s, and how far it was off, in tolerances.
struct VerletRun {
  double step = 0, error = 0;
};
/// Verlet's step after the run `last`, s: its error goes with the square of the step, or (kinks, dampers) with a lower
/// power, down to the first, as from the run `before` (without a step: there was none) to this one.
double shorter_step(const TransientOptions& options, const VerletRun& before, const VerletRun& last);

}  // namespace taut::solve::dynamics
