#include "taut/checks/anchor/anchor_tree.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/forestry/tree.hpp"

namespace taut::checks::anchor_tree_test {

/// The last row of the table for pulls along the ground.
const catalogue::AnchorTreeRow& thickest() {
  static const std::vector<catalogue::AnchorTreeRow> level = catalogue::anchor_trees_at(0);
  return level.back();
}

TEST(AnchorTree, the_worst_of_all_states_in_any_order) {
  const double force = thickest().force / 2;
  AnchorTree one, other;
  one.take(force, 0, "low");
  one.take(force / 2, 0, "less");
  other.take(force / 2, 0, "less");
  other.take(force, 0, "low");
  ASSERT_TRUE(one.needed() && other.needed());
  EXPECT_EQ(*one.needed(), *catalogue::anchor_tree_diameter(force, 0));
  EXPECT_EQ(*one.needed(), *other.needed());
  EXPECT_EQ(other.where, "low");
  EXPECT_EQ(one.where, "low");
  EXPECT_FALSE(AnchorTree().needed()) << "no state was shown";
}

// A state beyond the table hides the need of none of the others: no tree is enough by it, whatever comes after.
TEST(AnchorTree, beyond_the_table_no_diameter_is_known) {
  AnchorTree tree;
  tree.take(1.01 * thickest().force, 0, "strong");
  tree.take(0.1 * thickest().force, 0, "weak");
  EXPECT_FALSE(tree.needed());
  EXPECT_EQ(tree.diameter, thickest().diameter) << "at least this";
  AnchorTree steep;
  steep.take(0.1 * thickest().force, 1.2, "steep");
  EXPECT_FALSE(steep.needed());
  EXPECT_NE(steep.beyond.find("steep"), std::string::npos);
}

TEST(AnchorTree, the_check) {
  AnchorTree tree;
  tree.take(thickest().force / 2, 0, "at rest");
  const double needed = *tree.needed();
  const auto result = [&](const AnchorTree& of, std::optional<double> given) {
    Result r;
    add_anchor_tree("stump", of, given, r);
    return r;
  };
  EXPECT_TRUE(result(tree, std::nullopt).checks.empty()) << "a value alone";
  EXPECT_EQ(result(tree, std::nullopt).values.at(0).value, needed);
  EXPECT_TRUE(result(tree, needed).checks.at(0).passes);
  EXPECT_FALSE(result(tree, 0.99 * needed).checks.at(0).passes);
  EXPECT_NE(result(tree, needed).checks[0].rule.find("the ground counts as level"), std::string::npos);

  AnchorTree beyond;
  beyond.take(1.01 * thickest().force, 0, "strong");
  const Result thin = result(beyond, 0.9 * thickest().diameter), thick = result(beyond, 2 * thickest().diameter);
  EXPECT_FALSE(thin.checks.at(0).passes);
  EXPECT_TRUE(thick.checks.empty());
  EXPECT_EQ(thick.unmade.size(), 1u) << "not judged, and told";
  EXPECT_TRUE(thick.values.empty());
}

}  // namespace taut::checks::anchor_tree_test
