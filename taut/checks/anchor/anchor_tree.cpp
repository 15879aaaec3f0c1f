#include "taut/checks/anchor/anchor_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/catalogue/forestry/tree.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/guy/guy_checks.hpp"

namespace taut::checks {
namespace {

constexpr const char* orientation =
    "an orientation for healthy, well rooted trees on firm ground (SEILAPLAN); between its rows by the square of the "
    "diameter";

std::string pull_words(double force, double angle, const std::string& where, const Display& display) {
  return fmt::format("pull {} at {} above the ground ({})", display.brief(force, si::N), display.brief(angle, si::rad),
                     where);
}

}  // namespace

std::optional<double> AnchorTree::needed() const {
  if (!beyond.empty() || diameter == 0) return std::nullopt;
  return diameter;
}

void AnchorTree::take(double pull, double above_ground, const std::string& words) {
  const double steepest = catalogue::anchor_trees().back().angle_below * (1 - 1e-9);
  const double in_table = std::min(above_ground, steepest);
  const auto known = catalogue::anchor_tree_diameter(pull, in_table);
  if ((!known || above_ground > steepest) && beyond.empty()) beyond = pull_words(pull, above_ground, words, display);
  const double least = known.value_or(catalogue::anchor_trees_at(in_table).back().diameter);
  if (least <= diameter) return;
  diameter = least;
  force = pull;
  angle = above_ground;
  where = words;
}

void add_anchor_tree(const std::string& anchor, const AnchorTree& tree, std::optional<double> given, Result& r) {
  const std::string worst = pull_words(tree.force, tree.angle, tree.where, tree.display);
  if (const auto needed = tree.needed()) {
    r.values.push_back(
        make_value(named(value_kinds(), "ANCHOR.tree_diameter"), anchor, "", *needed,
                   fmt::format("diameter of the tree that holds {}, by force and angle: {}", anchor, worst)));
  }
  if (!given) return;
  if (!tree.beyond.empty() && *given >= tree.diameter) {
    r.unmade.push_back(fmt::format("{}: its tree of {} is not judged: beyond the table of anchor trees, {}", anchor,
                                   tree.display.brief(*given, si::m.in("cm")), tree.beyond));
    r.warnings.push_back(r.unmade.back());
    return;
  }
  const char* const slope = tree.level ? "; the ground counts as level: 'ground_slope' states another slope" : "";
  add_part_check(anchor, "anchor_tree", *given, si::m.in("cm"),
                 {.sense = Sense::at_least,
                  .limit = tree.diameter,
                  .rule = fmt::format("diameter of the tree; {}{}{}; {}", worst, slope,
                                      tree.beyond.empty() ? "" : "; beyond the table, at least this", orientation),
                  .trust = "derived"},
                 r);
}

}  // namespace taut::checks
