#pragma once
#include <optional>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// The tree that an anchor needs, by the force and the angle of the pull, over all states that were shown.
struct AnchorTree {
  double diameter = 0;          ///< the largest needed, m; of a state beyond the table at least this
  double force = 0, angle = 0;  ///< there: N, with the dynamic factor; rad above the ground
  std::string where;            ///< that state, with its factor
  bool level = true;            ///< the deck says nothing of the slope of the ground
  std::string beyond;           ///< a pull whose force or angle is beyond the table, in words; empty: none
  Display display = {};         ///< units of the sentences

  /// The diameter where the table has all of it.
  std::optional<double> needed() const;
  void take(double pull, double above_ground, const std::string& words);
};

/// Adds the diameter as a value, and, with the diameter of the tree that is there (m), the check `anchor_tree`. Beyond
/// the table a tree that is too thin for its last row fails; any other is not judged.
void add_anchor_tree(const std::string& anchor, const AnchorTree& tree, std::optional<double> given, Result& r);

}  // namespace taut::checks
