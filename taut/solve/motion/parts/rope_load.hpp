#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/build.hpp"

/// Forces along a running rope (a node of kind load). Such a force acts at a place of the free line between two rounds:
/// it keeps its distance from the one that stands still, or its share of the line where both move. The rope runs on
/// through that place, straight, and its tension jumps there. A cutting force is friction of a given size: it opposes
/// the rope and holds it where it stands, |T_out - T_in| <= F; one that has a direction of its own is there in any
/// case. docs/theory/rope-load.md.
///
/// The free line of length l is divided into parts, each a line of the mechanism with both ends of the whole: part i
/// has the length share_i l + more_i, and follows share_i of every virtual displacement. With T_out - T_in = -F at the
/// places, virtual work gives the rounds the tensions of the first and of the last part alone.
namespace taut::solve::dynamics {

/// The node at which the free line really begins (end 0) or ends (end 1), beyond loads.
int line_end(const machine::Reeving& rope, int node, std::size_t end);
/// Which part of the free line a line is; `from` and `to` are its nodes, its bodies those of the free line.
void set_part(const Mechanism& m, const machine::Reeving& rope, Line& line);
/// Where it lies on the free line at the start, as `now` has that.
void set_places(const DynamicState& start, const LineValues& now, const machine::Reeving& rope, Line& line);

/// The lengths of the spans in which loads lie.
void measure_loaded_spans(Mechanism& m, const DynamicState& start);
/// Puts the bodies of loads where they act.
void place_rope_loads(const Mechanism& m, Values& now);

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

/// What the turning of the whole line adds to the strain rate of a part: the part's share of the free length follows
/// both rounds, what is wound comes from the part beside the round. 1/s. Lines of kind skew go without.
double turned_strain_rate(const Line& line, const Array<Motion3>& bodies, const Array<ContactValues>& contacts,
                          const LineValues& now);

/// Force of a part on what carries an end of its free line, N: the tension where the part reaches that end, and what
/// its weight has across the line (along it the tensions bear it).
Vector3 part_force(const Line& line, const LineValues& now, std::size_t end);
/// The same in the residual.
void add_part(const Line& line, const LineValues& now, Work& w);
/// Its derivatives; `L`: of its unstretched length.
void add_part_slopes(Mechanism& m, const Scheme& s, const Line& line, const LineValues& now, const LineTangent& tangent,
                     const std::array<double, 14>& L, Work& w);

/// Work that the place's own way takes in a step, J.
double rope_load_work(const Contact& contact, const Values& before, const Values& now);

}  // namespace taut::solve::dynamics
