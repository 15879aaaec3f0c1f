#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/motion/step/step.hpp"

/// The method by itself, on y' = a y, whose answer is known: its order, with steps of changing size too, and what it
/// leaves of what is far too fast for its steps.
namespace taut::solve::dynamics::transient_scheme_test {

/// y(1) from y(0) = 1; `change`: each other step is so many times the one before.
double at_one(Scheme s, double a, int steps, double change) {
  Mechanism m;
  m.size = 1;
  Work w = work_for(m);
  Values before, now;
  before.q = {1};
  before.nu = {a};
  before.rate = {a * a};
  w.q_mean = before.nu;
  w.nu_mean = before.rate;
  now = before;
  const double first = 2 / (steps * (1 + change));
  for (int i = 0; i < steps; ++i) {
    s.h = i % 2 == 0 ? first : change * first;
    s.reach = s.h * s.gamma * s.alpha_f / s.alpha_m;
    begin_step(m, s, before, w);
    now.q[0] = w.q_star[0] / (1 - s.reach * a);
    now.nu[0] = a * now.q[0];
    now.rate[0] = a * now.nu[0];
    EXPECT_NEAR(now.nu[0], w.nu_star[0] + s.reach * now.rate[0],
                1e-8 * (1 + a * a * s.h));  // the rates are integrated alike
    end_step(m, s, before, now, w);
    std::swap(before, now);
  }
  return before.q[0];
}

TEST(TransientScheme, ItsErrorFallsByTheSquareOfTheStep) {
  const double a = -2;
  for (const double rho : {0.0, 0.5, 0.9, 1.0}) {
    for (const double change : {1.0, 1.6}) {
      const double coarse = at_one(scheme_of(rho), a, 100, change) - std::exp(a);
      const double fine = at_one(scheme_of(rho), a, 200, change) - std::exp(a);
      EXPECT_NEAR(coarse / fine, 4, 0.1) << rho << " " << change;
    }
  }
  const double euler = at_one(scheme_of_euler(), a, 100, 1) - std::exp(a);
  EXPECT_NEAR(euler / (at_one(scheme_of_euler(), a, 200, 1) - std::exp(a)), 2, 0.05);
}

/// rho of it in each step; rho = 1 is the trapezoidal rule, which has nothing of its own.
TEST(TransientScheme, OfWhatIsTooFastAStepLeavesRho) {
  for (const double rho : {0.3, 0.9}) {
    const double more = std::abs(at_one(scheme_of(rho), -1e9, 42, 1)),
                 less = std::abs(at_one(scheme_of(rho), -1e9, 40, 1));
    EXPECT_NEAR(more / less, rho * rho, 0.06 * rho) << rho;
  }
  EXPECT_LT(std::abs(at_one(scheme_of_euler(), -1e9, 4, 1)), 1e-30);
  const double h = 0.1, a = -3;
  const double trapezoid = std::pow((1 + h * a / 2) / (1 - h * a / 2), 10);
  EXPECT_NEAR(at_one(scheme_of(1), a, 10, 1), trapezoid, 1e-12);
}

}  // namespace taut::solve::dynamics::transient_scheme_test
