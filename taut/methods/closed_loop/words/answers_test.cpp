#include "taut/calc/answers.hpp"

#include <gtest/gtest.h>

#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/units/display.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::answers_test {

std::string line_of(const std::vector<Answer>& all, const std::string& label) {
  for (const Answer& a : all) {
    if (a.label == label) return a.text;
  }
  return {};
}

TEST(LoopAnswers, RopesThatTheDeckGivesAreNotProposed) {
  Input in = taut_test::example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = "EN 12385-4|6x36-IWRC|20|1960";
  in.traction_rope = "EN 12385-4|6x36-IWRC|24|1960";
  in.safety_factor = 3;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const auto all = answers(in, r, Display());
  EXPECT_NE(line_of(all, "Given").find("EN 12385-4 6x36-IWRC 20 mm 1960 MPa"), std::string::npos)
      << line_of(all, "Given");
  EXPECT_TRUE(line_of(all, "Build").empty());
}

TEST(LoopAnswers, RopesThatAreChosenAreToBeBuilt) {
  Input in = taut_test::example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = "IWRC", .grade = 1960e6};
  in.safety_factor = 3;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const auto all = answers(in, r, Display());
  EXPECT_NE(line_of(all, "Build").find("traction rope EN 12385-4 6x36-IWRC"), std::string::npos)
      << line_of(all, "Build");
  EXPECT_NE(line_of(all, "Load").find("factor"), std::string::npos);
  EXPECT_NE(line_of(all, "Tension").find("kN"), std::string::npos);
}

TEST(LoopAnswers, TheSagIsTheDeepestOfAllPositions) {
  Input in = taut_test::example();
  in.mode = Mode::winch_pull;
  in.sag.reset();
  in.winch_pull = 90e3;
  in.position = {20, 100};
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const Table& t = *r.find_table("positions");
  const double deepest = number_in(t, 1, "f");
  ASSERT_GT(deepest, 1.1 * number_in(t, 0, "f"));
  Result other = r;  // whichever position the values belong to
  for (Value& v : other.values) {
    if (v.name == "f") v.value = number_in(t, 0, "f");
    if (v.name == "x") v.value = 20;
  }
  for (const Result& one : {r, other}) {
    EXPECT_EQ(line_of(answers(in, one, Display()), "Sag"),
              Display().brief(deepest, si::m) + " at the carriage, carriage at 100 m");
  }
}

}  // namespace taut::closed_loop::answers_test
