// Cold starts that once failed, and what they have to find.
#include <gtest/gtest.h>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace start_test {

using namespace taut_test;
using namespace taut::solve;

/// A ropeway with a counterweight; its tower is a saddle of any size.
machine::Model ropeway(double tower_diameter) {
  machine::Model m;
  m.bodies.push_back(body("counterweight", {-1, 0, -8}, 11e3, "z"));
  m.bodies.push_back(body("cabin", {285, 0, 110}, 1700, "xyz"));
  machine::Node tower = sheave("tower", {150, 0, 69}, tower_diameter / 2, 1, 0);
  tower.law = {.friction = 0.08, .efficiency = 0};
  tower.support = Vector3::UnitZ();
  m.reevings.push_back(reeve("track",
                             {anchor_on("counterweight", 0), sheave("deflection", {0, 0, 6}, 1, 1, 0.98), tower,
                              over("cabin", origin, 1), anchor("upper", {420, 0, 160})},
                             470, 41, 50e6));
  m.reevings.push_back(reeve("haul", {anchor("winch", {420, 0, 158}), anchor_on("cabin", 1)}, 150, 5.3, 7e6));
  m.carriages.push_back({"cabin", 1, 0, 3, 1});
  return m;
}

TEST(Start, ColdBesideASaddleOfAnySize) {
  for (const double diameter : {0.0, 0.6, 2.0, 4.0, 8.0, 12.0}) {
    const machine::Model m = ropeway(diameter);
    double last = 0;
    for (double x = 410; x >= 155 + diameter; x -= 10) {
      EquilibriumOptions options;
      options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
      options.band = false;
      const EquilibriumResult r = equilibrium(m, options);
      ASSERT_TRUE(r.outcome.ok()) << diameter << " m, x " << x << ": " << r.outcome.message;
      // the counterweight keeps the tension wherever the cabin stands
      EXPECT_NEAR(r.branches[0].T_from / (11e3 * m.gravity), 1, 1e-9);
      EXPECT_NEAR(r.ropes[0].T_max / (last > 0 ? last : r.ropes[0].T_max), 1, 2e-3) << diameter << " m, x " << x;
      // the haul rope is no loop that hangs into the valley
      EXPECT_LT(r.branches.back().unstretched, 1.1 * r.branches.back().chord) << diameter << " m, x " << x;
      last = r.ropes[0].T_max;
    }
  }
}

/// A hook on six falls whose rope, where the deck puts the hook, is stretched by far too much.
TEST(Start, ALightHookThatStartsFarTooLow) {
  for (const double mass : {150.0, 720.0, 6000.0}) {
    for (const double stiffness : {11e6, 13e6, 13.39e6, 20e6}) {
      machine::Model m;
      m.bodies.push_back(body("hook", {0, 0, 3}, mass, "xz"));
      std::vector<machine::Node> nodes{anchor("winch", {-6, 0, 1})};
      nodes[0].radius = 0.158;
      for (int i = 0; i < 6; ++i) {
        nodes.push_back(i % 2 == 0 ? sheave("head", {0, 0, 10}, 0.16, 1, 0.97)
                                   : sheave("block", origin, 0.16, 1, 0.97, 0));
      }
      nodes.push_back(anchor("pin", {-0.15, 0, 9.7}));
      m.reevings.push_back(reeve("hoist", nodes, 52, 9.9, stiffness));
      const EquilibriumResult r = equilibrium(m);
      ASSERT_TRUE(r.outcome.ok()) << mass << " kg, " << stiffness << " N: " << r.outcome.message;
      double falls = 0;  // what the rope pulls the hook up with
      for (const ContactResult& c : r.contacts) falls += c.node % 2 == 0 ? c.force.z() : 0;
      EXPECT_NEAR(falls / (mass * m.gravity), 1, 1e-8);
    }
  }
}

}  // namespace start_test
