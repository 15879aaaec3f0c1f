#include "taut/units/expression.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "taut/units/unit.hpp"

/// Arithmetic of quantities, and texts as functions of one variable.
namespace taut::expression_test {

tl::expected<Measure, UnitError> value_of(std::string_view text) {
  return evaluate(text, [](std::string_view name) -> tl::expected<Measure, std::string> {
    if (name == "gap") return Measure{.value = 0.95, .dimension = dimension(0, 1, 0), .is_angle = false};
    if (name == "winter") return measure_of(*parse_any_quantity("-20 degC"));
    if (name == "beta") return Measure{.value = 0.5, .dimension = {}, .is_angle = true};
    return tl::unexpected(fmt::format("no {}", name));
  });
}

TEST(Expression, Arithmetic) {
  const std::vector<std::pair<std::string, double>> rows = {
      {"2 + 3 * 4", 14},
      {"(2 + 3) * 4", 20},
      {"2 - 3 - 4", -5},
      {"12 / 3 / 2", 2},
      {"-2^2", -4},
      {"2^3^1", 8},
      {"2^-1", 0.5},
      {"--3", 3},
      {"9 m - gap", 8.05},
      {"9 m - 2*gap", 7.1},
      {"gap/2", 0.475},
      {"1 m/gap", 1 / 0.95},
      {"60 km/h * 3 s", 50},
      {"3.5 kN/m * 2 m + 1 kN", 8000},
      {"5 1/s * 2 s", 10},
      {"2 m^2 / 4 m", 0.5},
      {"1 kg m^2 / 2 kg m2", 0.5},
      {"30 deg + beta", std::numbers::pi / 6 + 0.5},
      {"sin(30 deg) * 2", 1},
      {"tan(beta)", std::tan(0.5)},
      {"atan2(1 m, 1 m)", std::numbers::pi / 4},
      {"max(gap, 90 cm) + min(1 m, gap)", 1.9},
      {"sqrt(9 m^2) - abs(-1 m)", 2},
      {"2 * pi", 2 * std::numbers::pi},
      {"15 %", 0.15},
      {".5e1 + 1.5E-1", 5.15},
      {"1e3 N", 1000},
      {"9\u00a0m \u2212 2*gap", 7.1},
      {"\u22122\u202f* 3\u2009kN/m", -6000},
  };
  for (const auto& [text, expected] : rows) {
    const auto got = value_of(text);
    ASSERT_TRUE(got) << text << ": " << got.error().message;
    EXPECT_NEAR(got->value, expected, 1e-12 * std::max(1.0, std::abs(expected))) << text;
  }
  EXPECT_EQ(value_of("3 kN * 2 m")->dimension, si::N_m.dimension);
  EXPECT_TRUE(value_of("2 * beta")->is_angle);
  EXPECT_FALSE(value_of("beta / (1 deg)")->is_angle);
  EXPECT_FALSE(value_of("beta * gap")->is_angle);
}

TEST(Expression, TellsWhereItIsWrong) {
  const std::vector<std::tuple<std::string, std::string, int>> rows = {
      {"1 m + 2", "the left side is in ", 4},
      {"", "a value is missing", 0},
      {"2 *", "a value is missing", 2},
      {"(1 + 2", "is not closed", 0},
      {"1 2", "an operator", 2},
      {"2 gap", "gap", 2},
      {"gip + 1 m", "no gip", 0},
      {"1 m + 3 furlongs", "furlongs", 8},
      {"sine(1)", "there is no function 'sine'; did you mean 'sin'?", 0},
      {"sin(1)", "an angle is expected", 0},
      {"asin(2)", "outside -1 to 1", 0},
      {"sqrt(-1)", "below 0", 0},
      {"sqrt(1, 2)", "one value is expected", 0},
      {"max(1)", "two values are expected", 0},
      {"max(1 m, 1 s)", "the first value is", 0},
      {"gap^0.5", "a whole number", 3},
      {"beta + 1", "the left side is an angle", 5},
      {"1/0", "not a finite number", 0},
      {"#", "is expected here", 0},
  };
  for (const auto& [text, message, offset] : rows) {
    const auto got = value_of(text);
    ASSERT_FALSE(got) << text;
    EXPECT_NE(got.error().message.find(message), std::string::npos) << text << ": " << got.error().message;
    EXPECT_EQ(got.error().offset, offset) << text << ": " << got.error().message;
  }
  EXPECT_NE(value_of(std::string(100, '(') + "1" + std::string(100, ')')).error().message.find("deeper than 64"),
            std::string::npos);
  EXPECT_FALSE(value_of(std::string(100000, '-') + "1"));
}

TEST(Expression, AValueIsWrittenSoThatItIsReadBackExactly) {
  for (const char* text : {"0.1 m * 3", "7 kN / 3", "1 kg m^2 / 7", "beta / 3", "3 kN s/m / 7", "1/3", "4 m/s/3"}) {
    const auto value = value_of(text);
    ASSERT_TRUE(value) << text;
    const auto back = parse_any_quantity(to_text(*value));
    ASSERT_TRUE(back) << to_text(*value) << ": " << back.error().message;
    EXPECT_EQ(back->value, value->value) << to_text(*value);
    EXPECT_EQ(back->unit.dimension, value->dimension);
    EXPECT_EQ(back->unit.is_angle, value->is_angle);
  }
  EXPECT_EQ(to_text(*value_of("sqrt(1 m)")), "");
}

TEST(FormulaText, TellsWhatIsWrong) {
  const auto mistake = [](std::string_view text) {
    const auto formula = formula_text(text, "t", si::s.dimension);
    return formula ? std::string() : formula.error().message;
  };
  EXPECT_NE(mistake("sin(t)").find("an angle is expected"), std::string::npos);
  EXPECT_NE(mistake("1 m + t").find("the left side is in m, the right one in s"), std::string::npos)
      << mistake("1 m + t");
  EXPECT_NE(mistake("2 * x").find("there is no 'x' here"), std::string::npos);
  EXPECT_NE(mistake("2 ^ t").find("a whole number"), std::string::npos);
  EXPECT_NE(mistake("2 t").find("'*' is missing"), std::string::npos) << mistake("2 t");
  EXPECT_NE(mistake("min(1, t / (1 s)").find("is not closed"), std::string::npos);
}

/// On paper, in kelvin: -20 degC is 253.15 K, and 5 degC more is 258.15 K.
// "2 * f" is twice the frequency, where cycles per time are asked for and where a speed of turning is.
TEST(Expression, AFrequencyKeepsWhatItCounts) {
  const auto meaning = [](std::string_view) -> tl::expected<Measure, std::string> {
    return measure_of(*parse_any_quantity("0.5 Hz"));
  };
  const auto in = [&](const char* text, const Unit& unit) {
    const auto value = evaluate(text, meaning);
    EXPECT_TRUE(value) << text << ": " << value.error().message;
    return *parse_quantity(to_text(*value), unit);
  };
  const Unit cycles = si::per_s.in("Hz");
  for (const char* text :
       {"2 * f", "1 Hz", "360 deg/s", "f / 0.5", "f + 180 deg/s", "max(f, 1 Hz)", "360 deg / 1 s", "-(-2) * f"}) {
    EXPECT_NEAR(in(text, cycles), 1, 1e-12) << text;
    EXPECT_NEAR(in(text, si::per_s), 2 * M_PI, 1e-12) << text;
  }
  EXPECT_NEAR(in("1 / (0.5 s)", cycles), 2, 1e-12) << "as 2 1/s is";
  EXPECT_NEAR(in("(3 m/s) / (1.5 m)", si::per_s), 2, 1e-12);
  EXPECT_NEAR(in("(3 m/s) / (1.5 m) * 1 rad + 360 deg/s", si::per_s), 2 + 2 * M_PI, 1e-12);
  EXPECT_NE(evaluate("f + 1 / (2 s)", meaning).error().message.find("write both in the same unit"), std::string::npos);
}

TEST(Expression, ATemperatureInDegreesCountsFromItsOwnZero) {
  const std::vector<std::pair<std::string, double>> temperatures = {
      {"winter + 5 K", 258.15},
      {"-20 degC", 253.15},
      {"-20 degC + 5 K", 258.15},
      {"winter - 5 K", 248.15},
      {"max(winter, 0 degC)", 273.15},
      {"20 degC + (winter - 0 degC) / 2", 283.15},
      {"(20 degC - winter) + winter", 293.15},
  };
  for (const auto& [text, expected] : temperatures) {
    const auto got = value_of(text);
    ASSERT_TRUE(got) << text << ": " << got.error().message;
    EXPECT_NEAR(got->value, expected, 1e-10) << text;
    EXPECT_EQ(got->kelvins, Kelvins::reading) << text;
    EXPECT_NEAR(measure_of(*parse_any_quantity(to_text(*got))).value, expected, 1e-10) << to_text(*got);
  }
  const std::vector<std::pair<std::string, double>> differences = {
      {"20 degC - winter", 40}, {"abs(winter - 20 degC) / 2", 20}, {"3 * (20 degC - winter) - (5 degC - 4 degC)", 119}};
  for (const auto& [text, expected] : differences) {
    const auto got = value_of(text);
    ASSERT_TRUE(got) << text << ": " << got.error().message;
    EXPECT_NEAR(got->value, expected, 1e-10) << text;
    EXPECT_EQ(got->kelvins, Kelvins::difference) << text;
  }
  const auto share = value_of("1 m * (20 degC - winter) / 160 K");
  ASSERT_TRUE(share) << share.error().message;
  EXPECT_NEAR(share->value, 0.25, 1e-12);
  EXPECT_EQ(value_of("253.15 K + 5 K")->kelvins, Kelvins::either);
}

TEST(Expression, RefusesWhatWouldDependOnTheZeroOfTheScale) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"winter + 5 degC", "'20 degC + 5 K'"}, {"5 K + winter", "stands first"},
      {"300 K - winter", "both in degC"},     {"2 * winter", "(30 degC - 10 degC) / 2"},
      {"winter / 2", "its own zero"},         {"-winter", "its own zero"},
      {"-(5 degC)", "its own zero"},          {"winter^2", "its own zero"},
      {"abs(winter)", "its own zero"},        {"min(winter, 250 K)", "the same unit"},
  };
  for (const auto& [text, message] : rows) {
    const auto got = value_of(text);
    ASSERT_FALSE(got) << text << " " << got->value;
    EXPECT_NE(got.error().message.find(message), std::string::npos) << text << ": " << got.error().message;
  }
  EXPECT_EQ(value_of("winter + 5 degC").error().offset, 7);
}

}  // namespace taut::expression_test
