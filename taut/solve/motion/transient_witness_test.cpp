#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Machines in motion against witnesses that know nothing of the engine: closed forms, and equations of motion of one
/// unknown written by hand and integrated by Runge and Kutta.
namespace taut_test::transient_witness {
namespace {

using std::numbers::pi;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double g = 9.81;

/// Two masses on a rope of 4 kg/m over a sheave; each leg is a chain.
struct HeavyRope {
  double left = 60, right = 75, leg = 20, per_metre = 4, stiffness = 2e7;
};
machine::Model heavy_rope(const HeavyRope& of, machine::Node round, int segments) {
  machine::Model m;
  m.gravity = g;
  const double R = round.radius;
  m.bodies = {body("left", {-R, 0, -of.leg}, of.left, "z"), body("right", {R, 0, -of.leg}, of.right, "z")};
  m.reevings.push_back(reeve("rope", {anchor_on("left", 0), std::move(round), anchor_on("right", 1)},
                             2 * of.leg + pi * R - 40e3 / of.stiffness, of.per_metre * g, of.stiffness));
  m.reevings[0].segments = segments;
  m.reevings[0].damping_time = 2e-3;
  return m;
}

/// How far the right mass has sunk after a second.
double sunk(const machine::Model& m) {
  const TransientResult r = run_to_end(m, lasting(1, 1e-5));
  return m.bodies[1].position.z() - r.frames.back().bodies[1].position.z();
}

/// The engine holds half a segment's mass at each side of the sheave; the witness is told, so that few segments do.
TEST(TransientWitness, HeavyRopeRunsOverAFreeSheave) {
  const HeavyRope of;
  for (const int segments : {4, 8}) {
    machine::Node wheel = sheave("wheel", {0, 0, 0}, 0.2, 1);
    wheel.inertia = 0.6;
    const double held = of.per_metre * of.leg / segments;
    const double mass = of.left + of.right + 2 * of.per_metre * of.leg - held + 0.6 / 0.04;
    const auto a = [&](double, double x, double) { return g * (of.right - of.left + 2 * of.per_metre * x) / mass; };
    EXPECT_NEAR(sunk(heavy_rope(of, wheel, segments)) / runge_kutta(0, 0, 1, a)[0], 1, 3e-3) << segments;
  }
}

/// T_out - G = exp(mu theta) (T_in - G), G = m u^2, each leg moving as a whole.
TEST(TransientWitness, HeavyRopeSlipsOverALockedSheave) {
  HeavyRope of;
  of.right = 190;
  of.stiffness = 2e9;  // a soft rope sticks and slips while its legs find their stretch: 1 % at 2e7
  const double ratio = std::exp(0.1 * pi);
  for (const int segments : {4, 8}) {
    machine::Node round = sheave("drum", {0, 0, 0}, 0.2, 1, 0);
    round.law.friction = 0.1;
    const double held = of.per_metre * of.leg / segments / 2;
    const auto a = [&](double, double x, double u) {
      const double left = of.left + of.per_metre * of.leg - held, right = of.right + of.per_metre * of.leg - held;
      const double G = of.per_metre * u * u;
      const double pull_right = (right + held + of.per_metre * x) * g, pull_left = (left + held - of.per_metre * x) * g;
      return (pull_right - G - ratio * (pull_left - G)) / (right + ratio * left);
    };
    EXPECT_NEAR(sunk(heavy_rope(of, round, segments)) / runge_kutta(0, 0, 1, a)[0], 1, 5e-3) << segments;
  }
}

/// A tackle that takes in or pays out: from the winch on the tension falls, or grows, by eta at each sheave. One
/// unknown, by hand.
TEST(TransientWitness, TackleWithLossesHoistsAndLowers) {
  constexpr int falls = 6;
  constexpr double eta = 0.97, EA = 1e7, mass = 3000;
  for (const double speed : {0.2, -0.2}) {
    const double loss = speed > 0 ? eta : 1 / eta;
    double sum = 0;
    for (int i = 1; i <= falls; ++i) sum += std::pow(loss, i);
    const double T0 = mass * g / sum;
    machine::Model m;
    m.gravity = g;
    m.bodies.push_back(body("block", {0, 0, -10}, mass, "z"));
    taut::solve::DynamicState start;
    start.bodies.resize(1);
    start.bodies[0].position = {0, 0, -10};
    start.ropes.resize(1);
    double total = 0;
    std::vector<machine::Node> nodes{anchor("winch", {-10, 0, 0})};
    for (int i = 0; i <= falls; ++i) {
      start.ropes[0].length.push_back(10 / (1 + T0 * std::pow(loss, i) / EA));
      total += start.ropes[0].length.back();
      if (i == falls) break;
      nodes.push_back(i % 2 == 0 ? over("head", {0, 0, 0}) : over("block", {0, 0, 0}, 0));
      nodes.back().law.efficiency = eta;
    }
    nodes.push_back(anchor("becket", {0, 0, 0}));
    m.reevings.push_back(reeve("hoist", nodes, total, 0, EA));
    m.tensioners.push_back({0, true, {}});
    m.tensioners[0].change.law = machine::Moves{0, {{0, -speed, 1, machine::Change::linear}}};
    TransientOptions options;
    options.duration = options.output_step = 0.1;
    options.tolerance = 1e-7;
    options.from = start;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    // 10/(1 + T/EA) + sum (10 - z)/(1 + T loss^i/EA) = total - speed t
    const auto tension = [&](double z, double t) {
      double T = T0;
      for (int step = 0; step < 30; ++step) {
        double length = 10 / (1 + T / EA), slope = -10 / EA / std::pow(1 + T / EA, 2);
        for (int i = 1; i <= falls; ++i) {
          const double share = std::pow(loss, i), stretch = 1 + T * share / EA;
          length += (10 - z) / stretch;
          slope -= (10 - z) * share / EA / (stretch * stretch);
        }
        T -= (length - (total - speed * t)) / slope;
      }
      return T;
    };
    const auto [z, v] =
        runge_kutta(0, 0, 0.1, [&](double t, double x, double) { return tension(x, t) * sum / mass - g; });
    EXPECT_GT(v * speed, 0);
    EXPECT_NEAR(r.frames.back().bodies[0].position.z(), z - 10, 1e-8);
    for (int i = 0; i <= falls; ++i) {
      const double T = tension(z, 0.1) * std::pow(loss, i);
      EXPECT_NEAR(r.frames.back().branches[static_cast<std::size_t>(i)].T_from / T, 1, 2e-6) << i;
    }
    const auto& energy = r.frames.back().energy;
    EXPECT_GT(energy.bearings, 0);
    EXPECT_LT(std::abs(energy.residual), 1e-6 * energy.turnover);
  }
}

/// A belt that drives: the rims differ by the stretch, v2/v1 = (1 + T2/EA)/(1 + T1/EA), whatever the friction; with a
/// rope that has mass the tensions contain m v^2, and so does the stretch.
TEST(TransientWitness, BeltCreepsByItsStretch) {
  constexpr double R = 0.3, torque = 240, speed = 10, EA = 2e5;
  machine::Model m;
  m.gravity = g;
  for (const double side : {0.0, 1.0}) {
    machine::Node wheel = sheave(side > 0 ? "driven" : "drive", {5 * side, 0, 0}, R, 1);
    wheel.kind = side > 0 ? machine::NodeKind::contact : machine::NodeKind::drive;
    wheel.motor = static_cast<int>(side);
    wheel.law.friction = 0.5;
    wheel.inertia = 0.5;
    if (m.reevings.empty()) m.reevings.push_back(reeve("belt", {}, 0, 0.3 * g, EA));
    m.reevings[0].nodes.push_back(wheel);
  }
  m.reevings[0].closed = true;
  m.reevings[0].value = (10 + 2 * pi * R) / (1 + 1500 / EA);
  m.reevings[0].damping_time = 5e-3;
  m.motors.resize(2);
  m.motors[0].drive = {machine::DriveKind::speed, smooth_move(0, speed, 0, 1)};
  m.motors[1].drive = {machine::DriveKind::torque, smooth_move(0, -torque, 1, 1)};
  const TransientResult r = run_to_end(m, lasting(6, 1e-5));
  const auto& last = r.frames.back();
  const double T1 = last.contacts[0].T_in, T2 = last.contacts[0].T_out;
  EXPECT_NEAR(T1 - T2, torque / R, 1e-3 * torque / R);
  EXPECT_NEAR(last.contacts[0].spin * R, speed, 1e-9);
  const double creep = 1 - last.contacts[1].spin / last.contacts[0].spin;
  EXPECT_NEAR(creep, (T1 - T2) / EA / (1 + T1 / EA), 1e-3 * creep);
  EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover);
}

/// Two masses on a rope over two sheaves whose axes cross at right angles.
TEST(TransientWitness, CrossedSheaves) {
  constexpr double R = 0.2, J = 0.4, light = 100, heavy = 130;
  machine::Model m;
  m.gravity = g;
  machine::Node first = sheave("first", {0, 0, 0}, R, 1), second = sheave("second", {3, 1, 0.5}, R, 1);
  first.inertia = second.inertia = J;
  second.axis = Vector3(-1, 0, 0);
  m.bodies = {body("light", {-R, 0, -10}, light, "z"), body("heavy", {3, 1 + R, -10}, heavy, "z")};
  m.reevings.push_back(reeve("rope", {anchor_on("light", 0), first, second, anchor_on("heavy", 1)}, 1, 0, 1e7));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = light * g;
  m.reevings[0].damping_time = 5e-3;
  const TransientResult r = run_to_end(m, lasting(1, 1e-6));
  const double a = g * (heavy - light) / (heavy + light + 2 * J / (R * R));
  const auto& last = r.frames.back();
  EXPECT_NEAR(last.bodies[0].acceleration.z(), a, 1e-3 * a);
  EXPECT_NEAR(-last.bodies[1].acceleration.z(), a, 1e-3 * a);
  EXPECT_NEAR(last.contacts[0].spin * R, last.bodies[0].velocity.z(), 2e-3);
  EXPECT_NEAR(last.contacts[1].spin * R, last.bodies[0].velocity.z(), 2e-3);
  EXPECT_LT(std::abs(last.energy.residual), 1e-6 * last.energy.turnover);
}

/// Two masses on a rope round a wheel that is fixed to a body; the body rises and turns beyond a full turn. The rope
/// does not slip: each mass goes with the body, and with the rim.
TEST(TransientWitness, SheaveOnABodyThatMovesAndTurns) {
  constexpr double R = 0.4, angle = 7, rise = 1.5, EA = 1e7;
  for (const bool held : {true, false}) {
    machine::Model m;
    m.gravity = g;
    m.bodies = {body("arm", {0, 0, 0}, 50, ""), body("a", {-R, 0, -8}, 100, "z"), body("b", {R, 0, -8}, 100, "z")};
    m.bodies[0].driven.push_back({Vector3::UnitZ(), Vector3::Zero(), smooth_move(0, rise, 0.2, 2)});
    m.bodies[0].driven.push_back({Vector3::Zero(), Vector3::UnitY(), smooth_move(0, angle, 0.2, 2)});
    machine::Node wheel = sheave("wheel", {0, 0, 0}, R, 1, held ? 0 : 1, 0);
    wheel.law.friction = 3;
    if (!held) wheel.inertia = 1e-3;  // turns on its axle: the body turns under it
    m.reevings.push_back(reeve("rope", {anchor_on("a", 1), wheel, anchor_on("b", 2)}, 1, 0, EA));
    m.reevings[0].given = machine::Given::tension_at_start;
    m.reevings[0].value = 100 * g;
    m.reevings[0].damping_time = 5e-3;
    const TransientResult r = run_to_end(m, lasting(4, 1e-5));
    const auto& last = r.frames.back();
    const double turned = held ? angle * R : 0;  // right-handed about y takes the left side up
    EXPECT_NEAR(last.bodies[1].position.z(), -8 + rise + turned, 5e-3) << held;
    EXPECT_NEAR(last.bodies[2].position.z(), -8 + rise - turned, 5e-3) << held;
    EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover) << held;
  }
}

/// l phi'' + R phi'^2 + g sin(phi) = 0, l = l0 + R phi: a pendulum whose rope winds on and off a fixed drum.
TEST(TransientWitness, PendulumOnADrum) {
  constexpr double R = 0.5, l0 = 6, phi0 = 0.8, EA = 1e9;
  machine::Model m;
  m.gravity = g;
  const Vector3 t(std::sin(phi0), 0, -std::cos(phi0)), n(std::cos(phi0), 0, std::sin(phi0));
  const double l = l0 + R * phi0;
  m.bodies.push_back(body("load", R * n + l * t, 300, "xz"));
  m.reevings.push_back(reeve("rope", {add_drum(m, "drum", origin, R), anchor_on("load", 0)}, 1, 0, EA));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 300 * g * std::cos(phi0);
  m.reevings[0].damping_time = 1e-4;
  const TransientResult r = run_to_end(m, lasting(3, 1e-5));
  const auto [phi, rate] = runge_kutta(
      phi0, 0, 3, [&](double, double x, double v) { return -(R * v * v + g * std::sin(x)) / (l0 + R * x); });
  const Vector3 end(R * std::cos(phi) + (l0 + R * phi) * std::sin(phi), 0,
                    R * std::sin(phi) - (l0 + R * phi) * std::cos(phi));
  EXPECT_LT((r.frames.back().bodies[0].position - end).norm(), 2e-3);
  EXPECT_NEAR(r.frames.back().bodies[0].velocity.norm(), std::abs((l0 + R * phi) * rate), 5e-3);
}

/// A carriage falls into a slack skyline and rolls on it: on a rope without weight it never leaves the ellipse.
TEST(TransientWitness, CarriageFallsIntoASlackRope) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("car", {60, 0, 26}, 800, "xz"));
  const Vector3 head(0, 0, 40), tail(200, 0, 20);
  for (const double weight : {0.0, 1.7 * g}) {
    m.reevings = {
        reeve("skyline", {anchor("head", head), over("car", origin, 0), anchor("tail", tail)}, 203, weight, 26e6)};
    m.reevings[0].damping_time = 0.01;
    const TransientResult r = run_to_end(m, lasting(6, 1e-4, 60));
    for (const auto& frame : r.frames) {
      const Vector3& at = frame.bodies[0].position;
      const double path = (at - head).norm() + (at - tail).norm();
      EXPECT_LE(path, 203 * (1 + r.ropes[0].T.max / 26e6) * (1 + 1e-6));
      EXPECT_NEAR(frame.branches[0].unstretched + frame.branches[1].unstretched, 203, 1e-9);
      EXPECT_NEAR(frame.branches[0].T_to, frame.branches[1].T_from, 1e-4 * r.ropes[0].T.max);
    }
    EXPECT_GT(r.ropes[0].T.max, 30e3);
    EXPECT_LT(r.ropes[0].T.max, 300e3);
    EXPECT_GT(r.frames.back().bodies[0].position.x(), 65);
    // the weight of a slack rope hangs on nothing, which costs 2.5 % of what is turned over
    const double whole = weight == 0 ? r.frames.back().energy.turnover : r.frames.front().energy.potential;
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 0.01 * whole) << weight;
  }
}

}  // namespace
}  // namespace taut_test::transient_witness
