#include "taut/machine/without_rope.hpp"

#include <gtest/gtest.h>

namespace taut::machine::without_rope_test {

Reeving named(const std::string& name) {
  Reeving rope;
  rope.name = name;
  return rope;
}

/// Two carriages: `first` rides on rope 2, is pulled by 0 and 1; `second` rides on 2, too, and is fixed to 3.
Model machine() {
  Model m;
  m.reevings = {named("main"), named("back"), named("track"), named("haul")};
  Carriage first{.name = "first", .body = 0, .reeving = 2, .node = 1, .mainline = 0};
  first.haulback = 1;
  Carriage second{.name = "second", .body = 1, .reeving = 2, .node = 2, .mainline = {}};
  second.grip = Grip{.reeving = 3};
  m.carriages = {first, second};
  m.tensioners = {{.reeving = 0, .at_start = true, .change = {}}};
  return m;
}

TEST(WithoutRope, TheIndicesOfTheOthersFollow) {
  const auto m = without_rope(machine(), 0);
  ASSERT_TRUE(m);
  ASSERT_EQ(m->reevings.size(), 3U);
  const auto name = [&](int rope) { return m->reevings.at(static_cast<std::size_t>(rope)).name; };
  EXPECT_FALSE(m->carriages[0].mainline);
  EXPECT_EQ(name(m->carriages[0].haulback.value()), "back");
  for (const Carriage& car : m->carriages) EXPECT_EQ(name(car.reeving), "track") << car.name;
  EXPECT_EQ(name(m->carriages[1].grip.value().reeving), "haul");
  EXPECT_TRUE(m->tensioners.empty());
}

TEST(WithoutRope, WhatCarriesACarriageStays) {
  EXPECT_FALSE(without_rope(machine(), 2));
  EXPECT_FALSE(without_rope(machine(), 3));
}

TEST(WithRope, ItsBranchesAreStraightAndAsShortAsTheirStretchAsks) {
  Reeving rope = named("main");
  rope.stiffness = 1e6;
  for (const double x : {0.0, 30.0, 100.0}) {
    Node node;
    node.at.at = {x, 0, 0};
    rope.nodes.push_back(node);
  }
  State state;
  state.branches = {Array<BranchState>(1), Array<BranchState>(4)};
  state.touched = {Array<bool>(2, true), Array<bool>(5, true)};
  for (const double tension : {0.0, 1e4}) {
    const State with = with_rope(state, rope, 1, tension);
    ASSERT_EQ(with.branches.size(), 3U);
    ASSERT_EQ(with.branches[1].size(), 2U);
    EXPECT_NEAR(with.branches[1][0].length, 30 / (1 + tension / 1e6), 1e-12);
    EXPECT_NEAR(with.branches[1][1].length, 70 / (1 + tension / 1e6), 1e-12);
    EXPECT_EQ(with.branches[2].size(), 4U);
    EXPECT_EQ(with.touched[1].size(), 3U);
  }
}

}  // namespace taut::machine::without_rope_test
