#include <gtest/gtest.h>

#include "taut/solve/motion/parts/build.hpp"
#include "test/support/machines.hpp"

/// What each kind of drive gives a drum: a way of turning, a torque or a tension, and never two of them.
namespace taut::solve::dynamics::transient_drive_test {

using namespace taut_test;

constexpr double R = 0.4;

struct Winch {
  machine::Model m;
  Mechanism is;
  Values v;

  explicit Winch(double inertia, int copies = 1) {
    m.bodies.push_back(body("load", {3, 0, -9}, 100, "xz"));
    const machine::Node drum = add_drum(m, "winch", origin, R);
    m.drums[0].inertia = inertia;
    m.reevings.push_back(reeve("rope", {drum, anchor_on("load", 0)}, 9.4, 0, 1e6));
    m.reevings[0].copies = copies;
    Built built = build(m, assembled(m), {});
    EXPECT_TRUE(built.outcome.ok()) << built.outcome.message;
    is = std::move(built.mechanism);
    v = std::move(built.values);
  }
  void drive(machine::DriveKind kind, bool brake = false) {
    machine::Signal ramp;
    ramp.law = machine::Curve{{0, 10}, {100, 300}, {}};
    v.drum_drive[0] = {kind, ramp, brake};
  }
  std::optional<Turning> turning(double t) const { return prescribed(is, is.spins[0], v, t); }
  double torque(double t) const { return drive_torque(is, is.spins[0], v, t); }
  std::optional<double> tension(double t) const { return given_tension(is, is.contacts[0], v, t); }
};

TEST(TransientDrive, ASpeedIsThatOfTheRopeOnItsLayer) {
  Winch of(5);
  of.drive(machine::DriveKind::speed);
  ASSERT_TRUE(of.turning(2));
  EXPECT_NEAR(of.turning(2)->omega, 140 / R, 1e-12);
  EXPECT_NEAR(of.turning(2)->alpha, 20 / R, 1e-12);
  of.v.lines[0].radius[0] = 0.5;  // the next layer
  EXPECT_NEAR(of.turning(2)->omega, 140 / 0.5, 1e-12);
  EXPECT_EQ(of.torque(2), 0);
  EXPECT_FALSE(of.tension(2));
}

TEST(TransientDrive, WhatIsHeldOrBrakedStands) {
  Winch of(0);
  for (const machine::DriveKind kind : {machine::DriveKind::held, machine::DriveKind::free, machine::DriveKind::speed,
                                        machine::DriveKind::torque, machine::DriveKind::pull}) {
    of.drive(kind, kind != machine::DriveKind::held);
    ASSERT_TRUE(of.turning(2));
    EXPECT_EQ(of.turning(2)->omega, 0);
    EXPECT_EQ(of.torque(2), 0);
    EXPECT_FALSE(of.tension(2));
  }
}

/// With inertia a torque turns the drum; without it the rope has it as a tension at once, each of equal ropes its
/// share.
TEST(TransientDrive, ATorqueIsATensionWhereNothingTurnsSlowly) {
  for (const int copies : {1, 4}) {
    Winch heavy(5, copies), light(0, copies);
    for (Winch* of : {&heavy, &light}) {
      of->drive(machine::DriveKind::torque);
      EXPECT_FALSE(of->turning(5));
      EXPECT_NEAR(of->torque(5), 200, 1e-12);
    }
    EXPECT_FALSE(heavy.tension(5));
    ASSERT_TRUE(light.tension(5));
    EXPECT_NEAR(*light.tension(5) * R * copies, 200, 1e-12);
    light.drive(machine::DriveKind::free);
    EXPECT_EQ(light.tension(5), 0);
    EXPECT_EQ(light.torque(5), 0);
  }
}

/// A given pull is the rope's whatever the drum weighs; of a rope that breaks it fades with what is left of it.
TEST(TransientDrive, APullIsTheRopesOwn) {
  for (const double inertia : {0.0, 5.0}) {
    Winch of(inertia);
    of.drive(machine::DriveKind::pull);
    ASSERT_TRUE(of.turning(1));  // the drum does not count: the rope goes by
    EXPECT_EQ(of.turning(1)->omega, 0);
    EXPECT_EQ(of.torque(1), 0);
    EXPECT_NEAR(of.tension(1).value_or(-1), 120, 1e-12);
    of.v.lines[0].gone = 0.25;
    EXPECT_NEAR(of.tension(1).value_or(-1), 30, 1e-12);
    of.v.lines[0].gone = 0;
    EXPECT_EQ(of.tension(1).value_or(-1), 0);
  }
}

}  // namespace taut::solve::dynamics::transient_drive_test
