#include "taut/rope/guy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/rope/parabola.hpp"
#include "taut/rope/span.hpp"

namespace taut::rope::guy_test {

constexpr double pi = std::numbers::pi;

struct Exact {
  GuyLine guy;
  Span span;
};

/// A guy from its anchor to the mast whose mean tension is near T.
Exact exact_guy(double slope, double T) {
  const double EA = 2.5e7, w = 20, c = 40;
  const Vector3 chord(c * std::cos(slope), 0, c * std::sin(slope));
  const double across = w * c * std::cos(slope);
  const double L = c / (1 + T / EA - across * across / (24 * T * T));
  const Span span = *solve_span({.length = L, .weight = w, .stiffness = EA}, chord);
  const double mean = std::hypot(span.force.H, span.force.V);
  return {.guy = {.length = c, .slope = slope, .weight = w, .stiffness = EA, .tension = mean}, .span = span};
}

// Witness: the tangent stiffness of the exact catenary. The estimate takes the chord for the unstretched length (an
// error of the strain T/EA) and forgets that the chord's ends differ in tension (of the order of the sag over the
// chord).
TEST(Guy, HorizontalStiffnessIsNearTheCatenarys) {
  for (const double slope : {0.3, 0.7, 1.1}) {
    for (const double T : {5e3, 1e4, 5e4, 2e5}) {
      const Exact e = exact_guy(slope, T);
      const Matrix3 K = stiffness(e.span);
      const GuyStiffness k = horizontal_stiffness(e.guy);
      const double sag = e.guy.weight * 40 * std::cos(slope) / (8 * e.guy.tension);
      EXPECT_NEAR(k.in_plane / K(0, 0), 1, 1.1 * T / 2.5e7 + 1e-5 + 6 * sag * std::sin(slope) + 20 * sag * sag)
          << slope << ' ' << T;
      const double along = e.guy.weight * 40 * std::sin(slope) / e.guy.tension;
      EXPECT_NEAR(k.across / K(1, 1), 1, 1.1 * T / 2.5e7 + 1e-5 + 4 * sag * sag + along * along / 10)
          << slope << ' ' << T;
    }
  }
}

TEST(Guy, ErnstIsTheDerivativeOfTheTautCubic) {
  const GuyLine guy{.length = 40, .slope = 0.7, .weight = 20, .stiffness = 2.5e7, .tension = 0};
  const Parabola p{.span = 40 * std::cos(0.7), .rise = 40 * std::sin(0.7), .weight = 20};
  for (const double L : {39.95, 40.0, 40.02}) {
    const double T = taut_tension(p, L, guy.stiffness);
    GuyLine at = guy;
    at.tension = T;
    // T(c) at constant L and constant weight across the chord: dT/dc = E_eq A/L
    const auto stretched = [&](double c) {
      return taut_tension({.span = c * std::cos(0.7), .rise = c * std::sin(0.7), .weight = 20}, L, guy.stiffness);
    };
    const double slope = (stretched(40 + 1e-5) - stretched(40 - 1e-5)) / 2e-5;
    EXPECT_NEAR(ernst_stiffness(at) / L / slope, 1, 3e-3) << L;
  }
}

TEST(Guy, ErnstHasItsLimits) {
  EXPECT_EQ(ernst_stiffness({40, 0.7, 0, 2.5e7, 1e4}), 2.5e7);
  EXPECT_NEAR(ernst_stiffness({40, pi / 2, 20, 2.5e7, 1e4}), 2.5e7, 1e-3);  // upright: no sag
  const GuyLine guy{.length = 40, .slope = 0.7, .weight = 20, .stiffness = 2.5e7, .tension = 1e4};
  EXPECT_NEAR(ernst_secant_stiffness(guy, 1e4, 1e4), ernst_stiffness(guy), 1e-6);
  // the secant is the mean of the compliance between the tensions: integral of dT/(E_eq A)
  const double T_1 = 6e3, T_2 = 3e4;
  double strain = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    GuyLine at = guy;
    at.tension = T_1 + (T_2 - T_1) * (i + 0.5) / n;
    strain += (T_2 - T_1) / n / ernst_stiffness(at);
  }
  EXPECT_NEAR((T_2 - T_1) / strain / ernst_secant_stiffness(guy, T_1, T_2), 1, 1e-7);
}

TEST(Guy, ThreeEqualGuysAreAlikeInEveryDirection) {
  const GuyStiffness k =
      horizontal_stiffness({.length = 40, .slope = 0.7, .weight = 20, .stiffness = 2.5e7, .tension = 1e4});
  RingStiffness ring;
  for (int i = 0; i < 3; ++i) ring = ring + in_ring(k, 0.4 + i * 2 * pi / 3);
  EXPECT_NEAR(ring.xx, 1.5 * (k.in_plane + k.across), 1e-6);
  EXPECT_NEAR(ring.yy, ring.xx, 1e-6);
  EXPECT_NEAR(ring.xy, 0, 1e-6);
  const GuyPull pull = pull_on_mast({.length = 40, .slope = pi / 6, .weight = 20, .stiffness = 2.5e7, .tension = 1e4});
  EXPECT_NEAR(pull.downwards, 5e3, 1e-9);
  EXPECT_NEAR(pull.horizontal, 1e4 * std::sqrt(0.75), 1e-9);
}

TEST(Guy, RefusesASlackOne) { EXPECT_THROW(ernst_stiffness({40, 0.7, 20, 2.5e7, 0}), ContractViolation); }

}  // namespace taut::rope::guy_test
