#include "taut/calc/answers.hpp"

#include <gtest/gtest.h>

namespace answers_test {

using namespace taut;

Check check_of(const std::string& part, const std::string& name, double use, bool limits = true) {
  Check c = make_check(name, use, si::one, {.sense = Sense::at_most, .limit = 1, .rule = "a rule", .trust = "user"});
  c.part = part;
  c.limits = limits;
  return c;
}

std::string text_of(const Result& r, const std::string& label) {
  for (const Answer& a : r.answers) {
    if (a.label == label) return a.text;
  }
  return "no such line";
}

TEST(Answers, WhatPassesIsToBeBuilt) {
  Result r;
  r.checks = {check_of("skyline", "skyline.safety_factor", 0.8)};
  r.answers = {{"Load", "skyline 12 kN"}, {"Build", "a rope"}, {"Carries", "2 t"}};
  finish_answers(r);
  ASSERT_EQ(r.answers.size(), 4U);
  EXPECT_EQ(r.answers[0].label, "Carries");
  EXPECT_EQ(r.answers[1].label, "Build");
  EXPECT_EQ(r.answers[2].label, "Load");
  EXPECT_EQ(r.answers[3].label, "Uses");
}

TEST(Answers, NothingIsToBeBuiltThatFailsOrIsNotJudged) {
  Result fails;
  fails.checks = {check_of("skyline", "skyline.safety_factor", 1.2)};
  fails.answers = {{"Build", "a rope"}};
  finish_answers(fails);
  EXPECT_EQ(fails.answers[0].label, "Nearest");
  EXPECT_EQ(text_of(fails, "Uses"), "skyline.safety_factor 1.2 (fails)");
  Result open;
  open.answers = {{"Build", "a rope"}};
  finish_answers(open);
  EXPECT_EQ(open.answers[0].label, "Given");
  Result none;
  none.status = Status::infeasible;
  none.answers = {{"Build", "a rope"}};
  finish_answers(none);
  EXPECT_EQ(none.answers[0].label, "Nearest");
  Result bad;
  bad.status = Status::bad_deck;
  bad.answers = {{"Build", "a rope"}};
  finish_answers(bad);
  EXPECT_TRUE(bad.answers.empty());
}

TEST(Answers, EachPartHasItsWorstCheck) {
  Result r;
  r.checks = {check_of("a", "a.T", 0.3), check_of("b", "b.S", 0.4), check_of("a", "strength", 0.9),
              check_of("b", "b.break", 0.7, false)};
  finish_answers(r);
  EXPECT_EQ(text_of(r, "Uses"), "a: strength 0.9; b.break 0.7") << "as the table of page 1";
}

TEST(Answers, ALineSaysWhatItHasNoRoomFor) {
  Result r;
  add_answer_line(r, "Load", {std::string(90, 'a'), std::string(90, 'b'), std::string(90, 'c'), "d"});
  ASSERT_EQ(r.answers.size(), 1U);
  EXPECT_LE(r.answers[0].text.size(), longest_answer);
  EXPECT_TRUE(r.answers[0].text.ends_with("b; 2 more")) << r.answers[0].text;
  add_answer_line(r, "Load", {});
  EXPECT_EQ(r.answers.size(), 1U);
}

TEST(Answers, OneLineIsKeptForTheUses) {
  Result r;
  r.checks = {check_of("a", "a.T", 0.3)};
  for (int i = 0; i < 12; ++i) r.answers.push_back({"Load", "x"});
  finish_answers(r);
  EXPECT_EQ(r.answers.size(), most_answers);
  EXPECT_EQ(r.answers.back().label, "Uses");
}

}  // namespace answers_test
