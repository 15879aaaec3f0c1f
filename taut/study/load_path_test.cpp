#include "taut/study/load_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

namespace load_path_test {

namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;
using taut::Status;

TEST(LoadPath, GroundIsLinearBetweenItsPoints) {
  const std::vector<machine::GroundPoint> ground{{.x = 0, .z = 10}, {.x = 50, .z = 20}, {.x = 100, .z = 0}};
  EXPECT_DOUBLE_EQ(ground_height(ground, 0), 10);
  EXPECT_DOUBLE_EQ(ground_height(ground, 25), 15);
  EXPECT_DOUBLE_EQ(ground_height(ground, 50), 20);
  EXPECT_DOUBLE_EQ(ground_height(ground, 75), 10);
  EXPECT_DOUBLE_EQ(ground_height(ground, 100), 0);
  EXPECT_TRUE(std::isnan(ground_height(ground, -1)));
  EXPECT_TRUE(std::isnan(ground_height(ground, 101)));
  EXPECT_TRUE(std::isnan(ground_height({}, 1)));
}

TEST(LoadPath, EveryPositionIsTheEquilibriumThere) {
  for (const bool mainline : {true, false}) {
    machine::Model m = with_carriage(mainline);
    m.terrain = {{.x = 0, .z = 0}, {.x = 300, .z = 60}};
    LoadPathOptions options;
    options.from = mainline ? 135 : 95;
    options.to = 195;
    options.steps = 12;
    const LoadPath path = load_path(m, options);
    ASSERT_TRUE(path.outcome.ok()) << path.outcome.message;
    ASSERT_EQ(path.points.size(), 13U);
    for (const LoadPathPoint& p : path.points) {
      solve::EquilibriumOptions alone;
      alone.prescribed = machine::Prescribed{.carriage = 0, .x = p.x};
      const solve::EquilibriumResult cold = solve::equilibrium(m, alone);
      ASSERT_TRUE(cold.outcome.ok());
      EXPECT_NEAR(p.at.state.bodies[0].position.x(), p.x, 1e-8);
      EXPECT_NEAR(p.z, cold.state.bodies[0].position.z(), 1e-7);
      EXPECT_NEAR(p.clearance, p.z - p.x / 5, 1e-12);
      ASSERT_EQ(p.at.branches.size(), cold.branches.size());
      for (std::size_t k = 0; k < cold.branches.size(); ++k) {
        EXPECT_NEAR(p.at.branches[k].T_from / cold.branches[k].T_from, 1, 1e-8);
        EXPECT_NEAR(p.at.branches[k].T_to_max / cold.branches[k].T_to_max, 1, 1e-8);
      }
    }
    EXPECT_DOUBLE_EQ(path.points.back().x, 195);
  }
}

// Where the place before had no answer, a search begins with the carriage at its own place.
TEST(LoadPath, APlaceWithoutOneBeforeItBeginsWhereItIs) {
  const machine::Model m = with_carriage(false);
  LoadPathOptions options;
  options.from = 95;
  options.to = 195;
  const machine::Model there = standing_at(m, options, 170);
  EXPECT_NEAR(there.bodies[0].position.x(), 170, 1e-9);
  EXPECT_EQ(there.carriages[0].node, m.carriages[0].node);
  const machine::Model outside = standing_at(m, options, 1e4);
  EXPECT_EQ(outside.bodies[0].position, m.bodies[0].position) << "in no span";
}

TEST(LoadPath, SameThereAndBack) {
  LoadPathOptions there;
  there.from = 95;
  there.to = 195;
  there.steps = 10;
  LoadPathOptions back = there;
  std::swap(back.from, back.to);
  const machine::Model m = with_carriage(false);
  const LoadPath a = load_path(m, there), b = load_path(m, back);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_NEAR(a.points[i].at.ropes[0].T_max / b.points[10 - i].at.ropes[0].T_max, 1, 1e-8);
  }
}

TEST(LoadPath, AMainlineThatWouldHaveToPushIsNamed) {
  // the winch stands at the upper end: near the lower support the carriage would have to be pushed down to stay there
  LoadPathOptions options;
  options.from = 95;
  options.to = 195;
  options.steps = 10;
  const LoadPath path = load_path(with_carriage(true), options);
  EXPECT_EQ(path.outcome.status, Status::infeasible);
  EXPECT_NE(path.outcome.message.find("'car' at x = 95 m"), std::string::npos) << path.outcome.message;
  EXPECT_NE(path.outcome.message.find("a mainline can't push"), std::string::npos) << path.outcome.message;
  EXPECT_TRUE(path.points.back().at.outcome.ok());
}

TEST(LoadPath, ClampedCarriageIsMovedByItsClamp) {
  machine::Model m = with_carriage(false);
  m.reevings[0].nodes[2].kind = machine::NodeKind::clamp;
  LoadPathOptions options;
  options.from = 100;
  options.to = 190;
  options.steps = 9;
  const LoadPath path = load_path(m, options);
  ASSERT_TRUE(path.outcome.ok()) << path.outcome.message;
  for (const LoadPathPoint& p : path.points) {
    EXPECT_NEAR(p.at.state.bodies[0].position.x(), p.x, 1e-8);
    EXPECT_NEAR(p.at.branches[1].H / p.at.branches[2].H, 1, 1e-6);  // only weight hangs there
    EXPECT_EQ(p.at.hold, Vector3(0, 0, 0));
  }
}

TEST(LoadPath, SidesFollowPlaceByPlace) {
  LoadPathOptions options;
  options.from = 20;
  options.to = 100;
  options.steps = 8;
  const LoadPath above = load_path(downhill(40, -1), options), below = load_path(downhill(-60, 1), options);
  ASSERT_TRUE(above.outcome.ok()) << above.outcome.message;
  ASSERT_TRUE(below.outcome.ok()) << below.outcome.message;
  for (std::size_t i = 0; i < above.points.size(); ++i) {
    EXPECT_EQ(above.points[i].at.state.sides, below.points[i].at.state.sides);
    EXPECT_NEAR(above.points[i].at.ropes[0].T_max / below.points[i].at.ropes[0].T_max, 1, 1e-8);
    for (const solve::ContactResult& c : above.points[i].at.contacts) EXPECT_GE(c.wrap, 0);
  }
}

TEST(LoadPath, ASkylineOfGivenTensionKeepsItsTautRoot) {
  for (const double efficiency : {1.0, 0.94}) {
    LoadPathOptions options;
    options.from = 10;
    options.to = 135;
    options.steps = 25;
    options.equilibrium.motion = solve::Motion::in;
    std::vector<double> first;
    for (const double z : {-300.0, 0.0, 30.0, 60.0}) {
      const LoadPath path = load_path(fed_skyline(z, efficiency), options);
      ASSERT_TRUE(path.outcome.ok()) << path.outcome.message;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        if (first.size() == i) first.push_back(path.points[i].z);
        EXPECT_NEAR(path.points[i].z, first[i], 1e-6) << z;
        EXPECT_LT(path.points[i].at.ropes[0].unstretched, 1.1 * 450);
        // the same line by its length has the same place
        if (i % 8 == 0) {
          const machine::Model kept = solve::installed(fed_skyline(z, efficiency), path.points[i].at);
          solve::EquilibriumOptions same = options.equilibrium;
          same.prescribed = machine::Prescribed{.carriage = 0, .x = path.points[i].x};
          const solve::EquilibriumResult by_length = solve::equilibrium(kept, same, path.points[i].at.state);
          ASSERT_TRUE(by_length.outcome.ok()) << by_length.outcome.message;
          EXPECT_NEAR(by_length.state.bodies[0].position.z(), path.points[i].z, 1e-6);
        }
      }
    }
  }
}

TEST(LoadPath, AConditionHoldsAlongIt) {
  const machine::Model m = with_carriage(true, 0.1, 1500);
  LoadPathOptions path;
  path.from = 140;
  path.to = 185;
  path.steps = 5;
  path.equilibrium.band = false;
  path.condition =
      solve::Condition{.kind = solve::Condition::Kind::sag_at_carriage, .reeving = 0, .value = 9, .span = 0};
  const LoadPath there = load_path(m, path);
  ASSERT_TRUE(there.outcome.ok()) << there.outcome.message;
  std::swap(path.from, path.to);
  const LoadPath back = load_path(m, path);
  for (std::size_t i = 0; i < there.points.size(); ++i) {
    EXPECT_NEAR(solve::sag_of_carriage(m, there.points[i].at, 0), 9, 1e-7);
    EXPECT_NEAR(back.points[5 - i].at.ropes[0].unstretched, there.points[i].at.ropes[0].unstretched, 1e-6);
  }
}

}  // namespace load_path_test
