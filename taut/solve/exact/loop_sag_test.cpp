// find_loop_sag (running_loop.hpp) and the Newton iteration below it (loop_system.hpp).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "taut/solve/exact/loop_system.hpp"
#include "taut/solve/exact/running_loop.hpp"

namespace taut::solve::loop_sag_test {

RunningLoop uphill() {
  RunningLoop loop;
  loop.span = 240;
  loop.rise = 40;
  loop.branch_distance = 1;
  loop.traction_rope = {.weight = 14, .stiffness = 20e6};
  loop.return_rope = {.weight = 9, .stiffness = 12e6};
  loop.efficiency = 0.93;
  loop.pull_x = 9e3;
  loop.pull_z = -20e3;
  loop.carriage_weight = 2e3;
  return loop;
}

TEST(LoopSag, WhatASagGivesLeadsBackToIt) {
  const RunningLoop loop = uphill();
  for (const double x : {60.0, 120.0, 200.0}) {
    for (const double sag : {6.0, 14.0}) {
      LoopState s;
      ASSERT_TRUE(solve_loop(loop, {x, sag}, s).ok());
      for (const auto& [given, value] : {std::pair{LoopGiven::tension_at_A, s.lower_A.T_start},
                                         {LoopGiven::length, s.loop_length()},
                                         {LoopGiven::tension_at_carriage, s.lower_B.T_start}}) {
        LoopSag found;
        const Outcome o = find_loop_sag(loop, x, given, value, found);
        ASSERT_TRUE(o.ok()) << o.message;
        // the smallest sag with that; the one asked for is it, or the next deeper one
        const bool first = std::abs(found.sag - sag) < 1e-5 * sag;
        EXPECT_TRUE(first || (found.sag < sag && std::abs(found.second - sag) < 1e-5 * sag))
            << x << " " << sag << ": " << found.sag << ", " << found.second;
        LoopState again;
        ASSERT_TRUE(solve_loop(loop, {x, found.sag}, again).ok());
        EXPECT_NEAR(again.loop_length(), found.state.loop_length(), 1e-7);
      }
    }
  }
}

// The pull at A has its least value just before the roller lifts off, between the last two sags that the search tries.
TEST(LoopSag, ATurnBesideTheEndOfTheFeasibleSagsIsFound) {
  RunningLoop loop;
  loop.span = 751.3;
  loop.rise = -143.4;
  loop.branch_distance = 1.124;
  loop.traction_rope = {.weight = 13.02, .stiffness = 19.4e6};
  loop.return_rope = {.weight = 19.71, .stiffness = 7.857e6};
  loop.efficiency = 0.888;
  loop.pull_x = 27.57e3 * std::sin(35.29 * std::numbers::pi / 180);
  loop.pull_z = -27.57e3 * std::cos(35.29 * std::numbers::pi / 180);
  loop.carriage_weight = 610;
  loop.roller = RollerLaw::vertical;
  int found_all = 0;
  for (double sag = 70; sag < 95; sag += 0.7) {
    LoopState s;
    if (!solve_loop(loop, {.x = 79.4, .sag = sag}, s).ok()) break;
    LoopSag found;
    const Outcome o = find_loop_sag(loop, 79.4, LoopGiven::tension_at_A, s.lower_A.T_start, found);
    ASSERT_TRUE(o.ok()) << sag << ": " << o.message;
    EXPECT_TRUE(std::abs(found.sag - sag) < 1e-4 || std::abs(found.second - sag) < 1e-4)
        << sag << ": " << found.sag << ", " << found.second;
    ++found_all;
  }
  EXPECT_GT(found_all, 15);
}

TEST(LoopSag, OutOfReachTellsTheRange) {
  RunningLoop loop = uphill();
  loop.traction_rope.stiffness = loop.return_rope.stiffness = std::numeric_limits<double>::infinity();
  LoopSag found;
  const Outcome o = find_loop_sag(loop, 120, LoopGiven::length, 300, found);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("a loop length of 300 m is not possible"), std::string::npos) << o.message;
}

TEST(LoopSystem, ConvergesToTheSameFromDifferentStarts) {
  const RunningLoop loop = uphill();
  const LoopPlace place{.x = 120, .sag = 12};
  LoopState s;
  ASSERT_TRUE(solve_loop(loop, place, s).ok());
  for (const double factor : {0.7, 1.0, 1.4}) {
    LoopUnknowns start;
    start.H = {factor * s.lower_A.force.H, 0, factor * s.lower_B.force.H, factor * s.upper_A.force.H,
               factor * s.upper_B.force.H};
    start.first = s.first;
    LoopState again;
    ASSERT_TRUE(newton(loop, place, start, again)) << factor;
    EXPECT_NEAR(again.lower_A.force.H / s.lower_A.force.H, 1, 1e-9);
    EXPECT_NEAR(again.upper_B.force.H / s.upper_B.force.H, 1, 1e-9);
    EXPECT_LT(again.residual, 1e-6);
  }
}

}  // namespace taut::solve::loop_sag_test
