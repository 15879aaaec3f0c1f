#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive::run_test {

Input saw() {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.8;
  in.wrap = 3.4907;
  in.rope_mass = 0.35;
  in.speed = 15;
  in.grip_reserve = 1.3;
  in.sheave_radius = 0.25;
  in.rope_area = 50e-6;
  return in;
}

bool warns(const Result& r, std::string_view words) {
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

TEST(FrictionDriveRun, HasAllAReportNeeds) {
  const Result r = run(saw());
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(exit_code(r), 4) << "the paper's drive slips";
  for (const char* name :
       {"euler_ratio", "andreev_ratio", "phi", "e", "c", "P_slack", "P_tight", "P_T", "P_M", "P_M_printed",
        "takeup_no_slip", "T_1", "T_2", "slip_ratio", "torque", "power", "F_0", "sigma_0"}) {
    EXPECT_NE(r.find_value(name), nullptr) << name;
  }
  ASSERT_EQ(r.checks.size(), 1u);
  EXPECT_EQ(r.checks[0].name, "no slip");
  EXPECT_FALSE(r.checks[0].passes);
  EXPECT_EQ(r.figures.size(), 5u);
  EXPECT_EQ(r.comparisons.size(), 5u);
  ASSERT_NE(r.find_table("readings"), nullptr);
  EXPECT_EQ(r.find_table("readings")->rows.size(), 4u);
}

TEST(FrictionDriveRun, SaysWhichToBuildBy) {
  const Result r = run(saw());
  EXPECT_TRUE(warns(r, "is not safe"));
  EXPECT_TRUE(warns(r, "at least 4.679 kN"));
  EXPECT_TRUE(warns(r, "leaves out the idler loss"));
  EXPECT_TRUE(warns(r, "friction 0.8 is far above"));
}

/// It carries tension, whether the deck names it or not; the grip of the drive is no limit of its strength.
TEST(FrictionDriveRun, ARopeWithoutALimitIsNotJudged) {
  Input in = saw();
  EXPECT_EQ(run(in).unjudged, std::vector<std::string>{"rope"});
  in.rope_area.reset();
  EXPECT_EQ(run(in).unjudged, std::vector<std::string>{"rope"});
  in.rope = "6x36-IWRC 12 mm 1960 MPa";
  EXPECT_EQ(run(in).unjudged, std::vector<std::string>{"rope"});
}

TEST(FrictionDriveRun, TheWarningsAreInTheUnitsOfTheDeck) {
  Output out;
  const Result r = run(saw(), out, Display(std::map<std::string, std::string>{{"force", "kgf"}}));
  EXPECT_TRUE(warns(r, "at least 477.1 kgf"));  // 4678.4 N over 9.80665, rounded up
  EXPECT_FALSE(warns(r, " N "));
}

TEST(FrictionDriveRun, NoWarningOfFrictionUpTo04) {
  Input in = saw();
  in.friction = 0.4;
  EXPECT_FALSE(warns(run(in), "is far above"));
}

TEST(FrictionDriveRun, NoGripStillShowsItsSteps) {
  Input in = saw();
  in.friction = 0.02;
  const Result r = run(in);
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_NE(r.message.find("raise the wrap above"), std::string::npos);
  EXPECT_NE(r.find_value("e"), nullptr);
  EXPECT_EQ(r.find_value("P_M"), nullptr);
  EXPECT_FALSE(r.steps.empty());
  ASSERT_EQ(r.figures.size(), 1U) << "the drive as described";
  const auto& drive = std::get<Drawing>(r.figures.front());
  EXPECT_NE(drive.title.find("as described"), std::string::npos);
  for (const Shape& one : drive.shapes) {
    const auto* force = std::get_if<ForceArrow>(&one);
    EXPECT_TRUE(force == nullptr || force->label == "P_p") << "only what is given";
  }
}

TEST(FrictionDriveRun, ReserveBeyondTheGripIsSaid) {
  Input in = saw();
  in.friction = 0.0236;  // e just above 1.08: m (r - 1) > e - 1
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok);
  EXPECT_EQ(r.find_value("takeup_with_idler_loss"), nullptr);
  EXPECT_TRUE(warns(r, "no pull is enough"));
}

TEST(FrictionDriveRun, EveryErratumNamesATestOfTheCases) {
  for (const Erratum& e : about().errata) EXPECT_EQ(e.test.rfind("FrictionDriveCase.", 0), 0u);
}

}  // namespace taut::friction_drive::run_test
