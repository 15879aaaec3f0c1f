#include "taut/rope/parabola.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/rope/catenary_shape.hpp"
#include "taut/rope/loaded_span.hpp"
#include "taut/rope/span.hpp"

namespace taut::rope::parabola_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Parabola, SagAndTensionAreInverse) {
  const Parabola p{.span = 200, .rise = 80, .weight = 12};
  const double H = tension_for_sag(p, 6);
  EXPECT_NEAR(sag_for_tension(p, H), 6, 1e-13);
  EXPECT_NEAR(H, 12 * std::hypot(200, 80) * 200 / 48, 1e-9);
  EXPECT_EQ(sag_at(p, H, 0), 0);
  EXPECT_NEAR(sag_at(p, H, 50), 6 * 0.75, 1e-12);
  const ParabolaEnds e = end_forces(p, H);
  EXPECT_NEAR(e.V_end - e.V_start, 12 * chord(p), 1e-10);
  EXPECT_NEAR((e.V_end + e.V_start) / 2, H * 0.4, 1e-9);
}

// The catenary goes over into the parabola: error of the order of (sag/span)^2.
TEST(Parabola, IsTheLimitOfTheCatenary) {
  const double x = 200, z = 80, c = std::hypot(x, z);
  double before = 0;
  for (const double H : {2e4, 4e4, 8e4}) {
    const Parabola flat{.span = x, .rise = z, .weight = 12};
    const double L = arc_length(flat, H);
    const CatenaryRope rope{.length = L, .weight = 12 * c / L, .stiffness = infinite};
    const CatenaryForce f = solve_catenary(rope, x, z)->force;
    const double tension_error = std::abs(f.H / H - 1);
    const double sag_error = std::abs(largest_sag(rope, f).depth / sag_for_tension(flat, H) - 1);
    const double small = sag_for_tension(flat, H) / x;
    EXPECT_LT(tension_error, 4 * small * small) << H;
    EXPECT_LT(sag_error, 4 * small * small) << H;
    if (before > 0) {  // second order
      EXPECT_NEAR(before / tension_error, 4, 0.2);
    }
    before = tension_error;
  }
}

RC_GTEST_PROP(Parabola, LengthIsTheIntegralOfItsSlope, ()) {
  const Parabola p{.span = 100, .rise = static_cast<double>(*rc::gen::inRange(-150, 151)), .weight = 10};
  const double H = 10 * chord(p) / std::pow(10, *rc::gen::inRange(-40, 11) / 10.0);
  const double half = p.weight * chord(p) / (2 * H);
  const double length = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double x) { return std::hypot(1, p.rise / p.span + half * (2 * x / p.span - 1)); }, 0.0, p.span, 15, 1e-14);
  RC_ASSERT(std::abs(arc_length(p, H) - length) < 1e-12 * length);
  const Parabola swapped{.span = p.span, .rise = -p.rise, .weight = p.weight};
  RC_ASSERT(std::abs(arc_length(swapped, H) - arc_length(p, H)) < 1e-14 * length);
}

TEST(Parabola, CarriesALoad) {
  // midspan load on a nearly weightless inextensible rope: a triangle
  const Parabola p{.span = 100, .rise = 0, .weight = 0};
  const double H = tension_for_loaded_sag(p, 1000, 50, 4);
  EXPECT_NEAR(H, 1000 * 100 / (4 * 4.0), 1e-9);
  // and against the exact chain with the same sag
  const double w = 2, x = 100;
  const LoadedSpan s = *solve_loaded_span({.length = 100.4, .weight = w, .stiffness = 1e12}, {x, 0, 0},
                                          std::vector{PointLoad{.s = 50.2, .force = {0, 0, -1000}}});
  const double sag = -point_at(s, 50.2).z();
  EXPECT_NEAR(tension_for_loaded_sag({x, 0, w}, 1000, 50, sag) / force_on_start(s).x(), 1, 1e-2 * sag / x);
}

TEST(Parabola, TautTensionIsNearTheCatenarys) {
  for (const double rise : {-70.0, 0.0, 120.0}) {
    const double x = 100, c = std::hypot(x, rise);
    for (const double excess : {-4e-3, -1e-4, 0.0, 1e-4, 1e-3}) {
      const double L = c * (1 + excess);
      const CatenaryForce f = solve_catenary({.length = L, .weight = 15, .stiffness = 2e7}, x, rise)->force;
      const double T = taut_tension({.span = x, .rise = rise, .weight = 15}, L, 2e7);
      const double sag = 15 * L * x / (8 * T);
      EXPECT_NEAR(T / std::hypot(f.H, f.V), 1, 5e-2 * sag / c + 20 * sag * sag / (c * c)) << rise << ' ' << excess;
    }
  }
  EXPECT_EQ(taut_tension({100, 0, 0}, 101, 1e6), 0);
  EXPECT_NEAR(taut_tension({100, 0, 0}, 99, 1e6), 1e6 / 99, 1e-9);
  EXPECT_EQ(taut_tension({100, 0, 5}, 99, infinite), infinite);
  const double T = taut_tension({.span = 100, .rise = 0, .weight = 5}, 100.1,
                                infinite);  // (w L)^2/(24 T^2) = L/c - 1, to first order
  EXPECT_NEAR(T, std::sqrt(500.5 * 500.5 / 24 / (0.1 / 100.1)), 1e-6);
}

TEST(StraightRope, IsTheWeightlessSpan) {
  const Vector3 along(9, -6, 4);
  const StraightRope rope{.length = 11, .stiffness = 1e6};
  const Span s = *solve_span({.length = 11, .weight = 0, .stiffness = 1e6}, along);
  EXPECT_NEAR(straight_tension(rope, along.norm()), largest_tension(s), 1e-9);
  EXPECT_LT((straight_stiffness(rope, along) - stiffness(s)).norm(), 1e-9 * stiffness(s).norm());
  EXPECT_EQ(straight_tension(rope, 10), 0);
  EXPECT_EQ(straight_stiffness(rope, Vector3(1, 0, 0)).norm(), 0);
  const Matrix3 K = straight_stiffness(rope, along);
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    const auto force = [&](double by) {
      const Vector3 v = along + by * Vector3::Unit(i);
      return Vector3(straight_tension(rope, v.norm()) * v.normalized());
    };
    EXPECT_LT(((force(h) - force(-h)) / (2 * h) - K.col(i)).norm(), 1e-3);
  }
}

TEST(Parabola, RefusesWhatIsNone) {
  EXPECT_THROW(tension_for_sag({100, 0, 5}, 0), ContractViolation);
  EXPECT_THROW(sag_at({0, 1, 1}, 1, 0), ContractViolation);
  EXPECT_THROW(arc_length({100, 0, 5}, 0), ContractViolation);
}

}  // namespace taut::rope::parabola_test
