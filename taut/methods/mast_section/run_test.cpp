#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::mast_section::run_test {

Input yarder() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.mainline_block_height = 7.2;
  in.steel = "EN 10210-1 S355H";
  in.safety = 1.2;
  Span span;
  span.length = 300;
  span.chord_slope = 0.1;
  span.carriage_position = {290, 10, 75, 150};
  span.rope_weight = 18;
  span.load = 20e3;
  span.horizontal_tension = 90e3;
  in.span = span;
  return in;
}

bool warns(const Result& r, std::string_view words) {
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// A brake that holds more than the ropes ever have does not slip: they are paid out under their full force.
TEST(MastSectionRun, ABrakeThatNeverSlipsIsNotSaidToSlip) {
  const std::string slips = "under the force at which its brake slips", full = "under its full force";
  Input in = yarder();
  EXPECT_TRUE(warns(run(in), full));
  in.paid_out_force = 99e3;  // the skyline has 100 kN
  EXPECT_TRUE(warns(run(in), slips));
  in.paid_out_force = 120e3;
  const Result r = run(in);
  EXPECT_TRUE(warns(r, full));
  EXPECT_TRUE(warns(r, "no brake slips"));
  EXPECT_FALSE(warns(r, slips));
  in.paid_out_force.reset();
  EXPECT_EQ(r.find_value("M_payout")->value, run(in).find_value("M_payout")->value);
}

TEST(MastSectionRun, HasAllAReportNeeds) {
  const Result r = run(yarder());
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(exit_code(r), 0);
  for (const char* name : {"alpha", "wrap", "F_span_sky", "R_sky", "gamma_sky", "F_span_main", "R_main", "gamma_main",
                           "N", "M", "Q", "b_square", "B_hollow", "D_tube", "D_tube_printed", "section_stress"}) {
    EXPECT_NE(r.find_value(name), nullptr) << name;
  }
  const Table* positions = r.find_table("positions");
  ASSERT_NE(positions, nullptr);
  ASSERT_EQ(positions->rows.size(), 4u);
  EXPECT_EQ(std::get<double>(positions->rows[0][0]), 290) << "in the order of the deck";
  for (const auto& row : positions->rows) EXPECT_EQ(row.size(), positions->columns.size());
  const Table* sections = r.find_table("sections");
  ASSERT_NE(sections, nullptr);
  EXPECT_EQ(sections->rows.size(), 2u) << "no SHS of EN 10210, as its steel, is strong enough";
  for (const auto& row : sections->rows) EXPECT_EQ(row.size(), sections->columns.size());
  ASSERT_EQ(r.checks.size(), 4u);  // ropes hauled in, paid out, one of each, one at rest
  for (const Check& c : r.checks) EXPECT_TRUE(c.passes) << c.name;
  EXPECT_EQ(r.figures.size(), 7u);
  EXPECT_FALSE(r.steps.empty());
  EXPECT_FALSE(r.assumptions.empty());
  EXPECT_EQ(r.comparisons.size(), 7u);
  EXPECT_TRUE(warns(r, "guylines and buckling"));
}

TEST(MastSectionRun, InfeasibleStillShowsItsSteps) {
  Input in = yarder();
  in.span->horizontal_tension = 1;
  const Result r = run(in);
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_NE(r.message.find("branch angle"), std::string::npos);
  EXPECT_NE(r.find_value("alpha"), nullptr);
  EXPECT_EQ(r.find_value("N"), nullptr);
  EXPECT_FALSE(r.steps.empty());
  const Table* positions = r.find_table("positions");
  ASSERT_NE(positions, nullptr);
  EXPECT_FALSE(std::get<std::string>(positions->rows[0].back()).empty());
  EXPECT_TRUE(std::isnan(std::get<double>(positions->rows[0][6])));
}

TEST(MastSectionRun, NoSectionPasses) {
  Input in = yarder();
  in.skyline_force = 50e6;
  for (const bool wished : {false, true}) {
    if (wished) in.choose_section = ChooseSection{};
    const Result r = run(in);
    EXPECT_EQ(r.status, Status::ok);
    EXPECT_EQ(exit_code(r), 4);
    EXPECT_TRUE(warns(r, "no CHS of the catalogue carries the mast"));
    EXPECT_TRUE(warns(r, "comes nearest"));
    ASSERT_EQ(r.checks.size(), 4u);
    EXPECT_FALSE(r.checks[0].passes);
    EXPECT_NE(r.find_value("D_tube"), nullptr) << "the ideal sizes are there";
    EXPECT_TRUE(r.unjudged.empty());
  }
}

TEST(MastSectionRun, WarnsOfUnsafeChoices) {
  Input in = yarder();
  EXPECT_FALSE(warns(run(in), "wrap of 120 deg"));
  in.wrap = Wrap::paper;
  in.block_friction = 0.3;
  const Result r = run(in);
  EXPECT_TRUE(warns(r, "wrap of 120 deg"));
  EXPECT_TRUE(warns(r, "block friction 0.3"));
  EXPECT_TRUE(warns(r, "paid out"));
  EXPECT_TRUE(warns(r, "0.6 % too small"));
}

TEST(MastSectionRun, UnverifiedSectionIsMarked) {
  Input in = yarder();
  in.skyline_force = 20e3;
  in.mainline_force = 10e3;
  in.choose_section = ChooseSection{.shape = SectionKind::chs,
                                    .forming = FormingChoice::seamless,
                                    .standard = "GOST",
                                    .least_trust = LeastTrust::unverified,
                                    .largest_slenderness = 35};
  const Result r = run(in);
  ASSERT_EQ(r.checks.size(), 4u);
  EXPECT_TRUE(warns(r, "unverified row"));
}

TEST(MastSectionRun, SomePositionsMayFail) {
  Input in = yarder();
  in.span->chord_slope = 0;
  in.span->load = 1e6;
  in.span->horizontal_tension = 5e3;
  in.span->carriage_position = {1, 299};
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_TRUE(warns(r, "1 of 2 carriage positions"));
  ASSERT_EQ(r.missing.size(), 1u);
  EXPECT_EQ(r.missing[0].missing, 1);
  EXPECT_EQ(r.missing[0].places, 2);
  EXPECT_EQ(r.missing[0].first, "x = 1 m");
  EXPECT_EQ(r.missing[0].all, "x = 1 m");
}

TEST(MastSectionRun, EveryErratumNamesATestOfTheCases) {
  for (const Erratum& e : about().errata) EXPECT_EQ(e.test.rfind("MastSectionCase.", 0), 0u);
}

TEST(MastSectionRun, WithoutAnswerShowsTheMastAsDescribed) {
  Input in = yarder();
  in.span->horizontal_tension = 10;
  const Result r = run(in);
  EXPECT_EQ(exit_code(r), 3);
  ASSERT_EQ(r.figures.size(), 1U);
  const auto& mast = std::get<Drawing>(r.figures.front());
  EXPECT_NE(mast.title.find("as described"), std::string::npos);
  int forces = 0;
  for (const Shape& one : mast.shapes) {
    const auto* force = std::get_if<ForceArrow>(&one);
    if (force == nullptr) continue;
    ++forces;
    EXPECT_TRUE(force->label == "T_sky" || force->label == "T_main") << "only what is given";
  }
  EXPECT_EQ(forces, 2);
}

// Without friction both sides of a rope pull alike, hauled in and paid out: what differs in the last bits is not said
// to be more.
TEST(MastSectionRun, WithoutFrictionPayingOutBendsNoMore) {
  Input in;
  in.skyline_force = 200e3;
  in.mainline_force = 0;
  in.skyline_block_height = 12;
  in.branch_angle = std::acos(-1) / 4;
  in.steel = "EN 10210-1 S355H";
  in.safety = 1.5;
  in.tube_ratio = 0;
  for (const double friction : {0.0, 1e-9}) {
    in.block_friction = friction;
    EXPECT_FALSE(warns(run(in), "bends the mast more")) << friction;
  }
  in.block_friction = 0.12;
  EXPECT_TRUE(warns(run(in), "bends the mast more"));
  in.block_friction = 2e-5;  // seen in the fifth digit alone
  const Result r = run(in);
  for (const std::string& w : r.warnings) {
    const auto M = w.find("M "), instead = w.find(" instead of ");
    if (w.find("bends the mast more") == std::string::npos) continue;
    EXPECT_NE(w.substr(M + 2, instead - M - 2), w.substr(instead + 12, instead - M - 2)) << w;
  }
}

}  // namespace taut::mast_section::run_test
