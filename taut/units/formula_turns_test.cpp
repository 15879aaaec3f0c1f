#include "taut/units/formula_turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "taut/units/jet.hpp"
#include "taut/units/unit.hpp"

/// Kinks and extremes of formulas, however narrow.
namespace taut::formula_turns_test {
namespace {

Array<Turn> turns_of(const char* text, double from, double to) {
  const auto formula = formula_text(text, "t", si::s.dimension);
  EXPECT_TRUE(formula) << text;
  return formula ? turns(*formula, from, to) : Array<Turn>{};
}

/// Kinks and extremes as numbers: kinks first, then extremes.
void expect_turns(const char* text, double from, double to, const std::vector<double>& kinks,
                  const std::vector<double>& extremes) {
  std::vector<double> is_kinks, is_extremes;
  for (const Turn& turn : turns_of(text, from, to)) (turn.kink ? is_kinks : is_extremes).push_back(turn.at);
  ASSERT_EQ(is_kinks.size(), kinks.size()) << text;
  ASSERT_EQ(is_extremes.size(), extremes.size()) << text;
  for (std::size_t i = 0; i < kinks.size(); ++i) EXPECT_NEAR(is_kinks[i], kinks[i], 1e-13 * (1 + kinks[i])) << text;
  for (std::size_t i = 0; i < extremes.size(); ++i) EXPECT_NEAR(is_extremes[i], extremes[i], 2e-9) << text;
}

TEST(FormulaTurns, FindAPulseHoweverNarrow) {
  expect_turns("max(0, 1 - abs(t - 50.025 s)/(0.02 s))", 0, 100, {50.005, 50.025, 50.045}, {});
  expect_turns("max(0, 1 - abs(t - 50.025 s)/(2e-6 s))", 0, 100, {50.024998, 50.025, 50.025002}, {});
  expect_turns("1/(1 + ((t - 777.7 s)/(0.01 s))^2)^2", 0, 1000, {}, {777.7});
  expect_turns("1/(1 + (abs(t - 31 s)/(1e-5 s))^6)", 0, 60, {31}, {});
}

TEST(FormulaTurns, AreThoseOfEveryOperation) {
  const double pi = std::numbers::pi;
  expect_turns("sin(1 rad/s * t)", 0, 10, {}, {pi / 2, 3 * pi / 2, 5 * pi / 2});
  expect_turns("cos(1 rad/s * t)", 1, 10, {}, {pi, 2 * pi, 3 * pi});
  expect_turns("min(t, 3 s)", 0, 10, {3}, {});
  expect_turns("max(t, 3 s) + min(t, 7 s)", 0, 10, {3, 7}, {});
  expect_turns("1/(t - 4 s)", 0, 10, {4}, {});
  expect_turns("(t - 4 s)^-2", 0, 10, {4}, {});
  expect_turns("sqrt(max(0, t/(1 s) - 2))", 0, 10, {2}, {});
  expect_turns("abs(t - 5 s)/(t - 5 s)", 0, 10, {5}, {});
  expect_turns("(1 + (3 s - 2 * t)/abs(3 s - 2 * t))/2", 0, 10, {1.5}, {});
  expect_turns("tan(1 rad/s * t)", 0, 4, {pi / 2}, {});
  expect_turns("atan((t - 2 s)/(1 s))^2", 0, 4, {}, {2});
  expect_turns("atan2(t - 1 s, -1 s)", 0, 4, {1}, {});
  expect_turns("(t - 2 s)^2 * (t - 3 s)", 0, 4, {}, {2, 8.0 / 3});
  expect_turns("asin(min(1, t/(3 s)))", 0, 4, {3}, {});
  expect_turns("2 * t + 3 s", -4, 4, {}, {});
}

/// A minimum or maximum hides what it leaves out.
TEST(FormulaTurns, LeaveOutWhatDoesNotCount) { expect_turns("max(5 s, abs(t - 3 s))", 0, 7, {}, {}); }

TEST(FormulaTurns, AreInTheSamePlacesInEveryInterval) {
  const char* text = "0.3 * sin(2.7 rad/s * t) + max(0, sin(1.1 rad/s * t))";
  const Array<Turn> whole = turns_of(text, 0, 40), rest = turns_of(text, 13.37, 40);
  ASSERT_GT(rest.size(), 20U);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Turn &a = whole[whole.size() - rest.size() + i], &b = rest[i];
    EXPECT_EQ(a.at, b.at);
    EXPECT_EQ(a.kink, b.kink);
  }
}

/// Between two turns a formula goes one way: seen on a fine grid.
TEST(FormulaTurns, NothingTurnsBetweenThem) {
  for (const char* text : {"sin(3 rad/s * t) * cos(1.7 rad/s * t)", "abs(sin(2 rad/s * t)) - 0.2 * t/(1 s)",
                           "min(sin(2 rad/s * t), 0.5) + max(cos(3 rad/s * t), -0.2)"}) {
    const auto formula = formula_text(text, "t", si::s.dimension);
    double last = 0;
    for (const Turn& turn : turns(*formula, 0, 10)) {
      const int steps = 200;
      const double h = (turn.at - last) / steps;
      const double whole = jet_at(*formula, turn.at).value - jet_at(*formula, last).value;
      for (int i = 0; i < steps; ++i) {
        const double change = jet_at(*formula, last + (i + 1) * h).value - jet_at(*formula, last + i * h).value;
        EXPECT_GE(change * (whole < 0 ? -1 : 1), -1e-9) << text << " at " << last + i * h;
      }
      last = turn.at;
    }
    EXPECT_GT(last, 9) << text;
  }
}

/// What bounds never resolve ends in parts: none of them is long.
TEST(FormulaTurns, EndWithShortPartsWhereBoundsTellNothing) {
  const Array<Turn> all = turns_of("sin(1 rad/s * t)^2 + cos(1 rad/s * t)^2", 0, 10);
  ASSERT_GT(all.size(), 10000U);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i].at - all[i - 1].at, 1e-3);
}

}  // namespace
}  // namespace taut::formula_turns_test
