#include "taut/checks/rope/lasting_tension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "test/support/dice.hpp"

namespace taut::checks::lasting_tension_test {

/// Moments `step` apart, with so many steps of the motion from one to the next.
LastingTension of(double duration, double step, const std::function<double(double)>& T, long steps = 1) {
  LastingTension lasting;
  for (int i = 0; i * step <= duration; ++i) lasting.take(i * step, T(i * step), i * steps);
  return lasting;
}

TEST(LastingTension, ALoadThatComesAndStaysCountsAndAPeakDoesNot) {
  const auto comes = [](double t) { return t < 4 ? 1e3 : 3e3; };
  EXPECT_EQ(of(8.9, 0.1, comes).largest(), 1e3) << "3 kN have not lasted yet";
  EXPECT_EQ(of(9.1, 0.1, comes).largest(), 3e3);
  EXPECT_NEAR(of(20, 0.1, comes).when(), 9, 0.11);
  EXPECT_EQ(of(20, 0.1, [](double t) { return std::abs(t - 10) < 2 ? 9e3 : 1e3; }).largest(), 1e3);
  EXPECT_EQ(of(4.9, 0.1, [](double) { return 1e3; }).largest(), 0);
}

TEST(LastingTension, OfASwingItIsNotMoreThanItsMean) {
  for (const double period : {0.3, 1.0, 4.9}) {
    const auto swings = [&](double t) { return 5e3 + 2e3 * std::sin(2 * std::numbers::pi * t / period); };
    EXPECT_LT(of(60, 0.02, swings).largest(), 5e3) << period;
    EXPECT_GE(of(60, 0.02, swings).largest(), 3e3) << period;
  }
}

// A load of 3 kN beside 1 kN that comes for 4 s of 6 has not lasted; the mean over 5 s has 4/5 of it.
TEST(LastingTension, OfALoadThatComesAndGoesTheMeanTells) {
  const auto comes = [](double t) { return std::fmod(t, 6) < 4 ? 4e3 : 1e3; };
  EXPECT_EQ(of(60, 0.01, comes).largest(), 1e3);
  EXPECT_NEAR(of(60, 0.01, comes).mean(), 1e3 + 3e3 * 4 / 5, 10);
  EXPECT_NEAR(of(60, 0.01, [](double) { return 2e3; }).mean(), 2e3, 1e-6);
  EXPECT_EQ(of(4.9, 0.01, [](double) { return 2e3; }).mean(), 0);
  EXPECT_NEAR(of(
                  60, 0.3, [](double t) { return t; }, 2)
                  .mean(),
              60 - 2.5, 1e-9)
      << "the interval begins within a part";
  for (const double period : {0.5, 1.0, 2.5}) {
    const auto swings = [&](double t) { return 5e3 + 2e3 * std::sin(2 * std::numbers::pi * t / period); };
    EXPECT_NEAR(of(60, 0.01, swings).mean(), 5e3, 5) << period;
  }
  LastingTension twice;
  for (int i = 0; i <= 100; ++i) {
    twice.take(0.1 * i, 1e3, i);
    twice.take(0.1 * i, 2e3, i);  // a moment that is shown twice has the larger tension
  }
  EXPECT_NEAR(twice.mean(), 2e3, 1e-6);
}

TEST(LastingTension, WhatIsNotSeenSaysNothing) {
  const auto constant = [](double) { return 1e3; };
  EXPECT_EQ(of(60, 0.5, constant, 5000).largest(), 0) << "it may have been less in between";
  EXPECT_EQ(of(60, 0.2, constant, 2000).largest(), 1e3);
  EXPECT_EQ(of(60, 2.0, constant).largest(), 1e3) << "steps of 2 s";
}

// A load that comes 0.5 s before the end has not lasted; the mean from there on tells it. A swing is as high as its
// mean over whole periods, and higher from its trough on.
TEST(LastingTension, AtItsEndAMotionMayHaveMore) {
  const auto comes = [](double t) { return t < 8 ? 1e3 : 1.8e3; };
  EXPECT_NEAR(of(8.5, 0.01, comes).at_end(), 1.8e3, 1);
  EXPECT_EQ(of(8.5, 0.01, comes).largest(), 1e3);
  EXPECT_NEAR(of(20, 0.1, [](double) { return 2e3; }).at_end(), 2e3, 1e-9);
  EXPECT_NEAR(of(0.1, 0.05, [](double t) { return 1e3 + 1e4 * t; }).at_end(), 1.5e3, 1e-9) << "all of a short motion";
  const auto swings = [](double t) { return 5e3 + 1e3 * std::sin(2 * std::numbers::pi * t); };
  EXPECT_GE(of(20, 0.01, swings).at_end(), 4.99e3);
  EXPECT_LT(of(20, 0.01, swings).at_end(), 6e3);
  EXPECT_EQ(LastingTension().at_end(), 0);
}

// By the largest of equal times: neither an earlier peak nor a swing hides it.
TEST(LastingTension, ItGrows) {
  const auto ramp = [](double t) { return t < 8 ? (t < 5 && t > 4 ? 9e3 : 1e3) : 1e3 + 1e3 * (t - 8); };
  EXPECT_NEAR(of(9, 0.01, ramp).growth(0.25), 2e3 / 1.74e3 - 1, 1e-6) << "the last one before them is at 8.74 s";
  const auto swings = [](double t) { return 5e3 + 1e3 * t + 400 * std::sin(10 * 2 * std::numbers::pi * t); };
  for (const double end : {8.0, 8.02, 8.05, 8.08}) EXPECT_NEAR(of(end, 0.01, swings).growth(0.25), 0.02, 0.02) << end;
  const auto damped = [](double t) { return 5e3 + 1e3 * std::exp(-t) * std::sin(10 * 2 * std::numbers::pi * t); };
  EXPECT_EQ(of(1, 0.01, damped).growth(0.25), 0);
  EXPECT_EQ(of(3, 0.01, damped).growth(2.5), 0) << "of halves";
  EXPECT_EQ(LastingTension().growth(1), 0);
}

TEST(LastingTension, ANewMotionBeginsAnew) {
  LastingTension lasting;
  for (const double T : {2e3, 3e3}) {
    for (int i = 0; i <= 30; ++i) lasting.take(i * 0.1, T, i);
  }
  EXPECT_EQ(lasting.largest(), 0) << "two motions of 3 s are not one of 6 s";
}

/// Against the definition, at irregular moments.
TEST(LastingTension, IsTheLargestOfTheLeastOfAllIntervals) {
  taut_test::Dice dice;
  for (int round = 0; round < 20; ++round) {
    std::vector<double> t = {0}, T = {dice.in(1, 9)};
    LastingTension lasting;
    while (t.back() < 30) {
      t.push_back(t.back() + dice.in(0.01, 0.2));
      T.push_back(std::clamp(T.back() + dice.in(-1, 1), 0.0, 9.0));
    }
    double largest = 0;
    for (std::size_t end = 0; end < t.size(); ++end) {
      lasting.take(t[end], T[end], static_cast<long>(end));
      std::size_t begin = end;
      double least = T[end];
      while (begin > 0 && t[begin] > t[end] - LastingTension::lasts) least = std::min(least, T[--begin]);
      if (t[begin] <= t[end] - LastingTension::lasts) largest = std::max(largest, least);
    }
    EXPECT_EQ(lasting.largest(), largest) << round;
  }
}

}  // namespace taut::checks::lasting_tension_test
