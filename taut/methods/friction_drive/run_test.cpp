#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

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

std::string to_text_of(const std::vector<Answer>& lines) {
  std::string all;
  for (const Answer& line : lines) all += line.label + ": " + line.text + "\n";
  return all;
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

Input rubbed(double m) {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.35;
  in.wrap = 200 * std::numbers::pi / 180;
  in.rope_mass = 0.6;
  in.speed = 15;
  in.grip_reserve = m;
  in.section_factor = 0.126;
  return in;
}

const Check* find(const Result& r, const std::string& name) {
  const auto found = std::find_if(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
  return found == r.checks.end() ? nullptr : &*found;
}

// By hand: e = 2.7810, c = 135 N. (18) with m = 2 gives P_M = 9850.1 N. With T_1 = 1.08 T_2 + P_p a pull of P_M leaves
// T_2 = (9850.1 + 270 - 4000)/2.08 = 2942.4 N and T_1 = 7177.7 N: (T_1 - c)/(T_2 - c) = 2.509 < e, it holds. The slack
// branch carries 1.781 (2942.4 - 135) = 5000 N of the sheave's 4235.4 N: a reserve of 1.1805, not 2.
TEST(FrictionDriveRun, APullOfThePaperThatHoldsIsNotSaidToSlip) {
  const Input in = rubbed(2);
  const Result r = run(in);
  const Check *slip = find(r, "no slip"), *reserve = find(r, "grip reserve");
  ASSERT_NE(slip, nullptr);
  ASSERT_NE(reserve, nullptr);
  EXPECT_NEAR(slip->value, 2.509, 1e-3);
  EXPECT_TRUE(slip->passes);
  EXPECT_NEAR(reserve->value, 1.1805, 1e-3);
  EXPECT_FALSE(reserve->passes);
  EXPECT_EQ(exit_code(r), 4) << "the reserve is missed";
  EXPECT_FALSE(warns(r, "slips"));
  EXPECT_TRUE(warns(r, "with a reserve of 1.18, not 2"));
  const std::string words = to_text_of(answers(in, r, Display()));
  EXPECT_NE(words.find("its pull 9.85 kN of (18) holds the rope"), std::string::npos) << words;
  EXPECT_EQ(words.find("lets the rope slip"), std::string::npos) << words;
  // what the paper prints as (3) is 25.5 kN, and far from slipping
  EXPECT_EQ(r.comparisons[1].build_by.find("both slip"), std::string::npos) << r.comparisons[1].build_by;
}

// m = 1.3: P_M = 3.25 kN is less than the cutting force. The slack branch would have to push.
TEST(FrictionDriveRun, APullOfThePaperThatSlipsFailsAsItsBranchesDo) {
  const Result r = run(rubbed(1.3));
  ASSERT_NE(find(r, "no slip"), nullptr);
  EXPECT_NEAR(find(r, "no slip")->value, 7.4317, 1e-4);
  EXPECT_FALSE(find(r, "no slip")->passes);
  EXPECT_EQ(find(r, "grip reserve"), nullptr);
  EXPECT_TRUE(warns(r, "so the rope slips"));
}

/// The same drive with e = exp(0.0862) = 1.09 and r = 1.08.
Input barely_gripping() {
  Input in;
  in.cutting_force = 1000;
  in.friction = 0.0862;
  in.wrap = 1;
  in.rope_mass = 0.6;
  in.speed = 5;
  in.grip_reserve = 1.3;
  return in;
}

// takeup_no_slip is 1000 (1 + 2.6/0.09) = 29.88 kN. The loss of the idler, 0.08 T_2, takes 0.08 14.4 = 1.15 kN of the
// 0.09 14.4 = 1.3 kN that the slack branch carries: with it the rope slips. A pull of P_M = 248 kN leaves
// T_2 = 118.8 kN, which carries 10.69 kN of the 10.5 kN that the sheave has to pull.
TEST(FrictionDriveRun, APullWithWhichTheIdlerLossMakesTheRopeSlipIsNotToBeBuilt) {
  const Input in = barely_gripping();
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_FALSE(warns(r, "build by"));
  EXPECT_TRUE(warns(r, "no pull is enough"));
  EXPECT_TRUE(warns(r, "and the rope slips with it"));
  EXPECT_FALSE(warns(r, "not safe")) << "P_M holds";
  EXPECT_NEAR(find(r, "grip reserve")->value, 10.69 / 10.50, 2e-3);
  const std::string words = to_text_of(answers(in, r, Display()));
  EXPECT_EQ(words.find("pull on the idler of at least"), std::string::npos) << words;
}

// e = 1.1: the reserve of 1.2 can be kept, by far more pull than without the loss.
TEST(FrictionDriveRun, WhereTheIdlerLossMakesTheRopeSlipItsPullIsToBeBuilt) {
  Input in = barely_gripping();
  in.friction = 0.0953;
  in.grip_reserve = 1.2;
  const Result r = run(in);
  const double with = r.find_value("takeup_with_idler_loss")->value;
  EXPECT_TRUE(warns(r, "at least " + Display().brief(with, si::N, Rounding::up)));
  EXPECT_TRUE(warns(r, "build by the pull with the idler loss"));
}

TEST(FrictionDriveRun, EveryErratumNamesATestOfTheCases) {
  for (const Erratum& e : about().errata) EXPECT_EQ(e.test.rfind("FrictionDriveCase.", 0), 0u);
}

}  // namespace taut::friction_drive::run_test
