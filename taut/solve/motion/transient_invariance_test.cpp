#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// What must not change: the order of the method, momentum, the frame, a second run.
namespace taut_test::transient_invariance {
namespace {

using taut::Matrix3;
using taut::solve::DynamicState;
using taut::solve::Start;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// A mass on a spring-like rope that swings and stretches.
machine::Model pendulum() {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {6, 1, -8}, 100, "xyz"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("mass", 0)}, 9.5, 0, 2e4));
  return m;
}

Vector3 place_after(const machine::Model& m, double step) {
  return transient(m, in_steps(0.5, step)).frames.back().bodies[0].position;
}

TEST(TransientInvariance, SecondOrderOnAPendulum) {
  const machine::Model m = pendulum();
  const Vector3 exact = place_after(m, 2e-5);
  const double coarse = (place_after(m, 4e-3) - exact).norm(), fine = (place_after(m, 2e-3) - exact).norm(),
               finer = (place_after(m, 1e-3) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_NEAR(std::log2(fine / finer), 2, 0.1);
}

TEST(TransientInvariance, SecondOrderOverASheaveWithInertia) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("a", {0.2, 0, -5}, 100, "z"), body("b", {-0.2, 0, -5}, 120, "z")};
  machine::Node wheel = sheave("wheel", {0, 0, 0}, 0.2, -1);
  wheel.inertia = 0.8;
  m.reevings.push_back(reeve("rope", {anchor_on("a", 0), wheel, anchor_on("b", 1)}, 9.99 + 0.2 * M_PI, 0, 1e5));
  const Vector3 exact = place_after(m, 2e-5);
  const double coarse = (place_after(m, 4e-3) - exact).norm(), fine = (place_after(m, 2e-3) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

TEST(TransientInvariance, MomentumOfAFreeSystem) {
  machine::Model m;
  m.gravity = 1e-300;
  m.bodies = {body("a", {0, 0, 0}, 100, "xyz"), body("b", {10, 0, 0}, 60, "xyzXYZ")};
  m.bodies[1].inertia = {20, 30, 40};
  m.reevings.push_back(reeve("rope", {anchor_on("a", 0), anchor_on("b", 1, {-1, 0.4, 0.2})}, 8.9, 0, 1e5));
  DynamicState start;
  start.bodies.resize(2);
  start.bodies[0].velocity = {1, 2, -1};
  start.bodies[1].position = {10, 0, 0};
  start.bodies[1].velocity = {2, -1, 0.5};
  start.bodies[1].spin = {0.3, -0.2, 0.7};
  start.ropes.resize(1);
  start.ropes[0].length = {8.9};
  TransientOptions options = in_steps(2, 5e-4);
  options.from = start;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (const auto& frame : r.frames) {
    const auto &a = frame.bodies[0], &b = frame.bodies[1];
    const Vector3 P = 100 * a.velocity + 60 * b.velocity;
    EXPECT_LT((P - Vector3(220, 140, -70)).norm(), 1e-8);
    const Matrix3 I = b.orientation * Vector3(20, 30, 40).asDiagonal() * b.orientation.transpose();
    const Vector3 L = 100 * a.position.cross(a.velocity) + 60 * b.position.cross(b.velocity) + I * b.spin;
    const Vector3 L0 = 60 * Vector3(10, 0, 0).cross(Vector3(2, -1, 0.5)) + Vector3(6, -6, 28);
    EXPECT_LT((L - L0).norm(), 1e-4 * L0.norm());
  }
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-5 * r.frames.back().energy.turnover);
}

/// The machine turned about the vertical.
machine::Model turned(machine::Model m, const Matrix3& by) {
  for (machine::Body& b : m.bodies) {
    b.position = by * b.position;
    b.orientation = by * b.orientation;
    for (machine::Freedom& way : b.free) way = {by * way.along, by * way.about};
  }
  for (machine::Reeving& rope : m.reevings) {
    for (machine::Node& node : rope.nodes) {
      if (node.at.body != machine::ground) continue;
      node.at.at = by * node.at.at;
      node.axis = by * node.axis;
    }
  }
  return m;
}

TEST(TransientInvariance, TheSameInEveryFrameAndInEveryRun) {
  machine::Model m = boom();
  m.bodies[0].inertia = {100, 8000, 8000};
  m.reevings[1].nodes[1].inertia = 0.5;
  for (machine::Reeving& rope : m.reevings) rope.damping_ratio = 0.05;
  const auto run = [](const machine::Model& machine) {
    TransientOptions options = in_steps(0.5, 1e-3);
    options.step = 0;
    options.tolerance = 1e-5;
    options.start = Start::settled;
    return transient(machine, options);
  };
  m.bodies[1].position += Vector3(0.3, 0.2, 0);
  const TransientResult one = run(m), again = run(m);
  ASSERT_TRUE(one.outcome.ok()) << one.outcome.message;
  for (const double angle : {0.7, 2.1, -1.3}) {
    const TransientResult other = run(turned(m, Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix()));
    ASSERT_TRUE(other.outcome.ok()) << other.outcome.message;
    for (std::size_t f = 0; f < one.frames.size(); ++f) {
      for (std::size_t b = 0; b < one.frames[f].branches.size(); ++b) {
        const double T = one.frames[f].branches[b].T_from;
        EXPECT_EQ(T, again.frames[f].branches[b].T_from);
        EXPECT_NEAR(T, other.frames[f].branches[b].T_from, 1e-4 * one.ropes[0].T.max);
      }
      EXPECT_NEAR(one.frames[f].bodies[1].position.z(), other.frames[f].bodies[1].position.z(), 1e-6);
    }
  }
}

TEST(TransientInvariance, GoesOnFromItsState) {
  const machine::Model m = pendulum();
  TransientOptions options = in_steps(1, 1e-4);
  const TransientResult whole = transient(m, options);
  options.duration = 0.5;
  const TransientResult first = transient(m, options);
  options.from = first.state;
  const TransientResult second = transient(m, options);
  EXPECT_NEAR(second.t_end, 1, 1e-12);
  EXPECT_EQ(second.frames.back().bodies[0].position, whole.frames.back().bodies[0].position);
  // without the integrator's memory its accelerations begin anew
  options.from->memory.clear();
  const TransientResult anew = transient(m, options);
  EXPECT_LT((anew.frames.back().bodies[0].position - whole.frames.back().bodies[0].position).norm(), 1e-6);
}

/// Sheaves with inertia and friction, a heavy rope, a body that turns, dampers: to the last bit, by both methods.
TEST(TransientInvariance, GoesOnToTheLastBit) {
  machine::Model m = boom();
  m.bodies[0].inertia = {100, 8000, 8000};
  m.reevings[1].nodes[1].inertia = 0.5;
  m.reevings[1].nodes[1].law = {0.2, 0.95};
  for (machine::Reeving& rope : m.reevings) {
    rope.damping_ratio = 0.05;
    rope.weight = 20;
  }
  for (const auto method : {taut::solve::TimeMethod::implicit, taut::solve::TimeMethod::verlet}) {
    TransientOptions options = in_steps(0.4, 2e-4);
    options.output_step = 0.05;
    options.method = method;
    const TransientResult whole = transient(m, options);
    ASSERT_TRUE(whole.outcome.ok()) << whole.outcome.message;
    options.duration = 0.2;
    options.from = transient(m, options).state;
    const TransientResult second = transient(m, options);
    ASSERT_EQ(second.frames.size(), 5U);
    for (std::size_t f = 0; f < 5; ++f) {
      const auto &a = whole.frames[f + 4], &b = second.frames[f];
      EXPECT_EQ(a.t, b.t);
      EXPECT_EQ(a.bodies[1].position, b.bodies[1].position);
      EXPECT_EQ(a.branches[1].T_from, b.branches[1].T_from);
    }
  }
}

TEST(TransientInvariance, HalfTheToleranceGivesTheSame) {
  const machine::Model m = pendulum();
  TransientOptions options = in_steps(2, 0);
  options.tolerance = 1e-4;
  const TransientResult one = transient(m, options);
  options.tolerance = 0.5e-4;
  const TransientResult other = transient(m, options);
  EXPECT_LT((one.frames.back().bodies[0].position - other.frames.back().bodies[0].position).norm(), 1e-4 * 10);
  EXPECT_LT(other.steps, 3 * one.steps);
}

}  // namespace
}  // namespace taut_test::transient_invariance
