#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Faults met in other programs, one test each: none of them may be here.
namespace taut_test::transient_faults {
namespace {

using std::numbers::pi;
using taut::solve::ContactState;
using taut::solve::Start;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// A mass on a rope from above, and a longer one to the floor that is slack.
machine::Model between_two_ropes() {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, -10}, 100, "z"));
  m.reevings.push_back(reeve("upper", {anchor("top", {0, 0, 0}), anchor_on("mass", 0)}, 10, 0, 1e6));
  m.reevings.push_back(reeve("lower", {anchor("floor", {0, 0, -12}), anchor_on("mass", 0)}, 2.5, 0, 1e6));
  return m;
}

TEST(TransientFaults, RestIsNotFoundWithRopesThatPush) {
  const machine::Model m = between_two_ropes();
  const auto rest = taut::solve::equilibrium(m);
  ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
  TransientOptions options = in_steps(0.5, 0, 50);
  options.start = Start::settled;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.frames.front().branches[0].T_from, 981, 1e-6);
  EXPECT_EQ(r.frames.front().branches[1].T_from, 0);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), -10 * (1 + 981 / 1e6), 1e-8);
  for (const auto& span : rest.branches) EXPECT_GE(std::min(span.T_from, span.T_to), 0);
}

/// A step of 70 periods of the stiffest motion: an iteration to a fixed point would have to contract by 2e5.
TEST(TransientFaults, AStiffRopeIsSolvedByNewtonNotByAFixedPoint) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("light", {0, 0, -5}, 1, "z"), body("heavy", {0, 0, -10}, 1000, "z")};
  m.reevings.push_back(reeve("stiff", {anchor("top", {0, 0, 0}), anchor_on("light", 0)}, 5, 0, 1e9));
  m.reevings.push_back(reeve("soft", {anchor_on("light", 0), anchor_on("heavy", 1)}, 5, 0, 1e6));
  TransientOptions options = in_steps(2, 0.02, 50);
  options.rho = 0;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_LT(r.iterations, 8 * r.steps);
  EXPECT_LT(r.ropes[0].T.max, 2.1 * 1001 * 9.81);
  EXPECT_LT(r.frames.back().energy.kinetic,
            r.frames.front().energy.potential - r.frames.back().energy.potential + 1000);
}

/// The slow motion under the stiff one comes out right: the step knows the stiffness. 1000 kg on 1e6 N / 5 m.
TEST(TransientFaults, TheSlowMotionKeepsItsPeriodBesideAStiffRope) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("light", {0, 0, -5}, 1, "z"), body("heavy", {0, 0, -10}, 1000, "z")};
  m.reevings.push_back(reeve("stiff", {anchor("top", {0, 0, 0}), anchor_on("light", 0)}, 5, 0, 1e9));
  m.reevings.push_back(reeve("soft", {anchor_on("light", 0), anchor_on("heavy", 1)}, 5, 0, 1e6));
  const double stiffness = 1 / (5 / 1e9 + 5 / 1e6), omega = std::sqrt(stiffness / 1000);
  TransientOptions options = in_steps(2 * pi / omega * 4, 2 * pi / omega / 200, 50);
  options.output_step = options.duration;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  // after four periods it is back where it was dropped, without stretch
  EXPECT_NEAR(r.frames.back().bodies[1].position.z(), -10, 0.05 * 2 * 9810 / stiffness);
  EXPECT_NEAR(r.ropes[1].T.max, 2 * 9810, 0.01 * 9810);
}

/// Beta so large that the damper alone would push as soon as the rope gets shorter.
TEST(TransientFaults, ADamperNeverPushesInASlackRope) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, -10}, 100, "z"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("mass", 0)}, 9.9, 0, 1e5));
  m.reevings[0].damping_time = 0.2;
  TransientOptions options = in_steps(2, 0, 50);
  options.output_step = 1e-3;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (const auto& frame : r.frames) {
    const auto& branch = frame.branches[0];
    EXPECT_GE(branch.T_from, 0);
    if (branch.stretched <= branch.unstretched) {
      EXPECT_EQ(branch.T_from, 0);
    }
    // nor does it pull more than the stretch twice over
    const double elastic = 1e5 * std::max(0.0, branch.stretched / branch.unstretched - 1);
    EXPECT_LE(branch.T_from, 2 * elastic + 1e-6);
  }
}

TEST(TransientFaults, EveryPieceOfARopeTellsItsForce) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0.2, 0, -10}, 500, "z"));
  m.reevings.push_back(
      reeve("rope", {anchor("dead end", {-8, 0, 0}), sheave("head", {0, 0, 0}, 0.2, 1, 0.95), anchor_on("load", 0)},
            18.3, 5, 1e7));
  m.reevings[0].segments = 4;
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 4905;
  TransientOptions options = in_steps(0.2, 0, 50);
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (const auto& frame : r.frames) {
    ASSERT_EQ(frame.branches.size(), 8U);
    ASSERT_EQ(frame.inside[0].size(), 6U);
    for (const auto& piece : frame.branches) {
      EXPECT_TRUE(std::isfinite(piece.T_from) && piece.T_from >= 0);
      const double T = 1e7 * std::max(0.0, piece.stretched / piece.unstretched - 1);
      EXPECT_NEAR(piece.T_from, T, 1e-6 * 1e7);
    }
    EXPECT_EQ(frame.contacts[0].T_in, frame.branches[3].T_to);
    EXPECT_EQ(frame.contacts[0].T_out, frame.branches[4].T_from);
  }
}

/// Two turns and a half about a capstan that stands still: exp(mu 5 pi).
TEST(TransientFaults, WrapsGoBeyondOneTurn) {
  machine::Node capstan = sheave("capstan", {0, 0, 0}, 0.2, 1, 0);
  capstan.law.friction = 0.1;
  capstan.turns = 2;
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("left", {-0.2, 0, -20}, 100, "z"), body("right", {0.2, 0, -20}, 700, "z")};
  m.reevings.push_back(
      reeve("rope", {anchor_on("left", 0), capstan, anchor_on("right", 1)}, 40 + 0.2 * 5 * pi - 0.02, 0, 1e7));
  m.reevings[0].damping_time = 0.01;
  TransientOptions options = in_steps(1, 0, 50);
  options.tolerance = 1e-5;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const auto& contact = r.frames.back().contacts[0];
  EXPECT_NEAR(contact.wrap, 5 * pi, 1e-6);
  EXPECT_EQ(contact.state, ContactState::slipping);
  EXPECT_NEAR(contact.T_out / contact.T_in, std::exp(0.1 * 5 * pi), 1e-4);
}

/// Acceleration over a locked round in slip, m2 g - T2 = m2 a, T1 - m1 g = m1 a, T2 = r T1, from steps that are
/// quartered.
TEST(TransientFaults, SlipGetsBetterWithTheStep) {
  machine::Node round = sheave("bollard", {0, 0, 0}, 0.2, 1, 0);
  round.law.friction = 0.2;
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("left", {-0.2, 0, -20}, 100, "z"), body("right", {0.2, 0, -20}, 250, "z")};
  m.reevings.push_back(
      reeve("rope", {anchor_on("left", 0), round, anchor_on("right", 1)}, 40 + 0.2 * pi - 0.02, 0, 1e6));
  m.reevings[0].damping_time = 0.02;
  const auto fallen = [&](double step) {
    const TransientResult r = transient(m, in_steps(0.5, step, 50));
    EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
    return r.frames.back().bodies[1].position.z();
  };
  const double exact = fallen(1e-5);
  const double coarse = std::abs(fallen(2e-3) - exact), fine = std::abs(fallen(5e-4) - exact),
               finer = std::abs(fallen(1.25e-4) - exact);
  EXPECT_LT(fine, 0.36 * coarse);  // a single halving may meet the changes of grip better or worse
  EXPECT_LT(finer, 0.36 * fine);
  EXPECT_LT(finer, 1e-5);
}

/// A winch at one end of a rope over four points without loss: what it takes in stretches all of it alike.
TEST(TransientFaults, AWinchTightensTheWholeRope) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("idler", {3, 0, -3}, 1, "z"));  // something that moves
  m.reevings.push_back(reeve("light", {anchor("pin", {3, 0, 0}), anchor_on("idler", 0)}, 3, 0, 1e4));
  m.reevings.push_back(reeve("rope",
                             {anchor("winch", {0, 0, 0}), over("a", {4, 0, 1}), over("b", {9, 0, 0}),
                              over("c", {11, 2, 3}), anchor("dead end", {15, 2, 0})},
                             0, 0, 1e6));
  m.reevings[1].given = machine::Given::tension_at_start;
  m.reevings[1].value = 100;
  m.tensioners.push_back({1, true, smooth_move(0, -0.1, 0, 0.5)});
  const TransientResult r = transient(m, in_steps(1, 1e-2, 50));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  double l = 0;
  for (int k = 1; k <= 4; ++k) l += r.frames.back().branches[static_cast<std::size_t>(k)].stretched;
  const double L = l / (1 + 100 / 1e6) - 0.1, T = 1e6 * (l / L - 1);
  for (std::size_t k = 1; k <= 4; ++k) {
    EXPECT_NEAR(r.frames.front().branches[k].T_from, 100, 1e-6);
    EXPECT_NEAR(r.frames.back().branches[k].T_from, T, 1e-6 * T);
  }
}

/// The unstretched length follows what a drum takes in, at each time.
TEST(TransientFaults, TheUnstretchedLengthIsKeptUpToDate) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0.25, 0, -12}, 300, "z"));
  const machine::Node winch = add_drum(m, "winch", origin, 0.25);
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, 0.8, 0, 0.5)};
  m.drums[0].length_on_drum = 10;
  m.reevings.push_back(reeve("rope", {winch, anchor_on("load", 0)}, 12, 0, 1e6));
  TransientOptions options = in_steps(3, 0, 50);
  options.tolerance = 1e-6;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double first = r.frames.front().branches[0].unstretched + r.frames.front().on_drums[0].content;
  for (const auto& frame : r.frames) {
    const auto& branch = frame.branches[0];
    EXPECT_NEAR(branch.unstretched + frame.on_drums[0].content, first, 1e-9);
    EXPECT_NEAR(branch.T_from, 1e6 * std::max(0.0, branch.stretched / branch.unstretched - 1), 1);
  }
  // 0.8 m/s from 0.5 s on, half of it before; of stretched rope
  EXPECT_NEAR(r.frames.front().branches[0].unstretched - r.frames.back().branches[0].unstretched, 0.8 * 2.75, 0.02);
}

}  // namespace
}  // namespace taut_test::transient_faults
