#include "taut/rope/catenary_shape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"

namespace taut::rope::catenary_shape_test {

struct Solved {
  CatenaryRope rope;
  double x, z;
  CatenaryForce force;
};

Solved solved(const CatenaryRope& rope, double x, double z) {
  return {.rope = rope, .x = x, .z = z, .force = solve_catenary(rope, x, z)->force};
}

rc::Gen<Solved> any_span() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(-200, 201), rc::gen::inRange(980, 1500), rc::gen::inRange(60, 91),
                                     rc::gen::inRange(1, 200)),
                      [](const auto& t) {
                        const auto [slope, ratio, EA, w] = t;
                        const double z = slope, chord = std::hypot(100.0, z);
                        return solved({chord * ratio / 1000, 1.0 * w, std::pow(10, EA / 10.0)}, 100, z);
                      });
}

TEST(CatenaryShape, GivesTheSagOfTheSpecification) {
  const Solved s = solved({.length = 100, .weight = 9.81, .stiffness = 1e7}, 80, 0);
  const Sag sag = largest_sag(s.rope, s.force);
  EXPECT_NEAR(sag.depth, 26.547034967, 1e-8);
  EXPECT_NEAR(sag.x, 40, 1e-12);
  EXPECT_NEAR(sag.s, 50, 1e-12);
}

RC_GTEST_PROP(CatenaryShape, EndsAtItsEnd, ()) {
  const Solved s = *any_span();
  const RopePoint start = point_at(s.rope, s.force, 0), end = point_at(s.rope, s.force, s.rope.length);
  RC_ASSERT(start.x == 0 && start.z == 0);
  RC_ASSERT(std::abs(end.x - s.x) < 1e-12 * s.rope.length && std::abs(end.z - s.z) < 1e-12 * s.rope.length);
  RC_ASSERT(std::abs(end.V - start.V - s.rope.weight * s.rope.length) < 1e-9 * end.tension());
}

RC_GTEST_PROP(CatenaryShape, FindsThePlaceOverX, ()) {
  const Solved s = *any_span();
  const double x = s.x * *rc::gen::inRange(0, 1001) / 1000.0;
  const double at = length_to(s.rope, s.force, x);
  RC_ASSERT(std::abs(point_at(s.rope, s.force, at).x - x) < 1e-12 * s.rope.length);
}

RC_GTEST_PROP(CatenaryShape, LargestSagIsTheLargest, ()) {
  const Solved s = *any_span();
  const Sag sag = largest_sag(s.rope, s.force);
  RC_ASSERT(std::abs(sag_at(s.rope, s.force, sag.x) - sag.depth) < 1e-11 * s.rope.length);
  for (int i = 0; i <= 50; ++i) RC_ASSERT(sag_at(s.rope, s.force, s.x * i / 50) <= sag.depth + 1e-11 * s.rope.length);
}

RC_GTEST_PROP(CatenaryShape, SwappedEndsHaveTheSameSag, ()) {
  const Solved s = *any_span();
  const Solved swapped = solved(s.rope, s.x, -s.z);
  RC_ASSERT(std::abs(largest_sag(s.rope, s.force).depth - largest_sag(s.rope, swapped.force).depth) <
            1e-12 * s.rope.length);
  RC_ASSERT(std::abs(stretched_length(s.rope, s.force) / stretched_length(s.rope, swapped.force) - 1) < 1e-15);
}

// Independent witness: numerical integrals over the unstretched length.
RC_GTEST_PROP(CatenaryShape, StretchAndEnergyAreIntegrals, ()) {
  const Solved s = *any_span();
  const auto over_rope = [&](const auto& f) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double at) { return f(point_at(s.rope, s.force, at).tension()); }, 0.0, s.rope.length, 15, 1e-14);
  };
  const double EA = s.rope.stiffness;
  const double stretch = over_rope([&](double T) { return T / EA; });
  RC_ASSERT(std::abs(stretched_length(s.rope, s.force) - s.rope.length - stretch) < 1e-13 * s.rope.length);
  const double energy = over_rope([&](double T) { return T * T / (2 * EA); });
  RC_ASSERT(std::abs(elastic_energy(s.rope, s.force) - energy) < 1e-11 * energy);
  RC_ASSERT(stretched_length(s.rope, s.force) >= std::hypot(s.x, s.z));
}

RC_GTEST_PROP(CatenaryShape, LowestPointIsTheLowest, ()) {
  const Solved s = *any_span();
  const double lowest = point_at(s.rope, s.force, lowest_point(s.rope, s.force)).z;
  for (int i = 0; i <= 50; ++i) {
    RC_ASSERT(point_at(s.rope, s.force, s.rope.length * (i / 50.0)).z >= lowest - 1e-12 * s.rope.length);
  }
}

TEST(CatenaryShape, ATautUprightRopeHasNoSag) {
  // a point off the vertical by rounding or by millimetres, either end up
  for (const double x : {0.0, 1e-17, 1e-9, 0.01}) {
    for (const double z : {20.0, -20.0}) {
      const CatenaryRope rope{.length = 20, .weight = 50, .stiffness = 1e6};
      const auto s = solve_catenary(rope, x, z * (1 + 5e-3));
      ASSERT_TRUE(s);
      EXPECT_NEAR(largest_sag(rope, s->force).depth, 0, 1e-9) << x << ", " << z;
    }
  }
  // a loop hangs below its lower end
  const CatenaryRope rope{.length = 20, .weight = 50, .stiffness = 1e6};
  const auto loop = solve_catenary(rope, 1e-6, 4);
  EXPECT_NEAR(largest_sag(rope, loop->force).depth, 8, 0.05);
}

TEST(CatenaryShape, OfAWeightlessRopeIsItsChord) {
  const Solved s = solved({.length = 10, .weight = 0, .stiffness = 1e6}, 9, 6);
  EXPECT_NEAR(largest_sag(s.rope, s.force).depth, 0, 1e-14);
  EXPECT_NEAR(stretched_length(s.rope, s.force), std::hypot(9, 6), 1e-13);
  EXPECT_NEAR(point_at(s.rope, s.force, 5).x, 4.5, 1e-13);
}

TEST(CatenaryShape, OfAVerticalLoopHangsBelowItsLowerEnd) {
  const Solved s = solved({.length = 10, .weight = 5, .stiffness = std::numeric_limits<double>::infinity()}, 0, 4);
  const Sag sag = largest_sag(s.rope, s.force);
  EXPECT_NEAR(sag.depth, 3, 1e-13);
  EXPECT_NEAR(sag.s, 3, 1e-13);
  const Solved swapped = solved(s.rope, 0, -4);
  EXPECT_NEAR(largest_sag(swapped.rope, swapped.force).depth, 3, 1e-13);
  EXPECT_EQ(stretched_length(s.rope, s.force), 10);
  const Solved elastic = solved({.length = 10, .weight = 5, .stiffness = 1e3}, 0, 4);
  EXPECT_GT(stretched_length(elastic.rope, elastic.force), 10);
  EXPECT_THROW(length_to(s.rope, s.force, 0), ContractViolation);
  EXPECT_THROW(point_at(s.rope, s.force, 11), ContractViolation);
}

}  // namespace taut::rope::catenary_shape_test
