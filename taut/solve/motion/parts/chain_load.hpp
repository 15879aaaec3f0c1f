#pragma once
#include "taut/solve/motion/parts/build.hpp"

/// Forces along a rope in segments. Joints are fixed to the rope, the force acts at a place of the free line (it keeps
/// its distance along the chain from the end that stands still, or its share of the chain) while the rope runs through.
/// In the segment that encloses the place, at the share xi of its length, virtual work gives (1 - xi) F and xi F along
/// the segment to its two ends: joints, or the rope at a round, whose tension is then T + (1 - xi) F where the path
/// enters the segment, T - xi F where it leaves it. So the place goes over from one segment to the next without a jump.
///
/// A force against the motion is friction of a given size that also holds: it sticks by a bristle twenty times
/// as stiff as the segment (explicit steps: as stiff; return mapping, as contacts on faces do), |T_out - T_in| <= F.
/// docs/theory/rope-load.md.
namespace taut::solve::dynamics {

/// Chains through loads of the mechanism: their loads, once its lines stand.
void add_chain_loads(Mechanism& m, TimeMethod method);
/// Where they act at the start; `now` has the lines.
void place_chain_loads(const DynamicState& start, Mechanism& m, Values& now);
/// Forces at the end of a step, and what ends on rounds feel of them.
void follow_chain_loads(const Mechanism& m, const Scheme& s, const Values& before, Values& now);
/// Their rows.
void assemble_chain_loads(Mechanism& m, const Scheme& s, const Values& now, Work& w);

/// Works in a step, J: what friction takes, what forces of their own direction, and those that carry places, give.
struct ChainLoadWork {
  double lost = 0, supplied = 0;
};
ChainLoadWork work_of_chain_loads(const Mechanism& m, const Values& before, const Values& now);

/// As a contact of the frame: tensions before and behind the place, the speed of the rope there as its slip.
TransientFrame::Contact chain_load_frame(const Mechanism& m, const Values& v, std::size_t i);

}  // namespace taut::solve::dynamics
