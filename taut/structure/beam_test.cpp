#include "taut/structure/beam.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/section_search.hpp"

namespace taut::structure::beam_test {

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
