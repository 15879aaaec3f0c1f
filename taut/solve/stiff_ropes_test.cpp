#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace stiff_ropes_test {

using namespace taut_test;
using machine::Prescribed;
using taut::Status;
using taut::solve::equilibrium;
using taut::solve::EquilibriumOptions;
using taut::solve::EquilibriumResult;
using taut::solve::Motion;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr double g = 9.80665;

machine::Model hanging_body(double off, double length, double weight, double stiffness) {
  machine::Model m;
  m.bodies.push_back(body("load", {off, 0, -0.8 * length}, 300, "xyz"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("load", 0)}, length, weight, stiffness));
  return m;
}

TEST(StiffRopes, BodyOnOneRopeThatDoesNotStretchHangsByItsWeight) {
  for (const double weight : {0.0, 12.0}) {
    for (const double off : {0.0, 0.7, -4.0}) {
      for (const double length : {0.5, 7.0, 90.0}) {
        const EquilibriumResult r = equilibrium(hanging_body(off, length, weight, rigid));
        ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
        EXPECT_NEAR(r.branches[0].T_to, 300 * g, 1e-9 * 300 * g);
        EXPECT_NEAR(r.branches[0].T_from, 300 * g + weight * length, 1e-9 * 300 * g);
        EXPECT_NEAR(r.state.bodies[0].position.z(), -length, 1e-9 * length);
        EXPECT_NEAR(r.state.bodies[0].position.x(), 0, 1e-6 * length);
      }
    }
  }
}

TEST(StiffRopes, BodyOnTwoRopesByTheTriangleOfForces) {
  // ropes of 5 and 4 m over 3 m beside and above each other: a right angle at the body
  for (const double stiffness : {1e16, rigid}) {
    machine::Model m;
    m.bodies.push_back(body("load", {3, 0, -2}, 100, "xyz"));
    m.reevings.push_back(reeve("long", {anchor("a", {0, 0, 0}), anchor_on("load", 0)}, 4, 0, stiffness));
    m.reevings.push_back(reeve("short", {anchor("b", {5, 0, 0}), anchor_on("load", 0)}, 3, 0, stiffness));
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.branches[0].T_from, 100 * g * 3 / 5, 1e-6);
    EXPECT_NEAR(r.branches[1].T_from, 100 * g * 4 / 5, 1e-6);
    EXPECT_NEAR(r.state.bodies[0].position.x(), 16.0 / 5, 1e-9);
    EXPECT_NEAR(r.state.bodies[0].position.z(), -12.0 / 5, 1e-9);
  }
}

TEST(StiffRopes, CatenaryThatDoesNotStretchByItsClosedForm) {
  // level span: L = 2 a sinh(c/2a), T at the ends w a cosh(c/2a)
  const double c = 120, w = 15;
  for (const double a : {100.0, 1e3, 1e5}) {
    const double length = 2 * a * std::sinh(c / (2 * a)), end = w * a * std::cosh(c / (2 * a));
    machine::Model m;
    m.reevings.push_back(reeve("rope", {anchor("a", {0, 0, 0}), anchor("b", {c, 0, 0})}, length, w, rigid));
    EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    // the length is rounded to its last digit, and the tension follows the difference of length and chord
    const double rounded = 1e-9 + 1e-16 * length / (length - c);
    EXPECT_NEAR(r.branches[0].T_to / end, 1, rounded);
    m.reevings[0].given = machine::Given::tension_at_end;
    m.reevings[0].value = end;
    r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.branches[0].T_to / end, 1, 1e-9);
    EXPECT_NEAR(r.branches[0].unstretched, length, 1e-9 * length);
  }
}

TEST(StiffRopes, GivenTensionIsMetAtAnyStiffness) {
  EquilibriumOptions options;
  options.motion = Motion::in;
  for (const bool mainline : {false, true}) {
    for (const auto given : {machine::Given::tension_at_start, machine::Given::tension_at_end}) {
      double before = 0;
      for (const double stiffness : {1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e16, 1e18, rigid}) {
        machine::Model m = with_carriage(mainline);
        m.reevings[0].given = given;
        m.reevings[0].value = 123456;
        for (machine::Reeving& rope : m.reevings) rope.stiffness = stiffness;
        options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
        const EquilibriumResult r = equilibrium(m, options);
        ASSERT_TRUE(r.outcome.ok()) << stiffness << " " << r.outcome.message;
        const bool start = given == machine::Given::tension_at_start;
        EXPECT_NEAR((start ? r.branches[0].T_from : r.branches[3].T_to) / 123456, 1, 1e-9) << stiffness;
        EXPECT_LT(r.closure.force, 1e-9 * 123456) << stiffness;
        const double other = start ? r.branches[3].T_to : r.branches[0].T_from;
        if (stiffness > 1e10) {
          EXPECT_NEAR(other / before, 1, 1e-6) << stiffness;
        }
        before = other;
      }
    }
  }
}

TEST(StiffRopes, TackleOfRopeThatDoesNotStretchKeepsTheRatioOfItsSheaves) {
  // n falls of efficiency e: the winch pulls W (1 - e)/(1 - e^n)/e^1 on a block of weight W when it hoists
  const double e = 0.95;
  for (const double weight : {0.0, 10.0}) {
    for (const int falls : {2, 4, 6}) {
      EquilibriumOptions options;
      options.motion = Motion::hoist;
      machine::Model m = tackle(falls, e, 3000, weight);
      m.reevings[0].stiffness = rigid;
      const EquilibriumResult r = equilibrium(m, options);
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      EXPECT_LT(r.closure.force, 1e-9 * 3000 * g);
      m.reevings[0].stiffness = 3e9;
      const EquilibriumResult elastic = equilibrium(m, options);
      ASSERT_TRUE(elastic.outcome.ok()) << elastic.outcome.message;
      for (std::size_t k = 0; k < r.branches.size(); ++k) {
        EXPECT_NEAR(r.branches[k].T_from / elastic.branches[k].T_from, 1, 1e-4) << falls << " " << k;
      }
      if (weight > 0) continue;
      for (std::size_t k = 0; k + 1 < r.branches.size(); ++k) {
        const double ratio = r.branches[k + 1].T_from / r.branches[k].T_from;
        EXPECT_NEAR(std::min(ratio, 1 / ratio), e, 1e-9) << falls << " " << k;
      }
    }
  }
}

TEST(StiffRopes, RopeShorterThanItsWayIsRefusedWithBothLengths) {
  for (const double weight : {0.0, 10.0}) {
    for (const double lacks : {1e-8, 1e-3, 1.0}) {
      machine::Model m;
      m.reevings.push_back(
          reeve("rope", {anchor("a", {0, 0, 0}), anchor("b", {80, 0, 60})}, 100 - lacks, weight, rigid));
      const EquilibriumResult r = equilibrium(m);
      EXPECT_EQ(r.outcome.status, Status::infeasible);
      EXPECT_NE(r.outcome.message.find("'rope'"), std::string::npos) << r.outcome.message;
      EXPECT_NE(r.outcome.message.find("does not reach"), std::string::npos) << r.outcome.message;
      EXPECT_NE(r.outcome.message.find("100 m"), std::string::npos) << r.outcome.message;
      EXPECT_NE(r.outcome.message.find("99"), std::string::npos) << r.outcome.message;
    }
  }
}

TEST(StiffRopes, LoadSharedInMoreThanOneWayIsRefused) {
  machine::Model m;
  m.bodies.push_back(body("load", {0, 0, -10}, 100, "z"));
  m.reevings.push_back(reeve("left", {anchor("a", {-1, 0, 0}), anchor_on("load", 0)}, 10, 0, rigid));
  m.reevings.push_back(reeve("right", {anchor("b", {1, 0, 0}), anchor_on("load", 0)}, 10, 0, rigid));
  EquilibriumResult r = equilibrium(m);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("not determined"), std::string::npos) << r.outcome.message;
  // a stiffness, of one of them alone, makes it certain: the other one bears all
  m.reevings[0].stiffness = 1e6;
  r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double slope = std::abs(r.state.bodies[0].position.z()) / 10;
  EXPECT_NEAR(r.branches[1].T_from, 100 * g / slope, 1e-5);
}

TEST(StiffRopes, SlackRopeWithoutWeightCarriesNothing) {
  for (const double stiffness : {1e16, rigid}) {
    machine::Model m = hanging_body(0, 5, 0, rigid);
    m.reevings.push_back(reeve("loose", {anchor("b", {3, 0, 0}), anchor_on("load", 0)}, 8, 0, stiffness));
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_TRUE(r.branches[1].slack);
    EXPECT_EQ(r.branches[1].T_from, 0);
    EXPECT_NEAR(r.branches[0].T_from, 300 * g, 1e-6);
  }
}

TEST(StiffRopes, AnswerIsAStartForTheNextOne) {
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  machine::Model m = with_carriage(true);
  for (machine::Reeving& rope : m.reevings) rope.stiffness = rigid;
  const EquilibriumResult first = equilibrium(m, options);
  ASSERT_TRUE(first.outcome.ok()) << first.outcome.message;
  const EquilibriumResult again = equilibrium(m, options, first.state);
  ASSERT_TRUE(again.outcome.ok()) << again.outcome.message;
  EXPECT_LT(again.closure.iterations, first.closure.iterations);
  for (std::size_t k = 0; k < first.branches.size(); ++k) {
    EXPECT_NEAR(again.branches[k].T_from / first.branches[k].T_from, 1, 1e-9);
  }
}

TEST(StiffRopes, CarriageThatOnlyAForceHoldsHasNoEquilibriumUnlessItIsHeld) {
  machine::Model m;
  m.bodies.push_back(body("car", {30, 0, -1}, 200, "xz"));
  m.reevings.push_back(
      reeve("line", {anchor("a", {0, 0, 0}), over("car", Vector3::Zero(), 0), anchor("b", {100, 0, 0})}, 101, 5, 1e7));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 30};
  const EquilibriumResult held = equilibrium(m, options);
  ASSERT_TRUE(held.outcome.ok()) << held.outcome.message;
  EXPECT_GT(held.hold.norm(), 10);
  options.held = false;
  const EquilibriumResult r = equilibrium(m, options);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("'car'"), std::string::npos) << r.outcome.message;
  EXPECT_NE(r.outcome.message.find("kN"), std::string::npos) << r.outcome.message;
  // at the lowest point nothing is needed
  options.prescribed->x = 50;
  EXPECT_TRUE(equilibrium(m, options).outcome.ok());
}

TEST(StiffRopes, MainlineThatHardlyHasToPushIsSlack) {
  machine::Model m;
  m.bodies.push_back(body("car", {50, 0, -1}, 200, "xz"));
  m.reevings.push_back(
      reeve("line", {anchor("a", {0, 0, 0}), over("car", Vector3::Zero(), 0), anchor("b", {100, 0, 0})}, 101, 5, 1e7));
  m.reevings.push_back(reeve("pull", {anchor("high", {100, 0, 1}), anchor_on("car", 0)}, 60, 0, 2e6));
  m.carriages.push_back({"car", 0, 0, 1, 1});
  EquilibriumOptions options;
  for (const double off : {1e-12, 1e-10, 1e-8}) {
    options.prescribed = machine::Prescribed{.carriage = 0, .x = 50 - off};
    const EquilibriumResult r = equilibrium(m, options);
    ASSERT_TRUE(r.outcome.ok()) << off << " " << r.outcome.message;
    EXPECT_LT(r.branches[2].T_from, 1e-9 * 200 * g);
    EXPECT_NEAR(r.state.bodies[0].position.x(), 50 - off, 1e-13 * 50);
  }
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 49};
  EXPECT_EQ(equilibrium(m, options).outcome.status, Status::infeasible);
}

}  // namespace stiff_ropes_test
