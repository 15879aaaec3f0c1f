#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// What the ledger says of rope's weight that no tension carries, and of rope that turning lays on a round: in closed
/// form. (Ropes that leave a round askew: transient_askew_test.)
namespace taut::solve::dynamics::transient_wound_test {

using namespace taut_test;

/// A slack rope hangs upright from a drum that lets out more of it: each metre falls to its middle, half of its 20 m;
/// drawn in again it is lifted without a force.
TEST(TransientWound, RopeLetIntoSlackFallsToItsMiddle) {
  machine::Model m;
  const machine::Node winch = add_drum(m, "winch", origin, 0.3);
  m.drums[0].drive.kind = machine::DriveKind::speed;
  m.drums[0].drive.signal.law = machine::Moves{0,
                                               {{0.2, -0.5, 0.4, machine::Change::smooth},
                                                {1.2, 0, 0.4, machine::Change::smooth},
                                                {2, 0.5, 0.4, machine::Change::smooth},
                                                {3, 0, 0.4, machine::Change::smooth}}};
  m.reevings.push_back(reeve("rope", {winch, anchor("eye", {0.3, 0, -20})}, 21, 40, 1e7));
  m.observed.push_back({"slack", machine::Observed::dissipated, si::J, machine::ground, {}, Vector3::Zero()});
  const TransientResult r = run_to_end(m, lasting(3.6, 1e-7, 36));
  double most = 0;
  for (const TransientFrame& frame : r.frames) {
    const double let_in = frame.branches[0].unstretched - 21;
    EXPECT_NEAR(frame.energy.slack, 40 * 10 * let_in, 1e-6 * 200) << frame.t;
    EXPECT_LT(std::abs(frame.energy.residual), 1e-9 * 200);
    EXPECT_EQ(frame.branches[0].T_from, 0);
    EXPECT_EQ(frame.branches[0].T_to, 0);
    most = std::max(most, let_in);
  }
  EXPECT_NEAR(most, 0.5, 1e-6);
}

/// Drawn tight by a drum that pulls with 300 N at its top, upright, while its lower end comes up by 4 m: T = 300/1.9,
/// of w L/2 its ends bear 0.9 T; what is left of each metre's weight is lifted by nothing.
TEST(TransientWound, WhatTheTensionDoesNotBearIsLiftedByNothing) {
  machine::Model m;
  const machine::Node winch = add_drum(m, "winch", origin, 0.3);
  m.drums[0].drive.kind = machine::DriveKind::pull;
  m.drums[0].drive.signal.law = 300.0;
  m.bodies.push_back(body("eye", {0.3, 0, -20}, 0, ""));
  m.bodies[0].driven.push_back({Vector3::UnitZ(), Vector3::Zero(), smooth_move(0, 4, 0.1, 2)});
  m.reevings.push_back(reeve("rope", {winch, anchor_on("eye", 0)}, 20, 40, 1e7));
  const TransientResult r = run_to_end(m, in_steps(2.2, 2e-3, 11));
  const double T = 300 / 1.9, stretch = 1 + T / 1e7;
  for (const TransientFrame& frame : r.frames) {
    const double l = -frame.branches[0].end.z(), way = 20 - l;
    EXPECT_NEAR(frame.branches[0].T_to, T - 0.9 * T, 1e-3) << frame.t;
    // w (l_0^2 - l^2)/4 of the unstretched rope less 0.9 T by the way
    const double wanted = -(40 * (400 - l * l) / 4 / stretch - 0.9 * T * way);
    EXPECT_NEAR(frame.energy.slack, wanted, 1e-5 * 300 * 4) << frame.t;
    EXPECT_LT(std::abs(frame.energy.residual), 2e-3);
  }
  EXPECT_NEAR(r.frames.back().branches[0].end.z(), -16, 1e-9);
}

/// A locked drum winds rope by the swing of a load: that rope lies on it with the tension and at the height at which it
/// came there, and comes off again: over whole swings nothing is lost.
TEST(TransientWound, RopeLaidByASwingIsNotLost) {
  for (const double weight : {0.0, 30.0}) {
    machine::Model m;
    m.bodies.push_back(body("load", {4, 0, -6}, 900, "xz"));
    m.reevings.push_back(reeve("rope", {add_drum(m, "winch", origin, 0.5), anchor_on("load", 0)}, 7.15, weight, 2e6));
    const TransientResult r = run_to_end(m, lasting(5, 1e-7, 50));
    double least = HUGE_VAL, most = 0;
    for (const TransientFrame& frame : r.frames) {
      const EnergyLedger& energy = frame.energy;
      EXPECT_LE(std::abs(energy.residual), 2e-5 * energy.turnover) << frame.t;
      EXPECT_NEAR(energy.dissipated() - energy.slack, 0, 1e-9 * energy.turnover);
      least = std::min(least, frame.branches[0].unstretched);
      most = std::max(most, frame.branches[0].unstretched);
    }
    EXPECT_GT(most - least, 0.3);
  }
}

}  // namespace taut::solve::dynamics::transient_wound_test
