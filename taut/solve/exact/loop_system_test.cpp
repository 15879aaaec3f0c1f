#include "taut/solve/exact/loop_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/math/degree.hpp"

/// Newton's iteration by itself: from poor starts, how fast it ends, and its answer by spans that are solved another
/// way (from their lengths, not from their tensions).
namespace taut::solve::loop_system_test {

RunningLoop skyline(bool two, double stiffness = 8e6) {
  RunningLoop loop;
  loop.span = 180;
  loop.rise = 35;
  loop.branch_distance = 1.2;
  loop.traction_rope = {.weight = 14, .stiffness = stiffness};
  loop.return_rope = {.weight = 10, .stiffness = stiffness};
  loop.efficiency = 0.92;
  loop.pull_x = 12e3;
  loop.pull_z = -20e3;
  loop.carriage_weight = 3500;
  if (two) loop.second = SecondSection{.distance = 3};
  return loop;
}

constexpr LoopPlace place{.x = 75, .sag = 11};

/// Tensions and places near those of the loop, by factors and by metres.
LoopUnknowns start(double H, double off) {
  const double m = 35.0 / 180;
  return {.H = {70e3 * H, 60e3 * H, 60e3 * H, 50e3 * H, 50e3 * H},
          .lean = 0.1 * off,
          .first = {.x = 75 + off, .z = m * 75 - 11 - off},
          .second = {.x = 78 + 1.5 * off, .z = m * 78 - 11.5}};
}

LoopUnknowns at(const LoopState& s, double by = 0) {
  return {.H = {s.lower_A.force.H * (1 + by), s.between.force.H * (1 - by), s.lower_B.force.H * (1 - by),
                s.upper_A.force.H * (1 + by), s.upper_B.force.H * (1 + by)},
          .lean = s.lean + by,
          .first = {.x = s.first.x + 20 * by, .z = s.first.z - 10 * by},
          .second = {.x = s.second.x + 15 * by, .z = s.second.z + 10 * by}};
}

TEST(LoopSystem, PoorStartsComeToOneAnswer) {
  for (const bool two : {false, true}) {
    const RunningLoop loop = skyline(two);
    LoopState first;
    ASSERT_TRUE(newton(loop, place, start(1, 0), first));
    for (const auto& [H, off] : {std::pair{0.5, 0.0}, {2.0, 2.0}, {0.8, -3.0}}) {
      LoopState other;
      ASSERT_TRUE(newton(loop, place, start(H, off), other)) << H << " " << off;
      EXPECT_NEAR(other.lower_A.T_start, first.lower_A.T_start, 1e-9 * first.lower_A.T_start);
      EXPECT_NEAR(other.loop_length(), first.loop_length(), 1e-9);
      EXPECT_NEAR(other.lean, first.lean, 1e-9);
    }
  }
}

/// With exact derivatives what is left goes down by its square: from a part in a thousand two steps go to rounding, and
/// the third one sees it.
TEST(LoopSystem, ItEndsByTheSquare) {
  for (const bool two : {false, true}) {
    for (const RollerLaw law : {RollerLaw::free, RollerLaw::vertical}) {
      RunningLoop loop = skyline(two);
      loop.roller = law;
      LoopState first, again, near;
      ASSERT_TRUE(newton(loop, place, start(1, 0), first));
      ASSERT_TRUE(newton(loop, place, at(first), again));
      EXPECT_LE(again.iterations, 1);
      ASSERT_TRUE(newton(loop, place, at(first, 1e-4), near));
      EXPECT_LE(near.iterations, 3) << two;
      EXPECT_NEAR(near.lower_A.T_start, first.lower_A.T_start, 1e-9 * first.lower_A.T_start);
    }
  }
}

/// The pull of one span on what holds its ends, from its unstretched length alone.
struct Pulls {
  double H = 0, start_V = 0, end_V = 0;
};
Pulls pulls(const LoopSpan& span, const LoopNode& from, const LoopNode& to) {
  const auto solved = rope::solve_catenary(span.rope, to.x - from.x, to.z - from.z);
  EXPECT_TRUE(solved.has_value());
  const double half = span.rope.weight * span.rope.length / 2;
  return {.H = solved->force.H, .start_V = solved->force.V - half, .end_V = solved->force.V + half};
}

TEST(LoopSystem, ItsNodesAreInBalanceBySpansOfTheirLengths) {
  for (const bool two : {false, true}) {
    const RunningLoop loop = skyline(two);
    LoopState s;
    ASSERT_TRUE(newton(loop, place, start(1, 0), s));
    const double chord = std::hypot(loop.span, loop.rise), d = loop.branch_distance;
    const LoopNode A{.x = 0, .z = 0}, B{.x = loop.span, .z = loop.rise},
        up{.x = -d * loop.rise / chord, .z = d * loop.span / chord};
    const Pulls a = pulls(s.lower_A, A, s.first), b = pulls(s.lower_B, s.second, B);
    const Pulls u = pulls(s.upper_A, up, s.roller), w = pulls(s.upper_B, s.roller, {.x = B.x + up.x, .z = B.z + up.z});
    double T = std::hypot(b.H, b.end_V);
    EXPECT_NEAR(std::hypot(w.H, w.end_V), loop.efficiency * T, 1e-7 * T);
    if (!two) {
      EXPECT_NEAR(b.H + w.H - a.H - u.H + loop.pull_x, 0, 1e-7 * T);
      EXPECT_NEAR(b.start_V + w.start_V - a.end_V - u.end_V + loop.pull_z, loop.carriage_weight, 1e-7 * T);
    } else {
      const double t = s.between.force.H, V = s.between.V_end;  // that short rope does not stretch
      EXPECT_NEAR(b.H - t + loop.pull_x, 0, 1e-7 * T);
      EXPECT_NEAR(b.start_V - V + loop.pull_z, 0, 1e-7 * T);
      EXPECT_NEAR(t + w.H - a.H - u.H, 0, 1e-7 * T);
      EXPECT_NEAR(s.second.x - s.first.x, 3, 1e-9);
    }
    EXPECT_NEAR(s.first.x, place.x, 1e-9);
    EXPECT_NEAR(loop.rise / loop.span * s.first.x - s.first.z, place.sag, 1e-9);
    // the roller stands square to what it carries, one rope's tension on both sides
    EXPECT_NEAR((w.H - u.H) * (s.roller.z - s.first.z) - (w.start_V - u.end_V) * (s.roller.x - s.first.x), 0, 1e-6 * T);
    EXPECT_NEAR(std::hypot(u.H, u.end_V), std::hypot(w.H, w.start_V), 1e-7 * T);
  }
}

/// An empty loop, level and flat: by parabolas 4 f H/l - w l/2 of each branch adds up to the pull, and the upper one
/// has the efficiency's share of H. With a loss it hangs deeper than the carriage, whose roller would have to hold it
/// up: that is an answer too, to be judged elsewhere. Where the rope runs out it is the other way round.
TEST(LoopSystem, ARollerThatPullsIsStillAnAnswer) {
  for (const double efficiency : {0.8, 1.25}) {
    RunningLoop loop;
    loop.span = 180;
    loop.roller = RollerLaw::vertical;
    loop.traction_rope.weight = loop.return_rope.weight = 10;
    loop.efficiency = efficiency;
    loop.pull_z = -20;
    const double f = 3, all = 10 * 180 + 20, H = all * 180 / (4 * f * (1 + efficiency));
    LoopState s;
    const LoopUnknowns near{.H = {H, H, H, efficiency * H, efficiency * H},
                            .lean = 0,
                            .first = {.x = 90, .z = -f},
                            .second = {.x = 90, .z = -f}};
    ASSERT_TRUE(newton(loop, {90, f}, near, s));
    EXPECT_NEAR(s.lower_B.force.H, H, 2e-3 * H);
    EXPECT_NEAR(s.R_z, efficiency / (1 + efficiency) * all - 900, 2e-3 * all);
    EXPECT_EQ(s.R_z > 0, efficiency > 1);
  }
}

TEST(LoopSystem, WhatHasNoAnswerIsRefused) {
  const RunningLoop loop = skyline(false);
  LoopState s;
  LoopUnknowns none = start(1, 0);
  none.H[2] = -5e3;  // no logarithm
  EXPECT_FALSE(newton(loop, place, none, s));
  none = start(1, 0);
  none.first.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(newton(loop, place, none, s));
  // ropes without weight, straight at A's height: they carry nothing that hangs
  RunningLoop flat = loop;
  flat.traction_rope.weight = flat.return_rope.weight = flat.rise = 0;
  EXPECT_FALSE(newton(flat, {75, 1e-300}, start(1, 0), s));
}

}  // namespace taut::solve::loop_system_test
