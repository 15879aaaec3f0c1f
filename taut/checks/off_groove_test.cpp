#include "taut/checks/off_groove.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace taut::checks {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A rope from a point over a sheave whose groove stands in the x-z plane, to another point.
machine::Model over_a_sheave() {
  machine::Model m;
  machine::Reeving rope;
  rope.name = "line";
  rope.nodes.resize(3);
  rope.nodes[0].name = "tail";
  rope.nodes[1].name = "lead";
  rope.nodes[1].kind = machine::NodeKind::contact;
  rope.nodes[1].radius = 0.2;
  rope.nodes[2].name = "head";
  m.reevings.push_back(rope);
  return m;
}

/// Directions of its two branches, along the path: the first in the groove, the second `degrees` out of it.
std::array<Vector3, 2> directions(double degrees) {
  return {Vector3(1, 0, 0), Vector3(0, std::sin(degrees * degree), -std::cos(degrees * degree))};
}

solve::EquilibriumResult at_rest(double degrees, double T = 1e3) {
  solve::EquilibriumResult e;
  for (int i = 0; i < 2; ++i) {
    const Vector3 t = directions(degrees)[static_cast<std::size_t>(i)];
    solve::BranchResult s;
    s.from = i;
    s.to = i + 1;
    s.T_from = s.T_to = T;
    s.start = Vector3::Zero();
    s.end = t;
    s.H = T * std::hypot(t.x(), t.y());
    s.V_from = s.V_to = T * t.z();
    s.shape.along = s.H > 0 ? Vector3(t.x(), t.y(), 0).normalized() : Vector3(Vector3::UnitX());
    e.branches.push_back(s);
  }
  return e;
}

solve::TransientFrame in_motion(double degrees, double T = 1e3) {
  solve::TransientFrame f;
  for (int i = 0; i < 2; ++i) {
    solve::TransientFrame::Branch s;
    s.from = i;
    s.to = i + 1;
    s.T_from = s.T_to = T;
    s.leaves = s.arrives = directions(degrees)[static_cast<std::size_t>(i)];
    f.branches.push_back(s);
  }
  return f;
}

std::string said(const OffGroove& off) {
  Result r;
  off.add_warnings(r);
  EXPECT_EQ(r.unsafe.size(), r.warnings.size());
  std::string all;
  for (const std::string& one : r.warnings) all += one + "\n";
  return all;
}

template <class State>
std::string said_of(const State& state, const machine::Model& m = over_a_sheave(),
                    const std::set<std::string>& broken = {}) {
  OffGroove off;
  if constexpr (std::is_same_v<State, solve::TransientFrame>) {
    off.take(m, state, broken, "there");
  } else {
    off.take(m, state, "there");
  }
  return said(off);
}

TEST(OffGroove, AnAngleThatAGrooveCanHoldIsNoNews) {
  for (const double angle : {0.0, 5.0, -20.0, 29.9}) {
    EXPECT_EQ(said_of(at_rest(angle)), "") << angle;
    EXPECT_EQ(said_of(in_motion(angle)), "") << angle;
  }
}

TEST(OffGroove, BeyondHalfTheWidestThroatItIsUnsafe) {
  for (const double angle : {30.1, -47.0, 85.0}) {
    const std::string words = fmt::format("there: line runs {:.3g} deg out of the plane of 'lead'", std::abs(angle));
    EXPECT_EQ(said_of(at_rest(angle)).rfind(words, 0), 0U) << said_of(at_rest(angle));
    EXPECT_EQ(said_of(in_motion(angle)).rfind(words, 0), 0U) << said_of(in_motion(angle));
  }
}

TEST(OffGroove, ARopeWithoutTensionOrAPointHasNoGroove) {
  solve::EquilibriumResult slack = at_rest(60);
  slack.branches[1].slack = true;
  EXPECT_EQ(said_of(slack), "");
  EXPECT_EQ(said_of(at_rest(60, 0)), "");
  EXPECT_EQ(said_of(in_motion(60, 0)), "");
  solve::TransientFrame broken = in_motion(60);
  broken.branches[1].whole = false;
  EXPECT_EQ(said_of(broken), "");
  machine::Model point = over_a_sheave();
  point.reevings[0].nodes[1].radius = 0;
  EXPECT_EQ(said_of(at_rest(60), point), "");
}

TEST(OffGroove, TheGrooveTurnsWithItsBody) {
  machine::Model m = over_a_sheave();
  m.bodies.emplace_back();
  m.reevings[0].nodes[1].at.body = 0;
  const Matrix3 turned = Eigen::AngleAxisd(35 * degree, Vector3::UnitX()).toRotationMatrix();
  solve::TransientFrame f = in_motion(40);
  f.bodies.emplace_back();
  f.bodies[0].orientation = turned;  // towards the rope: 5 deg are left
  EXPECT_EQ(said_of(f, m), "");
  f.bodies[0].orientation = turned.transpose();
  EXPECT_NE(said_of(f, m).find("runs 75 deg"), std::string::npos) << said_of(f, m);
  solve::EquilibriumResult e = at_rest(40);
  e.state.bodies.emplace_back();
  e.state.bodies[0].orientation = turned;
  EXPECT_EQ(said_of(e, m), "");
  e.state.bodies[0].orientation = turned.transpose();
  EXPECT_NE(said_of(e, m).find("runs 75 deg"), std::string::npos) << said_of(e, m);
}

TEST(OffGroove, InSegmentsTheFirstAndTheLastTouchTheRound) {
  solve::TransientFrame f = in_motion(0);
  f.branches.push_back(f.branches[1]);
  f.branches.push_back(f.branches[1]);
  f.branches[2].leaves = f.branches[2].arrives = directions(70)[1];  // an inner segment is nobody's
  EXPECT_EQ(said_of(f), "");
  f.branches[1].leaves = directions(70)[1];
  EXPECT_NE(said_of(f).find("runs 70 deg"), std::string::npos);
}

TEST(OffGroove, TheWorstStateIsTold) {
  OffGroove off;
  const machine::Model m = over_a_sheave();
  off.take(m, at_rest(40), "first");
  off.take(m, at_rest(55), "second");
  off.take(m, in_motion(50), {}, "third");
  EXPECT_EQ(said(off).rfind("second: line runs 55 deg", 0), 0U) << said(off);
}

}  // namespace
}  // namespace taut::checks
