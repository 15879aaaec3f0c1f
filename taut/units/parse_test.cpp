#include "taut/units/parse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/units/any_quantity.hpp"
#include "taut/units/names.hpp"

namespace taut::parse_test {

double in_si(std::string_view text, const Unit& unit) {
  const auto v = parse_quantity(text, unit);
  EXPECT_TRUE(v.has_value()) << text << ": " << (v ? "" : v.error().message);
  return v.value_or(std::nan(""));
}

std::string refusal(std::string_view text, const Unit& unit) {
  const auto v = parse_quantity(text, unit);
  return v ? "accepted" : v.error().message;
}

TEST(ParseQuantity, TurnsUnitsIntoSi) {
  EXPECT_DOUBLE_EQ(in_si("63 kN", si::N), 63000);
  EXPECT_DOUBLE_EQ(in_si("63kN", si::N), 63000);
  EXPECT_DOUBLE_EQ(in_si("3000 kgf", si::N), 29419.95);
  EXPECT_DOUBLE_EQ(in_si("1 kgf/m", si::N_per_m), 9.80665);
  EXPECT_DOUBLE_EQ(in_si("140 kgf/mm2", si::Pa), 140 * 9.80665e6);
  EXPECT_DOUBLE_EQ(in_si("160 N/mm^2", si::Pa), 160e6);
  EXPECT_DOUBLE_EQ(in_si("160 N/mm²", si::Pa), 160e6);
  EXPECT_DOUBLE_EQ(in_si("2.72 MN/m", si::N_per_m), 2.72e6);
  EXPECT_DOUBLE_EQ(in_si("100 kN s/m", si::N_s_per_m), 1e5);
  EXPECT_DOUBLE_EQ(in_si("7000 kg m^2", si::kg_m2), 7000);
  EXPECT_DOUBLE_EQ(in_si("-1.5e-3 m", si::m), -1.5e-3);
  EXPECT_DOUBLE_EQ(in_si("+12 mm", si::m), 0.012);
  EXPECT_DOUBLE_EQ(in_si("1 in", si::m), 0.0254);
  EXPECT_DOUBLE_EQ(in_si("5 1/s", si::per_s), 5);
  EXPECT_DOUBLE_EQ(in_si("3 rad/s", si::per_s), 3);
  EXPECT_DOUBLE_EQ(in_si("3 Hz", si::per_s.in("Hz")), 3);
  EXPECT_DOUBLE_EQ(in_si("36 km/h", si::m_per_s), 10);
  EXPECT_DOUBLE_EQ(in_si("1 kip", si::N), 4448.2216152605);
}

/// A cycle is a whole turn: 2 pi rad, 360 deg.
TEST(ParseQuantity, ASpeedOfTurningIsSoManyCyclesPerTime) {
  const Unit cycles = si::per_s.in("Hz");
  EXPECT_DOUBLE_EQ(in_si("9 rad/s", cycles), 9 / (2 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(in_si("720 deg/s", cycles), 2);
  EXPECT_DOUBLE_EQ(in_si("60 1/min", cycles), 1);
  EXPECT_DOUBLE_EQ(unit_factor("rad/s", cycles).value(), 1 / (2 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(unit_factor("rad/s", si::per_s).value(), 1);
  EXPECT_DOUBLE_EQ(in_si("2 Hz", si::per_s), 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(in_si("2 1/s", si::per_s), 2);
}

TEST(ParseQuantity, ReadsAnglesAndSlopes) {
  EXPECT_DOUBLE_EQ(in_si("180 deg", si::rad), std::numbers::pi);
  EXPECT_DOUBLE_EQ(in_si("200 gon", si::rad), std::numbers::pi);
  EXPECT_DOUBLE_EQ(in_si("12 °", si::rad), 12 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(in_si("100 %", si::rad), std::atan(1.0));
  EXPECT_DOUBLE_EQ(in_si("-30 %", si::rad), std::atan(-0.3));
  EXPECT_DOUBLE_EQ(in_si("90 %", si::one), 0.9);
  EXPECT_DOUBLE_EQ(in_si("0.9", si::one), 0.9);
}

TEST(ParseQuantity, RefusesWhatIsAmbiguousAndNamesTheChoices) {
  EXPECT_NE(refusal("3 ton", si::kg).find("'t' (1000 kg)"), std::string::npos);
  EXPECT_NE(refusal("3 kn", si::N).find("'kN'"), std::string::npos);
  EXPECT_NE(refusal("3 lbs", si::N).find("'lbf'"), std::string::npos);
  EXPECT_NE(refusal("3 N/m s", si::N_s_per_m).find("ambiguous after '/'"), std::string::npos);
}

TEST(ParseQuantity, SaysWhatIsWrongAndWhatToDo) {
  EXPECT_NE(refusal("100", si::N).find("such as '1 kN'"), std::string::npos);
  EXPECT_NE(refusal("12", si::rad).find("such as '1 deg'"), std::string::npos);
  EXPECT_NE(refusal("12 mm", si::N).find("'mm' is a unit of length; a force"), std::string::npos);
  EXPECT_NE(refusal("12 Nn", si::N).find("did you mean"), std::string::npos);
  EXPECT_NE(refusal("1,5 m", si::m).find("decimal point"), std::string::npos);
  EXPECT_NE(refusal("1 000 m", si::m).find("two numbers"), std::string::npos);
  EXPECT_NE(refusal("1e999 m", si::m).find("too large"), std::string::npos);
  EXPECT_NE(refusal("0.5 m", si::one).find("plain number"), std::string::npos);
  EXPECT_NE(refusal("5 % m", si::m).find("'%' stands alone"), std::string::npos);
  for (const char* bad : {"", "m", "nan N", "inf N", ".inf N", "0x10 N", "1_0 N", "5 N^9", "5 N/", "5 /m", "5 N m2x",
                          "5 (N", "--5 N", "+-5 N", "5 N^", "5 N^-", "5 m12"}) {
    EXPECT_FALSE(parse_quantity(bad, si::N).has_value()) << bad;
  }
}

// As they are copied from a printed text: no-break spaces U+00A0 and U+202F, the thin space U+2009, the minus U+2212.
TEST(ParseQuantity, ReadsSpacesAndMinusOfAPrintedText) {
  EXPECT_DOUBLE_EQ(in_si("100\u00a0kN", si::N), 1e5);
  EXPECT_DOUBLE_EQ(in_si("100\u202fkN\u2009s/m\u00a0", si::N_s_per_m), 1e5);
  EXPECT_DOUBLE_EQ(in_si("\u00a0100 kN", si::N), 1e5);
  EXPECT_DOUBLE_EQ(in_si("\u221212\u00a0deg", si::rad), -12 * std::numbers::pi / 180);
  EXPECT_TRUE(std::isinf(parse_quantity("\u2212.inf", si::N, true).value()));
  EXPECT_EQ(parse_number("\u22120.5").value(), -0.5);
  EXPECT_DOUBLE_EQ(parse_difference("\u22125\u00a0degC", si::K).value(), -5);
  EXPECT_NEAR(parse_any_quantity("\u22125\u00a0degC")->value, 268.15, 1e-9);
  EXPECT_NE(refusal("1\u00a0000 kN", si::N).find("digits without spaces"), std::string::npos);
  for (const char* grouped : {"1'000 kN", "1\u2019000 kN", "1_000 kN"})
    EXPECT_NE(refusal(grouped, si::N).find("write 1000 without one"), std::string::npos) << grouped;
  for (const char* bad : {"5\u2212N", "\u2212\u22125 N", "10\u221220 N", "5 N^\u22121", "1e\u22123 N", "\u2212"})
    EXPECT_FALSE(parse_quantity(bad, si::N).has_value()) << bad;
  const auto v = parse_quantity("12\u202fkNN", si::N);
  ASSERT_FALSE(v.has_value());
  EXPECT_EQ(v.error().offset, 5) << "behind a space of three bytes";
}

TEST(ParseQuantity, AllowsInfinityOnlyWhereAsked) {
  EXPECT_TRUE(std::isinf(parse_quantity(".inf", si::N, true).value()));
  EXPECT_TRUE(std::isinf(parse_quantity(".inf kN", si::N, true).value()));
  EXPECT_FALSE(parse_quantity(".inf", si::N).has_value());
}

TEST(ParseQuantity, PointsIntoTheText) {
  const auto v = parse_quantity("12 kNN", si::N);
  ASSERT_FALSE(v.has_value());
  EXPECT_EQ(v.error().offset, 3);
  EXPECT_EQ(v.error().width, 3);
}

TEST(ParseNumber, TakesWholeTextOnly) {
  EXPECT_EQ(parse_number("0.12").value(), 0.12);
  for (const char* bad : {"", "0x10", "1_000", "1 2", "nan", "1e999", ".inf", "a"})
    EXPECT_FALSE(parse_number(bad)) << bad;
}

TEST(UnitNames, EveryNameIsReadAsAQuantityOfItsKind) {
  for (const NameRow& row : name_rows()) {
    const Unit unit{
        .dimension = row.dimension, .symbol = "?", .shown = row.name, .is_angle = row.is_angle, .kind = row.kind};
    EXPECT_TRUE(parse_quantity("1 " + std::string(row.name), unit).has_value()) << row.name;
  }
}

TEST(UnitNames, TemperatureHasItsOffset) {
  EXPECT_DOUBLE_EQ(in_si("15 degC", si::K), 288.15);
  EXPECT_DOUBLE_EQ(in_si("288.15 K", si::K), 288.15);
}

RC_GTEST_PROP(ParseQuantity, NeverThrowsOnAnyText, (const std::string& text)) {
  for (const Unit& unit : {si::N, si::rad, si::one}) parse_quantity(text, unit);
}

}  // namespace taut::parse_test
