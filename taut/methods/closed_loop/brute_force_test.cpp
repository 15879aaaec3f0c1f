#include <gtest/gtest.h>

#include <random>

#include "taut/catalogue/rope_search.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace taut::closed_loop::brute_force_test {

/// Largest tensions over the positions with these weights, hauled in and out; infinite where a position has none.
Peaks peaks_with(Input in, double q_b, double q_T) {
  Peaks peaks;
  for (const Haul haul : {Haul::in, Haul::out}) {
    in.haul = haul;
    for (const Row& row : sweep(in, {.q_b = q_b, .q_T = q_T, .return_rope = {}, .traction_rope = {}})) {
      if (row.outcome.ok()) peaks = larger(peaks, closed_form_peaks_of(row.out));
    }
  }
  return peaks;
}

bool passes(const Input& in, const catalogue::RopeRow& b, const catalogue::RopeRow& t) {
  const Peaks peaks = peaks_with(in, b.mass_per_length * standard_gravity, t.mass_per_length * standard_gravity);
  const double n = *in.safety_factor;
  return peaks.return_rope.tension > 0 && b.breaking_force >= n * peaks.return_rope.tension &&
         t.breaking_force >= n * peaks.traction_rope.tension;
}

Input random_loop(std::mt19937& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Input in;
  in.span = between(100, 400);
  in.slope = between(-0.3, 0.3);
  in.sag = in.span * between(0.04, 0.09);
  in.position = {0.3 * in.span, 0.5 * in.span, 0.7 * in.span};
  in.gathering_force = between(8e3, 40e3);
  in.gathering_angle = between(0.1, 0.6);
  in.tail_efficiency = between(0.85, 1);
  in.safety_factor = between(3, 4.5);
  in.choose_ropes.emplace();
  const char* const classes[] = {"6x7", "6x19", "6x36", "8x36"};
  in.choose_ropes->construction = classes[random() % 4];
  if (random() % 2 == 0) in.choose_ropes->grade = random() % 2 == 0 ? 1770e6 : 1960e6;
  return in;
}

// All pairs of ropes that are not larger than the pair chosen, the loop solved with the weights of each: none but the
// pair itself passes, and that one does.
TEST(ClosedLoopChoice, no_smaller_pair_passes_in_200_random_loops) {
  std::mt19937 random(12);
  int chosen = 0;
  for (int i = 0; i < 200; ++i) {
    const Input in = random_loop(random);
    Ropes ropes;
    const Outcome outcome = ropes_of(in, ropes);
    catalogue::RopeFilter filter;
    filter.construction = *in.choose_ropes->construction;
    filter.grade = in.choose_ropes->grade;
    const auto all = catalogue::ropes_by(catalogue::RopeOrder::diameter, filter);
    if (!outcome.ok()) continue;
    ++chosen;
    EXPECT_TRUE(passes(in, *ropes.return_rope, *ropes.traction_rope)) << i;
    for (const auto& b : all) {
      for (const auto& t : all) {
        const bool same = b.id == ropes.return_rope->id && t.id == ropes.traction_rope->id;
        if (!same) {
          EXPECT_FALSE(passes(in, b, t)) << i << " " << b.id << " " << t.id;
        }
        if (t.id == ropes.traction_rope->id) break;
      }
      if (b.id == ropes.return_rope->id) break;
    }
  }
  EXPECT_GT(chosen, 100);
}

}  // namespace taut::closed_loop::brute_force_test
