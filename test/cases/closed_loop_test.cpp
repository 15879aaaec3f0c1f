#include "taut/methods/closed_loop/closed_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "test/cases/closed_loop_example.hpp"

// Every number of the paper's example, as published where it holds and as re-derived where it does not.

namespace taut::closed_loop::closed_loop_test {

using namespace taut_test;

TEST(ClosedLoop, ResolvesTheGatheringForce) {
  const Output out = solved(example());
  EXPECT_NEAR(out.P / kgf, 2598.08, 0.01);
  EXPECT_NEAR(out.K / kgf, 1500.00, 0.01);
}

TEST(ClosedLoop, Equation4SubtractsTwiceTheSagNotTheSpan) {
  const Output out = solved(example());
  EXPECT_NEAR(out.P_b_no_weight / kgf, 1159.6, 0.1);
  EXPECT_NEAR(out.P_b_no_weight / kgf, 1160, 0.5);  // as published
  EXPECT_NEAR(out.P_b_4_printed / kgf, -190, 0.5);  // as printed: no load a rope could carry
}

TEST(ClosedLoop, LoadOfTheUpperBranchWithWeights) {
  const Output out = solved(example());
  EXPECT_NEAR(out.P_b / kgf, 1166.19, 0.01);
}

TEST(ClosedLoop, TensionsAtMidspan) {
  const Output out = solved(example());
  EXPECT_NEAR(out.T_b / kgf, 6331.0, 0.1);
  EXPECT_NEAR(out.T_n / kgf, 8534.4, 0.1);
  EXPECT_NEAR(out.T_lA_paper / kgf, 8534.4, 0.1);
  EXPECT_NEAR(200.0 * 200 / (8 * 10) * (1 + 2 * out.P_b_no_weight / kgf / 200), 6298.1, 0.1);  // (5) with (4)
}

TEST(ClosedLoop, CoefficientsOfTheExampleSystem) {
  // (11)/(14): T_B2 = a P_b + b, in kgf, for one section.
  const auto T_B2 = [](double P_b) { return 100.0 * 100 / (2 * 10) * (2 * P_b / 200 + 1) / 0.9; };
  EXPECT_NEAR(T_B2(1) - T_B2(0), 5.5556, 1e-4);
  EXPECT_NEAR(T_B2(0), 555.56, 0.005);
  // (12): (C2 - A2 P_b)/f_2 - C3.
  const double P = 3000 * std::cos(30 * degree);
  EXPECT_NEAR(100.0 * 100 / 2 * (2 * P / 200 + (200 + 100 * 0.5) / 200), 136153.8, 0.1);
  EXPECT_NEAR(100.0 * 100 / 2 * 2 * (1 - 3.0 / 100) / 200, 48.5, 1e-9);
  EXPECT_NEAR(100.0 * 100 / 2 * 2 * (1500.0 / 100) / 200, 750, 1e-9);
  // (13) as printed: C4/delta_f - C5, with and without its cos(alpha_1).
  const double cos_1 = std::cos(std::atan(10.0 / 100));
  EXPECT_NEAR(3 * 97 / (2 * cos_1) * (2 * P / 100 + 1 / cos_1), 7745.1, 0.1);
  EXPECT_NEAR(3 * 97 / 2.0 * (2 * P / 100 + 1), 7705.9, 0.1);
  EXPECT_NEAR(3 * 97 / 2.0 * 2 * 1500 / 3 / 100, 1455.0, 0.1);
}

TEST(ClosedLoop, TwoSectionSystemAsPrinted) {
  const Output out = solved(two_section_example());
  EXPECT_NEAR(out.P_b_printed / kgf, 1114.97, 0.005);
  EXPECT_NEAR(out.delta_f_printed, 0.94396, 5e-6);
}

TEST(ClosedLoop, TwoSectionSystemCorrected) {
  Input in = two_section_example();
  Output out = solved(in);
  EXPECT_NEAR(out.P_b / kgf, 1134.10, 0.0005 * 1134);
  EXPECT_NEAR(out.P_b / kgf, 1134.10, 0.005);
  EXPECT_NEAR(out.delta_f, 0.9798, 0.00005);
  in.position_of = Section::second;
  out = solved(in);
  EXPECT_NEAR(out.P_b / kgf, 1132.55, 0.005);
  EXPECT_NEAR(out.delta_f, 0.9813, 0.00005);
  in.sag_of = Section::second;
  out = solved(in);
  EXPECT_NEAR(out.P_b / kgf, 1137.03, 0.005);
  EXPECT_NEAR(out.delta_f, 0.9221, 0.00005);
}

TEST(ClosedLoop, TwoSectionTierIsCloseToExactCatenaries) {
  Input in = two_section_example();
  Output out = solved(in);
  EXPECT_NEAR(out.P_b_closed / kgf, 1134.84, 0.0005 * 1134.84);
  EXPECT_NEAR(out.delta_f_closed, 0.980, 0.001);  // 0.05 % and the last digit printed
  in.position_of = Section::second;
  out = solved(in);
  EXPECT_NEAR(out.P_b_closed / kgf, 1132.88, 0.0005 * 1132.88);
  EXPECT_NEAR(out.delta_f_closed, 0.981, 0.001);  // 0.05 % and the last digit printed
  in.sag_of = Section::second;
  out = solved(in);
  EXPECT_NEAR(out.P_b_closed / kgf, 1137.33, 0.0005 * 1137.33);
  EXPECT_NEAR(out.delta_f_closed, 0.922, 0.001);  // 0.05 % and the last digit printed
}

Input sized() {
  Input in = example();
  in.safety_factor = 3.5;
  in.wire_strength = 140 * kgf_per_mm2;
  in.weight_per_area = 0.01 * kgf / mm2;
  return in;
}

TEST(ClosedLoop, AreasOfTheExample) {
  const Output out = solved(sized());
  EXPECT_NEAR(out.F_return_paper / mm2, 165.7, 0.1657);
  EXPECT_NEAR(out.F_traction_paper / mm2, 222.8, 0.2228);
  EXPECT_NEAR(out.F_return / mm2, 187.0, 0.187);
  EXPECT_NEAR(out.F_traction / mm2, 224.3, 0.2243);
}

TEST(ClosedLoop, Equation8UndersizesTheReturnRope) {
  const Input in = sized();
  const Output first = solved(in);
  Input own = in;
  own.return_weight = in.weight_per_area * first.F_return_paper;
  own.traction_weight = in.weight_per_area * first.F_traction_paper;
  const Output out = solved(own);
  EXPECT_NEAR(*in.wire_strength * first.F_return_paper / out.T_lB, 3.12, 0.00312);
}

TEST(ClosedLoop, FreeRunningSag) {
  Input in = example();
  in.mode = Mode::free_running;
  in.sag.reset();
  const Output out = solved(in);
  EXPECT_NEAR(out.f, 22.3, 0.05);  // exact catenaries: 22.3 m
  EXPECT_NEAR(out.T_lLB / kgf, 3000, 1e-6);
}

}  // namespace taut::closed_loop::closed_loop_test
