#include "taut/machine/compile/path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/machine/compile.hpp"
#include "test/support/complaints.hpp"
#include "test/support/described.hpp"

namespace taut::machine::path_test {

using namespace described;
using taut_test::complaints_of;

/// A rope that comes back beside itself: from the mast to a carriage, round the tail block, and back to the carriage.
Machine running(double towards, double axis) {
  Machine m = line();
  m.points[0].at = {0, 0, 10};
  m.supports.clear();
  description::Round tail;
  tail.name = "tail_block";
  tail.at = {100 * towards, 0, 30};
  tail.diameter = 0.4;
  tail.axis = {0, axis, 0};
  m.sheaves = {tail};
  m.reevings[0].path = {anchor("head"), through("car"), over("tail_block"), anchor("car")};
  return m;
}

TEST(Sides, TheBranchWithTheCarriageIsTheUpperOne) {
  for (const double towards : {1.0, -1.0}) {
    for (const double axis : {1.0, -1.0}) {
      Machine m = running(towards, axis);
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      // above the centre on the arriving branch: d x axis side points upwards
      EXPECT_EQ(compile(m)->reevings[0].nodes[2].side, towards * axis > 0 ? 1 : -1);
      std::reverse(m.reevings[0].path.begin(), m.reevings[0].path.end());
      EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, towards * axis > 0 ? -1 : 1);
      m.reevings[0].path = {anchor("head"), over("tail_block"), anchor("head")};
      m.carriages.clear();
      m.reevings[1].path[1] = anchor("tail");
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, towards * axis > 0 ? 1 : -1) << "arrives above";
    }
  }
}

TEST(Sides, ASmallBendTurnsATackleWhereNothingElseDoes) {
  for (const double lead : {0.15, -0.15}) {
    for (const double axis : {1.0, -1.0}) {
      Machine m = tackle(4, {anchor("lead"), falls(4, "head", "block"), anchor("pin")});
      m.points[0].at = {lead, 0, 0};
      m.points[1].at = {0, 0, 9.5};
      for (auto& sheave : m.sheaves) sheave.axis = {0, axis, 0};
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      const bool from_left = lead < 0;
      const bool along_y = axis > 0;
      const bool clockwise = from_left == along_y;
      for (std::size_t i = 1; i <= 4; ++i) {
        // from the left over the top to the right: clockwise, seen with x to the right: positive about +y
        EXPECT_EQ(compile(m)->reevings[0].nodes[i].side, clockwise ? 1 : -1) << lead << " " << axis;
      }
    }
  }
}

/// A tackle under a davit, the lead to its winch above the ground, all of it turned about the vertical.
Machine davit(double angle) {
  Machine m = tackle(4, {on_drum("winch"), falls(4, "head", "block"), anchor("pin")});
  const auto at = [&](double x, double z) { return Triple{x * std::cos(angle), x * std::sin(angle), z}; };
  description::Body body;
  body.name = "davit";
  body.turned.emplace();
  body.turned->rz = angle;
  m.bodies.push_back(body);
  m.bodies[0].at = at(3, 4);
  m.bodies[0].turned = body.turned;
  m.bodies[0].free = {"x", "y", "z"};
  m.points[1].body = {"davit"};
  m.points[1].at = {3, 0, 9.5};
  m.sheaves[0].body = {"davit"};
  m.sheaves[0].at = {3, 0, 10};
  description::Drum winch;
  winch.name = "winch";
  winch.body = {"davit"};
  winch.at = {-6, 0, 10};
  winch.core_diameter = 0.58;
  m.drums = {winch};
  return m;
}

TEST(Sides, TurnWithTheirBody) {
  const auto sides = [](double angle) {
    Array<int> all;
    const Machine m = davit(angle);
    const auto model = compile(m);
    EXPECT_TRUE(model) << complaints_of(m);
    if (!model) return all;
    for (const Node& node : model->reevings[0].nodes) all.push_back(node.side);
    return all;
  };
  const Array<int> is = sides(0);
  for (const double angle : {0.7, 1.55, 1.6, 2.5, std::numbers::pi, -1.7}) EXPECT_EQ(sides(angle), is) << angle;
}

/// A line over a jack, turned about the vertical by an angle; its points and the jack in plan from their x alone.
Machine turned_line(double angle, std::optional<Triple> axis = {}) {
  Machine m = line();
  const auto turn = [&](Triple& at) {
    const double x = at[0];
    at[0] = x * std::cos(angle);
    at[1] = x * std::sin(angle);
  };
  for (auto& point : m.points) turn(point.at);
  turn(m.supports[0].at);
  turn(m.drums[0].at);
  m.supports[0].diameter = 0.4;
  m.supports[0].axis = axis;
  return m;
}

Vector3 jack_axis(const Machine& m) {
  const auto model = compile(m);
  EXPECT_TRUE(model) << complaints_of(m);
  if (!model) return {};
  for (const Node& node : model->reevings[0].nodes) {
    if (node.name == "jack") return node.axis;
  }
  ADD_FAILURE() << "no jack";
  return {};
}

TEST(Axes, LieAcrossThePathInPlan) {
  EXPECT_EQ(jack_axis(turned_line(0)), Vector3::UnitY());
  EXPECT_EQ(jack_axis(turned_line(std::numbers::pi)), Vector3::UnitY()) << "the same sense either way";
  for (const double angle : {0.3, -0.3, 1.2, -1.2, 2.5, -2.9}) {
    const Vector3 across = Vector3(-std::sin(angle), std::cos(angle), 0) * (std::cos(angle) < 0 ? -1 : 1);
    EXPECT_NEAR((jack_axis(turned_line(angle)) - across).norm(), 0, 1e-12) << angle;
    EXPECT_EQ(jack_axis(turned_line(angle, Triple{0, 1, 0})), Vector3::UnitY()) << "as the deck says";
  }
  for (const double angle : {std::numbers::pi / 2, -std::numbers::pi / 2}) {
    EXPECT_NEAR((jack_axis(turned_line(angle)) + Vector3::UnitX()).norm(), 0, 1e-6) << angle;
  }
}

// On a body the axis is the body's; one wheel of several ropes has one axis.
TEST(Axes, ThatPathsDoNotSayAreY) {
  Machine m = turned_line(0.3);
  m.supports[0].one_wheel = true;
  EXPECT_EQ(jack_axis(m), Vector3::UnitY());
  m = turned_line(0.3);
  description::Body mast;
  mast.name = "mast";
  m.bodies = {mast};
  m.supports[0].body = "mast";
  EXPECT_EQ(jack_axis(m), Vector3::UnitY());
}

// A tail block turns the rope back: it lies in the plane of both parts. At a right angle in plan nothing is said.
TEST(Axes, OfABlockThatTurnsTheRope) {
  const auto tail_axis = [](const Triple& first, const Triple& last) {
    Machine m = line();
    m.carriages.clear();
    m.supports.clear();
    m.drums.clear();
    m.ropes.resize(1);
    m.points = {{.name = "first", .body = {}, .at = first}, {.name = "last", .body = {}, .at = last}};
    description::Round tail;
    tail.name = "jack";
    tail.at = {100, 100, 30};
    tail.diameter = 0.4;
    m.sheaves = {tail};
    m.reevings.resize(1);
    m.reevings[0].path = {anchor("first"), over("jack"), anchor("last")};
    m.reevings[0].length = 300;
    return jack_axis(m);
  };
  const Vector3 across = Vector3(-1, 1, 0).normalized();
  EXPECT_NEAR((tail_axis({0, 0, 30}, {1, 1, 20}) - across).norm(), 0, 1e-9);
  EXPECT_NEAR((tail_axis({200, 200, 30}, {199, 199, 20}) - across).norm(), 0, 1e-9);
  EXPECT_EQ(tail_axis({0, 100, 20}, {100, 0, 20}), Vector3::UnitY()) << "a corner";
  // down a mast the leg has no direction in plan
  EXPECT_NEAR((tail_axis({0, 0, 30}, {100.5, 99.5, 0}) - across).norm(), 0, 1e-9);
}

}  // namespace taut::machine::path_test
