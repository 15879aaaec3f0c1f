#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Actuators against closed forms, and a mass on a belt against an integration from event to event.
namespace taut_test::transient_actuator_test {
namespace {

using taut::Matrix3;
using taut::machine::ActuatorKind;
using taut::machine::ActuatorMode;
using taut::solve::transient;
using taut::solve::TransientResult;

machine::Signal constant(double value, const taut::Unit& unit) {
  machine::Signal s;
  s.unit = unit;
  s.law = value;
  return s;
}

/// A mass that slides along x without gravity, 2 m from a wall, with a cylinder between them.
machine::Model pushed_mass(const machine::Actuator& ram) {
  machine::Model m;
  m.gravity = 0;
  m.bodies = {body("mass", {2, 0, 0}, 500, "x")};
  m.actuators = {ram};
  m.actuators[0].name = "ram";
  m.actuators[0].to_body = 0;
  m.observed = {{"F", machine::Observed::actuator_F, taut::si::N, 0, {}, origin},
                {"l", machine::Observed::actuator_length, taut::si::m, 0, {}, origin},
                {"v", machine::Observed::actuator_speed, taut::si::m_per_s, 0, {}, origin}};
  return m;
}

TransientResult run(const machine::Model& m, double duration, double tolerance = 1e-7) {
  TransientResult r = run_to_end(m, lasting(duration, tolerance, 100));
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover);
  return r;
}

TEST(TransientActuator, ALawComesToItsSpeed) {
  machine::Actuator ram;
  ram.kind = ActuatorKind::law;
  ram.F0 = 100;
  ram.gain = 1000;
  ram.signal = constant(0.2, taut::si::m_per_s);
  for (const bool out : {true, false}) {
    ram.mode = out ? ActuatorMode::extend : ActuatorMode::retract;
    const double end = out ? 0.3 : -0.2;  // reference + F0/gain; retracting without F0
    const TransientResult r = run(pushed_mass(ram), 1);
    const auto& last = r.frames.back().actuators[0];
    EXPECT_NEAR(last.speed, end * (1 - std::exp(-2.0)), 1e-5);
    EXPECT_NEAR(last.F, 1000 * end * std::exp(-2.0), 1e-2);
    EXPECT_NEAR(last.length, 2 + end * (1 - (1 - std::exp(-2.0)) / 2), 1e-5);
  }
}

TEST(TransientActuator, AForceIsLimitedAndTurnsWithItsMode) {
  machine::Actuator ram;
  ram.kind = ActuatorKind::force;
  ram.signal = constant(800, taut::si::N);
  ram.force_limit = 500;
  ram.mode = ActuatorMode::retract;
  const TransientResult r = run(pushed_mass(ram), 1);
  EXPECT_NEAR(r.frames.back().bodies[0].position.x(), 1.5, 1e-6);
  EXPECT_NEAR(r.frames.back().actuators[0].F, -500, 1e-9);
}

// 2 m at 1.6 m/s2: sqrt(2.5) s. Beyond its own length it went on as one that pushes the other way.
TEST(TransientActuator, OneWithoutLengthEndsTheMotion) {
  machine::Actuator ram;
  ram.kind = ActuatorKind::force;
  ram.signal = constant(800, taut::si::N);
  ram.mode = ActuatorMode::retract;
  for (const bool swapped : {false, true}) {
    machine::Model m = pushed_mass(ram);
    if (swapped) std::swap(m.actuators[0].from_body, m.actuators[0].to_body);
    const TransientResult r = transient(m, lasting(3, 1e-6));
    EXPECT_NE(r.outcome.message.find("the actuator 'ram' has no length left"), std::string::npos) << r.outcome.message;
    EXPECT_NEAR(r.t_end, std::sqrt(2.5), 1e-6);
    EXPECT_EQ(r.events.back().what, "length_zero");
  }
}

TEST(TransientActuator, ALockTakesOverTheForce) {
  machine::Actuator ram;
  ram.kind = ActuatorKind::force;
  ram.signal = constant(1000, taut::si::N);
  ram.lock_stiffness = 2e5;  // omega 20
  machine::Model m = pushed_mass(ram);
  machine::Event lock;
  lock.kind = machine::EventKind::actuator;
  lock.at = 0.5;
  lock.index = 0;
  m.events = {lock};
  const TransientResult r = run(m, 2);
  // from then on about 2.25 m + 1000 N/k, beginning with the speed 1 m/s
  const double mean = 2.25 + 1000 / 2e5, amplitude = std::hypot(1000 / 2e5, 1.0 / 20);
  EXPECT_NEAR(r.extremes[1].max, mean + amplitude, 1e-4);
  EXPECT_NEAR(r.extremes[0].min, -2e5 * amplitude, 20);
  EXPECT_NEAR(r.frames[25].actuators[0].F, 1000, 1);
}

TEST(TransientActuator, ASpeedMovesItWithoutDrift) {
  machine::Actuator ram;
  ram.kind = ActuatorKind::speed;
  ram.signal = constant(0, taut::si::m_per_s);
  ram.signal.law = taut::machine::Moves{0, {{0, 0.5, 1, machine::Change::linear}, {3, 0, 1, machine::Change::linear}}};
  ram.lock_stiffness = 1e7;
  ram.lock_damping = 5e4;
  const TransientResult r = run(pushed_mass(ram), 6, 1e-6);
  EXPECT_NEAR(r.frames.back().actuators[0].length, 2 + 0.5 * 3, 1e-6);
}

/// Lengths in the same way at any turn of the machine in space.
TEST(TransientActuator, TheFrameDoesNotMatter) {
  const Matrix3 R = (Eigen::AngleAxisd(0.9, Vector3(1, 2, 3).normalized())).toRotationMatrix();
  double length = 0;
  for (const bool turned : {false, true}) {
    const Matrix3 T = turned ? R : Matrix3(Matrix3::Identity());
    machine::Model m;
    m.gravity = 0;
    machine::Body b = body("beam", T * Vector3(1, 0, 0), 300, "xyzXYZ");
    b.orientation = T;
    b.centre = {0.2, 0.1, -0.3};
    b.inertia = {10, 20, 25};
    m.bodies = {b};
    machine::Actuator ram;
    ram.kind = ActuatorKind::law;
    ram.F0 = 2000;
    ram.gain = 3000;
    ram.signal = constant(0.4, taut::si::m_per_s);
    ram.to_body = 0;
    ram.to = {0.5, -0.4, 0.3};
    ram.from = T * Vector3(-1, 0.5, 0.2);
    m.actuators = {ram};
    const TransientResult r = run(m, 1.5);
    const double now = r.frames.back().actuators[0].length;
    if (turned) {
      EXPECT_NEAR(now, length, 1e-6);
    }
    length = now;
  }
}

struct OnBelt {
  double period = 0, largest = 0, least = 0;
};

/// m x'' = -k x + friction of a belt of speed v0 > 0, from rest; from stick to slip and back.
OnBelt on_belt(double m, double k, double N, double f0, double f1, double vs, double v0) {
  double x = 0, v = 0, t = 0, last_slip = 0;
  bool sticks = false;
  OnBelt found;
  const double h = 2e-6;
  const auto a = [&](double at, double speed) {
    const double relative = v0 - speed;
    return (-k * at + std::copysign(f1 + (f0 - f1) * std::exp(-std::abs(relative) / vs), relative) * N) / m;
  };
  while (t < 6) {
    t += h;
    if (sticks) {
      x += v0 * h;
      if (k * x < f0 * N) continue;
      sticks = false;
      found.period = t - last_slip;
      last_slip = t;
      found.largest = found.least = x;
      v = v0 - 1e-9;
    }
    const double k1 = a(x, v), k2 = a(x + h / 2 * v, v + h / 2 * k1),
                 k3 = a(x + h / 2 * v + h * h / 4 * k1, v + h / 2 * k2);
    const double k4 = a(x + h * v + h * h / 2 * k2, v + h * k3);
    x += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    found.largest = std::max(found.largest, x);
    found.least = std::min(found.least, x);
    sticks = v >= v0;
  }
  return found;
}

TEST(TransientActuator, AMassOnABeltSticksAndSlips) {
  const double mass = 1000, k = 1e5, N = mass * 9.81, v0 = 0.1;
  const OnBelt witness = on_belt(mass, k, N, 0.3, 0.2, 0.05, v0);
  machine::Model m;
  m.gravity = 9.81;
  machine::Body belt = body("belt", origin, 0, "");
  machine::Signal way = constant(0, taut::si::m);
  way.law = taut::machine::Curve{{0, 100}, {0, 100 * v0}, {}};
  belt.driven = {{Vector3::UnitX(), origin, way}};
  m.bodies = {body("mass", {0, 0, -N / 1e8}, mass, "xz"), belt};
  machine::Face face;
  face.body = 1;
  face.from = {-20, 0, 0};
  face.to = {20, 0, 0};
  m.faces = {face};
  machine::FaceContact c;
  c.name = "shoe";
  c.body = 0;
  c.stiffness = c.tangential_stiffness = 1e8;
  c.damping = c.tangential_damping = 1e5;
  c.static_friction = 0.3;
  c.kinetic_friction = 0.2;
  c.stribeck_speed = 0.05;
  m.contacts = {c};
  machine::Actuator spring;
  spring.from = {-2, 0, 0};
  spring.to_body = 0;
  spring.mode = ActuatorMode::lock;
  spring.lock_stiffness = k;
  m.actuators = {spring};
  const TransientResult r = run(m, 6, 1e-6);
  std::vector<double> slips;
  for (const auto& e : r.events) {
    if (e.what == "slip" && e.t > 1) slips.push_back(e.t);
  }
  ASSERT_GE(slips.size(), 4U);
  const double period = (slips.back() - slips[0]) / static_cast<double>(slips.size() - 1);
  EXPECT_NEAR(period, witness.period, 2e-3 * witness.period);
  double largest = 0, least = 1;
  for (const auto& frame : r.frames) {
    if (frame.t < 2) continue;
    largest = std::max(largest, frame.bodies[0].position.x());
    least = std::min(least, frame.bodies[0].position.x());
  }
  EXPECT_NEAR(largest, witness.largest, 0.03 * witness.largest);  // of the output steps only
  EXPECT_NEAR(least, witness.least, 0.05 * witness.largest);
}

TEST(TransientActuator, WhatCannotBeComputedIsTold) {
  machine::Actuator ram;
  ram.mode = ActuatorMode::lock;
  machine::Model m = pushed_mass(ram);
  EXPECT_NE(transient(m, lasting(1, 1e-6, 100)).outcome.message.find("lock_stiffness"), std::string::npos);
  m.actuators[0].mode = ActuatorMode::extend;
  m.actuators[0].from = {2, 0, 0};
  EXPECT_NE(transient(m, lasting(1, 1e-6, 100)).outcome.message.find("at one place"), std::string::npos);
}

}  // namespace
}  // namespace taut_test::transient_actuator_test
