#include <gtest/gtest.h>

#include "taut/methods/friction_drive/saw_drive_test.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive::answers_test {

std::string line_of(const std::vector<Answer>& all, const std::string& label) {
  for (const Answer& a : all) {
    if (a.label == label) return a.text;
  }
  return {};
}

TEST(DriveAnswers, NameThePullThatHolds) {
  const Input in = saw_drive();
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const Display newtons(std::map<std::string, std::string>{{"force", "N"}});
  const auto all = answers(in, r, newtons);
  EXPECT_NE(line_of(all, "Needs").find(newtons.brief(r.find_value("takeup_no_slip")->value, si::N, Rounding::up)),
            std::string::npos)
      << line_of(all, "Needs");
  EXPECT_NE(line_of(all, "Paper").find("slip"), std::string::npos);
  EXPECT_TRUE(line_of(all, "Given").empty());
}

TEST(DriveAnswers, TheRopeIsNamedInFull) {
  Input in = saw_drive();
  in.rope = "EN 12385-4|6x36-IWRC|12|1960";
  const auto all = answers(in, run(in), Display());
  EXPECT_NE(line_of(all, "Given").find("EN 12385-4 6x36-IWRC 12 mm 1960 MPa"), std::string::npos);
}

}  // namespace taut::friction_drive::answers_test
