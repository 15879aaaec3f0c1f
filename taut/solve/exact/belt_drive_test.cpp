#include "taut/solve/exact/belt_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace taut::solve::belt_drive_test {

BeltDrive saw() {
  BeltDrive d;
  d.friction = 0.35;
  d.wrap = 3.5;
  d.working_arc = 3.0;
  d.momentum_flow = 135;
  d.idler_loss = 1.08;
  d.load = 4000;
  d.stiffness = 4e6;
  d.branch = 9;
  d.radius = 0.25;
  d.pull = 14e3;
  return d;
}

BeltDriveState solved(const BeltDrive& d) {
  BeltDriveState s;
  const Outcome o = solve(d, s);
  EXPECT_TRUE(o.ok()) << o.message;
  return s;
}

TEST(BeltDrive, WeightSetsTheTensions) {
  for (const LoadPlace place : {LoadPlace::at_idler, LoadPlace::in_tight_branch}) {
    BeltDrive d = saw();
    d.place = place;
    const BeltDriveState s = solved(d);
    EXPECT_FALSE(s.slips);
    EXPECT_NEAR(s.T_1, 1.08 * s.T_2 + 4000, 1e-8);
    const double idler = place == LoadPlace::at_idler ? s.T_1 : 1.08 * s.T_2;
    EXPECT_NEAR(s.T_2 + idler - 2 * 135, 14e3, 1e-8);
    EXPECT_NEAR(s.slip_arc, std::log((s.T_1 - 135) / (s.T_2 - 135)) / 0.35, 1e-12);
    EXPECT_NEAR(s.rest_arc + s.slip_arc, 3.0, 1e-12);
    EXPECT_NEAR(s.creep, (s.T_1 - s.T_2) / 4e6, 1e-15);
  }
}

TEST(BeltDrive, SlipsAtTheLimitAndPassesOnLess) {
  BeltDrive d = saw();
  d.pull = 5e3;
  const BeltDriveState s = solved(d);
  EXPECT_TRUE(s.slips);
  EXPECT_NEAR((s.T_1 - 135) / (s.T_2 - 135), std::exp(0.35 * 3.0), 1e-9);
  EXPECT_NEAR(s.T_1 + s.T_2 - 270, 5e3, 1e-8);
  EXPECT_LT(s.load, 4000);
  EXPECT_NEAR(s.load, s.T_1 - 1.08 * s.T_2, 1e-9);
  d.load = 0.999999 * s.load;
  EXPECT_FALSE(solved(d).slips);
  d.load = 1.000001 * s.load;
  EXPECT_TRUE(solved(d).slips);
}

/// The rope's unstretched length by small steps around the loop, from the law of friction alone.
double unstretched(const BeltDrive& d, const BeltDriveState& s) {
  constexpr int steps = 200000;
  double length = d.branch / (1 + s.T_2 / d.stiffness);
  const double after = d.place == LoadPlace::at_idler ? s.T_1 : d.idler_loss * s.T_2;
  length += d.branch / 2 * (1 / (1 + after / d.stiffness) + 1 / (1 + s.T_1 / d.stiffness));
  double T = s.T_2;
  const double h = d.wrap / steps;
  for (int i = 0; i < steps; ++i) {  // from the slack side; friction stops where the tight tension is reached
    length += d.radius * h / (1 + T / d.stiffness);
    T = std::min(s.T_1, T + d.friction * (T - d.momentum_flow) * h);
  }
  const double idler = d.radius * (2 * std::numbers::pi - d.wrap);
  return length + idler / 2 * (1 / (1 + s.T_2 / d.stiffness) + 1 / (1 + after / d.stiffness));
}

TEST(BeltDrive, ScrewKeepsTheRopesLength) {
  for (const LoadPlace place : {LoadPlace::at_idler, LoadPlace::in_tight_branch}) {
    for (const double EA : {1e5, 4e6}) {
      BeltDrive d = saw();
      d.place = place;
      d.take_up = TakeUp::screw;
      d.stiffness = EA;
      const BeltDriveState s = solved(d);
      EXPECT_FALSE(s.slips);
      EXPECT_LT(s.stretch, 1e-12);
      const double all = 2 * d.branch + 2 * std::numbers::pi * d.radius;
      EXPECT_NEAR(unstretched(d, s), all / (1 + 7e3 / EA), 1e-6 * all * 7e3 / EA);
    }
  }
}

TEST(BeltDrive, ScrewWithoutArcsKeepsTheSumOfTensions) {
  BeltDrive d = saw();
  d.take_up = TakeUp::screw;
  d.radius = 0;
  d.stiffness = std::numeric_limits<double>::infinity();
  const BeltDriveState s = solved(d);
  EXPECT_NEAR(s.T_1 + s.T_2, 14e3, 1e-6);
  EXPECT_NEAR(s.pull, 14e3 - 270, 1e-6) << "the centrifugal tension takes its share of the pull";
  EXPECT_EQ(s.creep, 0);
}

TEST(BeltDrive, SpeedTakesTheGripOfAScrewNotOfAWeight) {
  BeltDrive d = saw();
  d.idler_loss = 1;
  d.radius = 0;
  d.momentum_flow = 6e3;
  EXPECT_FALSE(solved(d).slips);
  d.take_up = TakeUp::screw;
  EXPECT_TRUE(solved(d).slips);
  d.momentum_flow = 7.1e3;  // more than the tension at rest
  BeltDriveState s;
  const Outcome o = solve(d, s);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("lifts off"), std::string::npos);
}

}  // namespace taut::solve::belt_drive_test
