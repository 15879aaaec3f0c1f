#include "taut/units/any_quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "taut/units/display.hpp"

namespace taut::any_quantity_test {

TEST(AnyQuantity, ItsUnitSaysWhatItIs) {
  struct Case {
    const char* text;
    double value;
    Unit unit;
  };
  for (const Case& c :
       {Case{.text = "30 m/min", .value = 0.5, .unit = si::m_per_s},
        Case{.text = "12 kN", .value = 12e3, .unit = si::N}, Case{.text = "-3.5", .value = -3.5, .unit = si::one},
        Case{.text = "5 %", .value = 0.05, .unit = si::one}, Case{.text = "180 deg", .value = M_PI, .unit = si::rad},
        Case{.text = "2 kN m", .value = 2e3, .unit = si::N_m}, Case{.text = "120 cm", .value = 1.2, .unit = si::m},
        Case{.text = "2 s", .value = 2, .unit = si::s}}) {
    const auto found = parse_any_quantity(c.text);
    ASSERT_TRUE(found) << c.text;
    EXPECT_NEAR(found->value, c.value, 1e-12 * std::abs(c.value)) << c.text;
    EXPECT_TRUE(same_kind(found->unit, c.unit)) << c.text;
  }
}

TEST(AnyQuantity, APercentageIsWrittenDownAsOne) {
  EXPECT_TRUE(is_percentage(parse_any_quantity("5 %")->unit));
  for (const char* text : {"0.05", "5 deg", "5 m"}) EXPECT_FALSE(is_percentage(parse_any_quantity(text)->unit)) << text;
}

// What is written down again with its unit means the same, where cycles are asked for and where a speed of turning is.
TEST(AnyQuantity, AFrequencyKeepsWhatItCounts) {
  const auto of = [](const char* text) { return *parse_any_quantity(text); };
  EXPECT_EQ(of("1.5 Hz").value, 1.5);
  EXPECT_EQ(of("1.5 Hz").unit.symbol, "Hz");
  EXPECT_NEAR(of("360 deg/s").value, 2 * M_PI, 1e-12);
  EXPECT_EQ(of("360 deg/s").unit.symbol, "rad/s");
  EXPECT_EQ(of("3 1/s").unit.symbol, "1/s");
  EXPECT_TRUE(is_turning(of("0 Hz").unit));
  EXPECT_TRUE(is_turning(of("3 rad/s").unit));
  EXPECT_FALSE(is_turning(of("3 1/s").unit));
  EXPECT_TRUE(same_kind(of("3 Hz").unit, si::per_s));
}

TEST(AnyQuantity, ADifferenceOfTemperaturesHasNoZeroInDegreesCelsius) {
  for (const char* text : {"1 K", "1 degC"}) EXPECT_NEAR(*parse_difference(text, si::K.in("degC")), 1, 1e-12) << text;
  EXPECT_EQ(*parse_difference("3 kN", si::N), 3e3);
  EXPECT_FALSE(parse_difference("1 m", si::K));
  const Unit kelvins = difference_of(si::K.in("degC"));
  EXPECT_EQ(Display(std::map<std::string, std::string>{{"temperature", "degC"}}).quantity(0.5, kelvins), "0.5 K");
  EXPECT_TRUE(is_temperature(si::K));
  EXPECT_FALSE(is_temperature(kelvins));
  EXPECT_EQ(difference_of(si::N.in("kN")).shown, "kN");
}

TEST(AnyQuantity, SaysWhyNot) {
  for (const char* text : {"fast", "3 furlongz", "1,5 m", "1 kg^3 m^2"}) {
    const auto found = parse_any_quantity(text);
    ASSERT_FALSE(found) << text;
    EXPECT_FALSE(found.error().message.empty()) << text;
    EXPECT_EQ(found.error().message.find("a plain number is expected"), std::string::npos) << found.error().message;
  }
  EXPECT_FALSE(same_kind(si::rad, si::one));
}

}  // namespace taut::any_quantity_test
