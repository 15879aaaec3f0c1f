#pragma once
#include "taut/solve/motion/parts/values.hpp"

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
/// Which of its parts are of simpler kinds, and which have rope on rounds.
void classify(Mechanism& m, Arcs arcs);
/// The mass, its centre and the inertia of every body: its own, that of the loads on it, and half of the mass of each
/// line at its ends, by the lengths that `state` shares out.
void lump_masses(Mechanism& m, const DynamicState& state);
/// The values at the start, once the mechanism stands.
void fill_values(const DynamicState& start, Built& built);
/// Unstretched length of a line at the start, m.
double start_length(const Mechanism& m, const DynamicState& start, int line);
/// The length whose mass was shared out to its ends, m.
double lumped_length(const Mechanism& m, const DynamicState& start, int line);

/// What of the rope on half of a round has the strain of the line at its side at the start: on a rim that turns with
/// the rope all of it. On one that does not, the tension goes from that of one line to that of the other by the capstan
/// law, T = T_1 exp(-mu s), g = mu theta: its mean over the round is f (T_1 + T_2)/2 with f = tanh(g/2)/(g/2).
double share_that_stretches(const machine::Node& node, double wrap);

/// The state as described, at rest: each rope straight from round to round.
DynamicState assembled(const machine::Model& model);

/// The same from a state of statics.
DynamicState state_from(const machine::Model& model, const machine::State& state);

/// What is to be kept.
DynamicState state_of(const Mechanism& m, const Values& v, const DynamicState& before);

}  // namespace taut::solve::dynamics
