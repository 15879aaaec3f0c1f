#include "taut/methods/friction_drive/rope_strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "taut/catalogue/rope_words.hpp"

namespace taut::friction_drive::rope_strength_test {

Input saw() {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.8;
  in.wrap = 3.4907;
  in.rope_mass = 0.6;
  in.speed = 15;
  in.sheave_radius = 0.2;
  in.rope = "6x36-IWRC 10 mm 1960 MPa";
  return in;
}

catalogue::RopeRow rope(const char* words) {
  const auto found = catalogue::find_rope_in_words(words);
  EXPECT_TRUE(found.has_value()) << words;
  return found.value_or(catalogue::RopeRow{});
}

TEST(FrictionDriveRope, AdviceFollowsTheConstruction) {
  EXPECT_EQ(diameter_rule(rope("6x36-IWRC 10 mm 1960 MPa"))->id, "ratio.maker.6x36ws_iwrc");
  catalogue::RopeRow rotation_resistant;
  rotation_resistant.construction = "19x7";
  EXPECT_EQ(diameter_rule(rotation_resistant)->id, "ratio.maker.18x7_19x7") << "the second of two names";
  EXPECT_EQ(diameter_rule(rope("6x7-FC 10 mm 1770 MPa"))->id, "ratio.mainline_block.us_wa");
}

TEST(FrictionDriveRope, SafetyAndDiameterRatio) {
  const Input in = saw();
  const Result r = run(in);
  const catalogue::RopeRow row = *rope_of(in);
  const double largest =
      std::max({r.find_value("P_tight")->value, r.find_value("T_1")->value, r.find_value("T_1_no_slip")->value});
  EXPECT_DOUBLE_EQ(r.find_value("safety_factor")->value, row.breaking_force / largest);
  EXPECT_DOUBLE_EQ(r.find_value("diameter_ratio")->value, 40);
  EXPECT_DOUBLE_EQ(r.find_value("sigma_tight")->value * row.area,
                   std::max(r.find_value("P_tight")->value, r.find_value("T_1_no_slip")->value));
  const auto check = std::find_if(r.checks.begin(), r.checks.end(),
                                  [](const Check& c) { return c.name == "D/d of the driving sheave"; });
  ASSERT_NE(check, r.checks.end());
  EXPECT_TRUE(check->passes);
  EXPECT_EQ(check->limit, 23);
  EXPECT_EQ(check->trust, "verified");
}

TEST(FrictionDriveRope, SmallSheaveFailsItsCheck) {
  Input in = saw();
  in.sheave_radius = 0.1;
  const Result r = run(in);
  const bool fails = std::any_of(r.checks.begin(), r.checks.end(),
                                 [](const Check& c) { return c.name == "D/d of the driving sheave" && !c.passes; });
  EXPECT_TRUE(fails);
}

TEST(FrictionDriveRope, BareRopeHeavierThanTheMassGiven) {
  Input in = saw();
  in.rope_mass = 0.1;
  const Result r = run(in);
  EXPECT_TRUE(std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
    return w.find("less than that of the bare rope") != std::string::npos;
  }));
}

TEST(FrictionDriveRope, UnknownRopeIsAComplaint) {
  Input in = saw();
  EXPECT_TRUE(complaints(in).empty());
  in.rope = "6x36-IWRC 10.5 mm 1960 MPa";
  ASSERT_EQ(complaints(in).size(), 1u);
  EXPECT_EQ(complaints(in)[0].path, "rope");
  in.rope = "6x36-IWRC 10 mm 1960 MPa";
  in.rope_area = 1e-3;
  ASSERT_EQ(complaints(in).size(), 1u);
  EXPECT_EQ(complaints(in)[0].path, "rope_area");
}

}  // namespace taut::friction_drive::rope_strength_test
