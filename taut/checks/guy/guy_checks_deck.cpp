#include "taut/checks/guy/guy_checks_deck.hpp"

namespace taut::checks {

const Description& GuyCheckRequest::describe() {
  using R = GuyCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::safety_factor, "safety_factor", "", si::one,
                 "least breaking force over largest tension; default without 'rule': 2 (EN 1993-3-1, recalled)")
          .at_least(1)
          .at_most(20)
          .field(&R::rule, "rule", "the same by a rule: safety.guyline.ch_at (taut list rules --name safety.guyline)")
          .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "dynamic factor of its largest tension")
          .at_least(1)
          .at_most(10)
          .field(&R::breaking_force, "breaking_force", "F_min", si::N,
                 "value where neither deck nor catalogue gives it")
          .above(0)
          .field(&R::may_go_slack, "may_go_slack", "true: it may go slack")
          .field(&R::pretension, "pretension", "", si::one,
                 "least and largest installed tension over breaking force; default: 0.08 and 0.15 (recalled)")
          .above(0)
          .at_most(1)
          .field(&R::check_pretension, "check_pretension", "false: the installed tension is not checked");
  return d;
}

const Description& FasteningRequest::describe() {
  using F = FasteningRequest;
  static const Description d =
      Describe<F>()
          .field(&F::wraps, "wraps", "", si::one, "number of wraps, at least 2.5")
          .above(0)
          .at_most(100)
          .field(&F::spikes, "spikes", "", si::one,
                 "railroad spikes on the first and the last wrap together, at least 8")
          .at_least(0)
          .at_most(1000)
          .field(&F::staples, "staples", "", si::one, "staples in place of spikes, at least 6")
          .at_least(0)
          .at_most(1000)
          .field(&F::clips, "clips", "", si::one, "clips on the end of the line, at least 2 up to 1 in., 3 above")
          .at_least(0)
          .at_most(1000);
  return d;
}

const Description& AnchorCheckRequest::describe() {
  using R = AnchorCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::strength, "strength", "", si::N, "strength of the anchor in the direction of the pull")
          .above(0)
          .field(&R::safety_factor, "safety_factor", "", si::one, "least strength over largest force")
          .at_least(1)
          .at_most(20)
          .field(&R::as_strong_as_rope, "as_strong_as_rope",
                 "true: its strength must not be below the breaking forces of the ropes fixed to it, all copies, as "
                 "far as they pull together")
          .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "dynamic factor of the largest force")
          .at_least(1)
          .at_most(10)
          .field(&R::uplift, "uplift", "", si::N, "largest upward force on it")
          .at_least(0)
          .field(&R::angle, "angle", "", si::rad, "largest angle of the pull above the horizontal")
          .above(-1.5708)
          .below(1.5708)
          .field(
              &R::tree_diameter, "tree_diameter", "", si::m.in("cm"),
              "diameter of the tree or stump at breast height; what it needs follows from force and angle of the pull")
          .above(0)
          .at_most(5)
          .field(&R::ground_slope, "ground_slope", "", si::rad,
                 "slope of the ground from the anchor in the direction of the pull, up positive: the angle of the pull "
                 "counts from there")
          .above(-1.5708)
          .below(1.5708)
          .record(&R::fastening, "fastening", "fastening of the line to it, by WAC 296-54-569");
  return d;
}

const Description& LineCheckRequest::describe() {
  using R = LineCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::tail_tree, "tail_tree",
                 "the support after which the rope goes down to its anchor: at most 50 deg from the horizontal, the "
                 "anchor within 8 deg of the line (WAC 296-54-567)")
          .field(&R::tail_angle, "tail_angle", "", si::rad, "largest angle from the horizontal, in place of 50 deg")
          .above(0)
          .below(1.5708)
          .field(&R::off_line, "off_line", "", si::rad, "largest angle of the anchor off the line, in place of 8 deg")
          .above(0)
          .below(1.5708)
          .field(&R::break_angles, "break_angles",
                 "true: the angle by which it bends over each support must be within the limits of the rules layout.*")
          .field(&R::hold_down, "hold_down",
                 "true: straps hold it down on its saddles, and the least angle is 1 deg instead of 3 deg")
          .field(&R::end_masts, "end_masts", "supports at the ends of the line: at most 60 deg, the others 30 deg")
          .field(&R::clearance, "clearance", "true: the rope must keep 7 m from the terrain (layout.ground_clearance)")
          .field(&R::least_clearance, "least_clearance", "", si::m, "the same with another distance")
          .above(0)
          .at_most(1000)
          .field(&R::spar_rating, "spar_rating", "", si::N,
                 "breaking strength of this line on the plate of the spar (WAC 296-54-553)")
          .above(0)
          .field(&R::limiter, "limiter", "", si::N,
                 "set force of a tension limiter or line fuse, where the rope is stronger than the rating of the spar")
          .above(0)
          .field(&R::breaking_force, "breaking_force", "F_min", si::N,
                 "value where neither deck nor catalogue gives it")
          .above(0);
  return d;
}

}  // namespace taut::checks
