#include "taut/methods/mast_section/sizing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

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

/// By hand, friction 0.16, alpha 30 deg, wrap 120 deg, x = exp(-0.16 * 120 deg) = 0.7153: hauled in, T x cos(alpha)
/// across and T (1 + x sin(alpha)) down; paid out, T cos(alpha) across and T (sin(alpha) + x) down.
TEST(MastSectionSizing, EachRopeIsHauledInAndPaidOut) {
  Input in = plain_mast();
  in.skyline_force = 100e3;
  in.mainline_force = 56e3;
  in.skyline_block_height = 10;
  in.mainline_block_height = 9;
  in.block_friction = 0.16;
  in.paid_out_force = 56e3;
  in.branch_angle = std::numbers::pi / 6;
  const auto forces = clamp_forces(in, sweep(in));
  ASSERT_EQ(forces.size(), 9U);
  const double x = std::exp(-0.16 * 2 * std::numbers::pi / 3), c = std::sqrt(0.75);
  const auto in_out = std::find_if(forces.begin(), forces.end(), [](const auto& f) {
    return direction_words(f) == "skyline hauled in, mainline paid out";
  });
  ASSERT_NE(in_out, forces.end());
  EXPECT_NEAR(in_out->M, 100e3 * x * c * 10 + 56e3 * c * 9, 1);
  EXPECT_NEAR(in_out->N, 100e3 * (1 + x / 2) + 56e3 * (0.5 + x), 1);
  for (const ClampForces& f : forces) {
    EXPECT_LE(f.M, in_out->M) << direction_words(f);
    EXPECT_NEAR(f.M, f.skyline.across * 10 + f.mainline.across * 9, 1e-6 * f.M);
    EXPECT_NEAR(f.N, f.skyline.down + f.mainline.down, 1e-6 * f.N);
  }
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_GT(out.D_tube_mixed, std::max(out.D_tube, out.D_tube_payout));
  EXPECT_EQ(out.D_tube_worst, std::max(out.D_tube_mixed, out.D_tube_rest));
  const double D = out.D_tube_mixed, d = in.tube_ratio * D, pi = std::numbers::pi;
  EXPECT_NEAR(
      in_out->N / (pi / 4 * (D * D - d * d)) + in_out->M * D / 2 / (pi / 64 * (std::pow(D, 4) - std::pow(d, 4))), 160e6,
      1e-6 * 160e6);
}

/// By hand, friction 0.16, alpha 75 deg, wrap 165 deg: T cos(75 deg) across on each block, T (1 + sin(75 deg)) down.
/// The drum side of the brakes that slip at 50 kN has up to 50 kN exp(0.16 * 165 deg) = 79.3 kN.
TEST(MastSectionSizing, ARopeAtRestMayHaveItsFullForceOnBothSides) {
  Input in = plain_mast();
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 2.5;
  in.mainline_block_height.reset();
  in.block_friction = 0.16;
  in.branch_angle = 75 * std::numbers::pi / 180;
  const double s = std::sin(*in.branch_angle), c = std::cos(*in.branch_angle), pi = std::numbers::pi;
  const auto case_of = [&](const char* words) {
    const auto forces = clamp_forces(in, sweep(in));
    return *std::find_if(forces.begin(), forces.end(), [&](const auto& f) { return direction_words(f) == words; });
  };
  const ClampForces rest = case_of("ropes at rest");
  EXPECT_NEAR(rest.M, 140e3 * c * 2.5, 1e-6 * rest.M);
  EXPECT_NEAR(rest.N, 140e3 * (1 + s), 1e-6 * rest.N);
  EXPECT_NEAR(rest.M, case_of("ropes paid out").M, 1e-6 * rest.M);
  EXPECT_GT(rest.N, 1.2 * case_of("ropes paid out").N);
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  const double D = out.D_tube_rest, d = in.tube_ratio * D;
  EXPECT_GT(D, std::max({out.D_tube, out.D_tube_payout, out.D_tube_mixed}));
  EXPECT_EQ(out.D_tube_worst, D);
  EXPECT_NEAR(rest.N / (pi / 4 * (D * D - d * d)) + rest.M * D / 2 / (pi / 64 * (std::pow(D, 4) - std::pow(d, 4))),
              160e6, 1e-6 * 160e6);
  in.paid_out_force = 50e3;
  const double held = 50e3 * std::exp(0.16 * 165 * pi / 180);
  EXPECT_NEAR(case_of("ropes at rest").N, 50e3 * s + held + 40e3 * (1 + s), 1);
  EXPECT_NEAR(case_of("skyline at rest, mainline paid out").M, 90e3 * c * 2.5, 1);
}

// What balances the guys may be gone: one rope is laid before the other one.
TEST(MastSectionSizing, AGuyedMastMayHaveOneRopeAlone) {
  Input in = plain_mast();
  in.guys.emplace_back();
  const auto forces = clamp_forces(in, sweep(in));
  for (const bool skyline : {true, false}) {
    int alone = 0;
    for (const ClampForces& f : forces) {
      const BlockForce &slack = skyline ? f.mainline : f.skyline, &pulls = skyline ? f.skyline : f.mainline;
      if (f.put_up || slack.across != 0 || slack.down != 0) continue;
      ++alone;
      EXPECT_GT(pulls.across, 0);
      EXPECT_EQ(f.N, pulls.down);
      EXPECT_NE(direction_words(f).find("slack"), std::string::npos);
    }
    EXPECT_EQ(alone, 3);
  }
}

// The guys are put up before the ropes are laid: that is a load case of its own, without a carriage. A force from the
// side comes and goes, and may be what holds the mast against its guys.
TEST(MastSectionSizing, TheGuysAloneAreALoadCase) {
  Input in = plain_mast();
  const std::size_t unguyed = clamp_forces(in, sweep(in)).size();
  in.guys.emplace_back();
  const std::size_t without = unguyed + 6;  // each rope alone, hauled in, paid out and at rest
  in.lateral_force = 5e3;
  const auto forces = clamp_forces(in, sweep(in));
  ASSERT_EQ(forces.size(), 2 * without + 1);
  for (std::size_t k = 0; k < without; ++k) {
    const ClampForces &with_side = forces[k], &no_side = forces[without + k];
    EXPECT_EQ(with_side.lateral, 5e3);
    EXPECT_EQ(no_side.lateral, 0);
    EXPECT_EQ(no_side.M, with_side.M);
    EXPECT_EQ(case_words(in, no_side), case_words(in, with_side) + ", no side force");
  }
  const ClampForces& bare = forces.back();
  EXPECT_TRUE(bare.put_up);
  for (const double force : {bare.N, bare.M, bare.lateral, bare.skyline.across, bare.skyline.down, bare.mainline.down})
    EXPECT_EQ(force, 0);
  EXPECT_EQ(case_words(in, bare), "guys put up, no load");
  EXPECT_TRUE(std::none_of(forces.begin(), forces.end() - 1, [](const ClampForces& f) { return f.put_up; }));
  in.lateral_force.reset();
  EXPECT_EQ(clamp_forces(in, sweep(in)).size(), without + 1);
}

// Where second order decides alone the method's own stress is that of another mast.
TEST(MastSectionSizing, AnotherMastIsJudgedByItsOwnStress) {
  const Input in = plain_mast();
  SecondOrder guyed;
  guyed.decides_alone = true;
  guyed.stress = [](const catalogue::SectionRow& row, const ClampForces&) { return 100e6 * 50 / row.mass_per_length; };
  const auto light = lightest(in, SectionShape::chs, loads, guyed);
  ASSERT_TRUE(light);
  EXPECT_GT(light->stress, light->allowable);
  EXPECT_GE(light->section.mass_per_length, 50 * 100.0 / 160);
  EXPECT_LT(light->section.mass_per_length, 35) << "the next in the catalogue";
  guyed.wall_yields = [](const catalogue::SectionRow& row, double, const ClampForces&) {
    return row.mass_per_length > 60;
  };
  EXPECT_GT(lightest(in, SectionShape::chs, loads, guyed)->section.mass_per_length, 60);
  guyed.stress = [](const catalogue::SectionRow&, const ClampForces&) { return NAN; };
  EXPECT_FALSE(lightest(in, SectionShape::chs, loads, guyed));
  ASSERT_TRUE(strongest(in, SectionShape::chs, loads, guyed));
}

// EN 10210 is hot-finished, EN 10219 cold-formed: each has its own steel.
TEST(MastSectionSizing, ASectionIsOfTheStandardOfItsSteel) {
  Input in = plain_mast();
  in.allowable_stress.reset();
  in.safety = 1.5;
  const auto standards = [&](const char* steel) {
    in.steel = steel;
    std::set<std::string> all;
    for (const catalogue::SectionRow& row : candidates(in, SectionShape::chs)) all.insert(row.standard);
    return all;
  };
  EXPECT_EQ(standards("EN 10210-1 S355H").count("EN 10219-2"), 0U);
  EXPECT_EQ(standards("EN 10210-1 S355H").count("EN 10210-2"), 1U);
  EXPECT_EQ(standards("EN 10219-1 S355H").count("EN 10210-2"), 0U);
  EXPECT_EQ(standards("EN 10219-1 S355H").count("EN 10219-2"), 1U);
  EXPECT_EQ(standards("EN 10025-2 S355").count("EN 10219-2"), 1U) << "plain steel is taken for both";
}

}  // namespace taut::mast_section::sizing_test
