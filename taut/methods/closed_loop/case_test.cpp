#include "taut/methods/closed_loop/case.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::case_test {

using namespace taut_test;

Case<double> case_of(const Input& in) {
  Sheet<double> s;
  return make_case(in, {.x = in.position.data(), .q_b = *in.return_weight, .q_T = *in.traction_weight}, s);
}

TEST(ClosedLoopCase, HeightDifferenceStandsForTheSlope) {
  Input by_slope = example();
  by_slope.slope = -12 * degree;
  Input by_height = example();
  by_height.height_difference = 200 * std::tan(-12 * degree);
  const auto a = case_of(by_slope);
  const auto b = case_of(by_height);
  EXPECT_NEAR(a.m, b.m, 1e-15);
  EXPECT_NEAR(a.cos_a, b.cos_a, 1e-15);
  EXPECT_FALSE(b.downhill);
}

TEST(ClosedLoopCase, AngleFromTheHorizontalIsTheComplement) {
  Input in = example();
  in.gathering_angle = 60 * degree;
  in.gathering_angle_from = AngleFrom::horizontal;
  EXPECT_NEAR(case_of(in).sin_g, 0.5, 1e-15);
}

TEST(ClosedLoopCase, SheavesMultiplyAndOutHaulInverts) {
  Input in = example();
  in.tail_sheaves = 3;
  EXPECT_DOUBLE_EQ(case_of(in).eta, std::pow(0.9, 3));
  in.haul = Haul::out;
  EXPECT_DOUBLE_EQ(case_of(in).eta, 1 / std::pow(0.9, 3));
}

TEST(ClosedLoopCase, WithoutAPositionTheCarriageIsAtMidspan) {
  Input in = example();
  Sheet<double> s;
  const auto c = make_case(in, {.x = nullptr, .q_b = 1, .q_T = 1}, s);
  EXPECT_EQ(c.x, 100);
  EXPECT_TRUE(c.midspan);
  in.position = {100.001};
  EXPECT_FALSE(case_of(in).midspan);
}

TEST(ClosedLoopCase, WeightsPerHorizontalMetreGrowWithTheSlope) {
  Input in = example();
  in.slope = 60 * degree - 1e-9;
  EXPECT_NEAR(case_of(in).w_b, 2 * kgf, 1e-6);
}

}  // namespace taut::closed_loop::case_test
