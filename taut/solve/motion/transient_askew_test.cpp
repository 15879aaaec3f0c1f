#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

namespace taut_test::transient_askew {
namespace {

using taut::solve::EnergyLedger;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double radius = 0.3;

/// A round that turns with its body about its own axis, a rope stuck on it that comes in its plane and leaves out of
/// it to `end`; the body's weight beside the axis turns it. No line moves.
machine::Model winch(const Vector3& end, bool backwards, int side) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("round", {0, 0, 0}, 200, "Y"));
  m.bodies[0].inertia = Vector3(10, 20, 10);
  m.bodies[0].centre = {0.25, 0, 0};
  machine::Node on = sheave("groove", origin, radius, backwards ? -side : side, 0, 0);
  on.law = {20, 0};
  std::vector<machine::Node> path{anchor("start", {-2.0 * side, 0, -1}), on, anchor("end", end)};
  if (backwards) std::reverse(path.begin(), path.end());
  m.reevings.push_back(reeve("rope", path, 0, 0, 2e5));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 4000;
  return m;
}

TransientResult run(const machine::Model& m, taut::solve::Branches branches = taut::solve::Branches::catenary) {
  TransientOptions options = lasting(1, 1e-5, 500);
  options.branches = branches;  // of ropes with weight
  return transient(m, options);
}

/// The work by hand: T R (1 - cos d) d(psi) of the branch that leaves askew, from what the frames tell.
double by_hand(const TransientResult& r, std::size_t branch, double share, int side) {
  double work = 0, angle = 0, T = r.frames.front().branches[branch].T_from;
  for (const auto& frame : r.frames) {
    const Eigen::Matrix3d& R = frame.bodies[0].orientation;
    const double now = std::atan2(R(0, 2), R(0, 0)), T_now = frame.branches[branch].T_from;
    work += (T + T_now) / 2 * radius * share * side * (now - angle);
    angle = now;
    T = T_now;
  }
  return work;
}

/// Largest of its absolute values over the run, of the turnover at the end.
double largest(const TransientResult& r, double EnergyLedger::*part) {
  double most = 0;
  for (const auto& frame : r.frames) most = std::max(most, std::abs(frame.energy.*part));
  return most / r.frames.back().energy.turnover;
}

/// Either way along the path, and either way about the axis.
TEST(TransientAskew, FlangesTakeWhatTheLedgerWouldLack) {
  for (const bool backwards : {false, true}) {
    for (const int side : {1, -1}) {
      SCOPED_TRACE(testing::Message() << backwards << side);
      const Vector3 end{1.5 * side, 1.2, -1};
      const TransientResult r = run(winch(end, backwards, side));
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      const double length = std::sqrt(end.squaredNorm() - radius * radius),
                   share = 1 - std::sqrt(1 - 1.44 / (length * length));
      const double work = by_hand(r, backwards ? 0 : 1, share, side);
      EXPECT_GT(largest(r, &EnergyLedger::flanges), 0.03);
      EXPECT_NEAR(r.frames.back().energy.flanges, work, 1e-3 * std::abs(work));
      EXPECT_LT(largest(r, &EnergyLedger::residual), 1e-4);
    }
  }
}

/// In its plane there is none.
TEST(TransientAskew, NoneInThePlane) {
  const TransientResult r = run(winch({1.5, 0, -1}, false, 1));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_LT(largest(r, &EnergyLedger::flanges), 1e-15);
  EXPECT_LT(largest(r, &EnergyLedger::residual), 1e-4);
}

/// A block on a body that tumbles freely between rounds whose axes are not its own: every line moves, straight or
/// sagging.
TEST(TransientAskew, BlockThatTumbles) {
  for (const auto& [tilt, weight] : {std::pair{0.3, 0.0}, {-0.7, 0.0}, {0.3, 30.0}}) {
    SCOPED_TRACE(testing::Message() << tilt << ' ' << weight);
    machine::Model m;
    m.gravity = 9.81;
    m.bodies.push_back(body("block", {0, 0, 0}, 300, "xyzXYZ"));
    m.bodies[0].inertia = Vector3(20, 30, 25);
    m.bodies[0].centre = {0.1, 0.15, -0.2};
    machine::Node head = sheave("head", {2, 0.4, 5}, 0.2, 1);
    head.axis = Vector3(std::sin(tilt), std::cos(tilt), 0);
    machine::Node low = sheave("low", {0, 0, 0.2}, radius, -1, 1, 0);
    m.reevings.push_back(
        reeve("rope", {anchor("start", {-0.9, -0.2, 5}), low, head, anchor("end", {4, 1, 1})}, 0, weight, 5e5));
    m.reevings[0].given = machine::Given::tension_at_start;
    m.reevings[0].value = 1500;
    const TransientResult r = run(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_GT(largest(r, &EnergyLedger::flanges), 0.001);
    EXPECT_LT(largest(r, &EnergyLedger::residual), 1e-4);
  }
}

/// A block that falls aside into the slack of a heavy rope stuck on it: half of each branch's weight goes with the
/// touching point along the round.
TEST(TransientAskew, SlackRopeOnARound) {
  for (const double aside : {0.0, 0.8}) {
    SCOPED_TRACE(aside);
    machine::Model m;
    m.gravity = 9.81;
    m.bodies.push_back(body("block", {0, 0, 0}, 100, "xz"));
    machine::Node low = sheave("low", origin, radius, -1, 0, 0);
    low.law = {20, 0};
    m.reevings.push_back(reeve("rope", {anchor("start", {-3, 0, 2}), low, anchor("end", {2, aside, 1})}, 60, 40, 5e5));
    const TransientResult r = run(m, taut::solve::Branches::straight);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_GT(largest(r, &EnergyLedger::slack), 0.01);
    EXPECT_LT(largest(r, &EnergyLedger::residual), 1e-4);
  }
}

}  // namespace
}  // namespace taut_test::transient_askew
