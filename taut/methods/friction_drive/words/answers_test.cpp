#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

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

// At rest and with a reserve of 1 the pull of (18) is 0, and the branches of the paper are P_p and 0: no number tells
// their ratio.
TEST(DriveAnswers, ARatioWithoutASlackBranchIsInfinite) {
  Input in = saw_drive();
  in.friction = 0.15;
  in.wrap = 3 * std::numbers::pi;
  in.rope_mass = 0.3;
  in.speed = 0;
  in.grip_reserve = 1;
  in.section_factor = 0;
  in.fill_ratio = 1;
  in.rest_arc = 0;
  in.idler_loss = 1;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const std::string paper = line_of(answers(in, r, Display()), "Paper");
  EXPECT_NE(paper.find("the branches stand as infinite, the grip holds 4.111"), std::string::npos) << paper;
  EXPECT_TRUE(std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
    return w.find("(T_1 - c)/(T_2 - c) = infinite, the grip") != std::string::npos;
  }));
}

}  // namespace taut::friction_drive::answers_test
