// Closed loops whose upper supports stand straight above the lower ones on a slope: every sag leads back to itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "taut/math/degree.hpp"
#include "taut/solve/exact/loop_system.hpp"
#include "taut/solve/exact/running_loop.hpp"

namespace taut::solve::loop_offset_test {

/// The same numbers on every machine: std::uniform_real_distribution does not promise that.
class Chance {
 public:
  explicit Chance(unsigned seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0); }

 private:
  std::mt19937 bits_;
};

struct Case {
  RunningLoop loop;
  LoopPlace place;
};

Case case_by_chance(unsigned seed, bool elastic) {
  Chance chance(seed);
  Case c;
  RunningLoop& loop = c.loop;
  loop.span = chance.between(60, 600);
  loop.rise = loop.span * std::tan(chance.between(-30, 30) * degree);
  loop.branch_distance = chance.between(0.3, 3);
  loop.offset_is_vertical = true;
  c.place = {.x = loop.span * chance.between(0.1, 0.9),
             .sag = loop.span * std::exp(chance.between(std::log(0.01), std::log(0.2)))};
  const double S = chance.between(3e3, 80e3), gamma = chance.between(0, 55) * degree;
  loop.pull_x = S * std::sin(gamma);
  loop.pull_z = -S * std::cos(gamma);
  loop.return_rope.weight = chance.between(3, 25);
  loop.traction_rope.weight = chance.between(3, 40);
  loop.efficiency = chance.between(0.8, 1.25);
  loop.carriage_weight = chance.between(0, 5e3);
  if (elastic) {
    loop.return_rope.stiffness = chance.between(5e6, 40e6);
    loop.traction_rope.stiffness = chance.between(5e6, 60e6);
  }
  return c;
}

double given_by(LoopGiven given, const LoopState& s) {
  return given == LoopGiven::tension_at_A ? s.lower_A.T_start
         : given == LoopGiven::length     ? s.loop_length()
                                          : s.lower_B.T_start;
}

constexpr LoopGiven everything_given[] = {LoopGiven::tension_at_A, LoopGiven::length, LoopGiven::tension_at_carriage};

TEST(LoopOffset, NoneIsRefusedThatHasAnAnswer) {
  int feasible = 0;
  for (unsigned seed = 0; seed < 32; ++seed) {
    const auto [loop, place] = case_by_chance(seed, seed % 2 == 1);
    LoopState s;
    if (!solve_loop(loop, place, s).ok()) continue;
    ++feasible;
    for (const LoopGiven given : everything_given) {
      const double value = given_by(given, s);
      LoopSag found;
      const Outcome o = find_loop_sag(loop, place.x, given, value, found);
      ASSERT_TRUE(o.ok()) << seed << ": " << o.message;
      EXPECT_NEAR(given_by(given, found.state) / value, 1, 1e-9) << seed;
      EXPECT_LE(found.sag, place.sag * (1 + 1e-6)) << seed;  // the smallest one
      EXPECT_GT(found.state.roller_force(), 0);
      const double tension = std::max(found.state.lower_A.T_start, found.state.lower_B.T_end);
      EXPECT_LE(found.state.residual, 1e-9 * tension) << seed;
      EXPECT_LE(found.state.closure, 1e-9 * loop.span) << seed;
    }
  }
  EXPECT_GE(feasible, 29);
}

/// Below the sag at which the roller reaches the rope there is no answer; from there on its force grows from nothing.
TEST(LoopOffset, TheRollerForceGrowsFromNothing) {
  Case c = case_by_chance(4, false);
  c.loop.rise = -c.loop.span * std::tan(25 * degree);
  LoopState s;
  const auto pressed = [&](double sag) { return solve_loop(c.loop, {.x = c.place.x, .sag = sag}, s).ok(); };
  double none = 1e-3 * c.loop.branch_distance, some = 0.1 * c.loop.span;
  ASSERT_FALSE(pressed(none));
  ASSERT_TRUE(pressed(some));
  const double far = s.roller_force();
  while (some - none > 1e-9 * some) (pressed((none + some) / 2) ? some : none) = (none + some) / 2;
  ASSERT_TRUE(pressed(some));
  EXPECT_LT(s.roller_force(), 1e-5 * far);
  const Outcome o = solve_loop(c.loop, {.x = c.place.x, .sag = none}, s);
  EXPECT_NE(o.message.find("does not reach the upper branch"), std::string::npos) << o.message;
  EXPECT_NE(o.message.find("deepen the sag"), std::string::npos) << o.message;
}

/// With the link hanging anyhow beside a rope that it does not press on all forces balance too.
TEST(LoopOffset, ALinkWithoutForceIsNoAnswer) {
  const Case c = case_by_chance(10, false);
  for (const double part : {0.02, 0.2, 1.0}) {
    LoopState s;
    if (!reach_loop(c.loop, {.x = c.place.x, .sag = part * c.place.sag}, s, nullptr)) continue;
    EXPECT_GT(s.roller_force(), 1e-6 * s.lower_A.T_start) << part;
  }
}

TEST(LoopOffset, ContinuousInTheSlope) {
  int compared = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Case c = case_by_chance(seed, seed % 2 == 1);
    c.loop.rise = 0;
    LoopState level;
    ASSERT_TRUE(solve_loop(c.loop, c.place, level).ok()) << seed;
    const double length = level.loop_length(), pull = level.lower_A.T_start;
    for (const double slope : {-30.0, -12.0, -1e-6, 0.0, 1e-6, 12.0, 30.0}) {
      LoopSag here, there;
      for (const auto& [given, value] : {std::pair{LoopGiven::tension_at_A, 1.2 * pull},
                                         {LoopGiven::length, 1.002 * length / std::cos(slope * degree)}}) {
        c.loop.rise = c.loop.span * std::tan(slope * degree);
        const bool has = find_loop_sag(c.loop, c.place.x, given, value, here).ok();
        c.loop.rise = c.loop.span * std::tan((slope + 1e-7) * degree);
        ASSERT_EQ(find_loop_sag(c.loop, c.place.x, given, value, there).ok(), has) << seed << " " << slope;
        if (!has) continue;  // steep uphill a sideways pull lifts the roller off
        ++compared;
        EXPECT_NEAR(there.sag / here.sag, 1, 1e-5) << seed << " " << slope;
        EXPECT_NEAR(there.state.lower_B.T_end / here.state.lower_B.T_end, 1, 1e-5) << seed << " " << slope;
      }
    }
  }
  EXPECT_GE(compared, 35);  // of 42
}

/// The law of the roller is the same a hair from an ideal sheave.
TEST(LoopOffset, ContinuousAtTheIdealSheave) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Case c = case_by_chance(seed, true);
    c.loop.efficiency = 1;
    LoopState ideal;
    ASSERT_TRUE(solve_loop(c.loop, c.place, ideal).ok()) << seed;
    for (const double loss : {1e-11, 1e-6}) {
      c.loop.efficiency = 1 - loss;
      LoopState s;
      ASSERT_TRUE(solve_loop(c.loop, c.place, s).ok()) << seed;
      EXPECT_NEAR(s.lower_A.T_start / ideal.lower_A.T_start, 1, 1e-9 + 5 * loss);
      EXPECT_NEAR(s.upper_B.T_end / ideal.upper_B.T_end, 1, 1e-9 + 5 * loss);
    }
  }
}

}  // namespace taut::solve::loop_offset_test
