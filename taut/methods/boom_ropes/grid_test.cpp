#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/math/degree.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"

namespace taut::boom_ropes::grid_test {

TEST(BoomGrid, GapsStayInTheGridWithAWarning) {
  Input in = printed_boom();
  in.sliding = sliding_at(Operation::extend, 30, 9, 3e3);
  in.sliding->boom_length = {9, 30, 21};
  Output out;
  Sheet<Num> s("Reutov 2021", Input::describe(), &in);
  EXPECT_TRUE(compute_sliding(in, *in.sliding, s, out).ok());
  ASSERT_EQ(out.grid.size(), 3u);
  EXPECT_TRUE(std::isnan(out.grid[1].Fh));
  ASSERT_EQ(s.warnings().size(), 1u);
  EXPECT_NE(s.warnings()[0].find("30 m"), std::string::npos);
  EXPECT_EQ(out.governing_length, 21);
}

TEST(BoomGrid, NothingButGapsIsInfeasible) {
  Input in = printed_boom();
  in.sliding = sliding_at(Operation::extend, 30, 30, 3e3);
  Output out;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("9 ... 21 m"), std::string::npos);
}

TEST(BoomGrid, EveryPositionStandsAtItsPlace) {
  Input in = printed_boom();
  in.sliding = sliding_at(Operation::extend, 30, 9, 3e3);
  in.sliding->boom_length = {9, 12, 21};
  in.sliding->luffing_angle = {0.3, 0.9};
  in.sliding->suspended_weight = {3e3, 30e3, 10e3, 20e3};
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  ASSERT_EQ(out.grid.size(), 24u);
  EXPECT_EQ(out.grid[10].boom_length, 12);
  EXPECT_EQ(out.grid[10].luffing_angle, 0.9);
  EXPECT_EQ(out.grid[10].suspended_weight, 30e3);
  EXPECT_EQ(out.Fh, out.grid[out.governing_point].Fh);
  EXPECT_EQ(out.governing_length, out.grid[out.governing_point].boom_length);
  for (const SlidingPoint& p : out.grid) EXPECT_LE(std::abs(p.Fh), std::abs(out.Fh));
}

TEST(BoomGrid, ExtremesAreThoseOfTheGrid) {
  Input in = printed_boom();
  in.sliding = sliding_at(Operation::retract, 10, 9, 3e3);
  in.sliding->boom_length = {21, 9, 16};
  in.sliding->suspended_weight = {30e3, 3e3};
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  const auto by_S1 = [](const SlidingPoint& a, const SlidingPoint& b) { return a.S1 < b.S1; };
  EXPECT_EQ(out.S1_min, std::min_element(out.grid.begin(), out.grid.end(), by_S1)->S1);
  EXPECT_EQ(out.S1_max, std::max_element(out.grid.begin(), out.grid.end(), by_S1)->S1);
  EXPECT_LT(out.Fh, 0);  // the cylinder pulls, and that is the largest amount
  EXPECT_EQ(out.Fh, out.Fh_min);
}

}  // namespace taut::boom_ropes::grid_test
