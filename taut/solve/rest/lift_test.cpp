#include "taut/solve/rest/lift.hpp"

#include <gtest/gtest.h>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace lift_test {

using namespace taut_test;
using namespace taut::solve;

/// A taut line whose middle support stands below the others' chord.
machine::Model low_middle(bool may_lift, double length) {
  machine::Model m;
  machine::Node middle = saddle("middle", {100, 0, -6}, 0.1);
  middle.may_lift = may_lift;
  m.reevings.push_back(reeve("skyline", {anchor("a", {0, 0, 0}), middle, anchor("b", {200, 0, 0})}, length, 15, 2e7));
  return m;
}

TEST(Lift, ReportedOrLetGo) {
  const EquilibriumResult kept = equilibrium(low_middle(false, 200.1));
  ASSERT_TRUE(kept.outcome.ok());
  EXPECT_EQ(kept.contacts[0].state, ContactState::pulled);
  EXPECT_GT(kept.contacts[0].force.z(), 0);
  const EquilibriumResult free = equilibrium(low_middle(true, 200.1));
  ASSERT_TRUE(free.outcome.ok());
  EXPECT_EQ(free.contacts[0].state, ContactState::lifted);
  ASSERT_EQ(free.branches.size(), 1U);
  EXPECT_NEAR(free.branches[0].unstretched, 200.1, 1e-9);
  // as if the support were not there
  machine::Model without = low_middle(true, 200.1);
  without.reevings[0].nodes.erase(without.reevings[0].nodes.begin() + 1);
  EXPECT_NEAR(free.branches[0].T_from / equilibrium(without).branches[0].T_from, 1, 1e-9);
  EXPECT_LT(free.branches[0].sag, 6);  // it hangs above the support
}

TEST(Lift, PressesWhereTheRopeIsLongEnough) {
  const EquilibriumResult r = equilibrium(low_middle(true, 201.5));
  ASSERT_TRUE(r.outcome.ok());
  EXPECT_EQ(r.contacts[0].state, ContactState::stuck);
  EXPECT_LT(r.contacts[0].force.z(), 0);
}

TEST(Lift, ComesBackWhenTheRopeIsPaidOut) {
  const EquilibriumResult lifted = equilibrium(low_middle(true, 200.1));
  const EquilibriumResult back = equilibrium(low_middle(true, 201.5), {}, lifted.state);
  const EquilibriumResult fresh = equilibrium(low_middle(true, 201.5));
  ASSERT_TRUE(back.outcome.ok());
  ASSERT_EQ(back.branches.size(), 2U);
  EXPECT_NEAR(back.branches[1].T_to / fresh.branches[1].T_to, 1, 1e-9);
}

TEST(Lift, ARoundLetsGoToo) {
  machine::Model m = low_middle(true, 200.1);
  m.reevings[0].nodes[1].radius = 0.5;
  m.reevings[0].nodes[1].side = 1;  // along +x, over the top: right-handed about y
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_EQ(r.contacts[0].state, ContactState::lifted);
}

}  // namespace lift_test
