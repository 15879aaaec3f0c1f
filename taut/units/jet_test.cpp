#include "taut/units/jet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "taut/units/unit.hpp"

/// Texts as functions of one variable, with their derivatives.
namespace taut::jet_test {

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

TEST(FormulaText, IsNotFiniteWhereItHasNoValue) { EXPECT_TRUE(std::isinf(jet_at(of_time("1 s / t"), 0).value)); }

}  // namespace taut::jet_test
