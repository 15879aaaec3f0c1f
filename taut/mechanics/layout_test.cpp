#include "taut/mechanics/layout.hpp"

#include <gtest/gtest.h>

#include <set>

#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

namespace taut::mechanics::layout_test {

using namespace taut_test;

Layout layout_of(const machine::Model& m, const std::optional<machine::Prescribed>& prescribed = std::nullopt) {
  return layout(m, machine::initial_state(m), prescribed, no_flow(m));
}

/// Every unknown and every row is somebody's, and nobody's twice.
void expect_complete(const Layout& l) {
  std::set<int> unknowns, rows;
  const auto take = [&](std::set<int>& all, int i, const char* what) {
    EXPECT_TRUE(all.insert(i).second) << what << " " << i << " twice";
    EXPECT_GE(i, 0);
    EXPECT_LT(i, l.size);
  };
  for (int i = 0; i < static_cast<int>(l.dofs.size()); ++i) {
    take(unknowns, i, "unknown");
    take(rows, i, "row");
  }
  for (const Layout::Branch& k : l.branches) take(unknowns, k.unknown, "unknown");
  for (const Layout::Turn& t : l.turns) {
    if (t.row) take(rows, *t.row, "row");
  }
  for (const Layout::Rope& r : l.ropes) {
    take(rows, r.row, "row");
    if (r.open_load) take(unknowns, *r.open_load, "unknown");
  }
  for (const Layout::Piece& p : l.pieces) {
    for (int i = 0; i < p.count(); ++i) {
      take(unknowns, p.unknown + i, "unknown");
      take(rows, p.unknown + i, "row");
    }
  }
  if (l.hold) {
    take(unknowns, l.hold->unknown, "unknown");
    take(rows, *l.coordinate_row, "row");
  }
  EXPECT_EQ(static_cast<int>(unknowns.size()), l.size);
  EXPECT_EQ(static_cast<int>(rows.size()), l.size);
}

TEST(Layout, EveryUnknownHasItsEquation) {
  expect_complete(layout_of(three_spans(316, 0.1)));
  expect_complete(layout_of(with_carriage(true)));
  expect_complete(layout_of(with_carriage(true), machine::Prescribed{.carriage = 0, .x = 150}));
  expect_complete(layout_of(with_carriage(false), machine::Prescribed{.carriage = 0, .x = 150}));
  expect_complete(layout_of(rollers(2, 0.8, 0.3, 1000)));
  expect_complete(layout_of(tackle(6, 0.97, 3000)));
  expect_complete(layout_of(boom()));
}

TEST(Layout, WhatFollowsFromAPrescribedPlace) {
  const Layout free = layout_of(with_carriage(true));
  EXPECT_FALSE(free.coordinate_row);
  const Layout by_rope = layout_of(with_carriage(true), machine::Prescribed{.carriage = 0, .x = 150});
  EXPECT_EQ(by_rope.size, free.size) << "the mainline's length gives way";
  EXPECT_EQ(by_rope.coordinate_row, by_rope.ropes[1].row);
  EXPECT_FALSE(by_rope.hold);
  const Layout by_force = layout_of(with_carriage(false), machine::Prescribed{.carriage = 0, .x = 150});
  EXPECT_EQ(by_force.size, layout_of(with_carriage(false)).size + 1) << "a force along the track";
  EXPECT_TRUE(by_force.hold);
}

TEST(Layout, ALiftedSupportIsNoTurn) {
  const machine::Model m = three_spans(316, 0.1);
  machine::State state = machine::initial_state(m);
  state.touched[0][1] = false;
  const Layout l = layout(m, state, {}, no_flow(m));
  ASSERT_EQ(l.branches.size(), 2U);
  EXPECT_EQ(l.branches[0].from, 0);
  EXPECT_EQ(l.branches[0].to, 2);
  ASSERT_EQ(l.turns.size(), 1U);
  EXPECT_EQ(l.turns[0].node, 2);
  EXPECT_EQ(layout_of(m).branches.size(), 3U);
}

TEST(Layout, ScalesAreTheLargest) {
  machine::Model m = with_carriage(true, 0.1, 2000);
  m.loads.push_back({{.body = 0, .at = origin}, {0, 0, -50e3}});
  const Layout l = layout_of(m);
  EXPECT_GE(l.heaviest, 50e3);
  EXPECT_NEAR(l.stiffest, 26e6, 1e-6);
  EXPECT_GT(l.length, 100);
}

}  // namespace taut::mechanics::layout_test
