#include "taut/catalogue/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "taut/catalogue/section_search.hpp"
#include "test/paths.hpp"

namespace taut::catalogue::section_test {

constexpr double pi = std::numbers::pi;

/// Properties of a closed outline with rounded corners, by summing strips: knows nothing of the closed formulas.
struct Strips {
  double area = 0.0, second_moment = 0.0, plastic_modulus = 0.0;
};

Strips strips(double width, double height, double radius) {
  constexpr int n = 4000;
  Strips out;
  for (int i = 0; i < n; ++i) {
    // Angles instead of equal steps near the corner would be finer; 4000 strips are enough for 0.1 %.
    const double y = (i + 0.5) / n * height / 2.0;
    const double into_corner = std::max(0.0, y - (height / 2.0 - radius));
    const double w = width - 2.0 * (radius - std::sqrt(std::max(0.0, radius * radius - into_corner * into_corner)));
    const double dA = 2.0 * w * height / 2.0 / n;
    out.area += dA;
    out.second_moment += dA * y * y;
    out.plastic_modulus += dA * y;
  }
  return out;
}

Strips hollow(const SectionRow& row, double width, double height) {
  const Strips outer = strips(width, height, row.outer_radius);
  const Strips inner = strips(width - 2.0 * row.thickness, height - 2.0 * row.thickness, row.inner_radius);
  return {.area = outer.area - inner.area,
          .second_moment = outer.second_moment - inner.second_moment,
          .plastic_modulus = outer.plastic_modulus - inner.plastic_modulus};
}

TEST(Sections, the_built_in_table_is_read_whole) {
  EXPECT_EQ(sections().size(), 1571U);
  std::set<std::string> names;
  std::map<SectionShape, int> shapes;
  for (const SectionRow& row : sections()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.trust_text.empty()) << row.name;
    ++shapes[row.shape];
  }
  EXPECT_EQ(shapes.size(), 3U);
}

TEST(Sections, tubes_are_rings) {
  for (const SectionRow& row : sections()) {
    if (row.shape != SectionShape::chs) continue;
    const double D = row.height;
    const double d = D - 2.0 * row.thickness;
    const double I = pi / 64.0 * (std::pow(D, 4) - std::pow(d, 4));
    EXPECT_NEAR(row.area / (pi / 4.0 * (D * D - d * d)), 1.0, 1e-4) << row.name;
    EXPECT_NEAR(row.I_y / I, 1.0, 1e-4) << row.name;
    EXPECT_NEAR(row.W_el_y / (2.0 * I / D), 1.0, 1e-4) << row.name;
    EXPECT_NEAR(row.W_pl_y / ((D * D * D - d * d * d) / 6.0), 1.0, 1e-4) << row.name;
    EXPECT_NEAR(row.I_t / (2.0 * I), 1.0, 1e-4) << row.name;
    EXPECT_EQ(row.I_y, row.I_z) << row.name;
  }
}

TEST(Sections, all_agree_with_numerical_integration) {
  for (const SectionRow& row : sections()) {
    const Strips y = hollow(row, row.width, row.height);
    const Strips z = hollow(row, row.height, row.width);
    const double tolerance = 0.005;
    EXPECT_NEAR(row.area / y.area, 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.I_y / y.second_moment, 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.I_z / z.second_moment, 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.W_el_y / (2.0 * y.second_moment / row.height), 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.W_el_z / (2.0 * z.second_moment / row.width), 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.W_pl_y / y.plastic_modulus, 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.W_pl_z / z.plastic_modulus, 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.i_y / std::sqrt(y.second_moment / y.area), 1.0, tolerance) << row.name;
    EXPECT_NEAR(row.mass_per_length / (7850.0 * y.area), 1.0, tolerance) << row.name;
  }
}

// EN 10210-2: A = 2t(B + H - 2t) - (4 - pi)(r_o^2 - r_i^2) with r_o = 1.5 t, r_i = t.
TEST(Sections, hot_finished_rectangles_follow_their_formula) {
  for (const SectionRow& row : sections()) {
    if (row.shape == SectionShape::chs || row.forming != Forming::hot) continue;
    const double t = row.thickness;
    const double area = 2.0 * t * (row.width + row.height - 2.0 * t) - (4.0 - pi) * 1.25 * t * t;
    EXPECT_NEAR(row.area / area, 1.0, 1e-4) << row.name;
    EXPECT_NEAR(row.outer_radius, 1.5 * t, 1e-6) << row.name;
  }
}

TEST(Sections, figures_that_a_printed_table_gives) {
  const auto tube = find_section("CHS 508x16");  // 247 cm2, 74900 cm4, 2950 cm3, 3870 cm3, 194 kg/m
  ASSERT_TRUE(tube);
  EXPECT_NEAR(tube->area, 247e-4, 0.5e-4);
  EXPECT_NEAR(tube->I_y, 74900e-8, 50e-8);
  EXPECT_NEAR(tube->W_el_y, 2950e-6, 5e-6);
  EXPECT_NEAR(tube->W_pl_y, 3870e-6, 10e-6);
  EXPECT_NEAR(tube->mass_per_length, 194.0, 0.5);
  const auto box = find_section("SHS 100x100x5");  // 18.7 cm2, 279 cm4, 55.9 cm3, 66.4 cm3, 14.7 kg/m
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->area, 18.7e-4, 0.05e-4);
  EXPECT_NEAR(box->I_y, 279e-8, 0.5e-8);
  EXPECT_NEAR(box->W_el_y, 55.9e-6, 0.05e-6);
  EXPECT_NEAR(box->W_pl_y, 66.4e-6, 0.05e-6);
  EXPECT_NEAR(box->mass_per_length, 14.7, 0.05);
}

TEST(Sections, a_broken_table) {
  // The built-in table with one figure spoilt: the reader must point at it.
  std::ifstream file(taut_test::source_dir() / "data/sections/sections.csv");
  std::stringstream text;
  text << file.rdbuf();
  std::string broken = text.str();
  ASSERT_TRUE(read_sections(broken, "s.csv"));
  const std::string good = "CHS 21.3x2.3,EN 10210-2,CHS,hot,21.3,21.3,2.3,";
  ASSERT_NE(broken.find(good), std::string::npos);
  broken.replace(broken.find(good), good.size(), "CHS 21.3x2.3,EN 10210-2,IPE,warm,21.3,21.3,23,");
  const auto read = read_sections(broken, "s.csv");
  ASSERT_FALSE(read);
  ASSERT_EQ(read.error().size(), 2U);
  EXPECT_EQ(read.error()[0].message, "shape 'IPE' is not CHS, SHS or RHS");
  EXPECT_EQ(read.error()[0].place, (Place{2, 25}));
  EXPECT_EQ(read.error()[1].message, "forming 'warm' is not hot, cold, seamless or welded");
}

}  // namespace taut::catalogue::section_test
