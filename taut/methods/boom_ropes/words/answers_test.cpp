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

TEST(BoomAnswers, WithoutCasesTheSharesAreLeft) {
  const Input in = printed_boom();
  EXPECT_FALSE(answers(in, run(in), Display()).empty());
}

}  // namespace taut::boom_ropes::answers_test
