#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/trust.hpp"

/// Trees that hold a line: diameters by force, as planners read them from tables. Species, roots, soil and health are
/// not in them.
namespace taut::catalogue {

/// An anchor tree holds this force where the line pulls at it by less than this angle above the ground.
struct AnchorTreeRow {
  double angle_below = 0;  ///< rad
  double force = 0;        ///< N
  double diameter = 0;     ///< at breast height, m
  Trust trust = Trust::unverified;
  std::string trust_text;
};

/// The built-in table (data/trees/anchor_trees.csv): by angle, then by force.
const std::vector<AnchorTreeRow>& anchor_trees();

/// The rows for an angle (rad) of the pull above the ground; downwards counts as level. Empty: steeper than the table.
std::vector<AnchorTreeRow> anchor_trees_at(double angle);

/// Diameter of the tree that holds a force (N) at an angle (rad), m: between two rows the square of the diameter grows
/// evenly with the force, below the first row it is that of the row. Empty: beyond the table.
std::optional<double> anchor_tree_diameter(double force, double angle);

/// A support tree carries this force at its lashing, at this height.
struct SupportTreeRow {
  double force = 0;     ///< along the trunk, N
  double height = 0;    ///< of the lashing over the ground, m
  double diameter = 0;  ///< at the lashing, m
  Trust trust = Trust::unverified;
  std::string trust_text;
};

/// The built-in table (data/trees/support_trees.csv): by force, then by height.
const std::vector<SupportTreeRow>& support_trees();

/// Diameter at the lashing for a force (N) and a height of the lashing (m), m: of the next force and the next height of
/// the table. Empty: beyond the table.
std::optional<double> support_tree_diameter(double force, double height);

/// Diameter at breast height of a tree with this diameter at its lashing, m: it grows by 1 cm for each metre downwards,
/// to 1.5 m over the ground.
double breast_height_diameter(double at_lashing, double height);

}  // namespace taut::catalogue
