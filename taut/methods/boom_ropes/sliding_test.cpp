#include "taut/methods/boom_ropes/sliding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "taut/math/degree.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"

namespace taut::boom_ropes::sliding_test {

SlidingPoint slid(const Sliding& q) {
  Sheet<double> s;
  SlidingPoint p;
  slide(printed_boom(), q, {}, s, p);
  return p;
}

double number(int low, int high) { return *rc::gen::inRange(low, high); }

Sliding anything() {
  const auto o = *rc::gen::element(Operation::lift, Operation::retract, Operation::extend);
  Sliding q = sliding_at(o, number(-10, 91), number(90, 211) / 10, number(0, 60000));
  q.S10 = calibrated_S10;
  q.S20 = calibrated_S20;
  if (*rc::gen::arbitrary<bool>()) {  // else the ropes pull through the axis, a path of its own
    q.offset_extension = number(-5, 6) / 100;
    q.offset_retraction = number(-5, 6) / 100;
  }
  q.offset_hoist = number(-20, 21) / 100;
  q.sheave_efficiency_1 = number(90, 101) / 100;
  q.sheave_efficiency_2 = number(90, 101) / 100;
  return q;
}

double lead_of(const Sliding& q) {
  const double G_n = q.suspended_weight[0];
  return q.operation == Operation::retract ? G_n * 0.95 / falls_of(q) : G_n / (falls_of(q) * 0.95);
}

double direction_of(const Sliding& q) { return q.operation == Operation::extend ? 1 : -1; }

RC_GTEST_PROP(BoomSliding, ForcesAndPadsBalance, ()) {
  const Sliding q = anything();
  const SlidingPoint p = slid(q);
  RC_PRE(p.ok());
  const double W = 8.44e3 + q.suspended_weight[0];
  const double scale = 1e-9 * (p.S1 + p.S2 + W + std::abs(p.Nf));
  const double friction = direction_of(q) * q.kinetic_friction * (std::abs(p.Nf) + std::abs(p.Nr));
  const double F = -lead_of(q) - W * std::sin(p.luffing_angle) - friction;
  RC_ASSERT(std::abs(2 * p.S1 - p.S2 + F) <= scale);
  RC_ASSERT(std::abs(p.Nf + p.Nr - W * std::cos(p.luffing_angle)) <= scale);
  RC_ASSERT(std::abs(p.Mf + p.Mr - (W + 12e3) * std::cos(p.luffing_angle)) <= scale + 1e-9 * std::abs(p.Mf));
  RC_ASSERT(p.S1 >= 0 && p.S2 >= 0);
}

/// Moments of the whole of sections 2 and 3 about the rear pads of 2, from the places of the forces in space: nothing
/// between the sections enters.
RC_GTEST_PROP(BoomSliding, SectionsTogetherBalanceInMoments, ()) {
  const Sliding q = anything();
  const SlidingPoint p = slid(q);
  RC_PRE(p.ok());
  const double d = direction_of(q);
  const double c = std::cos(p.luffing_angle);
  const double G_n = q.suspended_weight[0];
  const double travel = (q.boom_length[0] - 9) / 2;
  const double W = 8.44e3 + G_n;
  const double rear_3 = q.gap + travel;  // rear pads of 3 from those of 2
  const double r_1 = d > 0 ? 1 / q.sheave_efficiency_1 : q.sheave_efficiency_1;
  const double r_2 = d > 0 ? q.sheave_efficiency_2 : 1 / q.sheave_efficiency_2;
  const double weights = 12e3 * c * q.center_2 + 8.44e3 * c * (rear_3 + q.center_3) +
                         G_n * c * (rear_3 + q.head_distance) - q.offset_hoist * G_n * std::sin(p.luffing_angle);
  const double along = -q.offset_lead * lead_of(q) - 2 * q.offset_extension * r_1 * p.S1 +
                       q.offset_retraction * r_2 * p.S2 + q.offset_cylinder * p.Fh +
                       d * q.kinetic_friction * (q.pad_height_2 / 2) * (W + 12e3) * c;
  const double overlap = q.overlap_12 - travel;
  RC_ASSERT(std::abs(p.Mf * overlap - weights - along) <= 1e-8 * (std::abs(weights) + std::abs(p.Mf) + 1e4));
}

RC_GTEST_PROP(BoomSliding, FreeSheavesKeepTheWeightedSum, ()) {
  Sliding q = anything();
  q.sheave_efficiency_1 = q.sheave_efficiency_2 = 1;
  const SlidingPoint p = slid(q);
  RC_PRE(p.ok() && p.S1 > 0 && p.S2 > 0);
  const double kappa = q.retraction_stiffness / q.extension_stiffness;
  const double sum = kappa * *q.S10 + *q.S20;
  RC_ASSERT(std::abs(kappa * p.S1 + p.S2 - sum) <= 1e-12 * sum);
}

// The rope that the cases are calculated with is the rope that slides.
TEST(BoomSliding, ThePretensionIsThatOfTheInput) {
  Input in = printed_boom();
  Sliding q = sliding_at(Operation::extend, 52, 21, 32373);
  q.sheave_efficiency_1 = q.sheave_efficiency_2 = 1;
  const double kappa = q.retraction_stiffness / q.extension_stiffness;
  const auto sum = [&] {
    Sheet<double> s;
    SlidingPoint p;
    slide(in, q, {}, s, p);
    return kappa * p.S1 + p.S2;
  };
  EXPECT_NEAR(sum(), kappa * 95.5e3 + 187e3, 1);  // of the KS-55713-5K-1: none given
  in.S10 = 119e3;
  in.S20 = 238e3;
  EXPECT_NEAR(sum(), kappa * 119e3 + 238e3, 1);
  q.S20 = 200e3;  // its own comes first
  EXPECT_NEAR(sum(), kappa * 119e3 + 200e3, 1);
}

RC_GTEST_PROP(BoomSliding, WithoutLossesTheCylinderHoldsTwiceTheForce, ()) {
  Sliding q = anything();
  q.sheave_efficiency_1 = q.sheave_efficiency_2 = 1;
  q.kinetic_friction = 0;
  const SlidingPoint p = slid(q);
  RC_ASSERT(p.ok());
  const double F = -lead_of(q) - (8.44e3 + q.suspended_weight[0]) * std::sin(p.luffing_angle);
  const double expected = -2 * F + 12e3 * std::sin(p.luffing_angle);
  RC_ASSERT(std::abs(p.Fh - expected) <= 1e-9 * (p.S1 + p.S2 + std::abs(expected)));
}

RC_GTEST_PROP(BoomSliding, ForcesScale, ()) {
  Sliding q = anything();
  const SlidingPoint p = slid(q);
  Input in = printed_boom();
  in.section_weight *= 3;
  for (double* x : {q.suspended_weight.data(), &q.section2_weight, &*q.S10, &*q.S20, &q.extension_stiffness,
                    &q.retraction_stiffness}) {
    *x *= 3;
  }
  Sheet<double> s;
  SlidingPoint tripled;
  slide(in, q, {}, s, tripled);
  RC_ASSERT(p.ok() == tripled.ok());
  RC_PRE(p.ok());
  RC_ASSERT(std::abs(tripled.S1 - 3 * p.S1) <= 1e-9 * (p.S1 + p.S2));
  RC_ASSERT(std::abs(tripled.Fh - 3 * p.Fh) <= 1e-8 * (p.S1 + p.S2 + std::abs(p.Fh)));
}

RC_GTEST_PROP(BoomSliding, WrittenOutIsBitIdentical, ()) {
  Input in = printed_boom();
  in.sliding = anything();
  SlidingPoint plain;
  SlidingPoint written;
  Sheet<double> s;
  Sheet<Num> n("Reutov 2021", Input::describe(), &in);
  slide(in, *in.sliding, {}, s, plain);
  slide(in, *in.sliding, {}, n, written);
  RC_ASSERT(plain.reason == written.reason);
  RC_PRE(plain.ok());
  RC_ASSERT(plain.X == written.X && plain.S1 == written.S1 && plain.S2 == written.S2);
  RC_ASSERT(plain.Fh == written.Fh && plain.Mf == written.Mf && plain.Nr == written.Nr);
}

TEST(BoomSliding, RopesOnTheAxisAreTheLimitOfRopesOffIt) {
  Sliding q = sliding_at(Operation::extend, 19, 21, 32373);
  const SlidingPoint on = slid(q);
  q.offset_extension = 1e-9;
  q.offset_retraction = -1e-9;
  const SlidingPoint off = slid(q);
  EXPECT_NEAR(on.S1, off.S1, 1);
  EXPECT_NEAR(on.Nf, off.Nf, 1);
  EXPECT_NEAR(on.Fh, off.Fh, 1);
}

TEST(BoomSliding, SlackRetractionRopeLeavesTheRestToTheExtensionRope) {
  Sliding q = sliding_at(Operation::lift, 77, 9, 400e3);
  const SlidingPoint p = slid(q);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p.S2, 0);
  const double W = 408.44e3;
  EXPECT_NEAR(2 * p.S1, lead_of(q) + W * std::sin(77 * degree) - 0.15 * (std::abs(p.Nf) + std::abs(p.Nr)), 1e-3);
}

TEST(BoomSliding, SlackExtensionRopeLeavesTheRestToTheRetractionRope) {
  Sliding q = sliding_at(Operation::retract, 0, 21, 60e3);
  q.S10 = 0.5e3;
  q.S20 = 1e3;
  const SlidingPoint p = slid(q);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p.S1, 0);
  EXPECT_GT(p.S2, 0);
}

TEST(BoomSliding, OutsideTheStrokeHasAReason) {
  for (const double length : {8.9, 21.1}) {
    const SlidingPoint p = slid(sliding_at(Operation::extend, 30, length, 3e3));
    EXPECT_FALSE(p.ok());
    EXPECT_TRUE(std::isnan(p.Fh));
    EXPECT_NE(p.reason.find("9 ... 21 m"), std::string::npos);
  }
}

TEST(BoomSliding, RopesFarOffTheAxisJamSection3) {
  Sliding q = sliding_at(Operation::extend, 30, 21, 3e3);
  q.offset_extension = 6;  // 2 f z_1 > a
  const SlidingPoint p = slid(q);
  EXPECT_FALSE(p.ok());
  EXPECT_NE(p.reason.find("section 3 jams"), std::string::npos);
}

TEST(BoomSliding, CylinderFarOffTheAxisJamsSection2) {
  Sliding q = sliding_at(Operation::extend, 30, 21, 3e3);
  q.offset_cylinder = 9;  // 2 f z_c > A
  const SlidingPoint p = slid(q);
  EXPECT_FALSE(p.ok());
  EXPECT_NE(p.reason.find("section 2 jams"), std::string::npos);
  EXPECT_GT(p.S1, 0);
  EXPECT_TRUE(std::isnan(p.Fh));
}

TEST(BoomSliding, EightFallsWhenLiftingElseSix) {
  EXPECT_EQ(falls_of(sliding_at(Operation::lift, 0, 9, 0)), 8);
  EXPECT_EQ(falls_of(sliding_at(Operation::extend, 0, 9, 0)), 6);
  Sliding q = sliding_at(Operation::lift, 0, 9, 0);
  q.falls = 4;
  EXPECT_EQ(falls_of(q), 4);
}

}  // namespace taut::boom_ropes::sliding_test
