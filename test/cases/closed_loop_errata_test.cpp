#include <gtest/gtest.h>

#include <cmath>

#include "taut/math/roots.hpp"
#include "test/cases/closed_loop_cases.hpp"

// The paper's mistakes shown wrong by witnesses that do not come from the paper: moments of a thread, energy,
// catenaries.

namespace taut::closed_loop::closed_loop_errata_test {

using namespace closed_loop_cases;

TEST(ClosedLoopErrata, Equation1BalancesBothBranches) {
  for (const LoopCase& c : assorted()) {
    const Output o = solved(c);
    const double cos_a = std::cos(std::atan(c.m));
    const double T_B2 = lower_branch_H2(c, o.P, o.K, o.P_b) / cos_a;
    const double upper_moment = o.P_b * c.x * (c.l - c.x) / c.l + c.q_b / cos_a * c.x * (c.l - c.x) / 2;
    EXPECT_NEAR(upper_moment / c.f / cos_a, c.eta * T_B2, 1e-9 * T_B2);
    EXPECT_NEAR(o.T_b, c.eta * T_B2, 1e-9 * T_B2);
    EXPECT_NEAR(o.T_n, T_B2 + o.K, 1e-9 * T_B2);
  }
  LoopCase c;
  c.eta = 1;
  c.q_T = c.q_b;
  const Output o = solved(c);
  EXPECT_NEAR(o.P_b, (o.P - o.K * c.f / c.x) / 2, 1e-9 * o.P);
}

TEST(ClosedLoopErrata, Equation6FollowsTheRopeOverTheSheave) {
  LoopCase c;
  const Output o = solved(c);
  const LoopForces e = exact(c, o);
  EXPECT_NEAR(o.T_n, e.T_lA, 0.01 * e.T_lA);
  EXPECT_GT(std::abs(o.T_n_printed / e.T_lA - 1), 0.035);  // S cos(gamma) in place of S sin(gamma)
  EXPECT_LT((o.T_b + o.K) / e.T_lA, 0.93);                 // T_b not divided by eta: unsafe
  c.gamma = 60 * degree;
  const Output flat = solved(c);
  EXPECT_LT(flat.T_n_printed / exact(c, flat).T_lA, 0.8);
}

TEST(ClosedLoopErrata, Equation9AgreesWithTheLevelChord) {
  LoopCase c;
  const Output o = solved(c);
  const double H_1 = lower_branch_H2(c, o.P, o.K, o.P_b) + c.S * std::sin(c.gamma);
  EXPECT_NEAR(o.T_lA_paper, H_1, 1e-9 * H_1);
  EXPECT_LT(o.T_lA_printed, 0.4 * H_1);
}

TEST(ClosedLoopErrata, Equations8And10MakeTensionTimesSafetyTheStrength) {
  for (double alpha : {-20.0, 0.0, 15.0}) {
    LoopCase c;
    c.m = std::tan(alpha * degree);
    Input in = input_of(c);
    in.safety_factor = 3.5;
    in.wire_strength = 140e6;  // 140 per mm2, weights 0.01 per m and mm2
    in.weight_per_area = 0.01e6;
    Output o;
    ASSERT_TRUE(solve(in, o).ok());
    const double a = std::abs(alpha) * degree;
    const double cos_a = std::cos(a);
    const double up = 1;  // the end slope at the upper support
    const double P_b = o.P_b_no_weight;
    const double q_b = in.weight_per_area * o.F_return_paper;
    const double H = c.l * c.l / (8 * c.f) * (q_b / cos_a + 2 * P_b / c.l);
    const double V = P_b / 2 + q_b / cos_a * c.l / 2;
    EXPECT_NEAR(3.5 * (H / cos_a + up * std::sin(a) * V), *in.wire_strength * o.F_return_paper, 1e-6 * 3.5 * H);
    LoopCase own = c;
    own.q_b = q_b;
    own.q_T = in.weight_per_area * o.F_traction_paper;
    const double H_1 = lower_branch_H2(own, o.P, o.K, P_b) + c.S * std::sin(c.gamma);
    const double V_A = H_1 * c.f / c.x + own.q_T / cos_a * c.x / 2;
    EXPECT_NEAR(3.5 * (H_1 / cos_a - std::sin(alpha * degree) * V_A), *in.wire_strength * o.F_traction_paper,
                1e-6 * 3.5 * H_1);
  }
}

TEST(ClosedLoopErrata, FreeRollerPullsTheLoadUpTheSlope) {
  // No friction, load straight down: moving it along the chord by s raises it by s sin(alpha), and the winches give
  // (T_lA - T_uA) s. The paper's formulas give no net pull at all.
  for (double alpha : {-30.0, -15.0, 15.0, 30.0}) {
    LoopCase c;
    c.m = std::tan(alpha * degree);
    c.gamma = 0;
    c.eta = 1;
    c.q_b = c.q_T = 1e-6;
    c.f = 4;
    const Output o = solved(c);
    const double net = -o.P * std::sin(alpha * degree);
    EXPECT_NEAR(o.T_lA - o.T_uA, net, 0.002 * std::abs(net)) << alpha;
    const double T_uA_paper = o.T_b - std::sin(alpha * degree) * o.P_b / 2;
    EXPECT_NEAR(o.T_lA_paper - T_uA_paper, 0, 1e-3 * std::abs(net)) << alpha;
    const LoopForces e = exact(c, o);
    EXPECT_NEAR(e.T_lA - e.T_uA, net, 0.002 * std::abs(net)) << alpha;
    EXPECT_NEAR(o.T_lA_paper - o.P_b * std::sin(alpha * degree), e.T_lA, 0.01 * e.T_lA) << alpha;
  }
}

TEST(ClosedLoopErrata, TwoSectionSystemAgreesWithCatenaries) {
  LoopCase c;
  c.d = 3;
  const Output o = solved(c);
  const LoopForces e = exact(c, o);
  EXPECT_NEAR(e.P_b, 1134.84, 0.0005 * 1134.84);
  const double delta_f = c.m * o.x_2 - (c.f * (o.x_2 - c.l) / (c.x - c.l)) - e.y2;
  EXPECT_NEAR(delta_f, 0.980, 0.0005);
  EXPECT_NEAR(o.P_b, e.P_b, 0.001 * e.P_b);
  EXPECT_NEAR(o.delta_f, delta_f, 0.001 * delta_f);
  EXPECT_GT(std::abs(o.P_b_printed / e.P_b - 1), 0.015);
  EXPECT_GT(std::abs(o.delta_f_printed / delta_f - 1), 0.03);
}

TEST(ClosedLoopErrata, PublishedTwoSectionAnswerSolvesNothing) {
  const auto line_1 = [](double P_b) { return 5.5 * P_b + 550; };
  const auto line_2 = [](double P_b, double df) { return (13.6e4 - 48.5 * P_b) / (10 + df) - 750; };
  const auto line_3 = [](double df) { return 700 / df - 14.5e3; };
  EXPECT_NEAR(line_1(1230), 7315, 0.5);
  EXPECT_NEAR(line_2(1230, 0.097), 6811, 0.5);
  EXPECT_NEAR(line_3(0.097), -7284, 1);
  const auto P_b_of = [](double df) { return ((13.6e4 / (10 + df) - 750) - 550) / (5.5 + 48.5 / (10 + df)); };
  const auto printed = find_root([&](double df) { return line_1(P_b_of(df)) - line_3(df); }, 1e-3, 1);
  ASSERT_TRUE(printed);
  EXPECT_NEAR(*printed, 0.03245, 5e-6);
  EXPECT_NEAR(P_b_of(*printed), 1185.95, 0.005);
  const auto repaired = find_root([&](double df) { return line_1(P_b_of(df)) - (7700 / df - 1450); }, 1e-3, 10);
  ASSERT_TRUE(repaired);
  EXPECT_NEAR(*repaired, 0.943, 0.0005);
  EXPECT_NEAR(P_b_of(*repaired), 1120.4, 0.05);
}

TEST(ClosedLoopErrata, SectionAheadLowersTheLoad) {
  LoopCase single;
  LoopCase two = single;
  two.d = 3;
  const Output a = solved(single);
  const Output b = solved(two);
  EXPECT_LT(b.P_b - a.P_b, -28);
  EXPECT_GT(b.P_b - a.P_b, -33);
  const LoopForces e_a = exact(single, a);
  two.x = 97;  // the load stays at midspan
  const LoopForces e_b = exact(two, solved(two));
  EXPECT_NEAR(e_b.T_uB / e_a.T_uB - 1, -0.027, 0.001);
}

}  // namespace taut::closed_loop::closed_loop_errata_test
