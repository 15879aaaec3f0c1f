#pragma once
#include "taut/solve/motion/transient_values.hpp"

namespace taut::solve::dynamics {

/// Where a build begins: poses and velocities of the model's bodies, lengths by reeving and line, places of inner
/// nodes.
struct Built {
  Mechanism mechanism;
  Values values;
  Outcome outcome;  ///< not ok: which part can't move
};
Built build(const machine::Model& model, const DynamicState& start, const TransientOptions& options);

/// Not ok: a part that can't be computed in motion, or that can't move.
Outcome check(const Mechanism& m, const DynamicState& start, const Values& v);
/// Whether the machine is simple, and lossless.
void classify(Mechanism& m);
/// The values at the start, once the mechanism stands.
void fill_values(const DynamicState& start, Built& built);
/// Unstretched length of a line at the start, m.
double start_length(const Mechanism& m, const DynamicState& start, int line);
/// The length whose mass was shared out to its ends, m.
double lumped_length(const Mechanism& m, const DynamicState& start, int line);

/// The state as described, at rest: each rope straight from round to round.
DynamicState assembled(const machine::Model& model);

/// The same from a state of statics.
DynamicState state_from(const machine::Model& model, const machine::State& state);

/// What is to be kept.
DynamicState state_of(const Mechanism& m, const Values& v, const DynamicState& before);

}  // namespace taut::solve::dynamics
