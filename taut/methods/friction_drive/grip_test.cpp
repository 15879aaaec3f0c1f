#include "taut/methods/friction_drive/grip.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::friction_drive::grip_test {

Input weak() {
  Input in;
  in.cutting_force = 1000;
  in.friction = 0.05;
  in.wrap = 1.5;
  in.rope_mass = 0.5;
  in.speed = 10;
  in.section_factor = 0.126;
  in.fill_ratio = 0.5;
  in.rest_arc = 0.1;
  return in;
}

TEST(FrictionDriveGrip, RatioIsThatOfTheSheet) {
  Input in = weak();
  in.friction = 0.4;
  in.wrap = 3;
  in.fill_ratio = 0.9;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(grip_ratio(in), out.e, 1e-14);
}

// Each value that the message names brings e to the ratio asked for.
TEST(FrictionDriveGrip, EachWayOutLeadsOut) {
  const Input in = weak();
  for (const double ratio : {1.05, 1.08}) {
    Input at = in;
    at.wrap = wrap_for(in, ratio).value();
    EXPECT_NEAR(grip_ratio(at), ratio, 1e-12);
    at = in;
    at.friction = friction_for(in, ratio).value();
    EXPECT_NEAR(grip_ratio(at), ratio, 1e-12);
  }
  Input at = in;
  at.fill_ratio = fill_for(in, 1.05).value();
  EXPECT_NEAR(grip_ratio(at), 1.05, 1e-12);
  EXPECT_FALSE(fill_for(in, 1.08).has_value()) << "more than full";
}

TEST(FrictionDriveGrip, NothingHelpsAnArcAllAtRest) {
  Input in = weak();
  in.rest_arc = 1.6;
  EXPECT_FALSE(friction_for(in, 1.08).has_value());
  EXPECT_FALSE(fill_for(in, 1.08).has_value());
  EXPECT_GT(wrap_for(in, 1.08).value(), 1.6);
  in.section_factor = 1;
  EXPECT_FALSE(wrap_for(in, 1.08).has_value());
}

TEST(FrictionDriveGrip, MessageNamesTheWays) {
  Output out;
  const Outcome outcome = solve(weak(), out);
  EXPECT_EQ(outcome.status, Status::infeasible);
  for (const char* words : {"no grip", "wrap above", "friction above", "rest arc", "section factor"}) {
    EXPECT_NE(outcome.message.find(words), std::string::npos) << outcome.message;
  }
  EXPECT_EQ(outcome.message.find("fill ratio above"), std::string::npos) << "that would not be enough";
}

TEST(FrictionDriveGrip, OnlyALowerSectionFactorHelpsAtOne) {
  Input in = weak();
  in.rest_arc = 0;
  in.section_factor = 1;
  const std::string words = how_to_get_grip(in, Display());
  EXPECT_TRUE(words.ends_with("; lower the section factor")) << words;
}

TEST(FrictionDriveGrip, PullAndForceAreInverse) {
  for (const double e : {1.1, 2.0, 16.0}) {
    EXPECT_NEAR(transmissible_force(pull_for(4000, e, 1.3), e, 1.3), 4000, 1e-9);
  }
  EXPECT_EQ(transmissible_force(-5, 2, 1), 0);
}

}  // namespace taut::friction_drive::grip_test
