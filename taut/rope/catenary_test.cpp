#include "taut/rope/catenary.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "taut/base/expects.hpp"
#include "taut/rope/exact_end.hpp"

namespace taut::rope::catenary_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

double V_at(const CatenaryRope& rope, const CatenaryForce& f, double s) {
  return f.V + rope.weight * (s - rope.length / 2);
}

double integral(double length, const auto& f) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, 0.0, length, 15, 1e-14);
}

struct Case {
  CatenaryRope rope;
  double x, z;
};

// The range in which a line is laid: slope to 63 degrees, length 0.98 to 1.5 of the chord, EA 1e6 to 1e9 N, 1 to 200
// N/m.
Case random_case(std::mt19937_64& source) {
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  const double chord = in(10, 1000);
  const double slope = in(-1.1, 1.1);
  return {.rope = {.length = chord * in(0.98, 1.5), .weight = in(1, 200), .stiffness = std::pow(10, in(6, 9))},
          .x = chord * std::cos(slope),
          .z = chord * std::sin(slope)};
}

rc::Gen<Case> any_case() {
  return rc::gen::map(rc::gen::arbitrary<unsigned>(), [](unsigned seed) {
    std::mt19937_64 source(seed);
    return random_case(source);
  });
}

double distance(const CatenaryForce& a, const CatenaryForce& b) { return std::hypot(a.H - b.H, a.V - b.V); }

double size(const CatenaryForce& a) { return std::hypot(a.H, a.V); }

TEST(Catenary, GivesTheSpanOfTheSpecification) {
  const CatenaryRope rope{.length = 100, .weight = 9.81, .stiffness = 1e7};
  const auto s = solve_catenary(rope, 80, 0);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->force.H, 331.73013818, 1e-8);
  EXPECT_NEAR(std::hypot(s->force.H, V_at(rope, s->force, 100)), 592.144521698, 1e-8);
  EXPECT_EQ(s->force.V, 0);
}

TEST(Catenary, ClosesThreeThousandSpans) {
  std::mt19937_64 source(1);
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(source);
    const auto s = solve_catenary(c.rope, c.x, c.z);
    ASSERT_TRUE(s) << i;
    const EndPosition p = end_position(c.rope, s->force);
    EXPECT_LT(std::hypot(p.x - c.x, p.z - c.z), 1e-9 * std::hypot(c.x, c.z)) << i;
    EXPECT_LT(s->closure, 1e-14 * std::hypot(c.x, c.z)) << i;
    EXPECT_LE(s->iterations, 12) << i;
  }
}

TEST(Catenary, TakesItsEndsInAnyOrderAndAnyUnits) {
  std::mt19937_64 source(2);
  const double foot = 0.3048, pound = 4.4482216152605;
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(source);
    const auto s = solve_catenary(c.rope, c.x, c.z);
    const auto swapped = solve_catenary(c.rope, c.x, -c.z);
    ASSERT_TRUE(s && swapped) << i;
    EXPECT_EQ(s->force.H, swapped->force.H) << i;
    EXPECT_EQ(s->force.V, -swapped->force.V) << i;
    const auto imperial = solve_catenary(
        {.length = c.rope.length / foot, .weight = c.rope.weight * foot / pound, .stiffness = c.rope.stiffness / pound},
        c.x / foot, c.z / foot);
    ASSERT_TRUE(imperial) << i;
    EXPECT_LT(distance(s->force, {imperial->force.H * pound, imperial->force.V * pound}), 1e-12 * size(s->force)) << i;
  }
}

// Independent witness: the shape by numerical integration of dx/ds = H/EA + H/T, dz/ds = V/EA + V/T.
RC_GTEST_PROP(Catenary, IsTheIntegralOfItsSlope, ()) {
  const Case c = *any_case();
  const auto s = solve_catenary(c.rope, c.x, c.z);
  RC_ASSERT(bool(s));
  const auto stretch = [&](double at) {
    return 1 / c.rope.stiffness + 1 / std::hypot(s->force.H, V_at(c.rope, s->force, at));
  };
  const double x = integral(c.rope.length, [&](double at) { return s->force.H * stretch(at); });
  const double z = integral(c.rope.length, [&](double at) { return V_at(c.rope, s->force, at) * stretch(at); });
  RC_ASSERT(std::abs(x - c.x) < 1e-11 * c.rope.length);
  RC_ASSERT(std::abs(z - c.z) < 1e-11 * c.rope.length);
}

RC_GTEST_PROP(Catenary, DoesNotDependOnTheStart, ()) {
  const Case c = *any_case();
  const auto cold = solve_catenary(c.rope, c.x, c.z);
  const double H = std::pow(10.0, *rc::gen::inRange(-3, 8));
  const double V = *rc::gen::inRange(-10, 11) * H;
  const auto warm = solve_catenary(c.rope, c.x, c.z, CatenaryForce{.H = H, .V = V});
  RC_ASSERT(cold && warm);
  RC_ASSERT(distance(cold->force, warm->force) <= 1e-13 * size(cold->force));
  const auto nonsense = solve_catenary(c.rope, c.x, c.z, CatenaryForce{.H = -1, .V = std::nan("")});
  RC_ASSERT(bool(nonsense));
  RC_ASSERT(distance(cold->force, nonsense->force) <= 1e-13 * size(cold->force));
}

TEST(Catenary, AnswersFarOutsideTheUsualRange) {
  std::mt19937_64 source(3);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  for (int i = 0; i < 20000; ++i) {
    const double chord = std::pow(10, in(0, 3));
    const double slope = in(-1.5707963, 1.5707963);
    const double x = in(0, 1) < 0.2 ? chord * std::pow(10, -in(0, 30)) : chord * std::cos(slope);
    const double z = chord * std::sin(slope);
    const double kind = in(0, 1);
    const double excess = kind < 0.3   ? in(-0.05, 0.6)
                          : kind < 0.6 ? std::pow(10, -in(1, 11)) * (in(0, 1) < 0.5 ? -1 : 1)
                                       : std::pow(10, in(-2, 2));
    const double EA = in(0, 1) < 0.1 ? infinite : std::pow(10, in(4, 11));
    const CatenaryRope rope{
        .length = std::hypot(x, z) * (1 + excess), .weight = std::pow(10, in(-4, 3)), .stiffness = EA};
    const auto s = solve_catenary(rope, x, z);
    if (std::isinf(EA) && rope.length <= std::hypot(x, z)) {
      ASSERT_FALSE(s);
      EXPECT_EQ(s.error(), NoCatenary::too_short);
      continue;
    }
    ASSERT_TRUE(s) << i << ": x " << x << " z " << z << " L " << rope.length << " w " << rope.weight << " EA " << EA;
    EXPECT_LT(s->closure, 1e-10 * std::max(rope.length, std::hypot(x, z))) << i;
  }
}

TEST(Catenary, InextensibleHasItsClosedForm) {
  // k = w x/(2 H), L^2 - z^2 = (x sinh(k)/k)^2
  for (const double k : {0.01, 0.3, 2.0, 20.0}) {
    const double x = 70, z = 40, w = 12;
    const CatenaryRope rope{.length = std::hypot(z, x * std::sinh(k) / k), .weight = w, .stiffness = infinite};
    const auto s = solve_catenary(rope, x, z);
    ASSERT_TRUE(s);
    const double expected = w * x / (2 * k);
    EXPECT_NEAR(s->force.H, expected, 1e-11 * expected);
    EXPECT_NEAR(s->force.V, w * z / 2 / std::tanh(k), 1e-11 * std::max(expected, w * rope.length));
  }
  // and is the limit of a stiff one
  const auto stiff = solve_catenary({.length = 90, .weight = 12, .stiffness = 1e14}, 70, 40);
  const auto rigid = solve_catenary({.length = 90, .weight = 12, .stiffness = infinite}, 70, 40);
  EXPECT_NEAR(stiff->force.H, rigid->force.H, 1e-10 * rigid->force.H);
}

TEST(Catenary, WithoutWeightIsASpring) {
  const auto s = solve_catenary({.length = 10, .weight = 0, .stiffness = 1e6}, 9, -6);
  ASSERT_TRUE(s);
  const double c = std::hypot(9, 6), T = 1e6 * (c - 10) / 10;
  EXPECT_NEAR(s->force.H, T * 9 / c, 1e-9);
  EXPECT_NEAR(s->force.V, -T * 6 / c, 1e-9);
  EXPECT_EQ(solve_catenary({11, 0, 1e6}, 9, -6).error(), NoCatenary::slack);
  EXPECT_EQ(solve_catenary({10, 0, infinite}, 9, -6).error(), NoCatenary::too_short);
  // and is the limit of a light one
  const auto light = solve_catenary({.length = 10, .weight = 1e-9, .stiffness = 1e6}, 9, -6);
  EXPECT_NEAR(light->force.H, s->force.H, 1e-8);
}

TEST(Catenary, HangsInAVerticalLine) {
  const CatenaryRope rope{.length = 10, .weight = 5, .stiffness = 1e4};
  const auto taut = solve_catenary(rope, 0, 12);  // z = L + V L/EA
  EXPECT_NEAR(taut->force.V, 2e3, 1e-9);
  EXPECT_EQ(taut->force.H, 0);
  const auto downwards = solve_catenary(rope, 0, -12);
  EXPECT_NEAR(downwards->force.V, -2e3, 1e-9);
  const auto loop = solve_catenary(rope, 0, 4);
  const EndPosition p = end_position(rope, loop->force);
  EXPECT_NEAR(p.z, 4, 1e-14);
  EXPECT_EQ(p.x, 0);
  EXPECT_EQ(p.dx_dH, infinite);
  EXPECT_NEAR(solve_catenary({10, 5, infinite}, 0, 4)->force.V, 5 * 4 / 2.0, 1e-13);
  EXPECT_EQ(solve_catenary({10, 5, infinite}, 0, 10).error(), NoCatenary::too_short);
  EXPECT_EQ(solve_catenary({10, 0, 1e4}, 0, 4).error(), NoCatenary::slack);
  // nearly vertical goes over into vertical
  for (const double z : {12.0, 4.0, -4.0, 10.0002}) {
    const auto at = solve_catenary(rope, 0, z);
    const auto beside = solve_catenary(rope, 1e-12, z);
    EXPECT_NEAR(beside->force.V, at->force.V, 1e-8) << z;
    EXPECT_GT(beside->force.H, 0) << z;
  }
}

TEST(Catenary, RefusesWhatIsNoRope) {
  EXPECT_THROW(solve_catenary({0, 1, 1}, 1, 1), ContractViolation);
  EXPECT_THROW(solve_catenary({1, -1, 1}, 1, 1), ContractViolation);
  EXPECT_THROW(solve_catenary({1, 1, 0}, 1, 1), ContractViolation);
  EXPECT_THROW(solve_catenary({1, 1, 1}, -1, 1), ContractViolation);
  EXPECT_THROW(solve_catenary({1, 1, 1}, 1, std::nan("")), ContractViolation);
  EXPECT_FALSE(to_text(NoCatenary::slack).empty());
}

// Compliance against central differences of the position, in extended precision.
void expect_compliance(const CatenaryRope& rope, const CatenaryForce& f, double tolerance) {
  const EndPosition p = end_position(rope, f);
  const double h = 1e-5 * f.H;
  const auto slope = [&](double dH, double dV, auto member) {
    const ExactEnd a = exact_end(rope, {.H = f.H + dH, .V = f.V + dV}),
                   b = exact_end(rope, {.H = f.H - dH, .V = f.V - dV});
    return static_cast<double>(a.*member - b.*member) / (2 * (dH + dV));
  };
  const double scale = std::max(p.dx_dH, p.dz_dV);
  EXPECT_NEAR(p.dx_dH, slope(h, 0, &ExactEnd::x), tolerance * scale);
  EXPECT_NEAR(p.dx_dV, slope(0, h, &ExactEnd::x), tolerance * scale);
  EXPECT_NEAR(p.dx_dV, slope(h, 0, &ExactEnd::z), tolerance * scale);
  EXPECT_NEAR(p.dz_dV, slope(0, h, &ExactEnd::z), tolerance * scale);
}

TEST(Catenary, KnowsItsCompliance) {
  for (const double EA : {1e4, 1e7, infinite}) {
    for (const double V : {-800.0, -200.0, 0.0, 30.0, 499.0, 2000.0}) {
      expect_compliance({.length = 100, .weight = 10, .stiffness = EA}, {.H = 300, .V = V}, 1e-8);
      expect_compliance({.length = 100, .weight = 1e-3, .stiffness = EA}, {.H = 300, .V = V}, 1e-8);
    }
  }
  // the small entry of a taut, level, inextensible rope keeps its digits: L (w L/T)^2/12/T
  const EndPosition p = end_position({.length = 100, .weight = 1e-4, .stiffness = infinite}, {.H = 1000, .V = 0});
  EXPECT_NEAR(p.dx_dH, 0.1 * 1e-10 / 12, 1e-9 * 0.1 * 1e-10 / 12);
}

RC_GTEST_PROP(Catenary, StiffnessLengthAndHeatAreDerivatives, ()) {
  const Case c = *any_case();
  const auto s = solve_catenary(c.rope, c.x, c.z);
  RC_ASSERT(bool(s));
  const CatenaryStiffness k = stiffness(c.rope, s->force);
  // steps small against the stretch and the sag, on which the curvature of the law scales
  const double slackness = std::abs(c.rope.length / std::hypot(c.x, c.z) - 1) + size(s->force) / c.rope.stiffness;
  const double h = 1e-4 * slackness * c.x;
  const auto solve = [&](double dx, double dz, double dL, double heat) {
    CatenaryRope rope = heated(c.rope, heat);
    rope.length += dL;
    return solve_catenary(rope, c.x + dx, c.z + dz)->force;
  };
  const auto check = [&](double dH, double dV, const CatenaryForce& a, const CatenaryForce& b, double step) {
    const double scale = std::hypot(dH, dV);
    RC_ASSERT(std::abs(dH - (a.H - b.H) / (2 * step)) < 1e-5 * scale);
    RC_ASSERT(std::abs(dV - (a.V - b.V) / (2 * step)) < 1e-5 * scale);
  };
  check(k.dH_dx, k.dH_dz, solve(h, 0, 0, 0), solve(-h, 0, 0, 0), h);
  check(k.dH_dz, k.dV_dz, solve(0, h, 0, 0), solve(0, -h, 0, 0), h);
  check(k.dH_dlength, k.dV_dlength, solve(0, 0, h, 0), solve(0, 0, -h, 0), h);
  const double heat = h / c.rope.length;
  check(k.dH_dheat, k.dV_dheat, solve(0, 0, 0, heat), solve(0, 0, 0, -heat), heat);
  RC_ASSERT(std::abs(k.out_of_plane - s->force.H / c.x) < 1e-12 * k.out_of_plane);
}

TEST(Catenary, StiffnessOfAVerticalRope) {
  const CatenaryRope rope{.length = 10, .weight = 5, .stiffness = 1e4};
  const CatenaryStiffness taut = stiffness(rope, solve_catenary(rope, 0, 12)->force);
  EXPECT_NEAR(taut.dV_dz, 1e3, 1e-9);  // EA/L
  const auto beside = solve_catenary(rope, 1e-6, 12);
  EXPECT_NEAR(taut.dH_dx, beside->force.H / 1e-6, 1e-6);
  EXPECT_NEAR(taut.out_of_plane, taut.dH_dx, 1e-9);
  const CatenaryStiffness loop = stiffness(rope, solve_catenary(rope, 0, 4)->force);
  EXPECT_EQ(loop.dH_dx, 0);
  EXPECT_EQ(loop.out_of_plane, 0);
  EXPECT_NEAR(loop.dV_dz, 1 / (1e-3 + 2 / 5.0), 1e-12);
}

TEST(Catenary, HeatKeepsTheWeight) {
  const CatenaryRope warm = heated({.length = 100, .weight = 10, .stiffness = 1e6}, 1.2e-5 * 40);
  EXPECT_NEAR(warm.length, 100.048, 1e-12);
  EXPECT_NEAR(warm.length * warm.weight, 1000, 1e-12 * 1000);
  EXPECT_EQ(warm.stiffness, 1e6);
  EXPECT_THROW(heated({100, 10, 1e6}, -1), ContractViolation);
}

}  // namespace taut::rope::catenary_test
