#include "taut/rope/strength.hpp"

#include <gtest/gtest.h>

#include "taut/calc/sheet.hpp"

namespace taut::rope::strength_test {

// A sheave maker's public table of strength against D/d (D/d, percent), printed to whole percents.
TEST(Strength, on_a_sheave_against_a_public_table) {
  constexpr double table[][2] = {{40, 95}, {30, 93}, {20, 91}, {15, 89}, {10, 86}, {8, 83}, {6, 79}, {4, 75}, {1, 50}};
  for (const auto& [ratio, percent] : table) {
    const double own = sheave_strength(ratio) * 100;
    EXPECT_LE(own, percent + 1.0) << ratio;  // the table's own rounding and no more
    EXPECT_GE(own, percent - 4.0) << ratio;
  }
  EXPECT_NEAR(sheave_strength(16.0), 0.875, 1e-12);
}

// Shigley, worked example 17-6 (monitor steel 6x19, 1 1/2 in. rope, 72 in. sheave): E_r = 12e6 psi, d_w = 0.067 d,
// A_m = 0.40 d^2 give F_b = 15.1 kip... here in the example's own figures: E_r d_w A_m/D.
TEST(Strength, bending_pull_of_a_textbook) {
  constexpr double inch = 0.0254;
  constexpr double psi = 6894.757;
  constexpr double pound = 4.4482216;
  const double d = 1.5 * inch;
  const double F_b = bending_pull(12e6 * psi, 0.067 * d, 0.40 * d * d, 72 * inch);
  EXPECT_NEAR(F_b / pound, 12e6 * 0.067 * 1.5 * 0.40 * 2.25 / 72, 0.5);
  EXPECT_NEAR(bending_stress(12e6 * psi, 0.067 * d, 72 * inch) * 0.40 * d * d, F_b, 1e-6 * F_b);
}

TEST(Strength, groove_pressure_is_twice_the_pull_over_the_projected_area) {
  EXPECT_NEAR(groove_pressure(100e3, 0.02, 0.5), 20e6, 1e-6);
}

// gamma_rb falls with D/d to its least value 2.07; 1.35 + 5/(20^0.8 - 4) = 2.0658 lies below it, 18 above.
TEST(Strength, resistance_factor) {
  EXPECT_NEAR(resistance_factor(11.2), 1.35 + 5 / (std::pow(11.2, 0.8) - 4), 1e-12);
  EXPECT_DOUBLE_EQ(resistance_factor(20.0), 2.07);
  EXPECT_GT(resistance_factor(18.0), 2.07);
  double last = 1e9;
  for (double ratio = 6; ratio < 40; ratio += 0.5) {
    EXPECT_LE(resistance_factor(ratio), last);
    last = resistance_factor(ratio);
  }
}

// s_r = 1 for half a million bendings at full force: F_u/7.
TEST(Strength, fatigue_pull) {
  EXPECT_NEAR(force_history(1.0, 5e5), 1, 1e-15);
  EXPECT_NEAR(fatigue_pull(700e3, 1.0, 1.0), 100e3, 1e-6);
  EXPECT_NEAR(fatigue_pull(700e3, 1.0, 8.0), 50e3, 1e-6);
}

// The catalogue's rule F_min = K d^2 R_r, read backwards.
TEST(Strength, least_diameter_gives_the_breaking_force_back) {
  const double d = least_diameter(4.5, 50e3, 0.356, 1960e6);
  EXPECT_NEAR(0.356 * d * d * 1960e6 / 50e3, 4.5, 1e-12);
}

TEST(Strength, the_laws_write_themselves_down) {
  EXPECT_EQ(value(resistance_factor(Num(11.2))), resistance_factor(11.2));
  const Num ratio = Num::named("D/d", si::one, 20);
  EXPECT_EQ(formula_text(sheave_strength(ratio).formula()), "1 - 0.5/sqrt(D/d)");
}

}  // namespace taut::rope::strength_test
