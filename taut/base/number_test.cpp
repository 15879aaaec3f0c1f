#include "taut/base/number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace taut::number_test {

TEST(Number, ReadsWhatTheWholeTextSays) {
  struct Case {
    const char* text;
    double value;
  };
  for (const Case& c : {Case{.text = "0", .value = 0.0},
                        {.text = "12", .value = 12.0},
                        {.text = "+12", .value = 12.0},
                        {.text = "-1.5e-3", .value = -1.5e-3},
                        {.text = ".5", .value = 0.5},
                        {.text = "+2.", .value = 2.0},
                        {.text = "1E5", .value = 1e5},
                        {.text = "0.1", .value = 0.1},
                        {.text = "000.0e999", .value = 0.0},
                        {.text = "4.9e-324", .value = 4.9e-324},
                        {.text = "1.7976931348623157e308", .value = 1.7976931348623157e308}}) {
    const auto read = parse_double(c.text);
    ASSERT_TRUE(read.has_value()) << c.text;
    EXPECT_EQ(*read, c.value) << c.text;
  }
  EXPECT_TRUE(std::signbit(parse_double("-0").value()));
}

TEST(Number, RoundsToTheNearestHoweverManyDigits) {
  // the midpoint of two doubles goes to the even one, a digit beyond it decides otherwise, also far behind
  EXPECT_EQ(parse_double("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(parse_double("9007199254740993.0" + std::string(200, '0') + "1"), 9007199254740994.0);
  EXPECT_EQ(parse_double("0." + std::string(100, '0') + "1" + "e101"), 1.0);
  EXPECT_EQ(parse_double("1" + std::string(300, '0')), 1e300);
}

TEST(Number, RefusesWhatIsNoDecimalNumber) {
  for (const char* text :
       {"",    " ",   "+",    "-",        ".",  "e5",  "+-5",   "--5",   " 1", "1 ",    "1,5",    "1_0",   "0x10",
        "inf", "nan", "-inf", "infinity", "1e", "1e+", "1.2.3", "1e5.0", "½",  "1e999", "-1e999", "1e-400"}) {
    EXPECT_FALSE(parse_double(text).has_value()) << text;
  }
  EXPECT_FALSE(parse_double(std::string_view("1\0", 2)).has_value());
}

TEST(Number, SaysWhereTheNumberAtTheFrontEnds) {
  EXPECT_EQ(number_at_front("63 kN").length, 2U);
  EXPECT_EQ(number_at_front("1.5e3m").length, 5U);
  EXPECT_EQ(number_at_front("5e").length, 1U) << "what only begins like an exponent is none";
  EXPECT_EQ(number_at_front("5e-x").length, 1U);
  EXPECT_EQ(number_at_front("0x10").length, 1U);
  EXPECT_EQ(number_at_front("kN").length, 0U);
  EXPECT_FALSE(number_at_front("1e999 m").in_range);
  EXPECT_EQ(number_at_front("1e999 m").length, 5U);
  EXPECT_FALSE(number_at_front("1e-999").in_range);
  EXPECT_TRUE(number_at_front("1e-310").in_range);
  // a view into a longer text ends where it ends
  EXPECT_EQ(number_at_front(std::string_view("12345").substr(0, 2)).value, 12.0);
}

TEST(Number, TheLanguageOfTheSystemPlaysNoPart) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* language : {"de_DE.UTF-8", "ru_RU.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, language) == nullptr) continue;  // not installed
    EXPECT_EQ(parse_double("1.5"), 1.5) << language;
    EXPECT_FALSE(parse_double("1,5").has_value()) << language;
  }
  std::setlocale(LC_ALL, before.c_str());
}

RC_GTEST_PROP(Number, ReadsBackEveryDouble, (const std::uint64_t& bits)) {
  const auto x = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(x));
  for (const std::string& text : {fmt::format("{}", x), fmt::format("{:.17g}", x), fmt::format("{:.16e}", x)}) {
    const auto read = parse_double(text);
    RC_ASSERT(read.has_value());
    RC_ASSERT(std::bit_cast<std::uint64_t>(*read) == bits);
  }
}

TEST(Number, StepsEndWhereTheyAreToEnd) {
  EXPECT_NE(150.3 + (60.1 - 150.3) * 24 / 24, 60.1) << "what the plain formula does";
  EXPECT_EQ(step_between(150.3, 60.1, 24, 24), 60.1);
  EXPECT_EQ(step_between(150.3, 60.1, 0, 24), 150.3);
  EXPECT_EQ(step_between(2, 4, 1, 4), 2.5);
}

TEST(PlaceNumber, MapCoordinatesKeepTheirCentimetres) {
  EXPECT_EQ(place_number(12.345678), "12.3457");
  EXPECT_EQ(place_number(12.345678, 4), "12.35");
  EXPECT_EQ(place_number(-1250), "-1250");
  EXPECT_EQ(place_number(2600030), "2600030");
  EXPECT_EQ(place_number(2600030.25, 4), "2600030.25");
  EXPECT_EQ(place_number(-5200039.9999999995), "-5200040");
  EXPECT_EQ(place_number(14142135.62), "14142135.62");
}

}  // namespace taut::number_test
