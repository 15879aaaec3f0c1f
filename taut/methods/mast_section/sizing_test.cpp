#include "taut/methods/mast_section/sizing.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/steel.hpp"
#include "taut/methods/mast_section/plain_mast_test.hpp"

namespace taut::mast_section::sizing_test {

using catalogue::SectionShape;

const std::vector<ClampForces> loads{{.N = 160e3, .M = 850e3, .index = 0}, {.N = 190e3, .M = 700e3, .index = 1}};

TEST(MastSectionSizing, LightestPassesAndNoLighterOneDoes) {
  Input in = plain_mast();
  in.allowable_stress = 300e6;
  for (const SectionShape shape : shapes_of(in)) {
    const auto best = lightest(in, shape, loads);
    ASSERT_TRUE(best.has_value());
    EXPECT_TRUE(best->passes());
    for (const catalogue::SectionRow& row : catalogue::sections()) {
      if (row.shape != shape || row.mass_per_length >= best->section.mass_per_length) continue;
      if (row.height / row.thickness > 35.001) continue;
      EXPECT_FALSE(assess(limit_of(in), row, loads)->passes()) << row.name;
    }
  }
}

TEST(MastSectionSizing, WorstLoadDecides) {
  const auto row = catalogue::find_section("CHS 508x16");
  ASSERT_TRUE(row.has_value());
  const auto a = assess(limit_of(plain_mast()), *row, loads);
  EXPECT_EQ(a->worst.index, 0u);
  EXPECT_DOUBLE_EQ(a->stress, 160e3 / row->area + 850e3 / row->W_el_y);
  const auto swapped = assess(limit_of(plain_mast()), *row, {loads[1], loads[0]});
  EXPECT_EQ(swapped->stress, a->stress);
}

TEST(MastSectionSizing, YieldIsThatOfTheWall) {
  Input in = plain_mast();
  in.allowable_stress.reset();
  in.steel = "S355 product";
  in.safety = 2;
  const auto thin = allowable_stress(limit_of(in), 0.010), thick = allowable_stress(limit_of(in), 0.025);
  ASSERT_TRUE(thin && thick);
  EXPECT_GT(*thin, *thick);
  EXPECT_EQ(*thick, catalogue::yield("S355 product", 0.025).value() / 2);
  EXPECT_FALSE(allowable_stress(limit_of(in), 10.0).has_value());
}

TEST(MastSectionSizing, ChoiceIsKept) {
  Input in = plain_mast();
  in.allowable_stress = 300e6;
  in.choose_section = ChooseSection{.shape = SectionKind::rhs,
                                    .forming = FormingChoice::hot,
                                    .standard = "EN 10210",
                                    .least_trust = LeastTrust::verified,
                                    .largest_slenderness = 35};
  EXPECT_EQ(shapes_of(in), std::vector{SectionShape::rhs});
  const auto best = lightest(in, SectionShape::rhs, loads);
  ASSERT_TRUE(best.has_value());
  EXPECT_EQ(best->section.standard, "EN 10210-2");
  EXPECT_EQ(best->section.trust, catalogue::Trust::verified);
  in.choose_section->forming = FormingChoice::seamless;
  EXPECT_FALSE(lightest(in, SectionShape::rhs, loads).has_value());
}

TEST(MastSectionSizing, ThinWallsOnlyWhenAllowed) {
  Input in = plain_mast();
  const auto stout = lightest(in, SectionShape::chs, loads);
  in.choose_section = ChooseSection{};
  in.choose_section->largest_slenderness = 200;
  const auto thin = lightest(in, SectionShape::chs, loads);
  ASSERT_TRUE(stout && thin);
  EXPECT_LE(stout->section.height / stout->section.thickness, 35.001);
  EXPECT_GT(thin->section.height / thin->section.thickness, 50);
  EXPECT_LT(thin->section.mass_per_length, stout->section.mass_per_length);
}

TEST(MastSectionSizing, NoneWhenNonePasses) {
  const std::vector<ClampForces> huge{{.N = 1e9, .M = 1e9, .index = 0}};
  EXPECT_FALSE(lightest(plain_mast(), SectionShape::chs, huge).has_value());
  const auto best = strongest(plain_mast(), SectionShape::chs, huge);
  ASSERT_TRUE(best.has_value());
  EXPECT_GT(best->utilisation(), 1);
}

TEST(MastSectionSizing, TrustOfTheLimit) {
  Input in = plain_mast();
  EXPECT_EQ(trust_of(limit_of(in)), "user");
  in.allowable_stress.reset();
  in.safety = 2;
  in.steel = "EN 10210-1 S355H";
  EXPECT_EQ(trust_of(limit_of(in)), "verified");
  in.steel = "S355 product";
  EXPECT_EQ(trust_of(limit_of(in)).substr(0, 10), "UNVERIFIED");
}

}  // namespace taut::mast_section::sizing_test
