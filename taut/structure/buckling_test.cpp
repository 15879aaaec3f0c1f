#include "taut/structure/buckling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/catalogue/section_search.hpp"

namespace taut::structure::buckling_test {

double chi(double lambda, Curve curve) {
  Sheet<double> s;
  return flexural_buckling(lambda * lambda, 1.0, curve, "y", s).chi;
}

// Printed tables of the curves (four figures) at lambda = 0.5, 1.0 and 2.0.
TEST(Buckling, PrintedCurves) {
  EXPECT_NEAR(chi(1.0, Curve::a0), 0.7253, 5e-5);
  EXPECT_NEAR(chi(1.0, Curve::a), 0.6656, 5e-5);
  EXPECT_NEAR(chi(1.0, Curve::b), 0.5970, 5e-5);
  EXPECT_NEAR(chi(1.0, Curve::c), 0.5399, 5e-5);
  EXPECT_NEAR(chi(1.0, Curve::d), 0.4671, 5e-5);
  EXPECT_NEAR(chi(0.5, Curve::a), 0.9243, 5e-5);
  EXPECT_NEAR(chi(2.0, Curve::c), 0.1962, 5e-5);
}

TEST(Buckling, EndsOfTheCurves) {
  for (const Curve c : {Curve::a0, Curve::a, Curve::b, Curve::c, Curve::d}) {
    EXPECT_EQ(chi(0.2, c), 1);
    EXPECT_EQ(chi(0.05, c), 1);
    EXPECT_NEAR(chi(30, c) * 900, 1, 0.03);  // Euler's hyperbola
    EXPECT_EQ(parse_curve(to_text(c)), c);
    for (double lambda = 0.2; lambda < 3; lambda += 0.1) EXPECT_GE(chi(lambda, c), chi(lambda + 0.1, c));
  }
  Sheet<double> s;
  EXPECT_EQ(flexural_buckling(1e6, std::numeric_limits<double>::infinity(), Curve::a, "y", s).chi, 1);
  EXPECT_FALSE(parse_curve("e"));
}

TEST(Buckling, CurveByMaking) {
  const auto of = [](const char* name, double yield) { return curve_of(*catalogue::find_section(name), yield); };
  EXPECT_EQ(of("CHS 508x16", 355e6), Curve::a);
  EXPECT_EQ(of("CHS 508x16", 460e6), Curve::a0);
  EXPECT_EQ(of("SHS-C 100x5", 355e6), Curve::c);
  EXPECT_EQ(of("SHS-C 100x5", 460e6), Curve::c);
  EXPECT_EQ(of("CHS 219x8 GOST 8732", 345e6), Curve::a);
  EXPECT_EQ(of("CHS 219x8 GOST 10704", 345e6), Curve::c);
}

TEST(Buckling, Imperfections) {
  EXPECT_DOUBLE_EQ(bow_share(Curve::a, true), 1.0 / 300);
  EXPECT_DOUBLE_EQ(bow_share(Curve::c, false), 1.0 / 150);
  EXPECT_DOUBLE_EQ(sway_of(1), 1.0 / 200);    // alpha_h at most 1
  EXPECT_NEAR(sway_of(8), 0.00353553, 5e-9);  // 2/sqrt(8)/200
  EXPECT_DOUBLE_EQ(sway_of(100), 1.0 / 300);  // at least 2/3
  EXPECT_NEAR(sway_of(8, 3), 0.00353553 * std::sqrt(2.0 / 3), 5e-9);
  EXPECT_FALSE(needs_bow(0.6, 8779e3, 163e3));
  EXPECT_TRUE(needs_bow(4, 8779e3, 163e3));
  EXPECT_FALSE(needs_bow(4, 8779e3, -5));
}

// By the differential equation: E I w'' = H (L - x) + N (w_L - w), stepped with small steps from a guessed w_L.
double moment_by_steps(double H, double N, double EI, double L) {
  constexpr int n = 20000;
  const double dx = L / n;
  double low = 0, high = 2 * H * L * L * L / (3 * EI);
  for (int k = 0; k < 60; ++k) {
    const double tip = (low + high) / 2;
    double w = 0, turn = 0;
    for (int i = 0; i < n; ++i) {
      const auto bend = [&](double x, double at) { return (H * (L - x) + N * (tip - at)) / EI; };
      const double x = i * dx, half = bend(x + dx / 2, w + turn * dx / 2);
      w += dx * (turn + dx / 2 * bend(x, w));
      turn += dx * half;
    }
    (w > tip ? low : high) = tip;
  }
  return H * L + N * (low + high) / 2;
}

TEST(Buckling, SecondOrderMomentOfACantilever) {
  Sheet<double> s;
  const double E = 210e9, I = 7.490904e-4, L = 8, H = 106508.023;
  EXPECT_NEAR(second_order_moment(H, 162638.979, E, I, L, s), 871368.542, 0.05);  // by hand, case A of the mast
  for (const double share : {0.1, 0.5}) {
    const double N = share * euler_load(E, I, 2 * L);
    const double exact = second_order_moment(H, N, E, I, L, s);
    EXPECT_NEAR(moment_by_steps(H, N, E * I, L) / exact, 1, 1e-5) << share;
  }
  EXPECT_EQ(second_order_moment(H, -1.0, E, I, L, s), H * L);
  EXPECT_NEAR(second_order_moment(H, 1.0, E, I, L, s) / (H * L), 1, 1e-6);
}

}  // namespace taut::structure::buckling_test
