#include "taut/solve/rest/sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"

namespace sides_test {

using namespace taut_test;
using namespace taut::solve;

constexpr double g = taut::standard_gravity;

EquilibriumOptions put_at(double x) {
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
  options.band = false;
  return options;
}

TEST(Sides, FollowFromTheAnswerAndNotFromTheFirstGuess) {
  const EquilibriumResult first = equilibrium(downhill(-6, 1), put_at(61.76));
  ASSERT_TRUE(first.outcome.ok()) << first.outcome.message;
  for (const double z : {-60.0, -20.0, -6.0, -4.2, 5.0, 40.0}) {
    for (const int side : {-1, 1}) {
      const EquilibriumResult r = equilibrium(downhill(z, side), put_at(61.76));
      ASSERT_TRUE(r.outcome.ok()) << z << ": " << r.outcome.message;
      EXPECT_EQ(r.state.sides, first.state.sides) << z;
      EXPECT_NEAR(r.ropes[0].T_max / first.ropes[0].T_max, 1, 1e-9) << z;
      for (const ContactResult& c : r.contacts) EXPECT_GE(c.wrap, 0) << z;
    }
  }
}

TEST(Sides, AGivenOneStays) {
  machine::Model m = downhill(-6, -1);
  m.reevings[0].nodes[2].side_open = false;
  const EquilibriumResult r = equilibrium(m, put_at(61.76));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_EQ(r.state.sides[0][2], -1);
  EXPECT_LT(r.contacts[1].wrap, 0);
}

TEST(Sides, MirroredItIsTheOtherOne) {
  for (const double diameter : {0.3, 1.0, 4.0}) {
    const EquilibriumResult r = equilibrium(downhill(-6, 1, diameter), put_at(61.76));
    machine::Model mirrored = downhill(-6, 1, diameter);
    for (machine::Node& node : mirrored.reevings[0].nodes) node.at.at.x() *= -1;
    mirrored.bodies[0].position.x() *= -1;
    const EquilibriumResult other = equilibrium(mirrored, put_at(-61.76));
    ASSERT_TRUE(r.outcome.ok() && other.outcome.ok()) << r.outcome.message << other.outcome.message;
    EXPECT_NEAR(other.ropes[0].T_max / r.ropes[0].T_max, 1, 1e-9) << diameter;
    for (const std::size_t node : {2U, 3U}) EXPECT_EQ(other.state.sides[0][node], -r.state.sides[0][node]) << diameter;
  }
}

// A rope that comes back beside itself, nearer than the sheave is wide, may cross itself or not: both are answers. The
// one that the description has is taken, from wherever the search begins.
TEST(Sides, BesideItselfTheDescriptionDecides) {
  const auto hung = [](int side) {
    machine::Model m;
    m.bodies.push_back(body("block", {0.05, 0, 2}, 300, "xz"));
    std::vector<machine::Node> nodes{anchor("head", {0, 0, 12}), sheave("block", origin, 0.2, side, 1, 0),
                                     anchor("end", {0.1, 0, 12})};
    nodes[1].side_open = true;
    m.reevings.push_back(reeve("hoist", nodes, 20, 0.5 * g, 4e6));
    return m;
  };
  std::vector<EquilibriumResult> all;
  for (const int side : {-1, 1}) {
    all.push_back(equilibrium(hung(side)));
    ASSERT_TRUE(all.back().outcome.ok()) << all.back().outcome.message;
    EXPECT_EQ(all.back().state.sides[0][1], side);
  }
  EXPECT_GT(std::abs(all[0].ropes[0].T_max / all[1].ropes[0].T_max - 1), 1e-5) << "the crossed ropes lean more";
  for (const std::size_t described : {0U, 1U}) {
    const EquilibriumResult r = equilibrium(hung(described == 0 ? -1 : 1), {}, all[1 - described].state);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_EQ(r.state.sides, all[described].state.sides);
    EXPECT_NEAR(r.ropes[0].T_max / all[described].ropes[0].T_max, 1, 1e-9);
  }
}

TEST(Sides, AMotionBeginsOnThem) {
  // the block comes to rest right of the line from head to end, although it is described left of it
  std::vector<double> tension;
  for (const double x : {-3.0, 3.0}) {
    machine::Model m;
    m.bodies.push_back(body("block", {x, 0, 2}, 300, "xz"));
    std::vector<machine::Node> nodes{anchor("head", {0, 0, 12}), sheave("block", origin, 0.2, x < 0 ? -1 : 1, 1, 0),
                                     anchor("end", {8, 0, 12})};
    nodes[1].side_open = true;
    m.reevings.push_back(reeve("hoist", nodes, 24, 0.5 * g, 4e6));
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_GT(r.contacts[0].wrap, 0);
    TransientOptions options;
    options.duration = 0.05;
    const TransientResult moved = transient(m, options);
    ASSERT_TRUE(moved.outcome.ok()) << moved.outcome.message;
    tension.push_back(r.ropes[0].T_max);
    EXPECT_NEAR(moved.frames.back().bodies[0].position.z(), r.state.bodies[0].position.z(), 0.02);
  }
  EXPECT_NEAR(tension[1] / tension[0], 1, 1e-9);
}

}  // namespace sides_test
