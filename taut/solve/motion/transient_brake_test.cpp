#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Brakes that slip, and viscous drag, against closed forms: a mass on a drum.
namespace taut_test::transient_brake_test {
namespace {

using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double radius = 0.25, mass = 400, inertia = 20, g = 9.80665;

/// The mass hangs on a rope without weight from a drum at the origin, which takes in where the mass rises.
machine::Model winch(machine::Drive drive) {
  machine::Model m;
  m.bodies = {body("mass", {radius, 0, -20}, mass, "z")};
  machine::Drum drum;
  drum.name = "winch";
  drum.core_radius = radius;
  drum.inertia = inertia;
  drum.drive = std::move(drive);
  m.drums = {drum};
  machine::Node on_drum = anchor("winch", origin);
  on_drum.radius = radius;
  on_drum.axis = Vector3::UnitY();
  on_drum.side = 1;
  on_drum.drum = 0;
  m.reevings = {reeve("rope", {on_drum, anchor_on("mass", 0)}, 20, 0, 40e6)};
  m.reevings[0].damping_ratio = 0.3;
  m.observed = {{"v", machine::Observed::drum_speed, taut::si::m_per_s, 0, {}, origin},
                {"F", machine::Observed::drum_T, taut::si::N, 0, {}, origin}};
  return m;
}

machine::Event brake_at(double t) {
  machine::Event e;
  e.words = "brake";
  e.kind = machine::EventKind::brake;
  e.at = t;
  e.index = 0;
  return e;
}

machine::Drive lowering(double speed) {
  machine::Drive drive;
  drive.kind = machine::DriveKind::speed;
  drive.signal = smooth_move(0, -speed, 0, 1);
  return drive;
}

TransientResult run(const machine::Model& m, const TransientOptions& options) {
  TransientResult r = run_to_end(m, options);
  const auto& energy = r.frames.back().energy;
  EXPECT_LT(std::abs(energy.residual), 1e-3 * energy.turnover);
  return r;
}

double height(const TransientResult& r) { return r.frames.back().bodies[0].position.z(); }
double speed(const TransientResult& r) { return r.frames.back().bodies[0].velocity.z(); }

constexpr double moved = mass * radius + inertia / radius;  // N s2/m times the radius

TEST(TransientBrake, ASetBrakeHoldsUpToItsTorque) {
  for (const double share : {1.05, 0.6}) {
    machine::Drive held;
    held.brake = true;
    machine::Model m = winch(held);
    m.drums[0].brake = machine::Brake{.torque = share * mass * g * radius};
    TransientOptions options = lasting(1, 1e-7);
    options.start = taut::solve::Start::settled;
    const TransientResult r = run(m, options);
    const double a = share < 1 ? (1 - share) * mass * g * radius / moved : 0;
    EXPECT_NEAR(speed(r), -a, 2e-3 * std::max(a, 1e-3)) << share;  // the rope swings on its 1e-4 of strain
  }
}

TEST(TransientBrake, AnEmergencyStopTakesItsDelayAndItsWay) {
  // lowered at 1.5 m/s, begun within 1 s; the drive is cut at 1.5 s, the mass falls with the drum for 0.2 s, then the
  // brake slips
  const double M = 2.2 * mass * g * radius, delay = 0.2;
  machine::Model m = winch(lowering(1.5));
  m.drums[0].brake = machine::Brake{.torque = M, .delay = delay};
  m.events = {brake_at(1.5)};
  TransientOptions options = lasting(4, 1e-6);
  options.start = taut::solve::Start::settled;
  const TransientResult r = run(m, options);
  const double falls = mass * g * radius / moved, stops = (M - mass * g * radius) / moved;
  const double fastest = 1.5 + falls * delay;
  const double way = 1.5 * (0.5 + 0.5) + (1.5 + fastest) / 2 * delay + fastest * fastest / (2 * stops);
  EXPECT_NEAR(r.frames.front().bodies[0].position.z() - height(r), way, 2e-3 * way);
  EXPECT_NEAR(speed(r), 0, 0.02);
  // what the brake took: all that moved and fell after the drive was cut
  const double heat = moved / radius * 1.5 * 1.5 / 2 + mass * g * (way - 1.5);
  EXPECT_NEAR(r.frames.back().energy.bearings, heat, 1e-2 * heat);
}

TEST(TransientBrake, ABrakeThatGrowsIsWorkedOutByItsSlope) {
  const double M = 3 * mass * g * radius, rise = 0.6;
  machine::Model m = winch(lowering(1));
  m.drums[0].brake = machine::Brake{.torque = M, .delay = 0, .rise = rise};
  m.events = {brake_at(1.2)};
  TransientOptions options = lasting(1.2 + 0.5, 1e-6);
  options.start = taut::solve::Start::settled;
  const TransientResult r = run(m, options);
  const double t = 0.5;  // M t/rise against the weight
  const double v = 1 + (mass * g * radius * t - M * t * t / (2 * rise)) / moved;
  EXPECT_NEAR(speed(r), -v, 3e-3);
}

TEST(TransientBrake, TellsWhereADrumIsLetGoBeforeItHasStood) {
  machine::Model m = winch(lowering(1));
  m.events = {brake_at(1.5), brake_at(2)};
  m.events[1].brake_set = false;
  TransientOptions options = lasting(2.5, 1e-6);
  options.start = taut::solve::Start::settled;
  const auto braked = [&](double share) {
    m.drums[0].brake = machine::Brake{.torque = share * mass * g * radius};
    return run(m, options);
  };
  const TransientResult slips = braked(0.8);
  ASSERT_TRUE(slips.brake_ways.at(0).let_go);
  EXPECT_DOUBLE_EQ(*slips.brake_ways[0].let_go, 2);
  EXPECT_NEAR(slips.brake_ways[0].speed, 1 + 0.2 * mass * g * radius / moved * 0.5, 1e-2);
  EXPECT_EQ(slips.brake_ways[0].way, 0);
  EXPECT_TRUE(slips.frames.front().drums[0].held);
  EXPECT_FALSE(slips.frames.back().drums[0].held);
  const TransientResult stops = braked(3);
  EXPECT_TRUE(stops.brake_ways.at(0).acted);
  EXPECT_FALSE(stops.brake_ways[0].let_go);
}

TEST(TransientBrake, DragLeadsToASteadySpeed) {
  machine::Drive free;
  free.kind = machine::DriveKind::free;
  machine::Model m = winch(free);
  const double c = 600;  // N m s: m g R = c v/R
  m.drums[0].drag = c;
  const TransientResult r = run(m, lasting(3, 1e-6));
  const double steady = mass * g * radius * radius / c, decay = c / (radius * moved);
  EXPECT_NEAR(speed(r), -steady * (1 - std::exp(-3 * decay)), 2e-3 * steady);
}

TEST(TransientBrake, ASheaveDragsToo) {
  // both ends hang; the sheave's drag holds back the heavier one: (m1 - m2) g = (m1 + m2 + J/R2) a + c v/R2
  machine::Model m;
  m.bodies = {body("left", {-0.2, 0, -10}, 60, "z"), body("right", {0.2, 0, -10}, 50, "z")};
  machine::Node over = sheave("head", origin, 0.2, 1, 1);
  over.inertia = 0.8;
  over.drag = 12;
  m.reevings = {reeve("rope", {anchor_on("left", 0), over, anchor_on("right", 1)}, 20 + M_PI * 0.2, 0, 10e6)};
  m.reevings[0].damping_ratio = 0.3;
  const TransientResult r = run(m, lasting(1.5, 1e-7));
  const double all = 60 + 50 + 0.8 / 0.04, c = 12 / 0.04;
  const double v = 10 * g / c * (1 - std::exp(-c / all * 1.5));
  EXPECT_NEAR(speed(r), -v, 3e-3 * v);
}

/// Where a run goes on between the setting of the brake and the end of its rise: the steps end there all the same.
TEST(TransientBrake, GoesOnToTheLastBitWhileItRises) {
  machine::Model m = winch(lowering(1));
  m.drums[0].brake = machine::Brake{.torque = 3 * mass * g * radius, .delay = 0.1237, .rise = 0.3911};
  m.events = {brake_at(1.2)};
  const auto until = [](double duration) {
    TransientOptions options = in_steps(duration, 1e-3);
    options.output_step = 0.05;
    return options;
  };
  const TransientResult whole = run(m, until(2));
  for (const int outputs : {25, 28, 33}) {  // in its delay, in its rise
    TransientOptions options = until(0.05 * outputs);
    const TransientResult first = run_to_end(m, options);
    options = until(2 - 0.05 * outputs);
    options.from = first.state;
    const TransientResult second = run_to_end(m, options);
    EXPECT_EQ(height(second), height(whole)) << outputs;
    EXPECT_EQ(speed(second), speed(whole)) << outputs;
  }
}

}  // namespace
}  // namespace taut_test::transient_brake_test
