#include "taut/structure/beam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/catalogue/section_search.hpp"

namespace taut::structure::beam_test {

TEST(Beam, EndMomentBendsItToACircle) {
  const BeamSection b = tube_section(0.2, 0.01);
  BeamState s;
  const double L = 5, radius = 5;
  s.moment = {0, b.EI_x / radius, 0};
  const BeamState end = carry(b, s, L, 200);
  EXPECT_NEAR(end.place.x(), radius * (1 - std::cos(L / radius)), 1e-9);
  EXPECT_NEAR(end.place.z(), radius * std::sin(L / radius), 1e-9);
  EXPECT_NEAR(end.axes(0, 2), std::sin(1), 1e-9);
  EXPECT_NEAR((end.moment - s.moment).norm(), 0, 1e-9);
  EXPECT_NEAR(section_forces(end).bends_to_x, b.EI_x / radius, 1e-3);
}

TEST(Beam, SectionForcesBelongToTheirDirections) {
  BeamState s;
  s.force = {1, 2, -3};
  s.moment = {4, 5, 6};
  const SectionForces f = section_forces(s);
  EXPECT_EQ(f.axial, -3);
  EXPECT_EQ(f.shear_x, 1);
  EXPECT_EQ(f.shear_y, 2);
  EXPECT_EQ(f.bends_to_x, 5);   // about +y: z leans towards +x
  EXPECT_EQ(f.bends_to_y, -4);  // about +x: z leans towards -y
  EXPECT_EQ(f.torsion, 6);
}

TEST(Beam, StiffnessOfAStraightPieceIsTheTextbooks) {
  BeamSection b = tube_section(0.2, 0.01);
  b.EI_y = b.EI_x / 3;
  const double L = 2, EI = b.EI_x;
  const auto K = piece_stiffness([&](const BeamState& s) { return carry(b, s, L, 40); }, {}, L, EI);
  EXPECT_NEAR(K(0, 0), 12 * EI / std::pow(L, 3), 1e-6 * K(0, 0));
  EXPECT_NEAR(K(1, 1), 12 * b.EI_y / std::pow(L, 3), 1e-6 * K(1, 1));
  EXPECT_NEAR(K(2, 2), b.EA / L, 1e-6 * K(2, 2));
  EXPECT_NEAR(K(4, 4), 4 * EI / L, 1e-6 * K(4, 4));
  EXPECT_NEAR(K(4, 10), 2 * EI / L, 1e-6 * K(4, 4));
  EXPECT_NEAR(K(3, 3), 4 * b.EI_y / L, 1e-6 * K(3, 3));
  EXPECT_NEAR(K(5, 5), b.GJ / L, 1e-6 * K(5, 5));
  EXPECT_LT((K - K.transpose()).norm(), 1e-6 * K.norm());
}

TEST(Beam, StressOfTubesAndBoxes) {
  const auto tube = catalogue::find_section("CHS 508x16"), box = catalogue::find_section("RHS 200x100x8");
  ASSERT_TRUE(tube && box);
  const BeamSection t = beam_section(*tube), b = beam_section(*box);
  EXPECT_NEAR(largest_stress(t, -1e5, 3e4, 4e4), 1e5 / tube->area + 5e4 / tube->W_el_y, 1e-3);
  EXPECT_NEAR(largest_stress(b, -1e5, 3e3, -4e3), 1e5 / box->area + 3e3 / box->W_el_y + 4e3 / box->W_el_z, 1e-3);
  EXPECT_GT(b.EI_x, b.EI_y) << "the strong axis takes the span's plane";
  EXPECT_NEAR(tube_section(0.508, 0.016).EI_x / t.EI_x, 1, 1e-3);
  EXPECT_NEAR(tube_section(0.508, 0.016).W_x / t.W_x, 1, 1e-3);
}

}  // namespace taut::structure::beam_test
