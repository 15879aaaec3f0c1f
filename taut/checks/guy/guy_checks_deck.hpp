#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::checks {

/// What is checked of guys: one by its name, or all of a rope.
struct GuyCheckRequest {
  std::string name;
  std::optional<double> safety_factor;
  std::optional<std::string> rule;  ///< below "safety."
  double dynamic_factor = 1;
  std::optional<double> breaking_force;  ///< N, where neither deck nor catalogue says it
  bool may_go_slack = false;
  std::vector<double> pretension;  ///< least and largest share of the breaking force
  bool check_pretension = true;
  static const Description& describe();
};

/// How a line is made fast to a stump or tree.
struct FasteningRequest {
  std::optional<double> wraps;
  std::optional<double> spikes, staples;  ///< on the first and on the last wrap together
  std::optional<double> clips;
  static const Description& describe();
};

/// What is checked of a place to which ropes are anchored, by the point's name.
struct AnchorCheckRequest {
  std::string name;
  std::optional<double> strength;  ///< N, of the anchor
  double safety_factor = 1;        ///< of it over the force
  bool as_strong_as_rope = false;  ///< strength >= breaking force of the ropes
  double dynamic_factor = 1;
  std::optional<double> uplift;         ///< N, largest
  std::optional<double> angle;          ///< rad, largest, of the force above the horizontal
  std::optional<double> tree_diameter;  ///< m, of the tree or stump that it is
  double ground_slope = 0;  ///< of the ground from the anchor in the direction of the pull, rad, up positive
  std::optional<FasteningRequest> fastening;
  static const Description& describe();
};

/// What is checked of a line over its supports, by the reeving's name.
struct LineCheckRequest {
  std::string name;
  std::optional<std::string> tail_tree;  ///< support behind which the rope goes to its anchor
  std::optional<double> tail_angle;      ///< rad, largest
  std::optional<double> off_line;        ///< rad, largest
  bool break_angles = false;
  bool hold_down = false;                 ///< the rope is strapped to its saddles
  std::vector<std::string> end_masts;     ///< supports at the ends of the line
  bool clearance = false;                 ///< over the ground, at least that of the rules
  std::optional<double> least_clearance;  ///< m, in place of it
  std::optional<double> spar_rating;      ///< N, strength of this line on the spar's plate
  std::optional<double> limiter;          ///< N, tension limiter or line fuse
  std::optional<double> breaking_force;   ///< N, where neither deck nor catalogue says it
  static const Description& describe();
};

}  // namespace taut::checks
