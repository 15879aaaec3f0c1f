#include "taut/calc/answers.hpp"

#include <gtest/gtest.h>

#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes::answers_test {

std::string line_of(const std::vector<Answer>& all, const std::string& label) {
  for (const Answer& a : all) {
    if (a.label == label) return a.text;
  }
  return {};
}

TEST(BoomAnswers, NameThePretension) {
  Input in = printed_boom();
  in.cases = {lifting("rated lift", 30e3), retracting("retract", 3e3)};
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const auto all = answers(in, r, Display());
  const Value* S20 = r.find_value("S20_set");
  ASSERT_NE(S20, nullptr);
  EXPECT_NE(line_of(all, "Needs").find(Display().brief(S20->value, S20->unit, Rounding::up)), std::string::npos)
      << line_of(all, "Needs");
  in.S10 = 90e3;
  in.S20 = 170e3;
  const auto given = answers(in, run(in), Display());
  EXPECT_NE(line_of(given, "Given").find("90 kN"), std::string::npos) << line_of(given, "Given");
  EXPECT_TRUE(line_of(given, "Needs").empty());
}

/// The boom of the example: its cases and its sliding sections.
Input sliding_boom() {
  Input in = whole_boom();
  in.sliding = sliding_at(Operation::extend, 52, 21, 32373);
  in.sliding->S10 = 95.5e3;
  in.sliding->S20 = 187e3;
  return in;
}

// The pretension of the sliding sections is that of the cases. By the printed stiffness it settles at 94.45 kN, of
// which the static test makes 219.8 kN: more than any position of the sliding sections (111 kN), so the rope is built
// for it.
TEST(BoomAnswers, TheLoadIsTheLargestOfAllStates) {
  const Input in = sliding_boom();
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const std::string load = line_of(answers(in, r, Display()), "Load");
  EXPECT_NE(load.find("one branch of the extension rope up to 219.8 kN (case static test)"), std::string::npos) << load;
  EXPECT_NE(load.find("retraction rope up to 189.2 kN (case retract hook, corrected stiffness)"), std::string::npos)
      << load;
}

// Without sliding sections the cases alone are the load.
TEST(BoomAnswers, CasesAloneHaveALoad) {
  Input in = whole_boom();
  in.S10 = 119e3;
  in.S20 = 238e3;
  const std::string load = line_of(answers(in, run(in), Display()), "Load");
  EXPECT_NE(load.find("retraction rope up to 238.1 kN (case retract hook, corrected stiffness)"), std::string::npos)
      << load;
}

// A case without a name is called by its number.
TEST(BoomAnswers, CasesWithoutANameHaveTheirNumber) {
  Input in = whole_boom();
  in.S10 = 119e3;
  in.S20 = 238e3;
  for (Case& one : in.cases) one.name.clear();
  const Result r = run(in);
  const std::string load = line_of(answers(in, r, Display()), "Load");
  EXPECT_NE(load.find("retraction rope up to 238.1 kN (case 4, corrected stiffness)"), std::string::npos) << load;
  std::string words;
  for (const Step& s : r.steps) words += s.words + "\n";
  for (const std::string& w : r.warnings) words += w + "\n";
  EXPECT_EQ(words.find("()"), std::string::npos) << words;
  EXPECT_EQ(words.find("Case 2: "), std::string::npos) << words;
  EXPECT_NE(words.find("smallest F: case 2. Each"), std::string::npos) << words;
}

TEST(LargestTension, IsNeverBelowAnyStateOfTheResult) {
  for (const Operation operation : {Operation::extend, Operation::retract}) {
    Input in = sliding_boom();
    in.sliding->operation = operation;
    in.sliding->luffing_angle = {0.3, 0.9, 1.3};
    in.sliding->suspended_weight = {2943, 32373};
    const Result r = run(in);
    ASSERT_EQ(r.status, Status::ok) << r.message;
    const LargestTension S1 = largest_tension(in, r, Rope::extension, Display());
    const LargestTension S2 = largest_tension(in, r, Rope::retraction, Display());
    for (const Table& t : r.tables) {
      for (std::size_t k = 0; k < t.rows.size(); ++k) {
        for (const char* column : {"S1", "S1_corrected"}) EXPECT_FALSE(number_in(t, k, column) > S1.tension) << t.name;
        for (const char* column : {"S2", "S2_corrected"}) EXPECT_FALSE(number_in(t, k, column) > S2.tension) << t.name;
      }
    }
  }
}

TEST(BoomAnswers, WithoutCasesTheSharesAreLeft) {
  const Input in = printed_boom();
  EXPECT_FALSE(answers(in, run(in), Display()).empty());
}

}  // namespace taut::boom_ropes::answers_test
