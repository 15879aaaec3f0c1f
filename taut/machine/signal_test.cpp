#include "taut/machine/signal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/base/array.hpp"
#include "taut/units/expression.hpp"
#include "taut/units/jet.hpp"

namespace taut::machine::signal_test {

Signal ramp(double from, double to, double start, double duration, bool smooth = false) {
  return {
      .name = "r",
      .unit = si::m_per_s,
      .law = Moves{
          .from = from,
          .moves = {{.at = start, .to = to, .over = duration, .change = smooth ? Change::smooth : Change::linear}}}};
}

/// Derivatives against central differences, away from breakpoints.
void expect_derivatives(const Signal& signal, double t) {
  const double h = 1e-4;
  const SignalValue before = at(signal, t - h), now = at(signal, t), after = at(signal, t + h);
  EXPECT_NEAR(now.rate, (after.value - before.value) / (2 * h), 1e-5 * (1 + std::abs(now.rate))) << t;
  EXPECT_NEAR(now.acceleration, (after.rate - before.rate) / (2 * h), 1e-5 * (1 + std::abs(now.acceleration))) << t;
}

TEST(Signal, ARampIsHeldBeforeAndAfter) {
  const Signal r = ramp(1, 3, 2, 4);
  EXPECT_EQ(at(r, 0).value, 1);
  EXPECT_EQ(at(r, 4).value, 2);
  EXPECT_EQ(at(r, 4).rate, 0.5);
  EXPECT_EQ(at(r, 6).value, 3);
  EXPECT_EQ(at(r, 6).rate, 0);
  EXPECT_EQ(at(r, 2).rate, 0.5) << "after the jump of the rate";
  EXPECT_EQ(breakpoints(r), (std::vector<double>{2, 6}));
}

TEST(Signal, RopeTakenInByARampIsThatOfTheTackle) {
  // s(t) = 0.5 t^2 to 0.5 s, then 0.5 m/s
  const Signal r = ramp(0, 0.5, 0, 0.5);
  EXPECT_NEAR(integral(r, 0, 0.3), 0.5 * 0.09, 1e-16);
  EXPECT_NEAR(integral(r, 0, 3), 0.125 + 2.5 * 0.5, 1e-15);
  EXPECT_NEAR(integral(r, 0.2, 0.4), 0.5 * (0.16 - 0.04), 1e-16);
}

TEST(Signal, AJumpIsTheNewValueAtOnce) {
  const Signal jump = ramp(1, 2, 1, 0);
  EXPECT_EQ(at(jump, 0.999999).value, 1);
  EXPECT_EQ(at(jump, 1).value, 2);
  EXPECT_EQ(breakpoints(jump), (std::vector<double>{1}));
  EXPECT_EQ(integral(jump, 0, 2), 3);
}

TEST(Signal, AHalfCosineHasItsLawItsRatesAndItsIntegral) {
  Signal r = ramp(2, -1, 1, 2);
  std::get<Moves>(r.law).moves[0].change = Change::half_cosine;
  EXPECT_NEAR(at(r, 1.5).value, 2 - 3 * (1 - std::sqrt(0.5)) / 2, 1e-15);
  EXPECT_EQ(at(r, 1).rate, 0);
  EXPECT_NEAR(at(r, 2).rate, -3 * M_PI / 4, 1e-15);
  for (const double t : {1.2, 1.9, 2.7}) expect_derivatives(r, t);
  EXPECT_NEAR(integral(r, 0, 4), 2 + 1 - 1, 1e-14);
  // of cos(pi s) over a part: 2 (1 - sin(pi/4))/pi less
  EXPECT_NEAR(integral(r, 1, 1.5), 0.5 * 0.5 + 1.5 * 2 / M_PI * std::sin(M_PI / 4), 1e-14);
}

TEST(Signal, ASmoothRampBeginsAndEndsAtRest) {
  const Signal r = ramp(2, -1, 1, 2, true);
  for (const double t : {1.0, 3.0 - 1e-12}) {
    EXPECT_NEAR(at(r, t).rate, 0, 1e-10);
    EXPECT_NEAR(at(r, t).acceleration, 0, 1e-10);
  }
  for (const double t : {1.1, 1.5, 2.0, 2.7}) expect_derivatives(r, t);
  EXPECT_NEAR(at(r, 2).value, 0.5, 1e-15);
  EXPECT_NEAR(integral(r, 0, 4), 2 + 2 * 0.5 - 1, 1e-14);
}

TEST(Signal, MovesFollowEachOther) {
  const Signal s{.name = "s",
                 .unit = si::m,
                 .law = Moves{.from = 0,
                              .moves = {{.at = 1, .to = 2, .over = 1, .change = Change::linear},
                                        {.at = 2, .to = 5, .over = 2, .change = Change::smooth},
                                        {.at = 6, .to = 0, .over = 0, .change = Change::linear}}}};
  EXPECT_EQ(at(s, 0.5).value, 0);
  EXPECT_EQ(at(s, 1.5).value, 1);
  EXPECT_EQ(at(s, 3).value, 3.5);
  EXPECT_EQ(at(s, 5).value, 5);
  EXPECT_EQ(at(s, 6).value, 0);
  EXPECT_EQ(breakpoints(s), (std::vector<double>{1, 2, 4, 6}));
}

TEST(Signal, ASineAndItsIntegral) {
  const Signal s{.name = "s", .unit = si::N, .law = Sine{.mean = 3, .amplitude = 2, .omega = 5, .phase = 0.4}};
  for (const double t : {0.0, 0.3, 2.0}) expect_derivatives(s, t);
  const double exact = 3 * 1.7 - 2.0 / 5 * (std::cos(5 * 1.9 + 0.4) - std::cos(5 * 0.2 + 0.4));
  EXPECT_NEAR(integral(s, 0.2, 1.9), exact, 1e-14);
  const Signal still{.name = "s", .unit = si::N, .law = Sine{.mean = 3, .amplitude = 2, .omega = 0, .phase = M_PI / 2}};
  EXPECT_NEAR(integral(still, 0, 2), 10, 1e-14);
}

TEST(Signal, ATableIsLinearAndHeldOutside) {
  const Signal s{.name = "s", .unit = si::m, .law = Curve{.t = {1, 2, 4}, .value = {5, 7, 3}, .slopes = {}}};
  EXPECT_EQ(at(s, 0).value, 5);
  EXPECT_EQ(at(s, 1.5).value, 6);
  EXPECT_EQ(at(s, 3).value, 5);
  EXPECT_EQ(at(s, 3).rate, -2);
  EXPECT_EQ(at(s, 9).value, 3);
  EXPECT_EQ(integral(s, 0, 5), 5 + 6 + 10 + 3);
}

TEST(Signal, TheRangeIsThatOfItsBreakpoints) {
  const auto most = [](const auto& law) { return range_of(Signal{.name = "s", .unit = si::N_m, .law = law})->most; };
  EXPECT_EQ(most(-3.0), -3);
  EXPECT_EQ(most(Moves{.from = 1, .moves = {{.at = 2, .to = 7, .over = 1}, {.at = 5, .to = -9, .over = 0}}}), 7);
  const Signal table{.name = "s", .unit = si::N_m, .law = Curve{.t = {0, 1, 2}, .value = {2, -8, 4}, .slopes = {}}};
  EXPECT_EQ(range_of(table)->least, -8);
  EXPECT_EQ(range_of(table)->most, 4);
  EXPECT_EQ(range_of(table)->kept, 4);
  const auto kept = [](double from, const Array<Move>& moves) {
    return range_of(Signal{.name = "s", .unit = si::N_m, .law = Moves{.from = from, .moves = moves}})->kept;
  };
  EXPECT_EQ(kept(0, {{.at = 1, .to = -3, .over = 2}}), 3);
  EXPECT_EQ(kept(3, {{.at = 1, .to = 1, .over = 2}}), 1);
  EXPECT_EQ(kept(0, {{.at = 1, .to = 5, .over = 2}, {.at = 4, .to = 2, .over = 0}, {.at = 6, .to = 4, .over = 1}}), 2);
  EXPECT_FALSE(range_of(Signal{.name = "s", .unit = si::N_m, .law = Sine{.mean = 1, .amplitude = 2, .omega = 3}}));
  EXPECT_FALSE(range_of(Signal{.name = "s", .unit = si::N_m, .law = std::nan("")}));
}

TEST(Signal, ACubicTableHasContinuousAcceleration) {
  const Signal s{.name = "s", .unit = si::rad, .law = smooth_curve({0, 1, 2.5, 3, 5}, {0, 1, -1, 0.5, 2})};
  const auto& curve = std::get<Curve>(s.law);
  for (std::size_t i = 0; i < curve.t.size(); ++i) EXPECT_NEAR(at(s, curve.t[i]).value, curve.value[i], 1e-14);
  for (const double t : {1.0, 2.5, 3.0}) {
    EXPECT_NEAR(at(s, t - 1e-9).acceleration, at(s, t + 1e-9).acceleration, 1e-6);
    EXPECT_NEAR(at(s, t - 1e-9).rate, at(s, t + 1e-9).rate, 1e-6);
  }
  EXPECT_NEAR(at(s, 0).rate, 0, 1e-14);
  EXPECT_NEAR(at(s, 5 - 1e-12).rate, 0, 1e-9);
  for (const double t : {0.5, 1.7, 2.8, 4.1}) expect_derivatives(s, t);
}

RC_GTEST_PROP(Signal, TheIntegralIsAdditiveAndItsDerivativeTheValue, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  Moves moves{.from = number(), .moves = {}};
  double t = 0;
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
    t += *rc::gen::inRange(0, 200) / 100.0;
    const double over = *rc::gen::inRange(0, 200) / 100.0;
    moves.moves.push_back({t, number(), over, *rc::gen::element(Change::linear, Change::smooth, Change::half_cosine)});
    t += over;
  }
  const Signal s{.name = "s", .unit = si::m, .law = moves};
  const double middle = t * *rc::gen::inRange(0, 100) / 100.0;
  RC_ASSERT(std::abs(integral(s, 0, middle) + integral(s, middle, t + 1) - integral(s, 0, t + 1)) < 1e-11);
  const std::vector<double> breaks = breakpoints(s);
  RC_ASSERT(std::is_sorted(breaks.begin(), breaks.end()));
}

Signal of_formula(const char* text) {
  return {.name = "f",
          .unit = si::m_per_s,
          .law = std::make_shared<const FormulaText>(formula_text(text, "t", si::s.dimension).value())};
}

TEST(Signal, AFormulaIsTheSineThatItSays) {
  const Signal f = of_formula("1 m/s + 0.5 m/s * sin(2 rad/s * t + 20 deg)");
  const Signal sine = {
      .name = "s", .unit = si::m_per_s, .law = Sine{.mean = 1, .amplitude = 0.5, .omega = 2, .phase = M_PI / 9}};
  for (const double t : {0.0, 0.7, 3.1}) {
    EXPECT_NEAR(at(f, t).value, at(sine, t).value, 1e-14);
    EXPECT_NEAR(at(f, t).rate, at(sine, t).rate, 1e-14);
    EXPECT_NEAR(at(f, t).acceleration, at(sine, t).acceleration, 1e-14);
    EXPECT_NEAR(integral(f, t, t + 7.3), integral(sine, t, t + 7.3), 1e-11);
  }
  EXPECT_TRUE(breakpoints(f).empty());
}

/// Over kinks too: a triangle of 2 s, and what is left of a sine above zero.
TEST(Signal, TheIntegralOfAFormulaPassesItsKinks) {
  EXPECT_NEAR(integral(of_formula("max(0 m/s, 1 m/s - 1 m/s^2 * abs(t - 1.23 s))"), 0, 5), 1, 1e-11);
  EXPECT_NEAR(integral(of_formula("1 m/s * max(0, sin(1 rad/s * t))"), 0, 2 * M_PI), 2, 1e-11);
}

TEST(Signal, AFormulaTellsItsKinksAndExtremes) {
  const auto by = [](const char* text) {
    Signal s;
    s.law = std::make_shared<const FormulaText>(*formula_text(text, "t", si::s.dimension));
    return s;
  };
  const Signal pulse = by("2 m/s * max(0, 1 - abs(t - 50.025 s)/(0.02 s))");
  const Array<double> kinks = breakpoints(pulse, 0, 100);
  ASSERT_EQ(kinks.size(), 3U);
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_NEAR(kinks[i], 50.005 + 0.02 * static_cast<double>(i), 1e-11);
  EXPECT_TRUE(breakpoints(pulse).empty());
  EXPECT_TRUE(extremes(pulse, 0, 100).empty());
  EXPECT_TRUE(breakpoints(pulse, 51, 100).empty());
  EXPECT_NEAR(integral(pulse, 0, 100), 2 * 0.02, 1e-12);  // the area of the triangle
  const Signal peak = by("1 N/(1 + ((t - 70.3 s)/(1 ms))^2)");
  ASSERT_EQ(extremes(peak, 0, 100).size(), 1U);
  EXPECT_NEAR(extremes(peak, 0, 100)[0], 70.3, 2e-9);
  EXPECT_NEAR(integral(peak, 0, 100), 1e-3 * (std::atan(29.7e3) + std::atan(70.3e3)), 1e-10);
}

TEST(Signal, ASineTellsItsExtremes) {
  const Signal s = {.name = "s", .unit = si::N, .law = Sine{.mean = 3, .amplitude = 2, .omega = 1.7, .phase = 0.4}};
  const Array<double> found = extremes(s, 0, 10);
  ASSERT_EQ(found.size(), 6U);
  for (const double t : found) EXPECT_NEAR(at(s, t).rate, 0, 1e-13);
  EXPECT_EQ(extremes(s, found[1], found[3]), (Array<double>{found[2]})) << "the same from any start";
  EXPECT_TRUE(extremes({.name = "s", .unit = si::N, .law = Sine{.mean = 3}}, 0, 10).empty());
}

TEST(Signal, ASineOfVeryManySwingsTellsSomeOfItsHighestAndLowestValues) {
  const Signal s = {.name = "s", .unit = si::N, .law = Sine{.amplitude = 1, .omega = 2 * M_PI * 50}};
  const Array<double> found = extremes(s, 0, 1e7);
  ASSERT_GT(found.size(), 5e4);
  ASSERT_LE(found.size(), 1e5 + 1);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(at(s, found[i]).value, i % 2 == 0 ? 1 : -1, 1e-6);
}

TEST(Signal, ASmoothTableTellsItsExtremesBetweenItsPoints) {
  const Signal s = {.name = "s", .unit = si::N, .law = smooth_curve({0, 2, 22, 24}, {10, 14, 14, 10})};
  const Array<double> found = extremes(s, 0, 100);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], 12, 1e-12);
  EXPECT_GT(at(s, 12).value, 25);
  EXPECT_EQ(range_of(s)->most, at(s, found[0]).value);
  EXPECT_EQ(range_of(s)->kept, 10);
  EXPECT_TRUE(extremes(s, 13, 100).empty());
}

}  // namespace taut::machine::signal_test
