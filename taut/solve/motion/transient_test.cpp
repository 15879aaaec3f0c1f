#include "taut/solve/motion/transient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/base/array.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

namespace taut_test::transient_rows {
namespace {

using taut::solve::Arcs;
using taut::solve::DynamicState;
using taut::solve::Start;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// Two masses over a sheave with inertia, each leg in equilibrium at the start.
machine::Model atwood() {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("light", {0.2, 0, -5}, 100, "z"), body("heavy", {-0.2, 0, -5}, 120, "z")};
  machine::Node wheel = sheave("wheel", {0, 0, 0}, 0.2, -1);
  wheel.inertia = 0.8;
  m.reevings.push_back(reeve("rope", {anchor_on("light", 0), wheel, anchor_on("heavy", 1)}, 10, 0, 1e6));
  return m;
}

DynamicState atwood_start() {
  DynamicState start;
  start.bodies.resize(2);
  start.bodies[0].position = {0.2, 0, -5};
  start.bodies[1].position = {-0.2, 0, -5};
  start.ropes.resize(1);
  start.ropes[0].length = {5 / (1 + 981 / 1e6), 5 / (1 + 1177.2 / 1e6)};
  return start;
}

/// By the fast scheme and by the reference: the tensions at 0.1, 0.5 and 1 s. Each leg is a spring of its free rope
/// and, where that stretches, half of the rope on the sheave; the numbers by Runge-Kutta of order 4 in 1e5 steps.
TEST(Transient, ElasticAtwoodMachine) {
  using taut::solve::TimeMethod;
  for (const auto& [method, arcs] :
       {std::pair(TimeMethod::implicit, Arcs::rigid), std::pair(TimeMethod::reference, Arcs::rigid),
        std::pair(TimeMethod::implicit, Arcs::stretch), std::pair(TimeMethod::reference, Arcs::stretch)}) {
    TransientOptions options = lasting(1, 1e-7);
    options.arcs = arcs;
    options.output_step = 0.1;
    options.method = method;
    options.from = atwood_start();
    const TransientResult r = transient(atwood(), options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    ASSERT_EQ(r.frames.size(), 11U);
    const bool rigid = arcs == Arcs::rigid;
    // the fast scheme at its tolerance: 1.5e-6 off at the end, 4e-7 at a tolerance of 1e-10
    const double allowed = rigid || method == TimeMethod::reference ? 1e-6 : 2e-6;
    const auto expect = [&](std::size_t frame, double T1, double T2) {
      EXPECT_NEAR(r.frames[frame].branches[0].T_from / T1, 1, allowed) << frame;
      EXPECT_NEAR(r.frames[frame].branches[1].T_to / T2, 1, allowed) << frame;
    };
    rigid ? expect(1, 1113.734318, 1021.676961) : expect(1, 1076.409002, 1056.317451);
    rigid ? expect(5, 1045.907490, 1080.440868) : expect(5, 1138.071755, 1002.164877);
    rigid ? expect(10, 1155.896844, 1008.819138) : expect(10, 1003.238647, 1115.915852);
    const auto& energy = r.frames.back().energy;
    if (method == TimeMethod::implicit) {
      EXPECT_LT(std::abs(energy.residual), 1e-8 * energy.turnover);
    }
  }
}

machine::Signal curve(std::vector<double> t, std::vector<double> value, std::vector<double> slopes) {
  machine::Signal signal;
  signal.law = machine::Curve{std::move(t), std::move(value), std::move(slopes)};
  return signal;
}

/// Six falls between points; its winch takes in unstretched rope: 0.5 t^2 to 0.5 s, then 0.5 m/s.
machine::Model six_falls(double efficiency) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("block", {0, 0, -10}, 3000, "z"));
  std::vector<machine::Node> nodes{anchor("winch", {-10, 0, 0})};
  for (int i = 0; i < 6; ++i) {
    nodes.push_back(i % 2 == 0 ? over("head", {0, 0, 0}) : over("block", {0, 0, 0}, 0));
    nodes.back().law.efficiency = efficiency;
  }
  nodes.push_back(anchor("becket", {0, 0, 0}));
  m.reevings.push_back(reeve("hoist", nodes, 70 / (1 + 4905 / 1e7), 0, 1e7));
  m.tensioners.push_back({0, true, curve({0, 0.5, 4}, {0, -0.125, -1.875}, {0, -0.5, -0.5})});
  return m;
}

TEST(Transient, TackleOfSixFallsWithoutLoss) {
  const TransientResult r = transient(six_falls(1), lasting(3, 2e-7));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.ropes[0].T.max / 5071.814129, 1, 1e-6);
  EXPECT_NEAR(r.ropes[0].T.t_max, 0.37923, 2e-4);
  for (const auto& branch : r.frames.back().branches) EXPECT_NEAR(branch.T_from / 4772.401609, 1, 1e-6);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z() + 10, 0.229430656, 1e-6);
  EXPECT_NEAR(r.ropes[0].T_static, 4905, 1e-6);
  const auto& energy = r.frames.back().energy;
  EXPECT_LT(std::abs(energy.residual), 1e-9 * energy.turnover);
  EXPECT_NEAR(energy.bearings, 0, 1e-6);
}

/// 50 segments with 500 kg in the middle, swinging.
machine::Model swing() {
  machine::Model m;
  m.gravity = 9.81;
  const double EA = 1e7, leg = 50 * (1 + 2250 / EA), R = std::sqrt(leg * leg - 1600);
  m.bodies.push_back(body("load", {40, R * std::sin(M_PI / 3), -R * std::cos(M_PI / 3)}, 500, "xyz"));
  m.reevings = {reeve("left", {anchor("a", {0, 0, 0}), anchor_on("load", 0)}, 50, 9.81, EA),
                reeve("right", {anchor_on("load", 0), anchor("b", {80, 0, 0})}, 50, 9.81, EA)};
  for (auto& rope : m.reevings) rope.segments = 25;
  return m;
}

TEST(Transient, SwingingLoadOnAChain) {
  TransientOptions options = lasting(10, 1e-6);
  options.output_step = 5;
  options.step = 0.5e-3;
  const TransientResult r = transient(swing(), options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const Vector3 at_5(40, -24.3934866968, -17.3419947503), at_10(40, 18.8184917186, -23.4280878018);
  EXPECT_LT((r.frames[1].bodies[0].position - at_5).norm(), 1e-5);
  EXPECT_LT((r.frames[2].bodies[0].position - at_10).norm(), 1e-5);
  EXPECT_LT(std::abs(r.frames[2].energy.residual), 1e-6 * r.frames[2].energy.turnover);
}

/// The shock as the rope tightens again, in the segment at the fixed end: lasting for 10 us, it wants such steps.
TEST(Transient, SwingingLoadTightensItsChain) {
  TransientOptions options = lasting(9, 1e-6);
  options.method = taut::solve::TimeMethod::verlet;
  options.step = 1e-5;
  options.output_step = 8.939;
  const TransientResult r = transient(swing(), options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  // the segment's tension; what holds its end bears half of its weight too
  const auto& top = r.frames[1].branches[0];
  const double hangs = 9.81 * (top.start - top.end).normalized().z();
  EXPECT_GT(hangs, 1);
  EXPECT_NEAR((std::max(r.ropes[0].T.max, r.ropes[1].T.max) - hangs) / 13388.40, 1, 1e-4);
  EXPECT_NEAR(r.ropes[0].T.t_max, 8.939, 5e-4);
  EXPECT_EQ(r.ropes[0].branch, 0);
}

TEST(Transient, ChainComesToRestWhereTheStaticOneHangs) {
  machine::Model m;
  m.gravity = 9.81;
  m.reevings.push_back(reeve("chain", {anchor("a", {0, 0, 0}), anchor("b", {80, 0, 0})}, 100, 9.81, 1e7));
  m.reevings[0].segments = 50;
  TransientOptions options = lasting(0.01, 1e-6);
  options.start = Start::settled;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const auto& first = r.frames[0].branches[0];
  const double T = first.T_to;  // of the segment: its start is held, its end is a joint
  const double H = T * (first.end - first.start).x() / first.stretched;
  EXPECT_NEAR(H / 331.69468956, 1, 1e-8);
  EXPECT_NEAR(T / 584.024180306, 1, 1e-8);
  EXPECT_NEAR(first.T_from - T, 9.81 * (first.start - first.end).normalized().z(), 1e-6);
  EXPECT_NEAR(r.ropes[0].T.max, first.T_from, 1e-6);
}

/// What holds a rope bears all of its weight, in however many segments it hangs, and the load's weight is its pull.
TEST(Transient, AHangingRopeInSegmentsBearsItsWholeWeight) {
  for (const auto method : {taut::solve::TimeMethod::implicit, taut::solve::TimeMethod::verlet}) {
    for (const int segments : {1, 2, 5}) {
      machine::Model m;
      m.gravity = 9.81;
      m.bodies = {body("load", {0, 0, -200}, 100, "xyz")};
      m.reevings = {reeve("rope", {anchor("a", {0, 0, 0}), anchor_on("load", 0)}, 200, 5 * 9.81, 1e9)};
      m.reevings[0].segments = segments;
      TransientOptions options = lasting(0.01, 1e-6);
      options.method = method;
      options.start = Start::settled;
      const TransientResult r = transient(m, options);
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      EXPECT_NEAR(r.frames[0].branches.front().T_from / (1100 * 9.81), 1, 1e-6) << segments;
      EXPECT_NEAR(r.frames[0].branches.back().T_to / (100 * 9.81), 1, 1e-6) << segments;
      EXPECT_NEAR(r.ropes[0].T.max / (1100 * 9.81), 1, 1e-6) << segments;
    }
  }
}

/// A load that is thrown up: its rope bears nothing but its own weight for a while, straight or as a catenary.
TEST(Transient, ACatenaryThatIsThrownGoesSlack) {
  taut::Array<double> slack;
  for (const auto branches : {taut::solve::Branches::straight, taut::solve::Branches::catenary}) {
    machine::Model m;
    m.gravity = 9.81;
    m.bodies = {body("load", {0, 0, -10.01}, 300, "xz")};
    m.reevings = {reeve("rope", {anchor("a", {0, 0, 0}), anchor_on("load", 0)}, 10, 2, 1e7)};
    TransientOptions options = lasting(0.3, 1e-5);
    options.branches = branches;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto found = std::find_if(r.events.begin(), r.events.end(), [](const auto& e) { return e.what == "slack"; });
    ASSERT_NE(found, r.events.end());
    slack.push_back(found->t);
  }
  EXPECT_NEAR(slack[0], slack[1], 1e-3 * slack[0]);
}

}  // namespace
}  // namespace taut_test::transient_rows
