#pragma once
#include "taut/analysis/transient_build.hpp"

/// Forces along a running rope (a node of kind load): a cutting force is friction of a given size. It opposes the rope
/// and holds it where it stands, |T_out - T_in| <= F; one that has a direction of its own is there in any case.
namespace taut::analysis::dynamics {

/// The lengths of the spans in which loads lie.
void measure_loaded_spans(Mechanism& m, const DynamicState& start);

/// What a rope load is in a step.
struct RopeLoadStep {
  double drop = 0;    ///< N: the bound F of |T_out - T_in|, or, with a direction of its own, T_out - T_in
  bool holds = true;  ///< opposes the motion; false: has a direction
};
/// At the time `when`; `flow`: of the rope before, for a load that goes with the motion. Lossless: what opposes is 0.
RopeLoadStep rope_load(const Mechanism& m, const Contact& contact, double when, double flow, bool lossless);

/// How the rope is at the load: `difference` T_out - T_in, `slip` what it has moved on in this step, as a force.
Grip grip_at_load(const RopeLoadStep& load, double difference, double slip);

/// T_out - T_in that the state of the contact asks for, N.
double asked_difference(const ContactValues& is);

/// The load's own force on the point of the rope, and its derivatives, into the residual and the solver.
void assemble_rope_load(Mechanism& m, const Contact& contact, const Values& now, Work& w);

/// Work that the point's own way takes in a step, J.
double rope_load_work(const Contact& contact, const Values& before, const Values& now);

}  // namespace taut::analysis::dynamics
