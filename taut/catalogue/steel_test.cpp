#include "taut/catalogue/steel.hpp"

#include <gtest/gtest.h>

#include <set>

namespace taut::catalogue::steel_test {

TEST(Steels, the_built_in_table) {
  std::set<std::string> names;
  for (const SteelRow& steel : steels()) {
    EXPECT_TRUE(names.insert(full_name(steel)).second) << full_name(steel);
    EXPECT_FALSE(steel.trust_text.empty()) << full_name(steel);
    EXPECT_EQ(steel.trust == Trust::verified, steel.basis == SteelBasis::design) << full_name(steel);
    double last = 1e12;
    for (const SteelRange& range : steel.ranges) {
      EXPECT_LE(range.yield, last) << full_name(steel);  // thicker is never stronger
      last = range.yield;
    }
    EXPECT_EQ(find_steel(full_name(steel))->name, steel.name);
  }
  EXPECT_EQ(steels().size(), 41U);
}

TEST(Steels, yield_by_thickness_design) {
  const auto steel = find_steel("S355");
  ASSERT_TRUE(steel);
  EXPECT_EQ(steel->basis, SteelBasis::design);
  EXPECT_EQ(yield(*steel), 355e6);
  EXPECT_EQ(yield(*steel, 0.016), 355e6);
  EXPECT_EQ(yield(*steel, 0.040), 355e6);
  EXPECT_EQ(yield(*steel, 0.041), 335e6);
  EXPECT_EQ(yield(*steel, 0.080), 335e6);
  EXPECT_EQ(yield(*steel, 0.04000000001), 355e6);  // 40 mm, with the noise of a computation
}

TEST(Steels, yield_by_thickness_product) {
  EXPECT_EQ(yield("S355 product", 0.016), 355e6);
  EXPECT_EQ(yield("S355 product", 0.0161), 345e6);
  EXPECT_EQ(yield("S355 product", 0.041), 335e6);
  EXPECT_EQ(yield("S355 product", 0.080), 325e6);
  EXPECT_EQ(yield("09G2S", 0.012), 325e6);
  EXPECT_EQ(find_steel("09\u04132\u0421")->name, "09G2S");
}

TEST(Steels, beyond_the_table) {
  EXPECT_EQ(yield("S355", 0.081).error().message,
            "EN 10025-2 S355 has no yield stress for 81 mm: its table goes from 0 to 80 mm");
  EXPECT_FALSE(yield("S690Q", 0.002));
  EXPECT_FALSE(yield("S355", 0.0));
  EXPECT_FALSE(yield("S355", -0.01));
  EXPECT_FALSE(yield("oak", 0.01));
}

TEST(Steels, names) {
  EXPECT_EQ(find_steel("s355")->name, "S355");
  EXPECT_EQ(find_steel("S355NL")->name, "S355N");
  EXPECT_EQ(find_steel("S355H EN 10210-1")->standard, "EN 10210-1");
  EXPECT_EQ(find_steel("EN 10219-1 S355H")->standard, "EN 10219-1");
  EXPECT_EQ(find_steel("S690Q")->basis, SteelBasis::product);
  const auto two = find_steel("S355H");
  ASSERT_FALSE(two);
  EXPECT_EQ(to_text(two.error()),
            "steel 'S355H' is in 2 standards; did you mean 'EN 10210-1 S355H' or 'EN 10219-1 S355H'?");
  const auto none = find_steel("S350");
  ASSERT_FALSE(none);
  EXPECT_FALSE(none.error().candidates.empty());
}

TEST(Steels, a_users_table) {
  const std::string header = "name,also,standard,basis,t_over_mm,t_to_mm,fy_MPa,fu_MPa,trust\n";
  ASSERT_TRUE(
      read_steels(header + "X,,own,product,0,16,700,800,verified\nX,,own,product,16,40,650,800,unverified\n", "x"));
  const auto weak =
      read_steels(header + "X,,own,product,0,16,700,800,verified\nX,,own,product,16,40,650,800,unverified\n", "x");
  EXPECT_EQ(weak->front().trust, Trust::unverified);
  EXPECT_FALSE(
      read_steels(header + "X,,own,product,0,16,700,800,verified\nX,,own,product,20,40,650,800,verified\n", "x"));
  EXPECT_FALSE(read_steels(header + "X,,own,product,16,16,700,800,verified\n", "x"));
  EXPECT_FALSE(read_steels(header + "X,,own,product,0,16,700,600,verified\n", "x"));
  EXPECT_FALSE(read_steels(header + "X,,own,guess,0,16,700,800,verified\n", "x"));
}

}  // namespace taut::catalogue::steel_test
