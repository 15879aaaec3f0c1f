#include "taut/chance/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/chance/counter.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance::calibration_test {

/// Tension of a catenary at twelve places: T(x) = H cosh(w (x - 40 m)/H), places 0 to 110 m; x = {H, w}.
std::vector<double> tensions(const Point& x) {
  std::vector<double> t;
  t.reserve(12);
  for (int k = 0; k < 12; ++k) t.push_back(x[0] * std::cosh(x[1] * (10. * k - 40) / x[0]));
  return t;
}

Evaluate each(std::vector<double> (*f)(const Point&)) {
  return [f](std::span<const Point> points) {
    std::vector<std::vector<double>> rows;
    for (const Point& x : points) rows.push_back(f(x));
    return rows;
  };
}

const std::vector<FreeParameter> rope{{.name = "H", .low = 5e3, .high = 20e3}, {.name = "w", .low = 10, .high = 200}};
const Point truth{9e3, 80};

std::vector<double> noisy(std::uint64_t seed, double sd) {
  std::vector<double> t = tensions(truth);
  for (std::uint32_t k = 0; k < t.size(); ++k) {
    t[k] += sd * normal_score(unit(random_bits(seed, Use::points, 1, 0, k)));
  }
  return t;
}

TEST(Calibration, exact_measurements_give_the_truth) {
  const Calibration c = calibrate(each(tensions), rope, {.values = tensions(truth), .sd = {}});
  ASSERT_EQ(c.status, CalibrationStatus::found) << c.reason;
  EXPECT_NEAR(c.parameters[0].value, 9e3, 1e-3);
  EXPECT_NEAR(c.parameters[1].value, 80, 1e-5);
  EXPECT_TRUE(c.other_fits.empty());
  EXPECT_EQ(c.freedom, 10);
}

// 200 seeds of twelve noisy tensions, with the sd given and with the sd estimated: the truth lies within the 95 %
// interval of each parameter in 90 to 99 % of them; "not identifiable" and a bound would be a miss. The p-value is
// below 0.05 as often as it should be.
TEST(Calibration, intervals_hold_the_truth) {
  constexpr int seeds = 200;
  constexpr double sd = 150;
  for (const bool given : {true, false}) {
    int held[2] = {0, 0};
    int surprising = 0;
    double estimated = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Measured measured{.values = noisy(seed, sd), .sd = {}};
      if (given) measured.sd.assign(12, sd);
      const Calibration c = calibrate(each(tensions), rope, measured);
      ASSERT_EQ(c.status, CalibrationStatus::found) << c.reason;
      for (std::size_t i = 0; i < 2; ++i) {
        const CalibratedParameter& p = c.parameters[i];
        held[i] += p.state == ParameterState::estimated && p.interval.low <= truth[i] && truth[i] <= p.interval.high;
      }
      surprising += given && c.p_value < 0.05;
      EXPECT_EQ(std::isnan(c.p_value), !given);
      EXPECT_EQ(std::isnan(c.sd), given);
      if (!given) estimated += c.sd * c.sd / seeds;
    }
    for (const int count : held) {
      EXPECT_GE(count, 0.9 * seeds) << given;
      EXPECT_LE(count, 0.99 * seeds) << given;
    }
    if (given) {
      EXPECT_LE(surprising, 0.12 * seeds);
      EXPECT_GE(surprising, 1);
    } else {
      EXPECT_NEAR(std::sqrt(estimated) / sd, 1, 0.1);
    }
  }
}

// A line y = a + b x has a covariance in closed form.
TEST(Calibration, covariance_of_a_line) {
  const Evaluate line = [](std::span<const Point> points) {
    std::vector<std::vector<double>> rows;
    for (const Point& x : points) rows.push_back({x[0], x[0] + x[1], x[0] + 2 * x[1], x[0] + 3 * x[1]});
    return rows;
  };
  const std::vector<FreeParameter> free{{.name = "a", .low = -10, .high = 10}, {.name = "b", .low = -10, .high = 10}};
  const Calibration c = calibrate(line, free, {.values = {1.1, 2.9, 5.2, 6.8}, .sd = {0.5, 0.5, 0.5, 0.5}});
  // slope S_xy/S_xx = 9.7/5, mean 4 at x = 1.5
  EXPECT_NEAR(c.parameters[1].value, 1.94, 1e-6);
  EXPECT_NEAR(c.parameters[0].value, 4 - 1.5 * 1.94, 1e-6);
  EXPECT_NEAR(c.covariance[3], 0.25 / 5, 1e-9);
  EXPECT_NEAR(c.covariance[0], 0.25 * (0.25 + 2.25 / 5), 1e-9);
  EXPECT_NEAR(c.covariance[1], -0.25 * 1.5 / 5, 1e-9);
  EXPECT_NEAR(c.parameters[1].interval.high - 1.94, 1.959964 * std::sqrt(0.05), 1e-5);
  const Calibration d = calibrate(line, free, {.values = {1.1, 2.9, 5.2, 6.8}, .sd = {}});
  EXPECT_NEAR(d.sd * d.sd, d.chi_squared / 2, 1e-12);
  EXPECT_NEAR(d.parameters[1].interval.high - 1.94, 4.302653 * d.sd / std::sqrt(5.), 1e-5);
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(d.model[j] + d.residuals[j], (std::vector<double>{1.1, 2.9, 5.2, 6.8})[j], 1e-12);
  }
}

// Stiffness and length that act only as a quotient: the pair is named; the weight is identified.
TEST(Calibration, names_a_pair_that_cannot_be_told_apart) {
  const Evaluate model = each([](const Point& x) {
    return std::vector<double>{x[0] / x[1], x[0] / x[1] + x[2], x[0] / x[1] + 2 * x[2], 3 * x[0] / x[1] + x[2]};
  });
  const std::vector<FreeParameter> free{{.name = "stiffness", .low = 1, .high = 3},
                                        {.name = "length", .low = 1, .high = 2},
                                        {.name = "weight", .low = 0, .high = 5}};
  const Calibration c = calibrate(model, free, {.values = {1.31, 3.29, 5.31, 5.92}, .sd = {0.05, 0.05, 0.05, 0.05}});
  ASSERT_EQ(c.status, CalibrationStatus::found) << c.reason;
  ASSERT_EQ(c.inseparable.size(), 1u);
  EXPECT_EQ(c.inseparable[0].parameters, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(c.inseparable[0].correlation, 1);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(c.parameters[i].state, ParameterState::not_identifiable);
    EXPECT_EQ(c.parameters[i].interval.high, free[i].high);
    EXPECT_TRUE(std::isnan(c.covariance[i * 4]));
  }
  EXPECT_EQ(c.parameters[0].note,
            "the measurements cannot tell 'stiffness' from 'length': fix one of them, or measure something else");
  EXPECT_EQ(c.parameters[2].state, ParameterState::estimated);
  EXPECT_NEAR(c.parameters[2].value, 2, 0.05);
  EXPECT_EQ(c.freedom, 2);
  // with the stiffness given, both others are identified
  const Calibration fixed = calibrate(
      [&](std::span<const Point> points) {
        Points full;
        for (const Point& x : points) full.push_back({2, x[0], x[1]});
        return model(full);
      },
      {free[1], free[2]}, {.values = {1.31, 3.29, 5.31, 5.92}, .sd = {0.05, 0.05, 0.05, 0.05}});
  EXPECT_EQ(fixed.parameters[0].state, ParameterState::estimated);
  EXPECT_NEAR(fixed.parameters[1].standard_error / c.parameters[2].standard_error, 1, 1e-3);
}

// Told, but only just apart: a pair by the correlation of the estimates.
TEST(Calibration, names_a_pair_that_moves_as_one) {
  const Evaluate model = each([](const Point& x) {
    return std::vector<double>{x[0] + x[1], x[0] + 1.01 * x[1], x[0] + 0.99 * x[1]};
  });
  const std::vector<FreeParameter> free{{.name = "a", .low = 0, .high = 10}, {.name = "b", .low = 0, .high = 10}};
  const Calibration c = calibrate(model, free, {.values = {7, 7.03, 6.97}, .sd = {0.01, 0.01, 0.01}});
  ASSERT_EQ(c.inseparable.size(), 1u);
  EXPECT_LT(c.inseparable[0].correlation, -0.999);
  EXPECT_EQ(c.parameters[0].state, ParameterState::estimated);
  EXPECT_NEAR(c.parameters[0].value, 4, 1e-6);
  // a hundred times the noise: told no more than by the bounds
  const Calibration d = calibrate(model, free, {.values = {7, 7.03, 6.97}, .sd = {1, 1, 1}});
  EXPECT_EQ(d.parameters[0].state, ParameterState::not_identifiable);
  EXPECT_NE(d.parameters[0].note.find("from 'b'"), std::string::npos);
}

TEST(Calibration, bounds_and_idle_parameters_are_said) {
  const Evaluate model = each([](const Point& x) { return std::vector<double>{x[0], x[0], x[0] + 0 * x[1], x[2]}; });
  const std::vector<FreeParameter> free{{.name = "a", .low = 0, .high = 10, .start = 2},
                                        {.name = "b", .low = 0, .high = 1},
                                        {.name = "c", .low = 0, .high = 5}};
  const Calibration c = calibrate(model, free, {.values = {4, 4.1, 3.9, 7}, .sd = {0.1, 0.1, 0.1, 0.1}});
  EXPECT_NEAR(c.parameters[0].value, 4, 1e-6);
  EXPECT_EQ(c.parameters[1].note, "no measured quantity depends on 'b'");
  EXPECT_EQ(c.parameters[2].state, ParameterState::at_high);
  EXPECT_EQ(c.parameters[2].value, 5);
  EXPECT_NE(c.parameters[2].note.find("upper bound"), std::string::npos);
  EXPECT_LT(c.p_value, 1e-6);  // the bound does not let it fit
  EXPECT_EQ(c.freedom, 3);
  const Calibration exact = calibrate(each([](const Point& x) { return x; }), {free[0]}, {.values = {3}, .sd = {}});
  EXPECT_NEAR(exact.parameters[0].value, 3, 1e-6);
  EXPECT_TRUE(std::isnan(exact.parameters[0].standard_error));
  EXPECT_NE(exact.parameters[0].note, "");
}

// cos is even: two fits as good as each other, and both are shown.
TEST(Calibration, other_fits_are_shown) {
  const Calibration c =
      calibrate(each([](const Point& x) {
                  return std::vector<double>{std::cos(x[0]), 0.5};
                }),
                {{.name = "angle", .low = -1, .high = 1.2}}, {.values = {std::cos(0.6), 0.5}, .sd = {0.01, 0.01}});
  ASSERT_EQ(c.status, CalibrationStatus::found);
  ASSERT_EQ(c.other_fits.size(), 1u);
  EXPECT_NEAR(c.other_fits[0][0], -c.parameters[0].value, 1e-4);
}

// Where the machine has no equilibrium no step is taken; nowhere an equilibrium: no calibration.
TEST(Calibration, failed_cases) {
  const auto holed = [](const Point& x) {
    std::vector<double> t = tensions(x);
    if (x[0] > 13e3 || x[1] > 150) t[3] = std::nan("");
    return t;
  };
  const Calibration c = calibrate(each(holed), rope, {.values = noisy(3, 10), .sd = {}});
  ASSERT_EQ(c.status, CalibrationStatus::found) << c.reason;
  EXPECT_NEAR(c.parameters[0].value, 9e3, 30);
  const Calibration none = calibrate(each([](const Point&) { return std::vector<double>(12, std::nan("")); }), rope,
                                     {.values = noisy(3, 10), .sd = {}});
  EXPECT_EQ(none.status, CalibrationStatus::not_converged);
  EXPECT_EQ(none.reason, "the calibration has not converged from any start: the case at the start failed");
  EXPECT_TRUE(none.parameters.empty());
}

TEST(Calibration, mistakes_are_named) {
  EXPECT_EQ(mistake(rope, {{1, 2}, {0.1}}), "1 standard deviations for 2 measurements: give one for each, or none");
  EXPECT_EQ(mistake(rope, {{1, 2}, {0.1, 0}}), "the standard deviation of measurement 2 must be above 0");
  EXPECT_EQ(mistake({{.name = "a", .low = 2, .high = 1}}, {{1}, {}}),
            "'a': the lower bound (2) must be below the upper one (1)");
  EXPECT_NE(mistake({}, {{1}, {}}), "");
  EXPECT_NE(mistake(rope, {}), "");
  EXPECT_EQ(mistake(rope, {{1}, {}}), "");
}

}  // namespace taut::chance::calibration_test
