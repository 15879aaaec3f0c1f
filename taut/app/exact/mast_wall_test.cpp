#include "taut/app/exact/mast_wall.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/section_search.hpp"

namespace taut::app::mast_wall_test {

/// EN 1993-1-1, table 5.2, tubes of class 3: D/t <= 90 * 235 MPa/f_y, by hand.
TEST(MastWall, ATubeIsOfClassThreeUpToItsOwnYieldStress) {
  const auto tube = catalogue::find_section("CHS 1016x8");
  ASSERT_TRUE(tube);
  const double most = 90 * 235e6 / (tube->height / tube->thickness);
  mast_section::ClampForces f;
  f.N = 1e5;
  EXPECT_EQ(wall_of({}, *tube, 0.999 * most, f).value, 3);
  EXPECT_EQ(wall_of({}, *tube, 1.001 * most, f).value, 4);
}

}  // namespace taut::app::mast_wall_test
