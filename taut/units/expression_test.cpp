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

FormulaText of_time(std::string_view text) {
  auto formula = formula_text(text, "t", si::s.dimension);
  EXPECT_TRUE(formula) << text << ": " << formula.error().message;
  return formula ? *formula : FormulaText{};
}

TEST(FormulaText, HasTheValueOfItsTextAndItsDerivatives) {
  const std::vector<std::string> texts = {
      "0.5 m/s * sin(90 deg/s * t)",
      "3 m - 2 m/s * t + 0.5 m/s^2 * t^2",
      "-(1 m) / (1 + (t / (2 s))^2)",
      "10 kN * sqrt(1 + t / (3 s))",
      "2 * cos(1 rad/s * t)^3 - tan(0.2 rad/s * t)",
      "asin(t / (9 s)) + acos(t / (8 s)) - atan(t / (1 s))",
      "atan2(1 m + 2 m/s * t, 4 m - 1 m/s * t)",
      "max(1 m, 0.1 m/s * t^2 / (1 s)) + min(9 kg, 2 kg) / 1 kg * abs(t - 1 s) * 1 m/s",
      "pi * 7 m / 2",
  };
  for (const std::string& text : texts) {
    const FormulaText formula = of_time(text);
    ASSERT_FALSE(formula.operations.empty());
    for (const double t : {0.3, 1.7, 2.9}) {
      const auto by_text = evaluate(text, [&](std::string_view) -> tl::expected<Measure, std::string> {
        return Measure{.value = t, .dimension = si::s.dimension, .is_angle = false};
      });
      const double h = 1e-4;
      const Jet before = jet_at(formula, t - h), now = jet_at(formula, t), after = jet_at(formula, t + h);
      if (text.find("* t") == std::string::npos) {  // there `evaluate` reads tonnes
        ASSERT_TRUE(by_text) << text << by_text.error().message;
        EXPECT_NEAR(now.value, by_text->value, 1e-14 * std::abs(by_text->value)) << text;
        EXPECT_EQ(formula.is.dimension, by_text->dimension);
        EXPECT_EQ(formula.is.is_angle, by_text->is_angle);
      }
      EXPECT_NEAR(now.first, (after.value - before.value) / (2 * h), 1e-6 * (1 + std::abs(now.first))) << text << t;
      EXPECT_NEAR(now.second, (after.first - before.first) / (2 * h), 1e-6 * (1 + std::abs(now.second))) << text << t;
    }
  }
}

TEST(FormulaText, KnowsItsVariableBehindUnits) {
  EXPECT_NEAR(jet_at(of_time("0.5 m/s * sin(90 deg/s * t)"), 1).value, 0.5, 1e-15);
  EXPECT_NEAR(jet_at(of_time("2 kN / 4 s * t"), 3).value, 1500, 1e-9);
  EXPECT_NEAR(jet_at(of_time("t / 4 s * 8"), 3).value, 6, 1e-12);
}

TEST(FormulaText, TakesAPlainNumberOfTheVariableForAnAngle) {
  EXPECT_NEAR(jet_at(of_time("sin(2 * pi * t / 4 s)"), 1).value, 1, 1e-15);
  EXPECT_NEAR(jet_at(of_time("0.5 m/s * min(2, cos(0.1 1/s * t))"), 0).value, 0.5, 1e-15);
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
  EXPECT_TRUE(std::isinf(jet_at(of_time("1 s / t"), 0).value));
}

}  // namespace taut::expression_test
