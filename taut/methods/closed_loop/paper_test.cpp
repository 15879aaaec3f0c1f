#include "taut/methods/closed_loop/paper.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::paper_test {

using namespace taut_test;

Paper<double> paper_of(const Input& in) {
  Sheet<double> s;
  auto c = make_case(in, {.x = in.position.data(), .q_b = *in.return_weight, .q_T = *in.traction_weight}, s);
  c.f = *in.sag;
  Paper<double> p{};
  resolve_force(c, s, p);
  paper_tensions(c, s, p);
  return p;
}

TEST(ClosedLoopPaper, PAndKAreSOfItsTwoDirections) {
  Input in = example();
  in.slope = 17 * degree;
  const auto p = paper_of(in);
  const double S_x = p.K * std::cos(in.slope);  // K along the chord, P straight down
  const double S_y = -p.P + p.K * std::sin(in.slope);
  EXPECT_NEAR(S_x, in.gathering_force * 0.5, 1e-6);
  EXPECT_NEAR(S_y, -in.gathering_force * std::cos(30 * degree), 1e-6);
}

TEST(ClosedLoopPaper, CarriageWeightAddsToP) {
  Input in = example();
  in.carriage_weight = 500;
  EXPECT_NEAR(paper_of(in).P - paper_of(example()).P, 500, 1e-9);
  EXPECT_NEAR(paper_of(in).P_b - paper_of(example()).P_b, 500 * 0.9 / 1.9, 1e-9);
}

TEST(ClosedLoopPaper, GeneralFormsMeetTheMidspanFormulas) {
  for (double alpha : {-25.0, -5.0, 0.0, 5.0, 25.0}) {
    Input in = example();
    in.slope = alpha * degree;
    const auto mid = paper_of(in);
    in.position = {100 + 1e-6};
    const auto near = paper_of(in);
    EXPECT_NEAR(near.P_b_no_weight, mid.P_b_no_weight, 1e-4);
    EXPECT_NEAR(near.T_b, mid.T_b, 1e-2);
    EXPECT_NEAR(near.T_up, mid.T_up, 1e-2);
    EXPECT_NEAR(near.T_lA, mid.T_lA, 1e-2);
  }
}

TEST(ClosedLoopPaper, AVerticalGatheringLineHasAFourthEquationToo) {
  Input in = example();
  in.gathering_angle = 0;
  EXPECT_NEAR(paper_of(in).P_b_no_weight, in.gathering_force * 0.9 / 1.9, 1e-9);
}

RC_GTEST_PROP(ClosedLoopPaper, ForcesScaleWithForces, ()) {
  Input in = example();
  in.slope = *rc::gen::inRange(-30, 31) * degree;
  in.position = {static_cast<double>(*rc::gen::inRange(20, 181))};
  const double k = *rc::gen::inRange(1, 1000) / 50.0;
  Input scaled = in;
  scaled.gathering_force *= k;
  *scaled.return_weight *= k;
  *scaled.traction_weight *= k;
  const auto a = paper_of(in);
  const auto b = paper_of(scaled);
  const double tolerance = 1e-12 * k * (std::abs(a.T_n) + std::abs(a.T_lA) + std::abs(a.T_up));
  RC_ASSERT(std::abs(b.P_b - k * a.P_b) < tolerance);
  RC_ASSERT(std::abs(b.T_b - k * a.T_b) < tolerance);
  RC_ASSERT(std::abs(b.T_up - k * a.T_up) < tolerance);
  RC_ASSERT(std::abs(b.T_lA - k * a.T_lA) < tolerance);
}

RC_GTEST_PROP(ClosedLoopPaper, ALossierSheaveTakesLoadOffTheUpperBranch, ()) {
  Input in = example();
  in.position = {static_cast<double>(*rc::gen::inRange(40, 161))};
  in.tail_efficiency = *rc::gen::inRange(50, 99) / 100.0;
  const auto lossy = paper_of(in);
  in.tail_efficiency += 0.01;
  const auto smooth = paper_of(in);
  RC_ASSERT(smooth.P_b > lossy.P_b);
  RC_ASSERT(smooth.T_n < lossy.T_n);
}

}  // namespace taut::closed_loop::paper_test
