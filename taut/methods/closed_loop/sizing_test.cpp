#include "taut/methods/closed_loop/sizing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/catalogue/rope_search.hpp"
#include "taut/methods/closed_loop/position.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::sizing_test {

using namespace taut_test;

Input sized() {
  Input in = example();
  in.safety_factor = 3.5;
  in.wire_strength = 140 * kgf_per_mm2;
  return in;
}

Input choosing() {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.safety_factor = 3.5;
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = "IWRC", .grade = 1960e6};
  in.position = {40, 100, 160};
  return in;
}

TEST(ClosedLoopSizing, ASmallSagCarriesNoRope) {
  Input in = sized();
  in.sag = 0.5;
  Output out;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("sag too small"), std::string::npos) << o.message;
  EXPECT_TRUE(std::isnan(out.F_return));
  EXPECT_TRUE(std::isfinite(out.T_lA));  // the tensions with the deck's weights are there all the same
}

TEST(ClosedLoopSizing, OutHaulSizesTheUpperBranchItself) {
  Input in = sized();
  in.haul = Haul::out;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(out.F_return, out.F_return_paper, 1e-12 * out.F_return);  // level chord: min(1, 1/eta) = 1
  EXPECT_GT(out.T_uB, out.T_lB);
  const auto true_factor = [&](double F_return) {
    Input own = in;
    own.return_weight = in.weight_per_area * F_return;
    own.traction_weight = in.weight_per_area * out.F_traction;
    Output check;
    EXPECT_TRUE(solve(own, check).ok());
    return *in.wire_strength * F_return / check.T_uB;
  };
  EXPECT_NEAR(true_factor(out.F_return), 3.44, 0.01);
  // With 1/eta in the denominator it would be sized for T_lB, the slacker side.
  const double own_weight = in.weight_per_area * 200 * 3.5 * 200;
  const double slack_side = 2 * out.P_b_no_weight * 3.5 * 200 / (8 * *in.wire_strength * 10 / 0.9 - own_weight);
  EXPECT_NEAR(true_factor(slack_side), 3.09, 0.02);
}

TEST(ClosedLoopSizing, CorrectedAreasEndNearTheSafetyFactor) {
  for (double alpha : {-20.0, -10.0, 0.0, 10.0, 20.0}) {
    Input in = sized();
    in.slope = alpha * degree;
    Output out;
    ASSERT_TRUE(solve(in, out).ok());
    Input own = in;
    own.return_weight = in.weight_per_area * out.F_return;
    own.traction_weight = in.weight_per_area * out.F_traction;
    Output check;
    ASSERT_TRUE(solve(own, check).ok());
    const Peaks peaks = peaks_of(check);
    EXPECT_NEAR(*in.wire_strength * out.F_return / check.T_lB, 3.5, 0.09) << alpha;
    EXPECT_NEAR(*in.wire_strength * out.F_traction / peaks.traction_rope.tension, 3.5, 0.09) << alpha;
  }
}

TEST(ClosedLoopSizing, StrongerWireNeedsLess) {
  Input in = sized();
  Output a;
  Output b;
  ASSERT_TRUE(solve(in, a).ok());
  *in.wire_strength *= 1.2;
  ASSERT_TRUE(solve(in, b).ok());
  EXPECT_LT(b.F_return, a.F_return);
  EXPECT_LT(b.F_traction, a.F_traction);
  EXPECT_LT(b.F_return_paper, a.F_return_paper);
}

/// Whether two ropes pass at every position.
bool pass(const Input& in, const catalogue::RopeRow& b, const catalogue::RopeRow& t) {
  for (double x : in.position) {
    Input one = in;
    one.choose_ropes.reset();
    one.position = {x};
    one.return_weight = b.mass_per_length * standard_gravity;
    one.traction_weight = t.mass_per_length * standard_gravity;
    Output o;
    if (!solve(one, o).ok()) continue;
    const Peaks p = peaks_of(o);
    if (b.breaking_force < *in.safety_factor * p.return_rope.tension) return false;
    if (t.breaking_force < *in.safety_factor * p.traction_rope.tension) return false;
  }
  return true;
}

/// The choice passes, and no thinner rope that the filter lets through would, beside the other one.
void expect_smallest(const Input& in, const catalogue::RopeFilter& filter) {
  Ropes ropes;
  ASSERT_TRUE(ropes_of(in, ropes).ok());
  ASSERT_TRUE(ropes.return_rope && ropes.traction_rope);
  EXPECT_TRUE(pass(in, *ropes.return_rope, *ropes.traction_rope));
  for (const auto& row : catalogue::select_ropes(filter)) {
    if (row.diameter < ropes.return_rope->diameter) {
      EXPECT_FALSE(pass(in, row, *ropes.traction_rope)) << row.id;
    }
    if (row.diameter < ropes.traction_rope->diameter) {
      EXPECT_FALSE(pass(in, *ropes.return_rope, row)) << row.id;
    }
  }
}

TEST(ClosedLoopSizing, ChosenRopesAreTheSmallestThatPass) {
  catalogue::RopeFilter filter;
  filter.construction = "6x36";
  filter.core = "IWRC";
  filter.grade = 1960e6;
  expect_smallest(choosing(), filter);
  Input steep = choosing();
  steep.slope = -20 * degree;
  steep.sag = 16;
  expect_smallest(steep, filter);
}

TEST(ClosedLoopSizing, AnEmptyFilterSearchesTheWholeCatalogue) {
  Input in = choosing();
  in.choose_ropes = RopeFilter{};
  expect_smallest(in, {});
}

TEST(ClosedLoopSizing, TooGreatALoadHasNoRope) {
  Input in = choosing();
  in.gathering_force *= 100;
  Ropes ropes;
  const Outcome o = ropes_of(in, ropes);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("strong enough"), std::string::npos) << o.message;
}

TEST(ClosedLoopSizing, PeaksAreTheLargestOfEachRope) {
  Output a;
  a.x = 10;
  a.T_uA = 1;
  a.T_lB = 5;
  a.T_lA = 7;
  Output b = a;
  b.x = 20;
  b.T_lB = 4;
  b.T_lA = 9;
  const Peaks p = larger(peaks_of(a), peaks_of(b));
  EXPECT_EQ(p.return_rope.tension, 5);
  EXPECT_EQ(p.return_rope.x, 10);
  EXPECT_EQ(p.traction_rope.tension, 9);
  EXPECT_EQ(p.traction_rope.x, 20);
  EXPECT_EQ(p.return_rope.where, "lower branch at B");
}

// The rope between the sections is return rope, the rope behind the sheaves at A traction rope.
TEST(ClosedLoopSizing, EveryPieceOfARopeCounts) {
  Output out;
  out.x = 100;
  for (double Output::*T :
       {&Output::T_uA, &Output::T_U, &Output::T_uB, &Output::T_lB, &Output::T_lLB, &Output::T_lA, &Output::T_lLA})
    out.*T = 50e3;
  EXPECT_EQ(peaks_of(out).return_rope.tension, 50e3) << "one section, no sheaves at A";
  out.T_12 = 60e3;
  out.T_winch = 70e3;
  EXPECT_EQ(peaks_of(out).return_rope.tension, 60e3);
  EXPECT_EQ(peaks_of(out).return_rope.where, "between the sections of the carriage");
  EXPECT_EQ(peaks_of(out).traction_rope.tension, 70e3);
  EXPECT_EQ(peaks_of(out).traction_rope.where, "at the winch, behind the sheaves at A");
}

// With the load at section 2 the rope beyond it is pulled by S sin(gamma) less.
TEST(ClosedLoopSizing, TwoSectionsPullTheRopeBetweenThem) {
  Input in = two_section_example();
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_GT(out.T_12, out.T_lLB + 0.9 * in.gathering_force * std::sin(in.gathering_angle));
  EXPECT_EQ(peaks_of(out).return_rope.tension, out.T_12);
}

// The areas are those of the load at midspan, wherever the carriage of the deck stands: near A the same pull leaves a
// tenth of the sag there.
TEST(ClosedLoopSizing, TheAreasTakeTheSagAtMidspan) {
  Input in = sized();
  in.sag.reset();
  in.mode = Mode::winch_pull;
  in.winch_pull = 82e3;
  Output middle;
  ASSERT_TRUE(solve(in, middle).ok());
  in.position = {5};
  Output near_A;
  const Outcome o = solve(in, near_A);
  ASSERT_TRUE(o.ok()) << o.message;
  EXPECT_LT(near_A.f, middle.f / 5);
  EXPECT_NEAR(near_A.F_return, middle.F_return, 1e-6 * middle.F_return);
  EXPECT_NEAR(near_A.F_traction, middle.F_traction, 1e-6 * middle.F_traction);
}

}  // namespace taut::closed_loop::sizing_test
