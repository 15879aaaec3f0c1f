#include "taut/results/described_state.hpp"

#include <gtest/gtest.h>

namespace taut::results {
namespace {

TEST(DescribedState, RopesAreTangentsAndNothingHasAForce) {
  machine::Model m;
  machine::Reeving rope;
  rope.name = "line";
  machine::Node start, sheave, end;
  start.name = "start";
  start.at.at = {-4, 0, 1};
  sheave.name = "sheave";
  sheave.kind = machine::NodeKind::contact;
  sheave.at.at = {0, 0, 0};
  sheave.radius = 1;
  end.name = "end";
  end.at.at = {1, 0, -5};
  rope.nodes = {start, sheave, end};
  rope.value = 10;
  rope.stiffness = 1e6;
  m.reevings.push_back(rope);
  const solve::EquilibriumResult e = described_state(m);
  EXPECT_FALSE(e.outcome.ok());
  ASSERT_EQ(e.branches.size(), 2U);
  EXPECT_NEAR((e.branches[0].end - Vector3(0, 0, 1)).norm(), 0, 1e-12) << "over the top";
  EXPECT_NEAR((e.branches[1].start - Vector3(1, 0, 0)).norm(), 0, 1e-12) << "down at its side";
  EXPECT_NEAR(e.branches[1].chord, 5, 1e-12);
  ASSERT_EQ(e.contacts.size(), 1U);
  EXPECT_EQ(e.contacts[0].force.norm(), 0);
  ASSERT_EQ(e.ropes.size(), 1U);
  EXPECT_EQ(e.ropes[0].branch, 1);
  EXPECT_EQ(e.ropes[0].T_max, 0);
}

TEST(DescribedState, WithoutATangentFromCentreToCentre) {
  machine::Model m;
  machine::Reeving rope;
  machine::Node inside, sheave, end;
  inside.at.at = {0.1, 0, 0};
  sheave.kind = machine::NodeKind::contact;
  sheave.radius = 1;
  end.at.at = {0, 0, -5};
  rope.nodes = {inside, sheave, end};
  rope.value = 10;
  rope.stiffness = 1e6;
  m.reevings.push_back(rope);
  const solve::EquilibriumResult e = described_state(m);
  EXPECT_NEAR((e.branches[0].start - Vector3(0.1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(e.branches[0].end.norm(), 0, 1e-12);
}

}  // namespace
}  // namespace taut::results
