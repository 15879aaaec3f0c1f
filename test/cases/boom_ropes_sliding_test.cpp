// The quasi-static reference model ("QS") of the boom: rope tensions, cylinder forces, slip angles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/methods/boom_ropes/slip.hpp"

namespace boom_ropes_sliding_test {

using namespace taut::boom_ropes;

constexpr double degree = std::numbers::pi / 180;
constexpr double tonne = 9.81e3;
constexpr double last_digit = 0.05e3;  // the reference prints tenths of a kN

Input crane() {
  Input in = printed_boom();
  return in;
}

SlidingPoint point(Operation operation, double angle, double length, double mass) {
  Sliding q;
  q.operation = operation;
  q.luffing_angle = {angle * degree};
  q.boom_length = {length};
  q.suspended_weight = {mass * tonne};
  taut::Sheet<double> s;
  SlidingPoint p;
  EXPECT_TRUE(slide(crane(), q, {}, s, p).ok());
  return p;
}

struct Row {
  Operation operation;
  double angle, length, mass, S1, S2;
};

class BoomRopesTable2 : public testing::TestWithParam<Row> {};

TEST_P(BoomRopesTable2, Tensions) {
  const Row& r = GetParam();
  const SlidingPoint p = point(r.operation, r.angle, r.length, r.mass);
  EXPECT_NEAR(p.S1, r.S1 * 1e3, last_digit);
  EXPECT_NEAR(p.S2, r.S2 * 1e3, last_digit);
}

INSTANTIATE_TEST_SUITE_P(
    QuasiStatic, BoomRopesTable2,
    testing::Values(Row{Operation::extend, 0, 9, 0, 95.2, 189.2}, Row{Operation::lift, 77, 9, 30.25, 175.5, 24.9},
                    Row{Operation::lift, 77, 9, 25.3, 162.5, 50.9}, Row{Operation::extend, 52, 9, 3.3, 105.0, 168.4},
                    Row{Operation::extend, 52, 21, 3.3, 111.3, 150.9}, Row{Operation::extend, 19, 9, 3.3, 100.9, 177.1},
                    Row{Operation::extend, 19, 21, 3.3, 111.2, 151.1},
                    Row{Operation::retract, 19, 21, 3.3, 86.9, 207.0},
                    Row{Operation::retract, 19, 12.2, 3.3, 97.0, 183.4}));

struct Curve {
  double angle, mass;
  double Fh[5];  // at 9, 12, 15, 18, 21 m
};

class BoomRopesCylinder : public testing::TestWithParam<Curve> {};

TEST_P(BoomRopesCylinder, ForceWhileExtending) {
  for (int i = 0; i < 5; ++i) {
    const SlidingPoint p = point(Operation::extend, GetParam().angle, 9 + 3 * i, GetParam().mass);
    EXPECT_NEAR(p.Fh, GetParam().Fh[i] * 1e3, last_digit) << 9 + 3 * i << " m";
  }
}

INSTANTIATE_TEST_SUITE_P(QuasiStatic, BoomRopesCylinder,
                         testing::Values(Curve{19, 3.3, {62.8, 66.7, 79.3, 103.2, 166.4}},
                                         Curve{52, 3.3, {101.4, 103.2, 111.3, 126.4, 166.7}},
                                         Curve{76, 3.3, {113.3, 113.6, 115.9, 121.4, 136.1}},
                                         Curve{19, 0.3, {25.0, 24.9, 25.7, 31.6, 46.7}},
                                         Curve{52, 0.3, {39.3, 39.3, 39.4, 43.1, 52.7}},
                                         Curve{76, 0.3, {43.7, 43.7, 43.7, 44.6, 47.9}}));

TEST(BoomRopesPublished, LargestCylinderForces) {
  EXPECT_NEAR(point(Operation::extend, 52, 21, 3.3).Fh, 161.5e3, 0.04 * 161.5e3);
  EXPECT_NEAR(point(Operation::extend, 76, 21, 3.3).Fh, 136.5e3, 0.03 * 136.5e3);
  EXPECT_GT(point(Operation::extend, 52, 21, 3.3).Fh, point(Operation::extend, 76, 21, 3.3).Fh);
}

TEST(BoomRopesPublished, ExtremeTensions) {
  const SlidingPoint test = point(Operation::lift, 77, 9, 30.25);
  const SlidingPoint retracting = point(Operation::retract, 19, 21, 3.3);
  for (const double length : {9.0, 15.0, 21.0}) {
    for (const double angle : {19.0, 52.0, 76.0}) {
      for (const Operation o : {Operation::extend, Operation::retract}) {
        const SlidingPoint p = point(o, angle, length, 3.3);
        EXPECT_LT(p.S1, test.S1);
        EXPECT_GT(p.S2, test.S2);
        EXPECT_GE(p.S1, retracting.S1);
        EXPECT_LE(p.S2, retracting.S2);
      }
    }
  }
}

/// Row 1, Table 2 as published; rows 2 and 3 have S2 within 10 and 4 kN only when the load overshoots (see the docs).
TEST(BoomRopesPublished, TensionsOfTheMovingBoom) {
  const auto near = [](const SlidingPoint& p, double S1, double S2, double tolerance_1, double tolerance_2) {
    EXPECT_NEAR(p.S1, S1 * 1e3, tolerance_1 * S1 * 1e3);
    EXPECT_NEAR(p.S2, S2 * 1e3, tolerance_2 * S2 * 1e3);
  };
  near(point(Operation::extend, 0, 9, 0), 95.5, 181, 0.02, 0.05);
  near(point(Operation::extend, 52, 9, 3.3), 105, 168, 0.02, 0.02);
  near(point(Operation::extend, 52, 21, 3.3), 114, 156, 0.04, 0.04);
  near(point(Operation::extend, 19, 9, 3.3), 104, 174, 0.04, 0.03);
  near(point(Operation::extend, 19, 21, 3.3), 113, 159, 0.04, 0.06);
  near(point(Operation::retract, 19, 12.2, 3.3), 100, 186, 0.04, 0.03);
}

TEST(BoomRopesPublished, JammingStartsAtThePublishedLengths) {
  const auto first = [](double angle, double mass) {
    double length = 9;
    while (!point(Operation::extend, angle, length, mass).jamming()) length += 0.01;
    return length;
  };
  EXPECT_NEAR(first(19, 0.3), 14.7, 0.06);
  EXPECT_NEAR(first(52, 0.3), 14.7, 0.06);
  EXPECT_NEAR(first(19, 3.3), 10.2, 0.06);
  EXPECT_NEAR(first(52, 3.3), 10.2, 0.06);
}

TEST(BoomRopesPublished, FrictionGrowsOnceAnUpperPadCarries) {
  const auto friction = [](double length) {
    const SlidingPoint p = point(Operation::extend, 19, length, 0.3);
    return std::abs(p.Nf) + std::abs(p.Nr);
  };
  EXPECT_NEAR(friction(9), friction(14), 1e-6);
  EXPECT_GT(friction(16), friction(14) + 1);
  EXPECT_GT(friction(21), friction(16) + 1);
}

struct SlipRow {
  double length, mass, overlap_change, angle;
};

class BoomRopesSlip : public testing::TestWithParam<SlipRow> {};

TEST_P(BoomRopesSlip, AngleAfterTheJerk) {
  const SlipRow& r = GetParam();
  const SlipAngle a = slip_angle(
      crane(), {},
      {.boom_length = r.length, .suspended_weight = r.mass * tonne, .overlap_change = r.overlap_change, .falls = 6});
  EXPECT_NEAR(a.angle / degree, r.angle, 0.05);
  EXPECT_TRUE(a.jamming);
}

INSTANTIATE_TEST_SUITE_P(QuasiStatic, BoomRopesSlip,
                         testing::Values(SlipRow{21, 0.3, 0.4, 30.4}, SlipRow{21, 3.3, 0.2, 45.1},
                                         SlipRow{17, 0.3, 0.57, 8.8}, SlipRow{17, 3.3, 0.3, 15.8},
                                         SlipRow{21, 0.3, -0.34, 48.9}, SlipRow{21, 3.3, -0.2, 55.0}));

}  // namespace boom_ropes_sliding_test
