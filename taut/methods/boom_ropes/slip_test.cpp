#include "taut/methods/boom_ropes/slip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace taut::boom_ropes::slip_test {

Input crane() {
  Input in;
  in.section_weight = 8.44e3;
  in.tackle_efficiency = 0.95;
  return in;
}

TEST(SlipAngle, WithoutLoadIsTheAngleOfFriction) {
  EXPECT_NEAR(free_slip_angle(8.44e3, 0, 0.155, 0.95, 6), std::atan(0.155), 1e-15);
}

TEST(SlipAngle, WithoutJammingBothAgree) {
  // A long overlap: both lower pads carry.
  const SlipAngle a =
      slip_angle(crane(), {}, {.boom_length = 9, .suspended_weight = 2943, .overlap_change = 0, .falls = 6});
  EXPECT_FALSE(a.jamming);
  EXPECT_NEAR(a.angle, a.free_angle, 1e-12);
}

TEST(SlipAngle, JammedWithoutOffsetsHasTheClosedForm) {
  Sliding q;
  q.offset_lead = 0;
  q.pad_height_3 = 0;
  const double G_n = 32373;
  const SlipAngle a =
      slip_angle(crane(), q, {.boom_length = 21, .suspended_weight = G_n, .overlap_change = 0, .falls = 6});
  ASSERT_TRUE(a.jamming);
  const double W = 8.44e3 + G_n;
  const double carried = 0.155 * (2 * (8.44e3 * q.center_3 + G_n * q.head_distance) / 1.35 - W);
  EXPECT_NEAR(G_n * 0.95 / 6 + W * std::sin(a.angle), carried * std::cos(a.angle), 1e-6 * W);
}

TEST(SlipAngle, SaysWhenThereIsNoOverlap) {
  const SlipAngle a =
      slip_angle(crane(), {}, {.boom_length = 21, .suspended_weight = 2943, .overlap_change = -2, .falls = 6});
  EXPECT_TRUE(std::isnan(a.angle));
  EXPECT_NE(a.reason.find("overlap"), std::string::npos);
}

TEST(SlipAngle, SaysWhenTheBoomIsTooLong) {
  EXPECT_NE(slip_angle(crane(), {}, {25, 2943, 0, 6}).reason.find("9 ... 21 m"), std::string::npos);
}

TEST(SlipAngle, BelowTheHorizontalWhereItSlidesThere) {
  Sliding q;
  q.static_friction = 0;
  const SlipAngle smooth =
      slip_angle(crane(), q, {.boom_length = 15, .suspended_weight = 2943, .overlap_change = 0, .falls = 6});
  EXPECT_NEAR(smooth.angle, -std::asin(2943 * 0.95 / 6 / (8.44e3 + 2943)), 1e-12);
  const SlipAngle heavy =
      slip_angle(crane(), {}, {.boom_length = 9, .suspended_weight = 100e3, .overlap_change = 0, .falls = 2});
  EXPECT_NEAR(heavy.free_angle * 180 / std::numbers::pi, -16.84, 0.005);
  EXPECT_FALSE(heavy.jamming);
  EXPECT_NEAR(heavy.angle, heavy.free_angle, 1e-12);
}

TEST(SlipAngle, PadsThatHoldAtEveryAngleAreAnAnswer) {
  Sliding q;
  q.offset_hoist = -10;  // the load presses the pads even where the boom points up
  const SlipAngle held =
      slip_angle(crane(), q, {.boom_length = 21, .suspended_weight = 32373, .overlap_change = 0, .falls = 6});
  const SlipAngle unknown =
      slip_angle(crane(), q, {.boom_length = 25, .suspended_weight = 32373, .overlap_change = 0, .falls = 6});
  EXPECT_TRUE(held.holds);
  EXPECT_TRUE(std::isnan(held.angle));
  EXPECT_FALSE(unknown.holds);
  EXPECT_TRUE(std::isnan(unknown.angle));
}

RC_GTEST_PROP(SlipAngle, LessOverlapHoldsSteeper, ()) {
  const double overlap_change = static_cast<double>(*rc::gen::inRange(0, 400)) / 1000;
  const double G_n = *rc::gen::inRange(1000, 40000);
  const SlipAngle a = slip_angle(
      crane(), {}, {.boom_length = 20, .suspended_weight = G_n, .overlap_change = overlap_change, .falls = 6});
  const SlipAngle b = slip_angle(
      crane(), {}, {.boom_length = 20, .suspended_weight = G_n, .overlap_change = overlap_change + 0.05, .falls = 6});
  RC_ASSERT(a.angle > b.angle);
  RC_ASSERT(a.angle >= a.free_angle);
}

}  // namespace taut::boom_ropes::slip_test
