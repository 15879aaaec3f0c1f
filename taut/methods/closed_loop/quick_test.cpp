#include "taut/methods/closed_loop/quick.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::quick_test {

using namespace taut_test;

Case<double> case_of(const Input& in) {
  Sheet<double> s;
  auto c = make_case(in, {.x = in.position.data(), .q_b = *in.return_weight, .q_T = *in.traction_weight}, s);
  c.f = *in.sag;
  return c;
}

Input drawn() {
  Input in = example();
  in.slope = *rc::gen::inRange(-300, 301) * 0.1 * degree;
  in.position = {static_cast<double>(*rc::gen::inRange(30, 171))};
  in.sag = *rc::gen::inRange(20, 200) * 0.1;
  in.gathering_angle = *rc::gen::inRange(0, 40) * degree;
  in.tail_efficiency = *rc::gen::inRange(60, 101) / 100.0;
  in.carriage_weight = *rc::gen::inRange(0, 3) * 700.0;
  in.haul = *rc::gen::element(Haul::in, Haul::out);
  in.roller = *rc::gen::element(Roller::free, Roller::vertical);
  return in;
}

TEST(ClosedLoopQuick, TanOfTheMeanAngleNeedsNoArcs) {
  for (double a : {-2.0, -0.3, 0.0, 0.7, 5.0}) {
    for (double b : {-4.0, 0.0, 0.1, 3.0}) {
      EXPECT_NEAR(tan_of_mean(a, b), std::tan((std::atan(a) + std::atan(b)) / 2), 1e-12);
    }
  }
}

TEST(ClosedLoopQuick, VerticalRollerPressesStraightDown) {
  Input in = example();
  in.slope = 20 * degree;
  in.roller = Roller::vertical;
  const auto q = quick(case_of(in));
  ASSERT_TRUE(q);
  EXPECT_EQ(q->N, q->P_v);
  EXPECT_EQ(q->H_3, q->H_4);
  in.roller = Roller::free;
  const auto free = quick(case_of(in));
  ASSERT_TRUE(free);
  EXPECT_GT(free->N, free->P_v);
  EXPECT_GT(free->H_3, free->H_4);  // pushed toward B, the higher end
}

TEST(ClosedLoopQuick, WeightlessRopesAreStraight) {
  // Two unknown tensions per node of straight ropes; the free roller keeps the tension of the upper one.
  Input in = example();
  in.slope = 10 * degree;
  in.position = {70};
  in.return_weight = 1e-9;
  in.traction_weight = 1e-9;
  const auto c = case_of(in);
  const auto q = quick(c);
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->T_uA, q->T_uB, 1e-6 * q->T_uB);
  EXPECT_NEAR(q->T_uB, 0.9 * q->T_lB, 1e-6 * q->T_uB);
  const double left = std::atan(c.m - c.f / c.x);
  const double right = std::atan(c.m + c.f / c.y);
  const double R_x = q->T_uB * (std::cos(right) - std::cos(left));
  const double R_y = q->T_uB * (std::sin(right) - std::sin(left));
  EXPECT_NEAR(q->N, std::hypot(R_x, R_y), 1e-6 * q->N);
  EXPECT_NEAR(q->T_lB * std::cos(right) - q->T_lA * std::cos(left) + c.S * c.sin_g + R_x, 0, 1e-5 * c.S);
  EXPECT_NEAR(q->T_lB * std::sin(right) - q->T_lA * std::sin(left) - c.S * c.cos_g + R_y, 0, 1e-5 * c.S);
}

TEST(ClosedLoopQuick, WithoutFrictionTheLevelLoopIsSymmetric) {
  Input in = example();
  in.gathering_angle = 0;
  in.tail_efficiency = 1;
  in.traction_weight = in.return_weight;
  const auto q = quick(case_of(in));
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->P_v, in.gathering_force / 2, 1e-9 * q->P_v);
  for (double T : {q->T_uA, q->T_lA, q->T_lB}) EXPECT_NEAR(T, q->T_uB, 1e-12 * T);
}

TEST(ClosedLoopQuick, LiftOffSaysSo) {
  Input in = example();
  in.slope = -30 * degree;
  in.gathering_angle = 58 * degree;
  const auto c = case_of(in);
  Sheet<double> s;
  Quick<double> q{};
  const Outcome o = quick_tensions(c, c, s, q);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("lifts off"), std::string::npos);
  EXPECT_LT(q.P_v, 0);
}

RC_GTEST_PROP(ClosedLoopQuick, TheCarriageIsInEquilibrium, ()) {
  const auto c = case_of(drawn());
  const auto q = quick(c);
  RC_PRE(q.has_value());
  const double left = c.m - c.f / c.x + c.w_T * c.x / (2 * q->H_1);
  const double right = c.m + c.f / c.y - c.w_b * c.y / (2 * q->H_2);
  const double sum_x = q->H_2 - q->H_1 + c.S * c.sin_g - q->P_v * q->m_x;
  const double sum_y = q->H_2 * right - q->H_1 * left - c.S * c.cos_g - c.W_c + q->P_v;
  RC_ASSERT(std::abs(sum_x) < 1e-9 * q->H_1);
  RC_ASSERT(std::abs(sum_y) < 1e-9 * q->H_1);
}

RC_GTEST_PROP(ClosedLoopQuick, TheRollerIsInEquilibriumAndTheSheaveKeepsItsRatio, ()) {
  const auto c = case_of(drawn());
  const auto q = quick(c);
  RC_PRE(q.has_value());
  const double left = c.m - c.f / c.x + c.w_b * c.x / (2 * q->H_3);
  const double right = c.m + c.f / c.y - c.w_b * c.y / (2 * q->H_4);
  RC_ASSERT(std::abs(q->H_4 * right - q->H_3 * left - q->P_v) < 1e-8 * q->H_3);
  RC_ASSERT(std::abs(q->T_uB - c.eta * q->T_lB) < 1e-10 * q->T_lB);
  if (c.roller == Roller::free) {
    // A free roller turns the rope without changing its tension.
    const double T_A = q->H_3 * std::hypot(1, left);
    const double T_B = q->H_4 * std::hypot(1, right);
    RC_ASSERT(std::abs(T_A - T_B) < 1e-8 * T_A);
  }
}

RC_GTEST_PROP(ClosedLoopQuick, HeavierLoadsPullHarder, ()) {
  Input in = drawn();
  const auto a = quick(case_of(in));
  in.carriage_weight += 1000;
  const auto b = quick(case_of(in));
  RC_PRE(a.has_value() && b.has_value());
  RC_ASSERT(b->T_lA > a->T_lA);
  RC_ASSERT(b->T_uB > a->T_uB);
  RC_ASSERT(b->P_v > a->P_v);
}

RC_GTEST_PROP(ClosedLoopQuick, SettlesInTheUsualRange, ()) {
  const auto c = case_of(drawn());
  const Pass p = settle(c);
  const bool taut = p.H_1 > 0 && p.H_2 > 0 && p.H_3 > 0 && p.H_4 > 0;
  RC_ASSERT(p.converged || !taut);
  RC_ASSERT(p.passes < 60);
}

}  // namespace taut::closed_loop::quick_test
