#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/closed_loop/position.hpp"
#include "test/cases/closed_loop_example.hpp"
#include "test/cross/closed_loop_tiers.hpp"

namespace taut::closed_loop::closed_loop_any_deck_test {

using namespace taut_test;
using exact_tiers::Solved;
using exact_tiers::solved;

/// Any deck that the method accepts, far beyond what is built.
Input any_deck(std::mt19937& source) {
  const auto in_range = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(source); };
  const auto power = [&](double a, double b) { return std::pow(10, in_range(a, b)); };
  const auto chance = [&](double part) { return in_range(0, 1) < part; };
  Input in = example();
  in.span = power(0, 4);
  in.slope = in_range(-1.04, 1.04);
  in.position = {in.span * in_range(0.001, 0.999)};
  in.sag.reset();
  in.mode = static_cast<Mode>(static_cast<int>(in_range(0, 4)));
  if (in.mode == Mode::sag) in.sag = in.span * power(-6, 1);
  if (in.mode == Mode::winch_pull) in.winch_pull = power(1, 7);
  if (in.mode == Mode::loop_length) in.loop_length = in.span * 2 / std::cos(in.slope) * (1 + power(-5, 0));
  in.gathering_force = power(2, 6);
  in.gathering_angle = in_range(0, 1.57);
  in.return_weight = power(-2, 3);
  in.traction_weight = power(-2, 3);
  in.tail_efficiency = in_range(0.3, 1);
  if (chance(0.3)) in.haul = Haul::out;
  if (chance(0.7)) in.return_stiffness = power(2, 9);
  if (chance(0.7)) in.traction_stiffness = power(2, 9);
  if (chance(0.6)) in.branch_distance = power(-2, 2);
  if (chance(0.5)) in.branch_offset = BranchOffset::vertical;
  if (chance(0.4)) in.roller = Roller::vertical;
  if (chance(0.5)) in.carriage_weight = power(1, 4);
  if (chance(0.3)) {
    in.carriage = Carriage::two_section;
    in.section_distance = in_range(0.001, 0.9) * std::min(in.position[0], in.span - in.position[0]);
    if (chance(0.5)) in.distance_kind = DistanceKind::rope;
    if (chance(0.5)) in.sag_of = Section::second;
    if (chance(0.5)) in.position_of = Section::second;
  }
  return in;
}

TEST(ClosedLoopAnyDeck, NoneGivesANumberThatDoesNotClose) {
  std::mt19937 source(5);
  int answered = 0;
  for (int i = 0; i < 400; ++i) {
    const Input in = any_deck(source);
    if (!complaints(in).empty()) continue;
    const Solved s = solved(in);
    const Output& o = s.out;
    if (!s.outcome.ok()) {
      EXPECT_FALSE(s.outcome.message.empty());
      continue;
    }
    if (!std::isfinite(o.T_lA_exact)) continue;
    ++answered;
    EXPECT_LE(o.residual_exact, 1e-9) << i;
    EXPECT_LE(o.closure_exact, 1e-9) << i;
    EXPECT_GT(o.P_v_exact, 0) << i;
    if (in.mode == Mode::winch_pull) {
      EXPECT_NEAR(o.T_lA_exact, *in.winch_pull, 1e-6 * *in.winch_pull) << i;
    }
    if (in.mode == Mode::loop_length) {
      EXPECT_NEAR(o.loop_length_exact, *in.loop_length, 1e-6 * *in.loop_length) << i;
    }
  }
  EXPECT_GT(answered, 100);
}

}  // namespace taut::closed_loop::closed_loop_any_deck_test
