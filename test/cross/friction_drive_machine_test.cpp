#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/app/job.hpp"
#include "test/cross/drive_results.hpp"

// The method's exact column and the same drive written as a machine deck.
namespace friction_drive_machine_test {

using namespace taut;
using namespace taut_test::drive_results;

struct Case {
  double cutting_force = 4000, friction = 0.35, speed = 15, idler_loss = 1, pull = 13e3;
  bool screw = false, reversed = false;
  double radius = 0.25;  ///< m
  int start = 0;         ///< where the machine deck's path begins
};

Result method(const Case& k) {
  const std::string deck =
      fmt::format(R"(taut: 1
method: friction_drive
input:
  cutting_force: {} N
  friction: {}
  wrap: 180 deg
  rope_mass: 0.6 kg/m
  speed: {} m/s
  grip_reserve: 1
  idler_loss: {}
  sheave_radius: {} m
  take_up: {{{}: {} N}}
  rope_stiffness: 6.5 MN
  centre_distance: 9 m
  cut: in_tight_branch
)",
                  k.cutting_force, k.friction, k.speed, k.idler_loss, k.radius, k.screw ? "screw" : "weight", k.pull);
  return taut::app::run(taut::app::Job{.text = deck, .name = "method.yaml", .set = {}});
}

Result machine(const Case& k) {
  // a screw: the length with which the rope pulls the idler with that force at rest
  const double rest = (2 * 9 + 2 * M_PI * k.radius) / (1 + k.pull / 2 / 6.5e6);
  const std::string side = k.reversed ? "right" : "left";
  const std::string drive = fmt::format("{{over: drive, side: {}}}", side);
  const std::string idler = fmt::format("{{over: idler, side: {}}}", side);
  const std::string deck = fmt::format(
      R"(taut: 1
machine:
  gravity: 0 m/s^2
  ropes: {{saw: {{mass: 0.6 kg/m, stiffness: 6.5 MN}}}}
  bodies: {{slide: {{at: [{} m, 0 m, 0 m], free: [x]}}}}
  sheaves:
    drive: {{at: [0 m, 0 m, 0 m], diameter: {} m, friction: {}, motor: {{speed: {} m/s}}}}
    idler: {{body: slide, at: [0 m, 0 m, 0 m], diameter: {} m, efficiency: {:.17g}}}
  reevings: [{{rope: saw, path: [{}, {}], closed: true, length: {:.17g} m}}]
  {}
  rope_loads: [{{rope: saw, between: [idler, drive], tangential: {} N}}]
analyses: [equilibrium: {{motion: in}}]
)",
      k.screw ? 8.97 : 9.0, 2 * k.radius, k.friction, k.speed, 2 * k.radius, 1 / k.idler_loss,
      k.start == 0 ? drive : idler, k.start == 0 ? idler : drive, rest,
      fmt::format("take_up: [{{body: slide, screw: {} N, keeps: {}}}]", k.pull, k.screw ? "place" : "force"),
      k.cutting_force);
  return taut::app::run(taut::app::Job{.text = deck, .name = "machine.yaml", .set = {}});
}

void expect_same(const Case& k, double tolerance) {
  const Result a = method(k), b = machine(k);
  const auto near = [&](const char* paper, const char* column) {
    const double wanted = value(a, paper);
    EXPECT_NEAR(drive(b, column), wanted, tolerance * std::abs(wanted)) << column;
  };
  near("T_1_exact", "T_in");
  near("T_2_exact", "T_out");
  near("slip_arc_exact", "slip_arc");
  near("creep_exact", "creep");
  EXPECT_NEAR(drive(b, "power"), k.cutting_force * k.speed,
              2e-3 * drive(b, "power") + k.speed * 600 * (k.idler_loss - 1) * 12);
}

TEST(FrictionDriveMachine, AWeightSetsTheSameTensions) {
  for (const double speed : {0.01, 15.0, 40.0}) {
    for (const double force : {1000.0, 4000.0}) {
      Case k;
      k.speed = speed;
      k.cutting_force = force;
      expect_same(k, 1e-6);
    }
  }
}

TEST(FrictionDriveMachine, ALossOfTheIdlerToo) {
  Case k;
  k.speed = 0.01;  // the method's loss counts the centrifugal tension in, the machine's bearing does not feel it
  k.idler_loss = 1.08;
  expect_same(k, 1e-6);
}

TEST(FrictionDriveMachine, FixedCentres) {
  for (const double radius : {0.05, 0.25, 0.6}) {
    for (const double speed : {0.01, 15.0, 40.0}) {
      Case k;
      k.screw = true;
      k.speed = speed;
      k.radius = radius;
      // the cut stands in the middle of the stretched branch there, of the unstretched one here: 5e-5 of the tensions
      expect_same(k, 7e-5);
    }
  }
}

TEST(FrictionDriveMachine, TheOtherWayRoundAndFromAnotherStart) {
  Case k;
  const Result a = machine(k);
  for (const bool reversed : {false, true}) {
    for (const int start : {0, 1}) {
      k.reversed = reversed;
      k.start = start;
      const Result b = machine(k);
      for (const char* column : {"T_in", "T_out", "torque", "power", "slip_arc", "ratio"}) {
        EXPECT_NEAR(drive(b, column), drive(a, column), 1e-8 * std::abs(drive(a, column))) << column;
      }
    }
  }
}

TEST(FrictionDriveMachine, BothSayWhenItSlips) {
  Case k;
  k.cutting_force = 14e3;
  const Result a = method(k), b = machine(k);
  EXPECT_EQ(value(a, "slips_exact"), 1);
  bool fails = false;
  for (const Check& c : b.checks) fails = fails || (c.name == "drive.grip" && !c.passes);
  EXPECT_TRUE(fails);
}

}  // namespace friction_drive_machine_test
