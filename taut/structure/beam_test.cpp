#include "taut/structure/beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/catalogue/section_search.hpp"

namespace taut::structure::beam_test {

TEST(Beam, StressOfTubesAndBoxes) {
  const auto tube = catalogue::find_section("CHS 508x16"), box = catalogue::find_section("RHS 200x100x8");
  ASSERT_TRUE(tube && box);
  const BeamSection t = beam_section(*tube), b = beam_section(*box);
  EXPECT_NEAR(largest_stress(t, {.axial = -1e5, .bends_to_x = 3e4, .bends_to_y = 4e4}),
              1e5 / tube->area + 5e4 / tube->W_el_y, 1e-3);
  EXPECT_NEAR(largest_stress(b, {.axial = -1e5, .bends_to_x = 3e3, .bends_to_y = -4e3}),
              1e5 / box->area + 3e3 / box->W_el_y + 4e3 / box->W_el_z, 1e-3);
  EXPECT_GT(b.EI_x, b.EI_y) << "the strong axis takes the span's plane";
  EXPECT_NEAR(tube_section(0.508, 0.016).EI_x / t.EI_x, 1, 1e-3);
  EXPECT_NEAR(tube_section(0.508, 0.016).W_x / t.W_x, 1, 1e-3);
}

TEST(Beam, ShearInThePlaneOfTheBendingDoesNotCountInItsFibre) {
  const BeamSection t = beam_section(*catalogue::find_section("CHS 508x16"));
  const SectionForces plain{.axial = -1e5, .bends_to_x = 3e4, .bends_to_y = 0};
  SectionForces sheared = plain;
  sheared.shear_x = 2e4;
  EXPECT_EQ(largest_stress(t, sheared), largest_stress(t, plain));
  EXPECT_EQ(largest_stress(t, plain), 1e5 / t.area + 3e4 / t.W_x) << "to the last digit";
}

// CHS 219.1x8: A 5305.4 mm2, W_el 269.9 cm3, W_t = 2 W_el.
TEST(Beam, TorsionAddsByVonMises) {
  const auto row = catalogue::find_section("CHS 219.1x8");
  const BeamSection t = beam_section(*row);
  EXPECT_NEAR(t.W_t / (2 * row->W_el_y), 1, 1e-3);
  const SectionForces f{.axial = -10e3, .bends_to_x = 81e3, .bends_to_y = 0, .torsion = -99.4e3};
  const double sigma = 10e3 / row->area + 81e3 / row->W_el_y, tau = 99.4e3 / t.W_t;
  const PointStress p = most_stressed_point(t, f);
  EXPECT_NEAR(p.sigma, sigma, 1e-9 * sigma);
  EXPECT_NEAR(p.tau, tau, 1e-9 * tau);
  EXPECT_NEAR(largest_stress(t, f), std::sqrt(sigma * sigma + 3 * tau * tau), 1e-3);
  EXPECT_GT(largest_stress(t, f), 1.2 * 355e6);
}

// Against walking around the tube; a hinged stub (no moment) has its largest stress where the shear is.
TEST(Beam, TheMostStressedPointOfATubeIsTheWorstOfAll) {
  const BeamSection t = tube_section(0.2, 0.01);
  const double A = t.area, W = t.W_x;
  for (const SectionForces& f : {SectionForces{.axial = -2e5, .shear_x = 3e5, .bends_to_x = 9e3, .torsion = 2e4},
                                 {.axial = 1e5, .shear_x = 4e5, .shear_y = -3e5, .bends_to_x = 2e4, .bends_to_y = 1e4},
                                 {.axial = 5e4, .shear_y = 2e5, .torsion = -3e4},
                                 {.axial = 3e5, .shear_x = 1e5, .shear_y = 2e5, .bends_to_y = 3e4, .torsion = 1e4},
                                 {.shear_x = 1e5},
                                 {.axial = 1e5}}) {
    const double M = std::hypot(f.bends_to_x, f.bends_to_y), V = std::hypot(f.shear_x, f.shear_y);
    const double apart = M > 0 ? std::acos((f.shear_x * f.bends_to_x + f.shear_y * f.bends_to_y) / M / V) : 0;
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
      const double at = std::numbers::pi * i / 10000;
      const double sigma = std::abs(f.axial) / A + M / W * std::cos(at);
      for (const double sign : {-1, 1}) {
        const double tau = std::abs(f.torsion) / t.W_t + sign * 2 * V / A * std::sin(at - apart);
        most = std::max(most, std::hypot(sigma, std::numbers::sqrt3 * tau));
      }
    }
    if (V == 0) most = std::abs(f.axial) / A;
    EXPECT_NEAR(largest_stress(t, f) / most, 1, 1e-7) << f.axial << " " << M << " " << V;
  }
}

// RHS 200x100x8 by hand: Jourawski's flow in the corner and in the middle of a wall.
TEST(Beam, ShearOfABox) {
  const auto row = catalogue::find_section("RHS 200x100x8");
  const BeamSection b = beam_section(*row);
  const double V = 2e5, corner = V * 0.192 * 0.092 / (4 * row->I_y), middle = V * row->W_pl_y / 2 / (row->I_y * 0.016);
  EXPECT_NEAR(largest_stress(b, {.shear_x = V}), std::sqrt(3) * middle, 1e-6 * middle);
  const double sigma = 40e3 / row->W_el_y;
  EXPECT_GE(largest_stress(b, {.shear_x = V, .bends_to_x = 40e3}), std::hypot(sigma, std::sqrt(3) * corner));
  EXPECT_LE(largest_stress(b, {.shear_x = V, .bends_to_x = 40e3}), std::hypot(sigma, std::sqrt(3) * middle));
  EXPECT_LT(largest_stress(b, {.shear_x = V / 50, .bends_to_x = 40e3}), 1.001 * sigma);
}

// One modulus, axes not said: a moment of any direction has one stress, and sqrt(2) of it in the worst corner.
TEST(Beam, OutlineNotSaid) {
  BeamSection b = tube_section(0.2, 0.01);
  b.outline = Outline::unsaid;
  b.shear_x = b.shear_y = {};
  const double M = 30e3, N = 1e5 / b.area;
  for (const double at : {0.0, 0.3, 0.7, 2.0}) {
    const SectionForces f{.axial = -1e5, .bends_to_x = M * std::cos(at), .bends_to_y = M * std::sin(at)};
    EXPECT_NEAR(largest_stress(b, f) / (N + M / b.W_x), 1, 1e-12);
    EXPECT_NEAR(largest_stress_in_corner(b, f) / (N + std::sqrt(2) * M / b.W_x), 1, 1e-12);
    BeamSection box = b;
    box.outline = Outline::box;
    EXPECT_LE(largest_stress(box, f), largest_stress_in_corner(b, f) * (1 + 1e-12));
    EXPECT_EQ(largest_stress_in_corner(box, f), largest_stress(box, f));
  }
}

TEST(Beam, TorsionWithoutAModulusIsSaidToBeLeftOut) {
  BeamSection b = tube_section(0.2, 0.01);
  EXPECT_FALSE(leaves_out_torsion(b, {.axial = 1e5, .torsion = 1e4}));
  b.W_t = 0;
  EXPECT_TRUE(leaves_out_torsion(b, {.axial = 1e5, .torsion = 100}));
  EXPECT_FALSE(leaves_out_torsion(b, {.axial = 1e5, .torsion = 1e-9})) << "rounding";
  EXPECT_FALSE(leaves_out_torsion(b, {.axial = 1e5}));
}

}  // namespace taut::structure::beam_test
