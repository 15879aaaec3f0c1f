#include "taut/machine/signals_in.hpp"

#include <gtest/gtest.h>

namespace taut::machine::signals_in_test {

/// A ramp to its end at 2 s, and a load that swings.
TEST(SignalsIn, WhatGoesOnAtATime) {
  Model m;
  m.drums.emplace_back().drive.signal.law = Moves{.from = 0, .moves = {{.at = 1, .to = 3, .over = 1}}};
  EXPECT_FALSE(goes_on(m, 0.5).ramps);
  EXPECT_TRUE(goes_on(m, 1.5).ramps);
  EXPECT_FALSE(goes_on(m, 2.5).ramps);
  EXPECT_FALSE(goes_on(m, 1.5).swings);
  m.loads.emplace_back().over_time =
      Signal{.name = "s", .unit = si::N, .law = Sine{.mean = 1, .amplitude = 2, .omega = 3}};
  EXPECT_TRUE(goes_on(m, 2.5).swings);
  EXPECT_FALSE(goes_on(m, 2.5).ramps);
}

TEST(SignalsIn, AllAreShown) {
  Model m;
  m.signals.resize(1);
  m.drums.resize(1);
  m.motors.resize(1);
  m.actuators.resize(1);
  m.tensioners.resize(1);
  m.loads.resize(2);
  m.loads[0].over_time.emplace();
  m.bodies.emplace_back().driven.resize(2);
  m.reevings.emplace_back().nodes.emplace_back().load.signal.emplace();
  m.events.emplace_back().kind = EventKind::drive;
  int seen = 0;
  for_each_signal(m, [&](const Signal&) { ++seen; });
  EXPECT_EQ(seen, 10);
}

}  // namespace taut::machine::signals_in_test
