#include "taut/catalogue/rope.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "taut/catalogue/rope_factor.hpp"
#include "taut/catalogue/rope_search.hpp"

namespace taut::catalogue::rope_test {

TEST(Ropes, the_built_in_table_is_read_whole) {
  EXPECT_EQ(ropes().size(), 1613U);
  EXPECT_EQ(&ropes(), &ropes());
  std::set<std::string> ids;
  for (const RopeRow& row : ropes()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.trust_text.empty()) << row.id;
  }
}

TEST(Ropes, figures_are_those_of_steel_ropes) {
  for (const RopeRow& row : ropes()) {
    const double circle = std::numbers::pi / 4.0 * row.diameter * row.diameter;
    EXPECT_GT(row.area, 0.42 * circle) << row.id;
    EXPECT_LT(row.area, 0.71 * circle) << row.id;
    const double density =
        row.mass_per_length / row.area;  // above 7850: wires run longer than the rope; core and grease
    EXPECT_GT(density, 8700.0) << row.id;
    EXPECT_LT(density, 10000.0) << row.id;
    if (!row.grade) continue;
    const double lay_loss = row.breaking_force / (row.area * *row.grade);
    EXPECT_GT(lay_loss, 0.75) << row.id;
    EXPECT_LT(lay_loss, 0.905) << row.id;
  }
}

TEST(Ropes, en_rows_follow_the_factors_of_their_class) {
  std::size_t compared = 0;
  for (const RopeRow& row : ropes()) {
    if (row.standard != "EN 12385-4") continue;
    const auto factors = find_rope_factors(row.construction, row.core);
    ASSERT_TRUE(factors) << row.id;
    const double d2 = row.diameter * row.diameter;
    EXPECT_NEAR(row.breaking_force / (factors->breaking_factor * d2 * *row.grade), 1.0, 5e-4) << row.id;
    EXPECT_NEAR(row.area / (factors->area_factor * d2), 1.0, 1e-4) << row.id;
    EXPECT_NEAR(row.mass_per_length / (factors->mass_factor * d2), 1.0, 1e-3) << row.id;
    ++compared;
  }
  EXPECT_EQ(compared, 1350U);
}

// A second public table of the same class (API 9A, 6x7 with fibre core), as printed: d mm, kg/m, kN in 1770.
TEST(Ropes, en_6x7_agrees_with_the_printed_table_of_another_standard) {
  struct Printed {
    double diameter, mass, force;
  };
  for (const auto& [d, mass, force] :
       {Printed{.diameter = 6, .mass = 0.124, .force = 21.2}, Printed{.diameter = 10, .mass = 0.345, .force = 58.8},
        Printed{.diameter = 16, .mass = 0.883, .force = 150}, Printed{.diameter = 28, .mass = 2.70, .force = 461},
        Printed{.diameter = 40, .mass = 5.52, .force = 940}}) {
    const auto row = find_rope(
        RopeDescription{.construction = "6x7", .core = "FC", .diameter = d / 1e3, .grade = 1770e6, .standard = "EN"});
    ASSERT_TRUE(row) << d;
    EXPECT_NEAR(row->mass_per_length / mass, 1.0, 0.005) << d;
    EXPECT_NEAR(row->breaking_force / (force * 1e3), 1.0, 0.005) << d;
  }
}

TEST(Ropes, force_and_mass_grow_with_diameter) {
  for (const RopeRow& a : ropes()) {
    for (const RopeRow& b : ropes()) {
      if (a.standard != b.standard || a.construction != b.construction || a.core != b.core || a.grade != b.grade)
        continue;
      if (!a.grade || !(a.diameter < b.diameter)) continue;
      ASSERT_LT(a.breaking_force, b.breaking_force) << a.id << " " << b.id;
      ASSERT_LT(a.mass_per_length, b.mass_per_length) << a.id << " " << b.id;
      ASSERT_LT(a.area, b.area) << a.id << " " << b.id;
    }
  }
}

constexpr std::string_view header =
    "id,standard,construction,core,d_mm,area_mm2,mass_kg_per_m,grade_MPa,mbf_kN,trust,trust_text\n";

std::vector<std::string> mistakes(std::string_view lines) {
  const auto read = read_ropes(fmt::format("{}{}", header, lines), "mine.csv");
  std::vector<std::string> out;
  if (read) return out;
  for (const Diagnostic& d : read.error())
    out.push_back(fmt::format("{}:{} {}", d.place.line, d.place.column, d.message));
  return out;
}

TEST(Ropes, a_table_without_rows_is_told) {
  const auto read = read_ropes(header, "mine.csv");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().at(0).message, "the table has no rows, only the names of its columns");
}

TEST(Ropes, a_users_table) {
  const auto read = read_ropes(fmt::format("{}A,maker,6x26K,IWRC,16,140,1.2,1960,230,verified,\"certificate, 2024\"\n"
                                           "B,maker,swaged,,20,220,1.98,,356,unverified,\n",
                                           header),
                               "mine.csv");
  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->at(0).area_trust, Trust::verified);  // as trust, when the column is not there
  EXPECT_EQ(read->at(0).trust_text, "certificate, 2024");
  EXPECT_FALSE(read->at(1).grade);
  EXPECT_EQ(read->at(1).core, "");
}

TEST(Ropes, slips_of_unit_in_a_users_table) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(mistakes("A,maker,6x36,FC,1.6,126,1.2,1960,20,verified,\n"),
            Texts{"2:21 a metallic area of 126 mm2 does not fit into a rope of 1.6 mm (2.01062 mm2)"});
  EXPECT_EQ(mistakes("A,maker,6x36,FC,16,100,0.94,1770,165000,verified,\n"),
            Texts{"2:34 a breaking force of 165000 kN is above area x grade = 177 kN"});
  EXPECT_EQ(mistakes("A,maker,6x36,FC,16,100,0.94,17700,165,verified,\n"),
            Texts{"2:29 17700 MPa is no grade of a rope; wires have 1370 to 2160: look at the unit"});
  EXPECT_EQ(mistakes("A,maker,6x36,FC,16,100,0.94,,260,verified,\n"),
            Texts{"2:30 a breaking force of 260 kN on 100 mm2 is 2600 MPa; steel wire ropes have 800 to 2200: look at "
                  "the units of both"});
  EXPECT_EQ(
      mistakes("A,maker,6x36,FC,16,100,94,1770,165,verified,\n"),
      Texts{"2:24 94 kg/m on 100 mm2 are 940 g per m and mm2; wire ropes have 8 to 11: look at the units of both"});
  EXPECT_EQ(mistakes("A,maker,6x36,FC,16,100,0.94,,16.5,verified,\n"),
            Texts{"2:30 a breaking force of 16.5 kN on 100 mm2 is 165 MPa; steel wire ropes have 800 to 2200: look at "
                  "the units of "
                  "both"});
  EXPECT_EQ(
      mistakes("A,maker,6x36,FC,16,-100,0.94,1770,165,sure,\n"),
      (Texts{"2:20 area_mm2: -100 must be above 0", "2:39 trust: 'sure' is not verified, derived or unverified"}));
}

TEST(RopeFactors, table) {
  EXPECT_EQ(rope_factors().size(), 20U);
  for (const RopeFactorRow& row : rope_factors()) {
    EXPECT_NEAR(row.fill_factor, 4.0 / std::numbers::pi * row.area_factor, 1e-3) << row.construction;
    EXPECT_FALSE(row.trust_text.empty());
  }
  const auto factors = find_rope_factors("6x36WS", "IWRC");
  ASSERT_TRUE(factors);
  EXPECT_EQ(factors->breaking_factor, 0.356);
  EXPECT_DOUBLE_EQ(factors->mass_factor, 4090.0);
  EXPECT_EQ(find_rope_factors("8x19", "FC")->trust, Trust::unverified);
  EXPECT_FALSE(find_rope_factors("6x36", "oak"));
}

}  // namespace taut::catalogue::rope_test
