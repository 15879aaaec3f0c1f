#include "taut/checks/guy/guy_checks_deck.hpp"

namespace taut::checks {

const Description& GuyCheckRequest::describe() {
  using R = GuyCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::safety_factor, "safety_factor", "", si::one,
                 "breaking force over the largest tension, at least; without it and 'rule' 2 (EN 1993-3-1, recalled)")
          .at_least(1)
          .at_most(20)
          .field(&R::rule, "rule", "the same by a rule: safety.guyline.ch_at (taut list rules --name safety.guyline)")
          .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "of its largest tension")
          .at_least(1)
          .at_most(10)
          .field(&R::breaking_force, "breaking_force", "F_min", si::N, "where neither deck nor catalogue says it")
          .above(0)
          .field(&R::may_go_slack, "may_go_slack", "whether it may lose its tension in some state")
          .field(&R::pretension, "pretension", "", si::one,
                 "least and largest tension as put up over the breaking force; without it 0.08 and 0.15 (recalled)")
          .above(0)
          .at_most(1)
          .field(&R::check_pretension, "check_pretension", "whether the tension as put up is checked");
  return d;
}

const Description& FasteningRequest::describe() {
  using F = FasteningRequest;
  static const Description d =
      Describe<F>()
          .field(&F::wraps, "wraps", "", si::one, "turns of the line round it: 2.5")
          .above(0)
          .at_most(100)
          .field(&F::spikes, "spikes", "", si::one, "railroad spikes on the first and the last wrap together: 8")
          .at_least(0)
          .at_most(1000)
          .field(&F::staples, "staples", "", si::one, "in place of spikes: 6")
          .at_least(0)
          .at_most(1000)
          .field(&F::clips, "clips", "", si::one, "on the line's end: 2 up to 1 in., 3 above")
          .at_least(0)
          .at_most(1000);
  return d;
}

const Description& AnchorCheckRequest::describe() {
  using R = AnchorCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::strength, "strength", "", si::N, "of the anchor along the ropes' pull")
          .above(0)
          .field(&R::safety_factor, "safety_factor", "", si::one, "of its strength over the largest force")
          .at_least(1)
          .at_most(20)
          .field(&R::as_strong_as_rope, "as_strong_as_rope",
                 "also: its strength is not below the breaking force of any rope fixed to it")
          .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "of the largest force")
          .at_least(1)
          .at_most(10)
          .field(&R::uplift, "uplift", "", si::N, "largest force upwards on it")
          .at_least(0)
          .field(&R::angle, "angle", "", si::rad, "largest angle of the pull above the horizontal")
          .above(-1.5708)
          .below(1.5708)
          .field(&R::tree_diameter, "tree_diameter", "", si::m.in("cm"),
                 "of the tree or stump that it is: its pull by a rule of thumb, 80 kN at 50 cm")
          .above(0)
          .at_most(5)
          .record(&R::fastening, "fastening", "how the line is made fast to it, by WAC 296-54-569");
  return d;
}

const Description& LineCheckRequest::describe() {
  using R = LineCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::tail_tree, "tail_tree",
                 "the support behind which the rope goes down to its anchor: at most 50 deg from the horizontal, the "
                 "anchor within 8 deg of the line (WAC 296-54-567)")
          .field(&R::tail_angle, "tail_angle", "", si::rad, "largest angle from the horizontal, in place of 50 deg")
          .above(0)
          .below(1.5708)
          .field(&R::off_line, "off_line", "", si::rad, "largest angle of the anchor off the line, in place of 8 deg")
          .above(0)
          .below(1.5708)
          .field(&R::break_angles, "break_angles",
                 "whether the angle by which it bends over each support lies within the limits of the rules layout.*")
          .field(&R::hold_down, "hold_down", "whether straps hold it down on its saddles: at least 1 deg, else 3 deg")
          .field(&R::end_masts, "end_masts", "supports at the ends of the line: at most 60 deg, the others 30 deg")
          .field(&R::clearance, "clearance",
                 "whether the rope keeps its distance from the terrain: layout.ground_clearance, 7 m")
          .field(&R::least_clearance, "least_clearance", "", si::m, "the same with a distance of the deck's own")
          .above(0)
          .at_most(1000)
          .field(&R::spar_rating, "spar_rating", "", si::N,
                 "breaking strength of this line on the plate of the spar (WAC 296-54-553)")
          .above(0)
          .field(&R::limiter, "limiter", "", si::N,
                 "set force of a tension limiter or line fuse, where the rope is stronger than the spar's rating")
          .above(0)
          .field(&R::breaking_force, "breaking_force", "F_min", si::N, "where neither deck nor catalogue says it")
          .above(0);
  return d;
}

}  // namespace taut::checks
