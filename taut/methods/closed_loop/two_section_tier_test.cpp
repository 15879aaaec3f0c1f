#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "taut/methods/closed_loop/two_section.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::two_section_tier_test {

using namespace taut_test;

Input drawn() {
  Input in = two_section_example();
  in.slope = *rc::gen::inRange(-20, 21) * degree;
  in.position = {static_cast<double>(*rc::gen::inRange(40, 161))};
  in.sag = *rc::gen::inRange(30, 150) * 0.1;
  in.section_distance = *rc::gen::inRange(1, 10);
  in.gathering_angle = *rc::gen::inRange(5, 40) * degree;
  in.carriage_weight = *rc::gen::inRange(0, 3) * 700.0;
  in.roller = *rc::gen::element(Roller::free, Roller::vertical);
  return in;
}

TEST(ClosedLoopTwoSectionTier, NearSectionsAreOneCarriage) {
  for (double alpha : {-20.0, 0.0, 15.0}) {
    const auto [two, one] = near_sections(alpha * degree);
    const Output a = solved(two), b = solved(one);
    EXPECT_NEAR(a.N, b.N, 1e-4 * b.N);
    EXPECT_NEAR(a.T_uA, b.T_uA, 1e-4 * b.T_uA);
    EXPECT_NEAR(a.T_uB, b.T_uB, 1e-4 * b.T_uB);
    EXPECT_NEAR(a.T_lA, b.T_lA, 1e-4 * b.T_lA);
    EXPECT_NEAR(a.T_lB, b.T_lB, 1e-4 * b.T_lB);
  }
}

RC_GTEST_PROP(ClosedLoopTwoSectionTier, BothSectionsAreInEquilibrium, ()) {
  const Input in = drawn();
  Output o;
  RC_PRE(solve(in, o).ok());
  const double m = std::tan(in.slope);
  const double cos_a = std::cos(in.slope);
  const double w_b = *in.return_weight / cos_a;
  const double w_T = *in.traction_weight / cos_a;
  const double d = o.x_2 - o.x_1;
  const double S_x = in.gathering_force * std::sin(in.gathering_angle);
  const double S_y = in.gathering_force * std::cos(in.gathering_angle);
  const double left = m - o.f_1 / o.x_1 + w_T * o.x_1 / (2 * o.H_1);
  const double right = m + o.f_2 / (200 - o.x_2) - w_b * (200 - o.x_2) / (2 * o.H_2);
  const double sum_y = o.H_2 * right - o.H_1 * left - S_y - in.carriage_weight + o.P_v - w_b * d;
  RC_ASSERT(std::abs(sum_y) < 1e-7 * o.H_1);
  RC_ASSERT(std::abs(o.H_2 - o.H_1 + S_x - o.P_v * std::tan(o.phi)) < 1e-7 * o.H_1);
  // Section 2 alone, with the parabola between the sections.
  const double H_12 = o.H_2 + S_x;
  const double slope_12 = m - (o.f_2 - o.f_1) / d + w_b * d / (2 * H_12);
  RC_ASSERT(std::abs(o.H_2 * right - H_12 * slope_12 - S_y) < 1e-7 * o.H_1);
  RC_ASSERT(std::abs(o.T_uB - 0.9 * o.T_lB) < 1e-9 * o.T_lB);
}

}  // namespace taut::closed_loop::two_section_tier_test
