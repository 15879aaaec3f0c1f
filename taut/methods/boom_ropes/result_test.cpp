#include "taut/calc/result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/math/degree.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes::result_test {

Input crane() {
  Input in = governing_boom();
  in.sliding.emplace();
  in.sliding->boom_length = {9, 15, 21};
  in.sliding->luffing_angle = {19 * degree, 52 * degree};
  in.sliding->suspended_weight = {2943, 32373};
  in.sliding->slip_angles = {{.boom_length = 21, .suspended_weight = 2943, .overlap_change = 0.4, .falls = 6},
                             {.boom_length = 21, .suspended_weight = 2943, .overlap_change = -3, .falls = 6}};
  return in;
}

TEST(BoomRopesResult, NamesTheWorstPlace) {
  const Result r = run(crane());
  ASSERT_EQ(r.status, Status::ok);
  EXPECT_NEAR(r.find_value("Fh")->value, 166.7e3, 50);
  EXPECT_NEAR(r.find_value("governing_angle")->value, 52 * degree, 1e-12);
  EXPECT_EQ(r.find_value("governing_length")->value, 21);
  EXPECT_EQ(r.find_value("Fh")->value, r.find_value("Fh_max")->value);
  EXPECT_NEAR(r.find_value("F_1")->value, -326.17e3, 5);
}

TEST(BoomRopesResult, TableHasTheWholeGrid) {
  const Result r = run(crane());
  const Table* t = r.find_table("extension");
  ASSERT_NE(t, nullptr);
  std::vector<std::string> names;
  names.reserve(t->columns.size());
  for (const Column& c : t->columns) names.push_back(c.name);
  EXPECT_THAT(names, testing::ElementsAre("luffing_angle", "boom_length", "suspended_weight", "Fh", "S1", "S2", "Nf",
                                          "Nr", "Mf", "Mr", "jamming"));
  ASSERT_EQ(t->rows.size(), 12u);
  EXPECT_EQ(std::get<double>(t->rows[0][10]), 0);
  EXPECT_EQ(std::get<double>(t->rows[11][10]), 1);
}

TEST(BoomRopesResult, LastStepsBelongToTheGoverningPlace) {
  const Result r = run(crane());
  double last = 0;
  for (const Step& s : r.steps) {
    if (s.symbol == "F_h") last = s.value;
  }
  EXPECT_EQ(last, r.find_value("Fh")->value);
}

TEST(BoomRopesResult, WarnsOfThePrintedStiffness) {
  const Result r = run(crane());
  bool unsafe = false;
  for (const Comparison& c : r.comparisons) unsafe = unsafe || (c.symbol == "S_20min" && c.printed_unsafe);
  EXPECT_TRUE(unsafe);
  EXPECT_THAT(r.warnings, testing::Contains(testing::HasSubstr("unsafe")));
  Input other = crane();
  other.extension_stiffness = 0.778e6;
  EXPECT_TRUE(run(other).comparisons.empty());
}

TEST(BoomRopesResult, SlipTableSaysWhereThereIsNoAngle) {
  const Result r = run(crane());
  const Table* t = r.find_table("slip_angles");
  ASSERT_NE(t, nullptr);
  EXPECT_NEAR(std::get<double>(t->rows[0][3]) / degree, 30.4, 0.05);
  EXPECT_TRUE(std::isnan(std::get<double>(t->rows[1][3])));
  EXPECT_THAT(std::get<std::string>(t->rows[1][6]), testing::HasSubstr("overlap"));
}

TEST(BoomRopesResult, SlackRopeFailsTheCheck) {
  Input in = crane();
  in.sliding->operation = Operation::lift;
  in.sliding->boom_length = {9};
  in.sliding->luffing_angle = {77 * degree};
  in.sliding->suspended_weight = {400e3};
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(exit_code(r), 4);
  EXPECT_THAT(r.warnings, testing::Contains(testing::HasSubstr("slack")));
}

TEST(BoomRopesResult, InfeasibleKeepsTheStaticPart) {
  Input in = crane();
  in.sliding->boom_length = {30};
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.find_value("S20_min"), nullptr);
  EXPECT_EQ(r.find_value("Fh"), nullptr);
  EXPECT_FALSE(r.steps.empty());
  EXPECT_NE(r.find_table("extension"), nullptr);
  ASSERT_FALSE(r.figures.empty());
  const auto& boom = std::get<Drawing>(r.figures.front());
  EXPECT_NE(boom.title.find("as described"), std::string::npos);
  for (const Shape& one : boom.shapes) {
    const auto* force = std::get_if<ForceArrow>(&one);
    EXPECT_TRUE(force == nullptr || force->label == "G_n" || force->label == "G_3") << "only what is given";
  }
}

TEST(BoomRopesResult, EveryGivenLineIsFoundOnce) {
  const Result r = run(crane());
  int weights = 0;
  for (const Step& s : r.steps) weights += s.kind == Step::Kind::given && s.symbol == "G_3";
  EXPECT_EQ(weights, 1);
}

TEST(BoomRopesComplaints, OneOfTwoPretensions) {
  Input in = crane();
  in.S10 = 90e3;
  const auto all = complaints(in);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].path, "S10");
}

TEST(BoomRopesComplaints, TwoPretensionsOfOneRope) {
  Input in = crane();
  in.S10 = in.sliding->S10 = 90e3;
  in.S20 = in.sliding->S20 = 180e3;
  EXPECT_TRUE(complaints(in).empty());
  in.sliding->S20 = 40e3;
  const auto all = complaints(in);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].path, "sliding.S20");
  EXPECT_THAT(all[0].message, testing::HasSubstr("180 kN"));
}

// The cases and the sliding sections have the same ropes: they have the same pretension and the same checks.
TEST(BoomRopesResult, ThePretensionOfTheSlidingSectionsIsThatOfTheCases) {
  Input of_input = crane(), of_sliding = crane();
  of_input.S10 = of_sliding.sliding->S10 = 20e3;
  of_input.S20 = of_sliding.sliding->S20 = 40e3;
  const Result a = run(of_input), b = run(of_sliding);
  ASSERT_EQ(b.status, Status::ok) << b.message;
  for (const char* value : {"S10_set", "S20_set"}) EXPECT_EQ(a.find_value(value)->value, b.find_value(value)->value);
  ASSERT_EQ(a.checks.size(), b.checks.size());
  const auto retraction = [](const Check& c) { return c.name == "pretension of the retraction rope"; };
  const auto check = std::find_if(b.checks.begin(), b.checks.end(), retraction);
  ASSERT_NE(check, b.checks.end());
  EXPECT_FALSE(check->passes);
  EXPECT_NEAR(check->limit, 166.5e3, 500);  // as the comparison of the paper's stiffness has it
  of_sliding.sliding->S20.reset();          // the other one is then the calibrated one, as in the sliding sections
  EXPECT_GT(run(of_sliding).find_value("S20_set")->value, 100e3);
  of_sliding.cases.clear();
  EXPECT_EQ(run(of_sliding).find_value("S10_set"), nullptr) << "without cases nothing asks for it";
}

TEST(BoomRopesComplaints, EmptyLists) {
  Input in = crane();
  in.sliding->boom_length.clear();
  const auto all = complaints(in);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].path, "sliding.boom_length");
  EXPECT_TRUE(complaints(crane()).empty());
}

TEST(BoomRopesComplaints, RopeShorterThanItsBranch) {
  Input in = crane();
  in.sliding->extension_length = 7;
  ASSERT_EQ(complaints(in).size(), 1u);
  EXPECT_EQ(complaints(in)[0].path, "sliding.extension_length");
}

TEST(BoomRopesResult, ASlipAngleWithoutAnAnswerIsNotJudged) {
  Input in = crane();
  in.sliding->slip_angles = {{.boom_length = 21, .suspended_weight = 2943, .overlap_change = 0.4, .falls = 6},
                             {.boom_length = 25, .suspended_weight = 2943, .overlap_change = 0, .falls = 6},
                             {.boom_length = 21, .suspended_weight = 2943, .overlap_change = -3, .falls = 6}};
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  ASSERT_EQ(r.unmade.size(), 2u);
  EXPECT_THAT(r.unmade[0], testing::HasSubstr("slip_angles[1] has no answer: "));
  EXPECT_THAT(r.unmade[0], testing::HasSubstr("9 ... 21 m"));
  EXPECT_THAT(r.unmade[1], testing::HasSubstr("slip_angles[2]"));
  in.sliding->slip_angles.resize(1);
  EXPECT_TRUE(run(in).unmade.empty());
  in.sliding->offset_hoist = -10;
  in.sliding->slip_angles[0] = {.boom_length = 21, .suspended_weight = 32373, .overlap_change = 0, .falls = 6};
  const Result held = run(in);
  EXPECT_THAT(std::get<std::string>(held.find_table("slip_angles")->rows[0][6]), testing::HasSubstr("every angle"));
  EXPECT_TRUE(held.unmade.empty()) << "that is an answer";
}

/// Sentences, titles and captions are in the units of the deck, as tables are.
TEST(BoomRopesResult, WordsFollowTheDisplay) {
  const Result r = run(crane(), Display({{"force", "kgf"}, {"length", "cm"}}));
  ASSERT_EQ(r.status, Status::ok);
  std::vector<std::string> words = r.warnings;
  for (const Table& t : r.tables) {
    if (t.name == "cases") words.push_back(t.title);
  }
  for (const Figure& f : r.figures) {
    if (const auto* drawing = std::get_if<Drawing>(&f)) words.push_back(drawing->caption);
    if (const auto* plot = std::get_if<Plot>(&f)) words.push_back(plot->caption);
  }
  for (const Step& s : r.steps) {
    if (s.kind == Step::Kind::note) words.push_back(s.words);
  }
  for (const std::string& one : words) EXPECT_THAT(one, testing::Not(testing::ContainsRegex("[0-9] (kN|m)[^a-z0-9]")));
  EXPECT_THAT(words, testing::Contains(testing::HasSubstr("Cases under a pretension of ")));
  EXPECT_THAT(words, testing::Contains(testing::HasSubstr(" kgf, not ")));
  EXPECT_THAT(words, testing::Contains(testing::HasSubstr("Luffing angle 52 deg, boom 2100 cm")));
}

}  // namespace taut::boom_ropes::result_test
