#include "taut/units/display.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"

namespace taut::display_test {

TEST(Display, PrintsInTheUnitsOwnUnitOfPrint) {
  const Display d;
  EXPECT_EQ(d.quantity(63000, si::N), "63 kN");
  EXPECT_EQ(d.quantity(0.012, si::m.in("mm")), "12 mm");
  EXPECT_EQ(d.quantity(0.012, si::m), "0.012 m");
  EXPECT_EQ(d.quantity(0.15, si::one), "0.15");
  EXPECT_EQ(d.quantity(0.15, si::one.in("%")), "15 %");
  EXPECT_EQ(d.quantity(M_PI / 6, si::rad), "30 deg");
  EXPECT_EQ(d.quantity(2.72e6, si::N_per_m.in("MN/m")), "2.72 MN/m");
  EXPECT_EQ(d.quantity(253.15, si::K.in("degC")), "-20 degC");
}

TEST(Display, PrintsInTheUnitChosenForTheKind) {
  const Display d({{"force", "kgf"}, {"length", "mm"}, {"angle", "%"}, {"section modulus", "mm^3"}});
  EXPECT_EQ(d.quantity(9806.65, si::N), "1000 kgf");
  EXPECT_EQ(d.quantity(0.012, si::m), "12 mm");
  EXPECT_EQ(d.quantity(0.012, si::m.in("cm")), "12 mm");
  EXPECT_EQ(d.quantity(std::atan(0.5), si::rad), "50 %");
  EXPECT_EQ(d.quantity(1e-6, si::m3), "1000 mm^3");
  EXPECT_EQ(Display(std::map<std::string, std::string>{{"temperature", "K"}}).quantity(253.15, si::K), "253.15 K");
  EXPECT_EQ(d.unit(si::Pa), "MPa");
  EXPECT_EQ(d.unit(si::one), "");
}

TEST(Display, KeepsFiveSignificantDigits) {
  EXPECT_EQ(short_number(1.23456789), "1.2346");
  EXPECT_EQ(short_number(-0.00123456789), "-0.0012346");
  EXPECT_EQ(short_number(12), "12");
  EXPECT_EQ(short_number(123456.7), "123457");
  EXPECT_EQ(short_number(99999.7), "100000");
  EXPECT_EQ(short_number(7654321.4), "7654321");
  EXPECT_EQ(short_number(2.1e11), "2.1e11");
  EXPECT_EQ(short_number(1.234567e-7), "1.2346e-7");
  EXPECT_EQ(short_number(-0.0), "0");
}

TEST(Display, ABriefQuantityHasFourDigits) {
  const Display d;
  EXPECT_EQ(d.brief(138860.6, si::N), "138.9 kN");
  EXPECT_EQ(d.brief(12345.6, si::one), "12346") << "whole digits stay";
  EXPECT_EQ(d.brief(9999.9, si::one), "10000");
  EXPECT_EQ(d.brief(0.88563, si::m), "0.8856 m");
  EXPECT_EQ(d.brief(382.4199, si::m), "382.42 m") << "a rope is cut to the centimetre";
  EXPECT_EQ(d.brief(170, si::m), "170 m");
  for (const char* unit : {"ft", "in", "cm", "yd", "km"}) {
    const Display own(std::map<std::string, std::string>{{"length", unit}});
    for (const double length : {12.3456, 67.0199, 382.4199, 1234.5678}) {
      const std::string text = own.brief(length, si::m);
      EXPECT_NEAR(*parse_quantity(text, si::m), length, 0.0051) << text;
    }
  }
  EXPECT_EQ(d.brief(std::nan(""), si::m), "-");
  EXPECT_EQ(d.brief(0, si::N), "0 kN");
}

TEST(Display, SaysWhatIsNoNumber) {
  const Display d;
  EXPECT_EQ(d.quantity(std::nan(""), si::N), "-");
  EXPECT_EQ(d.quantity(std::numeric_limits<double>::infinity(), si::N_per_m), "infinite");
  EXPECT_EQ(d.quantity(-std::numeric_limits<double>::infinity(), si::one), "-infinite");
}

TEST(Display, EveryKindPrintsInItsOwnUnit) {
  for (const Unit& u : display_kinds()) {
    EXPECT_TRUE(check_display(u.kind, u.shown).has_value()) << u.kind;
    EXPECT_GT(Display().from_si(1000.0, u), 0.0) << u.kind;
  }
}

TEST(Display, RefusesWrongKindsAndUnits) {
  const auto kind = check_display("forse", "kN");
  ASSERT_FALSE(kind);
  EXPECT_TRUE(kind.error().of_kind);
  EXPECT_NE(kind.error().message.find("did you mean 'force'?"), std::string::npos);
  const auto strange = check_display("colour", "red");
  ASSERT_FALSE(strange);
  EXPECT_NE(strange.error().message.find("length"), std::string::npos);
  const auto unit = check_display("force", "mm");
  ASSERT_FALSE(unit);
  EXPECT_FALSE(unit.error().of_kind);
  EXPECT_EQ(unit.error().offset, 0);
  EXPECT_NE(unit.error().message.find("force"), std::string::npos);
  EXPECT_FALSE(check_display("force", "ton"));
  EXPECT_FALSE(check_display("force", ""));
  EXPECT_FALSE(check_display("number", "%")) << "a plain number has no unit to choose";
}

TEST(Display, AUnitThatWasNotCheckedIsOurBug) {
  const std::map<std::string, std::string> unchecked = {{"force", "mm"}};
  EXPECT_THROW(Display(unchecked).number(1, si::N), ContractViolation);
}

RC_GTEST_PROP(Display, ReadsBackWhatItPrints, (const std::int32_t& whole)) {
  const double x = whole / 1000.0;
  const Display d({{"force", "lbf"}, {"length", "ft"}});
  for (const Unit& u : {si::N, si::m, si::Pa, si::kg_per_m, si::rad}) {
    if (u.is_angle && std::abs(x) > 1e5) continue;
    const auto back = parse_quantity(d.quantity(x, u), u);
    RC_ASSERT(back.has_value());
    RC_ASSERT(std::abs(*back - x) <= 6e-5 * std::abs(x));
  }
}

TEST(Display, RoundsBriefNumbersToTheSafeSide) {
  const Display d;
  const Unit t = si::kg.in("t");
  EXPECT_EQ(d.brief(2957.6, t), "2.958 t");
  EXPECT_EQ(d.brief(2957.6, t, Rounding::down), "2.957 t");
  EXPECT_EQ(d.brief(2957.1, t, Rounding::up), "2.958 t");
  EXPECT_EQ(d.brief(2957, t, Rounding::up), "2.957 t");
  EXPECT_EQ(d.brief(2957, t, Rounding::down), "2.957 t");
  EXPECT_EQ(d.brief(-2957.6, t, Rounding::down), "-2.958 t");
  EXPECT_EQ(d.brief(0.1 + 0.2, si::one, Rounding::up), "0.3");
  EXPECT_EQ(d.brief(12345.2, si::one, Rounding::up), "12346");
  EXPECT_EQ(d.brief(382.4249, si::m, Rounding::up), "382.43 m");
  EXPECT_EQ(d.brief(0, si::m, Rounding::up), "0 m");
  EXPECT_EQ(d.brief(std::nan(""), si::m, Rounding::down), d.brief(std::nan(""), si::m));
}

}  // namespace taut::display_test
