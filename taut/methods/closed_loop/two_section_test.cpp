#include "taut/methods/closed_loop/two_section.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::two_section_test {

using namespace taut_test;

TEST(ClosedLoopTwoSection, NearSectionsAreOneCarriage) {
  for (double alpha : {-20.0, 0.0, 15.0}) {
    const auto [two, one] = near_sections(alpha * degree);
    const Output a = solved(two), b = solved(one);
    EXPECT_NEAR(a.P_b, b.P_b, 1e-4 * b.P_b);
    EXPECT_NEAR(a.T_lA_paper, b.T_lA_paper, 1e-4 * b.T_lA_paper);
    EXPECT_NEAR(a.delta_f, 0, 1e-4);
  }
}

TEST(ClosedLoopTwoSection, AboutOnePercentOfPbPerMetreUpToTwelve) {
  const double single = solved(example()).P_b;
  for (double d : {3.0, 6.0, 12.0}) {
    Input in = two_section_example();
    in.section_distance = d;
    EXPECT_NEAR((solved(in).P_b / single - 1) / d, -0.01, 0.002) << d;
  }
}

TEST(ClosedLoopTwoSection, SystemHoldsInItsOwnEquations) {
  Input in = two_section_example();
  in.slope = 8 * degree;
  in.carriage_weight = 900;
  Output out;
  Sheet<Num> s("Martynikhin 1971", Input::describe(), &in);
  ASSERT_TRUE(compute(in, s, out).ok());
  double by_12 = 0;
  double by_13 = 0;
  double T_B1 = 0;
  double T_B2 = 0;
  for (const Step& step : s.steps()) {
    if (step.eq == "12*" && step.symbol == "H_2") by_12 = step.value;
    if (step.eq == "13*" && step.symbol == "H_2") by_13 = step.value;
    if (step.symbol == "T_B1") T_B1 = step.value;
    if (step.symbol == "T_B2") T_B2 = step.value;
  }
  ASSERT_GT(by_12, 0);
  EXPECT_NEAR(by_12, by_13, 1e-9 * by_12);
  EXPECT_NEAR(T_B1, 0.9 * T_B2, 1e-9 * T_B1);
}

TEST(ClosedLoopTwoSection, RopeDistanceIsTheLengthBetweenTheSections) {
  Input in = two_section_example();
  in.slope = -12 * degree;
  in.distance_kind = DistanceKind::rope;
  const Output o = solved(in);
  const double dx = o.x_2 - o.x_1;
  const double dy = std::tan(in.slope) * dx - (o.f_2 - o.f_1);
  EXPECT_NEAR(std::hypot(dx, dy), 3, 1e-9);
  EXPECT_LT(dx, 3);
}

TEST(ClosedLoopTwoSection, SagAndPositionMayBelongToEitherSection) {
  Input first = two_section_example();
  const Output a = solved(first);
  Input second = first;
  second.position_of = Section::second;
  second.sag_of = Section::second;
  second.position = {a.x_2};
  second.sag = a.f_2;
  const Output b = solved(second);
  EXPECT_NEAR(a.T_lA, b.T_lA, 1e-9 * a.T_lA);
  EXPECT_NEAR(a.x_1, b.x_1, 1e-12);
  EXPECT_NEAR(a.f_1, b.f_1, 1e-9);
}

TEST(ClosedLoopTwoSection, NoPlaceForSection2IsInfeasible) {
  Input in = two_section_example();
  in.slope = -35 * degree;
  in.gathering_angle = 54 * degree;
  Output out;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_FALSE(o.message.empty());
}

RC_GTEST_PROP(ClosedLoopTwoSection, ForcesScaleWithForces, ()) {
  Input in = two_section_example();
  in.slope = *rc::gen::inRange(-15, 16) * degree;
  const double k = *rc::gen::inRange(1, 500) / 25.0;
  Input scaled = in;
  scaled.gathering_force *= k;
  *scaled.return_weight *= k;
  *scaled.traction_weight *= k;
  const Output a = solved(in);
  const Output b = solved(scaled);
  RC_ASSERT(std::abs(b.P_b - k * a.P_b) < 1e-9 * k * a.T_n);
  RC_ASSERT(std::abs(b.delta_f - a.delta_f) < 1e-9);
  RC_ASSERT(std::abs(b.T_lA - k * a.T_lA) < 1e-9 * k * a.T_n);
}

}  // namespace taut::closed_loop::two_section_test
