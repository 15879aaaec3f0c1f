#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Loads whose size is a signal, against closed forms.
namespace taut_test::transient_push_test {
namespace {

using taut::solve::Start;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

machine::Signal sine(double mean, double amplitude, double omega) {
  machine::Signal s;
  s.unit = taut::si::N;
  s.law = machine::Sine{.mean = mean, .amplitude = amplitude, .omega = omega, .phase = 0};
  return s;
}

machine::Load over_time(int body, const Vector3& at, const Vector3& force, const machine::Signal& signal) {
  machine::Load load{.at = {.body = body, .at = at}, .force = force};
  load.over_time = signal;
  return load;
}

TransientResult run(const machine::Model& m, const TransientOptions& options) {
  TransientResult r = run_to_end(m, options);
  const auto& energy = r.frames.back().energy;
  EXPECT_LT(std::abs(energy.residual), 1e-4 * energy.turnover);
  return r;
}

TEST(TransientPush, AFreeMassTakesTheImpulse) {
  // F = 400 + 900 sin 3t along (3, 0, 4)/5, on 50 kg
  machine::Model m;
  m.gravity = 0;
  m.bodies = {body("mass", {0, 0, 0}, 50, "xyz")};
  m.loads = {over_time(0, origin, {30, 0, 40}, sine(400, 900, 3))};
  const double t = 1.7;
  const TransientResult r = run(m, lasting(t, 1e-8));
  const double v = (400 * t + 300 * (1 - std::cos(3 * t))) / 50;
  const auto& last = r.frames.back();
  EXPECT_LT((last.bodies[0].velocity - v * Vector3(0.6, 0, 0.8)).norm(), 1e-5 * v);
  EXPECT_NEAR(last.energy.supplied, 25 * v * v, 1e-4 * 25 * v * v);
}

TEST(TransientPush, ABarIsTurnedByAForceThatKeepsItsDirection) {
  // J phi'' = -F(t) a cos phi, without gravity; the force is downwards at the end of the arm
  machine::Model m;
  m.gravity = 0;
  m.bodies = {body("bar", {0, 0, 0}, 10, "Y")};
  m.bodies[0].inertia = {1, 20, 20};
  m.loads = {over_time(0, {2, 0, 0}, {0, 0, -5}, sine(30, 20, 2))};
  const TransientResult r = run(m, lasting(1.5, 1e-8));
  const auto [phi, rate] = runge_kutta(
      0, 0, 1.5, [](double t, double angle, double) { return (30 + 20 * std::sin(2 * t)) * 2 * std::cos(angle) / 20; });
  const taut::Matrix3& R = r.frames.back().bodies[0].orientation;
  EXPECT_NEAR(std::atan2(-R(2, 0), R(0, 0)), phi, 1e-5);  // right-handed about y: x turns to -z
  EXPECT_NEAR(r.frames.back().bodies[0].spin.y(), rate, 1e-5);
}

TEST(TransientPush, ItBeginsAtRestUnderWhatItBeginsWith) {
  // a mass on a rope, pushed aside by a tenth of its weight at the start; statics takes the force itself
  machine::Model m;
  m.bodies = {body("mass", {0, 0, -10}, 100, "xz")};
  m.reevings = {reeve("rope", {anchor("top", origin), anchor_on("mass", 0)}, 10, 0, 1e6)};
  const double weight = 100 * m.gravity;
  m.loads = {over_time(0, origin, {0.5 * weight, 0, 0}, sine(0.1 * weight, 0, 0))};
  TransientOptions options = lasting(2, 1e-7, 10);
  options.start = Start::settled;
  const TransientResult r = run_to_end(m, options);
  for (const auto& frame : r.frames) {
    EXPECT_NEAR(frame.bodies[0].position.x() / -frame.bodies[0].position.z(), 0.1, 1e-6);
  }
}

TEST(TransientPush, AJumpEndsAStep) {
  machine::Model m;
  m.gravity = 0;
  m.bodies = {body("mass", {0, 0, 0}, 50, "x")};
  machine::Signal jump;
  jump.law = machine::Moves{.from = 0, .moves = {{.at = 0.3, .to = 100, .over = 0}, {.at = 0.8, .to = 0, .over = 0}}};
  m.loads = {over_time(0, origin, {1, 0, 0}, jump)};
  const TransientResult r = run(m, lasting(1, 1e-6));
  EXPECT_NEAR(r.frames.back().bodies[0].velocity.x(), 1, 1e-9);
}

}  // namespace
}  // namespace taut_test::transient_push_test
