#include <gtest/gtest.h>

#include <cmath>

#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/plain_mast_test.hpp"

namespace taut::mast_section::complaints_test {

Span span_of(std::vector<double> positions) {
  Span span;
  span.length = 300;
  span.carriage_position = std::move(positions);
  span.rope_weight = 18;
  span.load = 20e3;
  span.horizontal_tension = 90e3;
  return span;
}

std::vector<std::string> paths(const Input& in) {
  std::vector<std::string> all;
  for (const Complaint& c : complaints(in)) {
    EXPECT_FALSE(c.message.empty());
    all.push_back(c.path);
  }
  return all;
}

using Paths = std::vector<std::string>;

TEST(MastSectionComplaints, NoneForAGoodDeck) {
  EXPECT_EQ(paths(plain_mast()), Paths{});
  Input in = plain_mast();
  in.branch_angle.reset();
  in.span = span_of({10, 300});
  EXPECT_EQ(paths(in), Paths{}) << "the far end itself is allowed";
}

TEST(MastSectionComplaints, AngleOrSpan) {
  Input in = plain_mast();
  in.span = span_of({10});
  EXPECT_EQ(paths(in), Paths{"branch_angle"});
  in.span.reset();
  in.branch_angle.reset();
  EXPECT_EQ(paths(in), Paths{""});
}

TEST(MastSectionComplaints, CarriageBeyondTheSpan) {
  Input in = plain_mast();
  in.branch_angle.reset();
  in.span = span_of({10, 301, 5, 400});
  EXPECT_EQ(paths(in), (Paths{"span.carriage_position[1]", "span.carriage_position[3]"}));
  in.span = span_of({301});
  EXPECT_EQ(paths(in), Paths{"span.carriage_position"});
  in.span = span_of({});
  EXPECT_EQ(paths(in), Paths{"span.carriage_position"});
}

// The span's skyline is that of the mast: H = 90 kN and a chord of tan(alpha) = (f_x + x tan(psi))/x.
TEST(MastSectionComplaints, TheSpanPullsNoMoreThanTheLargestForce) {
  Input in = plain_mast();
  in.branch_angle.reset();
  in.span = span_of({150, 10});
  const double f_10 = 10.0 * 290 / (2 * 90e3) * (18 + 2 * 20e3 / 300), at_mast = 90e3 * std::hypot(1, f_10 / 10);
  in.skyline_force = 1.001 * at_mast;
  EXPECT_EQ(paths(in), Paths{});
  in.skyline_force = 0.999 * at_mast;
  EXPECT_EQ(paths(in), Paths{}) << "rounded";
  in.skyline_force = 0.99 * at_mast;
  ASSERT_EQ(paths(in), Paths{"skyline_force"});
  EXPECT_NE(complaints(in)[0].message.find("at the mast with the carriage at 10 m"), std::string::npos);
  in.span->chord_slope = -0.5;  // the span rises from the mast: the far end has the most
  in.span->carriage_position = {10};
  const double f_rising = 10.0 * 290 / (2 * 90e3) * (18 / std::cos(0.5) + 2 * 20e3 / 300);
  in.skyline_force = 1.001 * 90e3 * std::hypot(1, std::tan(0.5) + f_rising / 290);
  EXPECT_EQ(paths(in), Paths{});
  in.skyline_force *= 0.98;
  ASSERT_EQ(paths(in), Paths{"skyline_force"});
  EXPECT_NE(complaints(in)[0].message.find("far end"), std::string::npos);
}

TEST(MastSectionComplaints, StressOrSteelWithSafety) {
  Input in = plain_mast();
  in.steel = "S355";
  in.safety = 1.5;
  EXPECT_EQ(paths(in), (Paths{"steel", "safety"}));
  in.allowable_stress.reset();
  EXPECT_EQ(paths(in), Paths{});
  in.safety.reset();
  EXPECT_EQ(paths(in), Paths{"steel"});
  in.steel = "S350";
  in.safety = 1.5;
  ASSERT_EQ(paths(in), Paths{"steel"});
  EXPECT_NE(complaints(in)[0].message.find("S355"), std::string::npos);
  in.steel.reset();
  in.safety.reset();
  EXPECT_EQ(paths(in), Paths{""});
}

TEST(MastSectionComplaints, SectionsThatAreNotThere) {
  Input in = plain_mast();
  in.section = "CHS 509x16";
  EXPECT_EQ(paths(in), Paths{"section"});
  in.section = "CHS 508x16";
  EXPECT_EQ(paths(in), Paths{});
  in.choose_section = ChooseSection{};
  EXPECT_EQ(paths(in), Paths{"choose_section"});
  in.section.reset();
  in.choose_section->standard = "DIN 99999";
  EXPECT_EQ(paths(in), Paths{"choose_section"});
  in.choose_section->standard = "GOST";
  EXPECT_EQ(paths(in), Paths{});
}

}  // namespace taut::mast_section::complaints_test
