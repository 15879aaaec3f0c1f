#include "taut/methods/closed_loop/sag.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::sag_test {

using namespace taut_test;

Input pulled(double force) {
  Input in = example();
  in.sag.reset();
  in.mode = Mode::winch_pull;
  in.winch_pull = force;
  return in;
}

RC_GTEST_PROP(ClosedLoopSag, WinchPullFindsTheSagThatHasIt, ()) {
  Input in = example();
  in.slope = *rc::gen::inRange(-20, 21) * degree;
  in.position = {static_cast<double>(*rc::gen::inRange(50, 151))};
  in.sag = *rc::gen::inRange(20, 100) * 0.1;
  Output at_sag;
  RC_PRE(solve(in, at_sag).ok());
  Input back = in;
  back.sag.reset();
  back.mode = Mode::winch_pull;
  back.head_efficiency = 0.95;
  back.winch_pull = at_sag.T_lA / 0.95;
  Output out;
  RC_ASSERT(solve(back, out).ok());
  RC_ASSERT(std::abs(out.f - *in.sag) < 1e-8);
  RC_ASSERT(std::abs(out.T_lA - at_sag.T_lA) < 1e-6 * at_sag.T_lA);
}

TEST(ClosedLoopSag, HarderPullLiftsTheCarriage) {
  Output a;
  Output b;
  ASSERT_TRUE(solve(pulled(70e3), a).ok());
  ASSERT_TRUE(solve(pulled(90e3), b).ok());
  EXPECT_LT(b.f, a.f);
}

TEST(ClosedLoopSag, ReportsASecondDeeperSag) {
  // A heavy rope on a deep sag pulls harder again: the tension at A has a least value.
  Input in = pulled(0);
  in.gathering_force = 300 * kgf;
  in.return_weight = 3 * kgf;
  in.traction_weight = 6 * kgf;
  double least = INFINITY;
  Input at = in;
  at.mode = Mode::sag;
  at.winch_pull.reset();
  for (double f = 5; f < 300; f += 1) {
    at.sag = f;
    Output o;
    if (solve(at, o).ok()) least = std::min(least, o.T_lA);
  }
  in.winch_pull = 1.02 * least;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  ASSERT_TRUE(std::isfinite(out.f_second));
  EXPECT_GT(out.f_second, out.f);
  at.sag = out.f_second;
  Output deep;
  ASSERT_TRUE(solve(at, deep).ok());
  EXPECT_NEAR(deep.T_lA, *in.winch_pull, 1e-6 * *in.winch_pull);
}

TEST(ClosedLoopSag, AnImpossiblePullSaysWhatIsPossible) {
  Output out;
  const Outcome o = solve(pulled(1e3), out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("change the winch pull"), std::string::npos) << o.message;
}

TEST(ClosedLoopSag, WithoutContactNoSagHelps) {
  Input in = pulled(80e3);
  in.gathering_force = 100 * kgf;  // the upper branch hangs on its own weight behind a stiff sheave
  in.return_weight = 5 * kgf;
  in.tail_efficiency = 0.5;
  Output out;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("no sag is feasible"), std::string::npos) << o.message;
}

// The sheaves at A take their part of the winch's pull, and help it to hold when the rope runs out.
TEST(ClosedLoopSag, TheWinchPullsBehindItsSheaves) {
  Input in = pulled(90e3);
  in.head_efficiency = 0.9;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(out.T_lA, 81e3, 1);
  EXPECT_NEAR(out.T_winch, 90e3, 1);
  in.haul = Haul::out;
  Output back;
  ASSERT_TRUE(solve(in, back).ok());
  EXPECT_NEAR(back.T_lA, 100e3, 1);
  EXPECT_NEAR(back.T_winch, 90e3, 1);
  EXPECT_LT(back.f, out.f);
  in.head_efficiency = 1;
  Output plain;
  ASSERT_TRUE(solve(in, plain).ok());
  EXPECT_TRUE(std::isnan(plain.T_winch)) << "no sheaves, no value of its own";
}

}  // namespace taut::closed_loop::sag_test
