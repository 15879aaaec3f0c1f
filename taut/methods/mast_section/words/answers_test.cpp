#include <gtest/gtest.h>

#include "taut/methods/mast_section/plain_mast_test.hpp"
#include "taut/units/display.hpp"

namespace taut::mast_section::answers_test {

std::string line_of(const std::vector<Answer>& all, const std::string& label) {
  for (const Answer& a : all) {
    if (a.label == label) return a.text;
  }
  return {};
}

TEST(MastAnswers, NameTheSectionThatIsChosen) {
  Input in = plain_mast();
  in.choose_section = ChooseSection{};
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const auto all = answers(in, r, Display());
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().label, "Build");
  EXPECT_NE(all.front().text.find("8 m high"), std::string::npos) << all.front().text;
  bool checked = false;
  for (const Check& c : r.checks) {
    const std::string name = c.name.substr(0, c.name.find(','));  // "strength of CHS 508x16"
    checked = checked || all.front().text.find(name.substr(std::string("strength of ").size())) != std::string::npos;
  }
  EXPECT_TRUE(checked) << all.front().text;
  EXPECT_NE(line_of(all, "Stress").find("of 160 MPa allowed"), std::string::npos) << line_of(all, "Stress");
}

// Without `section` and `choose_section` the lightest of all is chosen too.
TEST(MastAnswers, ASectionIsChosenUnasked) {
  const Input in = plain_mast();
  const auto all = answers(in, run(in), Display());
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().label, "Build");
}

TEST(MastAnswers, AGivenSectionIsNotProposed) {
  Input in = plain_mast();
  in.section = "CHS 508x16";
  const auto all = answers(in, run(in), Display());
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().label, "Given");
}

TEST(MastAnswers, TheTubeIsNeededOrIdeal) {
  const Input in = plain_mast();
  const Result r = run(in);
  const auto all = answers(in, r, Display());
  const double D = std::max({r.find_value("D_tube")->value, r.find_value("D_tube_payout")->value,
                             r.find_value("D_tube_mixed")->value, r.find_value("D_tube_rest")->value});
  const std::string needed = line_of(all, r.find_table("sections") == nullptr ? "Needs" : "Ideal tube");
  EXPECT_NE(needed.find(Display().brief(D, si::m.in("mm"))), std::string::npos) << needed;
}

// A slenderness of 6.3 under a limit of 1.5 is worse than any stress, and is none.
TEST(MastAnswers, TheStressIsAStress) {
  Input in = plain_mast();
  in.section = "CHS 508x16";
  Result r = run(in);
  const std::string before = line_of(answers(in, r, Display()), "Stress");
  EXPECT_NE(before.find("MPa"), std::string::npos) << before;
  Check slender = make_check("mast.slenderness", 6.333, si::one,
                             {.sense = Sense::at_most, .limit = 1.5, .rule = "slenderness", .trust = "user"});
  slender.part = "mast";
  r.checks.push_back(slender);
  EXPECT_EQ(line_of(answers(in, r, Display()), "Stress"), before);
}

}  // namespace taut::mast_section::answers_test
