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

}  // namespace taut::closed_loop::answers_test
