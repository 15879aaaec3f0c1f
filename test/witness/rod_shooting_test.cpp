#include "test/witness/rod_shooting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut_test::rod_shooting_test {

using namespace witness;
using taut::structure::BeamSection;
using taut::structure::tube_section;

TEST(RodShooting, EndMomentBendsItToACircle) {
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

TEST(RodShooting, StiffnessOfAStraightPieceIsTheTextbooks) {
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

}  // namespace taut_test::rod_shooting_test
