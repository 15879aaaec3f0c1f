#include "taut/structure/hollow_section.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/catalogue/section_search.hpp"

namespace taut::structure::hollow_section_test {

using catalogue::SectionRow;

// The catalogue's rows were computed elsewhere, and 410 of them compared with a printed table.
TEST(HollowSection, AgreesWithEveryRowOfTheCatalogue) {
  for (const SectionRow& r : catalogue::sections()) {
    const SectionRow own = hollow_section(sizes_of(r));
    const double printed = 2e-5;  // six figures
    EXPECT_NEAR(own.area / r.area, 1, printed) << r.name;
    EXPECT_NEAR(own.I_y / r.I_y, 1, printed) << r.name;
    EXPECT_NEAR(own.I_z / r.I_z, 1, printed) << r.name;
    EXPECT_NEAR(own.W_el_z / r.W_el_z, 1, printed) << r.name;
    EXPECT_NEAR(own.W_pl_y / r.W_pl_y, 1, printed) << r.name;
    EXPECT_NEAR(own.W_pl_z / r.W_pl_z, 1, printed) << r.name;
    EXPECT_NEAR(own.I_t / r.I_t, 1, printed) << r.name;
    EXPECT_NEAR(own.mass_per_length / r.mass_per_length, 1, printed) << r.name;
  }
}

TEST(HollowSection, UsualRadiiAreTheCatalogues) {
  for (const SectionRow& r : catalogue::sections()) {
    if (r.shape == catalogue::SectionShape::chs) continue;
    const HollowSizes usual = with_usual_radii(sizes_of(r));
    EXPECT_NEAR(usual.outer_radius, r.outer_radius, 1e-6) << r.name;
    EXPECT_NEAR(usual.inner_radius, r.inner_radius, 1e-6) << r.name;
  }
}

TEST(HollowSection, ThinnerWallKeepsTheOutside) {
  const SectionRow row = *catalogue::find_section("CHS 508x16");
  const SectionRow thin = with_thinner_wall(row, 0.125);
  EXPECT_DOUBLE_EQ(thin.height, row.height);
  EXPECT_NEAR(thin.thickness, 0.014, 1e-12);
  EXPECT_NEAR(thin.area, std::acos(-1.0) * (0.508 - 0.014) * 0.014, 1e-12);
  EXPECT_EQ(thin.mass_per_length, row.mass_per_length);
  EXPECT_EQ(with_thinner_wall(row, 0).name, row.name);
  EXPECT_THROW(with_thinner_wall(row, 1), ContractViolation);
}

TEST(HollowSection, RefusesWallsThatFillIt) {
  EXPECT_THROW(hollow_section({catalogue::SectionShape::chs, catalogue::Forming::hot, 0.1, 0.1, 0.05, 0, 0}),
               ContractViolation);
}

// EN 10210-2, table: C_t of SHS 100x100x5 is 81.8 cm3, W_t of a tube 2 W_el.
TEST(HollowSection, TorsionModulus) {
  const SectionRow box = *catalogue::find_section("SHS 100x100x5"), tube = *catalogue::find_section("CHS 219.1x8");
  EXPECT_NEAR(torsion_modulus(box), 81.8e-6, 0.05e-6);
  EXPECT_LT(torsion_modulus(box), 2 * enclosed_area(box) * box.thickness) << "largest above mean stress";
  EXPECT_NEAR(torsion_modulus(tube) / tube.W_el_y, 2, 2e-3);
}

}  // namespace taut::structure::hollow_section_test
