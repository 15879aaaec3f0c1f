#include "taut/rope/drum.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::rope::drum_test {

constexpr double pi = std::numbers::pi;
const DrumLayers winch{.core_diameter = 0.3, .rope_diameter = 0.02, .width = 0.4, .flange_diameter = 0.5};

TEST(Drum, LayersLieARopeApart) {
  for (int k = 1; k <= 5; ++k) EXPECT_NEAR(layer_radius(winch, k), 0.15 + (k - 0.5) * 0.02, 1e-15);
  EXPECT_EQ(turns_per_layer(winch), 20);
  EXPECT_EQ(layers_within_flanges(winch), 5);
  DrumLayers open = winch;
  open.flange_diameter = 0;
  EXPECT_EQ(layers_within_flanges(open), std::numeric_limits<int>::max());
  open.flange_diameter = 0.33;
  EXPECT_EQ(layers_within_flanges(open), 0);
}

// Independent witness: the helix by summation of short straight pieces.
TEST(Drum, ATurnIsAHelix) {
  const int n = 200000;
  double sum = 0;
  const double R = layer_radius(winch, 2);
  for (int i = 0; i < n; ++i) sum += std::hypot(2 * R * std::sin(pi / n), 0.02 / n);
  EXPECT_NEAR(turn_length(winch, 2), sum, 1e-9);
}

TEST(Drum, CapacityIsTheSumOfItsLayers) {
  EXPECT_EQ(drum_capacity(winch, 0), 0);
  EXPECT_NEAR(drum_capacity(winch, 3), layer_length(winch, 1) + layer_length(winch, 2) + layer_length(winch, 3), 1e-12);
  // volume of the rope against that of the coil it fills: pi/4 for round in square
  const double coil = pi * (0.25 * 0.25 - 0.15 * 0.15) * 0.4;
  EXPECT_NEAR(drum_capacity(winch, 5) * pi * 1e-4 / coil, pi / 4, 1e-3);
}

RC_GTEST_PROP(Drum, LengthAndAngleAreInverse, ()) {
  const double length = *rc::gen::inRange(0, 200000) / 1000.0;
  const OnDrum on = on_drum(winch, length);
  RC_ASSERT(std::abs(length_on_drum(winch, on.angle) - length) < 1e-11);
  RC_ASSERT(on.turns >= 0 && on.turns <= turns_per_layer(winch) * (1 + 1e-14));
  RC_ASSERT(length <= drum_capacity(winch, on.layer) && length >= drum_capacity(winch, on.layer - 1));
  RC_ASSERT(on.radius == layer_radius(winch, on.layer));
}

TEST(Drum, PullFallsWithTheLayers) {
  const double M = 2400;
  EXPECT_NEAR(pull_at_layer(winch, 1, M), M / 0.16, 1e-9);
  EXPECT_NEAR(pull_at_layer(winch, 5, M) / pull_at_layer(winch, 1, M), 0.16 / 0.24, 1e-15);
  EXPECT_NEAR(torque_at_layer(winch, 3, pull_at_layer(winch, 3, M)), M, 1e-9);
}

TEST(Drum, BeddedAndGroovedDrums) {
  DrumLayers d = winch;
  d.pitch = 0.021;
  d.layer_height = 0.0175;
  EXPECT_EQ(turns_per_layer(d), 19);
  EXPECT_NEAR(layer_radius(d, 3), 0.16 + 2 * 0.0175, 1e-15);
  EXPECT_EQ(layers_within_flanges(d), 5);
}

TEST(Drum, RefusesWhatIsNone) {
  EXPECT_THROW(layer_radius(winch, 0), ContractViolation);
  EXPECT_THROW(turns_per_layer({}), ContractViolation);
  EXPECT_THROW(on_drum(winch, -1), ContractViolation);
}

// What fits exactly does so in any unit: 0.432 m - 0.4 m is 0.032 m less a rounding.
TEST(Drum, WhatFitsExactlyFits) {
  for (const auto& [core, rope, flange] : {std::array{0.4, 0.016, 0.432},
                                           {0.4, 0.015, 0.43},
                                           {0.4, 0.02, 0.44},
                                           {0.4, 0.018, 0.436},
                                           {0.6, 0.014, 0.628}}) {
    const DrumLayers one{.core_diameter = core, .rope_diameter = rope, .width = 7 * rope, .flange_diameter = flange};
    EXPECT_EQ(layers_within_flanges(one), 1) << rope;
    EXPECT_EQ(turns_per_layer(one), 7) << rope;
    DrumLayers less = one;
    less.flange_diameter -= 1e-9;
    EXPECT_EQ(layers_within_flanges(less), 0) << rope;
  }
}

}  // namespace taut::rope::drum_test
