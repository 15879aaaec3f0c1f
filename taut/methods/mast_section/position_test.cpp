#include "taut/methods/mast_section/position.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/math/degree.hpp"

namespace taut::mast_section::position_test {

Input yarder() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.allowable_stress = 160e6;
  Span span;
  span.length = 300;
  span.chord_slope = 8 * degree;
  span.carriage_position = {10, 75, 150, 290};
  span.rope_weight = 18;
  span.load = 20e3;
  span.horizontal_tension = 90e3;
  in.span = span;
  return in;
}

// (11) at midspan without slope: q l^2 / 8 H + Q l / 4 H.
TEST(MastSectionPosition, SagAtMidspan) {
  Input in = yarder();
  in.span->chord_slope = 0;
  Sheet<double> s;
  Output out;
  ASSERT_TRUE(compute_at(in, 2, s, out).ok());
  EXPECT_NEAR(out.f_x, 18.0 * 300 * 300 / (8 * 90e3) + 20e3 * 300 / (4 * 90e3), 1e-12);
  EXPECT_NEAR(out.alpha, std::atan(out.f_x / 150), 1e-15);
}

// The branch points from the block to the carriage, which hangs f_x below the chord.
TEST(MastSectionPosition, BranchPointsToTheCarriage) {
  const Input in = yarder();
  for (const Position& p : sweep(in)) {
    ASSERT_TRUE(p.outcome.ok());
    const double drop = p.out.f_x + p.out.x * std::tan(8 * degree);
    EXPECT_NEAR(std::tan(p.out.alpha), drop / p.out.x, 1e-14);
  }
}

TEST(MastSectionPosition, LargestSizeGoverns) {
  const Input in = yarder();
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  double D = 0, b = 0, worst = 0;
  for (const Position& p : sweep(in)) {
    D = std::max(D, p.out.D_tube);
    worst = std::max(worst, p.out.D_tube_worst);
    b = std::max(b, p.out.b_square);
  }
  EXPECT_EQ(out.D_tube, D);
  EXPECT_EQ(out.D_tube_worst, worst) << "each from the position that governs it";
  EXPECT_GT(worst, D);
  EXPECT_EQ(out.b_square, b);
  EXPECT_EQ(out.x, 290) << "the flattest branch bends most";
}

// On a low mast N weighs as much as M: kinds of section may then be governed by different positions.
TEST(MastSectionPosition, KindsMayHaveDifferentGoverningPositions) {
  Input in = yarder();
  in.skyline_block_height = 0.06;
  in.tube_ratio = 0.97;
  in.span->chord_slope = -30 * degree;
  in.span->carriage_position.clear();
  in.span->horizontal_tension = 9e3;
  for (int i = 1; i <= 300; ++i) in.span->carriage_position.push_back(i);
  const Governing g = governing_of(sweep(in));
  ASSERT_TRUE(g.outcome.ok());
  EXPECT_NE(g.of[0], g.of[1]);
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  double b = 0;
  for (const Position& p : sweep(in)) {
    if (p.outcome.ok()) b = std::max(b, p.out.b_square);
  }
  EXPECT_EQ(out.b_square, b);
}

TEST(MastSectionPosition, TooSteepIsInfeasibleWithItsAngle) {
  Input in = yarder();
  in.span->horizontal_tension = 1;
  Output out;
  const Outcome outcome = solve(in, out);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_NE(outcome.message.find("branch angle"), std::string::npos);
  EXPECT_TRUE(std::isnan(out.N));
  EXPECT_GT(out.alpha, 85 * degree);
}

TEST(MastSectionPosition, OneFeasiblePositionIsEnough) {
  Input in = yarder();
  in.span->chord_slope = 0;
  in.span->rope_weight = 0;
  in.span->load = 1e6;
  in.span->horizontal_tension = 80e3;
  in.span->carriage_position = {1, 299};
  Output out;
  EXPECT_TRUE(solve(in, out).ok());
  in.span->horizontal_tension = 5e3;  // near the mast 89.7 deg, at the far end 34 deg
  out = {};
  EXPECT_TRUE(solve(in, out).ok());
  EXPECT_EQ(out.x, 299);
}

TEST(MastSectionPosition, LimitsOfTheAngleAreIncluded) {
  Input in = yarder();
  in.span.reset();
  Output out;
  for (const double angle : {-60.0, 85.0}) {
    in.branch_angle = angle * degree;
    EXPECT_TRUE(solve(in, out).ok());
  }
  EXPECT_TRUE(Input::describe().find("branch_angle")->range.contains(-60 * degree));
}

TEST(MastSectionPosition, SteelGivesTheYieldOfItsThinnestRange) {
  Input in = yarder();
  in.allowable_stress.reset();
  in.steel = "S355";
  in.safety = 2;
  EXPECT_DOUBLE_EQ(allowable_stress(in), 177.5e6);
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_DOUBLE_EQ(out.sigma_allow, 177.5e6);
}

}  // namespace taut::mast_section::position_test
