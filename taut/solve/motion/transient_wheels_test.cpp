#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/solve/drives.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Several ropes, or turns of one, over one wheel; several motors on one rope.
namespace taut_test::wheels_test {
namespace {

using std::numbers::pi;
using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double radius = 0.2, inertia = 8;

/// Two pairs of masses, each on a rope over the same place. `wheel`: over two grooves of one wheel. `turned`: the
/// second rope runs over it the other way along its path.
machine::Model two_ropes(bool wheel, bool turned) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("a", {-radius, 0, -10}, 300, "z"), body("b", {radius, 0, -10}, 420, "z"),
              body("c", {-radius, 1, -10}, 250, "z"), body("d", {radius, 1, -10}, 200, "z")};
  for (const int r : {0, 1}) {
    const bool reversed = r == 1 && turned;
    machine::Node round = sheave("head", {0, 1.0 * r, 0}, radius, reversed ? -1 : 1);
    round.inertia = inertia;
    if (wheel) round.wheel = 7;
    const machine::Node left = anchor_on("left", 2 * r), right = anchor_on("right", 2 * r + 1);
    m.reevings.push_back(reeve(r == 0 ? "first" : "second", {reversed ? right : left, round, reversed ? left : right},
                               20 + radius * pi - 0.02, 0, 1e7));
    m.reevings.back().damping_time = 0.01;
  }
  return m;
}

/// The first pair pulls with 120 g, the second one against it with 50 g. The wheel counts once.
TEST(Wheels, TakeAllRopesOverThemAlong) {
  constexpr double mass = 300 + 420 + 250 + 200, a = (120.0 - 50.0) * 9.81 / (mass + inertia / (radius * radius));
  for (const bool turned : {false, true}) {
    const TransientResult r = run_to_end(two_ropes(true, turned), lasting(1, 1e-5));
    const TransientFrame& last = r.frames.back();
    EXPECT_NEAR(last.bodies[0].acceleration.z(), a, 1e-3 * a) << turned;
    EXPECT_NEAR(last.bodies[2].acceleration.z(), a, 1e-3 * a) << turned;
    EXPECT_LT(std::abs(last.energy.residual), 1e-5 * last.energy.turnover);
  }
}

TEST(Wheels, AreSheavesThatTurnByThemselvesWithoutTheirNumber) {
  constexpr double wheel = inertia / (radius * radius);
  const TransientResult r = run_to_end(two_ropes(false, false), lasting(1, 1e-5));
  const TransientFrame& last = r.frames.back();
  EXPECT_NEAR(last.bodies[0].acceleration.z(), 120 * 9.81 / (720 + wheel), 1e-3);
  EXPECT_NEAR(last.bodies[2].acceleration.z(), -50 * 9.81 / (450 + wheel), 1e-3);
}

/// Copies of a rope run over a wheel each, with its inertia and its drag, unless they share one.
TEST(Wheels, EachCopyOfARopeHasItsOwn) {
  constexpr double wheel = inertia / (radius * radius);
  for (const bool shared : {false, true}) {
    machine::Model m = two_ropes(shared, false);
    m.reevings[0].copies = 3;
    m.reevings.pop_back();
    m.bodies.resize(2);
    const TransientResult r = run_to_end(m, lasting(1, 1e-5));
    EXPECT_NEAR(r.frames.back().bodies[0].acceleration.z(), 120 * 9.81 / (720 + (shared ? 1 : 3) * wheel), 1e-3);
    m.reevings[0].nodes[1].drag = 50;
    const double drag = (shared ? 1 : 3) * 50 / (radius * radius);
    const TransientResult slow = run_to_end(m, lasting(1, 1e-5));
    const double rate = drag / (720 + (shared ? 1 : 3) * wheel);
    EXPECT_NEAR(slow.frames.back().bodies[0].velocity.z(), 120 * 9.81 / drag * (1 - std::exp(-rate)), 2e-3);
  }
}

TEST(Wheels, TurnTheSameInTheReference) {
  TransientOptions options = lasting(0.5, 1e-6);
  const TransientResult a = run_to_end(two_ropes(true, true), options);
  options.method = TimeMethod::reference;
  const TransientResult b = run_to_end(two_ropes(true, true), options);
  for (const int body : {0, 2}) {
    EXPECT_NEAR(a.frames.back().bodies[body].position.z(), b.frames.back().bodies[body].position.z(), 1e-6);
  }
}

/// A loop between two driven sheaves, one on a slide that a weight pulls.
machine::Model loop(std::optional<double> torque, int turns = 1) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("slide", {30, 0, 0}, 200, "x")};
  m.loads.push_back({{.body = 0, .at = origin}, {12e3, 0, 0}});
  const machine::Drive speed{machine::DriveKind::speed, smooth_move(0, 1.5, 0.1, 1)};
  m.motors = {{.name = "first", .drive = speed, .working_arc = {}},
              {.name = "second", .drive = speed, .working_arc = {}}};
  if (torque) m.motors[1].drive = {machine::DriveKind::torque, smooth_move(0, *torque, 0.1, 1)};
  std::vector<machine::Node> nodes;
  for (int k = 0; k < turns; ++k) {
    machine::Node first = sheave("first", origin, 0.5, 1), second = sheave("second", origin, 0.5, 1, 1, 0);
    first.kind = k == 0 ? machine::NodeKind::drive : machine::NodeKind::contact;
    first.motor = 0;
    first.wheel = 0;
    second.wheel = 1;
    second.motor = 1;
    first.inertia = second.inertia = 3;
    first.law.friction = second.law.friction = 0.4;
    if (torque) second.tension_drop = 0;
    nodes.push_back(first), nodes.push_back(second);
  }
  m.reevings.push_back(reeve("loop", nodes, turns * (60 + 2 * 0.5 * pi), 0, 4e6));
  m.reevings[0].closed = true;
  m.reevings[0].damping_time = 2e-3;
  m.reevings[0].mass = 0.3;
  m.reevings[0].speed = 1.5;
  return m;
}

TransientOptions settled(double duration) {
  TransientOptions options = lasting(duration, 1e-6, 10);
  options.start = Start::settled;
  return options;
}

/// 400 N m at the radius of 0.5 m: 800 N between the strands, and the second sheave runs ahead by their creep.
TEST(Wheels, HelpADriveByTheirTorque) {
  machine::Model m = loop(400);
  for (const int node : {1, 0}) {
    for (const auto quantity : {machine::Observed::sheave_torque, machine::Observed::sheave_power}) {
      machine::Observable one;
      one.quantity = quantity;
      one.index = 0;
      one.part = node;
      m.observed.push_back(one);
    }
  }
  const TransientResult r = run_to_end(m, settled(4));
  const TransientFrame& last = r.frames.back();
  EXPECT_NEAR(r.observed[0].back(), 400, 1e-9);
  EXPECT_NEAR(r.observed[1].back(), 400 * 1.5 / 0.5, 1.2);
  EXPECT_NEAR(r.observed[2].back(), -400, 0.3);  // the leading one is driven
  EXPECT_NEAR(r.observed[3].back(), -400 * 1.5 / 0.5, 1.2);
  const double T_1 = last.branches[0].T_from, T_2 = last.branches[1].T_from;
  EXPECT_NEAR(T_1 + T_2, 12e3 + 2 * 0.3 * 1.5 * 1.5, 0.05);  // m v^2 in both strands
  EXPECT_NEAR(std::abs(T_1 - T_2), 800, 0.5);
  EXPECT_NEAR(last.motors[1].torque, 400, 1e-9);
  EXPECT_NEAR(last.motors[0].torque, -400, 0.3);
  EXPECT_NEAR(last.motors[1].speed / last.motors[0].speed - 1, 800 / 4e6, 2e-6);
}

/// Two speeds that differ: the rope carries what creep makes of the difference, until it slips.
TEST(Wheels, ShareAPullByTheCreepOfTheirRope) {
  machine::Model m = loop({});
  m.motors[1].drive.signal = smooth_move(0, 1.5 * (1 + 1e-4), 0.1, 1);
  const TransientResult r = run_to_end(m, settled(60));
  const TransientFrame& last = r.frames.back();
  // the strand that runs to the faster sheave is tighter: v_2/v_1 - 1 = (T_1 - T_2)/EA
  const double T_1 = last.branches[0].T_from, T_2 = last.branches[1].T_from;
  EXPECT_NEAR(T_1 - T_2, 1e-4 * 4e6, 5);
}

/// Two grooves each: the torque is that of all of them.
TEST(Wheels, DriveByAllTheirGrooves) {
  const TransientResult r = run_to_end(loop(400, 2), settled(60));
  const TransientFrame& last = r.frames.back();
  double drop = 0;
  for (const TransientFrame::Contact& c : last.contacts) {
    if (c.node % 2 == 1) drop += c.T_in - c.T_out;
    EXPECT_NEAR(c.spin * 0.5, last.motors[c.node % 2].speed, 1e-12);
  }
  EXPECT_NEAR(0.5 * drop, 400, 0.5);
  EXPECT_NEAR(last.motors[0].torque, -400, 0.5);
}

/// What statics does not know it refuses.
TEST(Wheels, AreRefusedAtRestWhereTheirShareIsOpen) {
  const auto refused = [](const machine::Model& m) { return taut::solve::equilibrium(m, {}).outcome.message; };
  EXPECT_NE(refused(loop({})).find("give all motors but one a 'torque'"), std::string::npos);
  EXPECT_NE(refused(loop(400, 2)).find("one wheel with 2 grooves"), std::string::npos);
  EXPECT_NE(refused(two_ropes(true, false)).find("one wheel with 2 grooves"), std::string::npos);
  EXPECT_EQ(refused(loop(400)), "");
}

/// A given torque is met, and the other motor gives the rest; the rest of a motion is the equilibrium.
TEST(Wheels, HelpADriveAtRestToo) {
  machine::Model m = loop(400);
  m.reevings[0].nodes[1].tension_drop = 400 / 0.5;
  taut::solve::EquilibriumOptions options;
  options.motion = taut::solve::Motion::in;
  const auto found = taut::solve::equilibrium(m, options);
  ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
  const auto drives = taut::solve::drives(m, found);
  ASSERT_EQ(drives.size(), 2U);
  EXPECT_NEAR(drives[1].torque, 400, 1e-6);
  EXPECT_NEAR(drives[0].torque, -400, 1e-6);
  const TransientResult r = run_to_end(loop(400), settled(6));
  EXPECT_NEAR(r.frames.back().branches[0].T_from, found.branches[0].T_from, 0.05);
}

}  // namespace
}  // namespace taut_test::wheels_test
