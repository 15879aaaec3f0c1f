#pragma once
#include "taut/solve/motion/parts/values.hpp"

/// How far an iteration goes in a machine without losses. Its ropes are springs that may be slack, so the answer of a
/// step is where an energy is least: that of its masses about where they would go by themselves, of its ropes, of its
/// weights. Slack and taut branches have kinks in it, between which Newton's steps may go to and fro; none of them goes
/// to and fro that ends where the energy along it is least.
namespace taut::solve::dynamics {

/// The step from `before` to `now` at the time t.
struct StepAt {
  Mechanism& m;
  const Scheme& s;
  const Values& before;
  double t;
  Values& now;
  Work& w;
};

/// A share of the step of an iteration is taken; of the ropes' flows that share of it.
void apply(const Mechanism& m, const Array<double>& step, double share, double of_flows, Values& now);

/// Takes the step as far as the energy falls along it: to where the forces that are out of balance do no work any more,
/// to a twentieth of what they did at first. That work is the derivative of the energy; unlike the energy it does not
/// drown in rounding. `w.residual` holds these forces at first. Where the energy falls on beyond the step, as rope
/// without tension lets it, the step may be taken up to `most` times, at least once. Returns the share that has been
/// taken.
double go_downhill(const StepAt& at, const Array<double>& step, double most);

}  // namespace taut::solve::dynamics
