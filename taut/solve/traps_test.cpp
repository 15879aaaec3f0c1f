// What other programs got wrong with status 0, each as a test.
#include <gtest/gtest.h>

#include <cmath>

#include "taut/rope/span.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace traps_test {

using namespace taut_test;
using namespace taut::solve;

/// A loaded line of two spans, its ends and its middle support at the given heights.
machine::Model line(double start, double middle, double end) {
  machine::Model m;
  m.bodies.push_back(body("car", {60, 0, (start + middle) / 2 - 4}, 1500, "xyz"));
  m.reevings.push_back(reeve("skyline",
                             {anchor("a", {0, 0, start}), over("car", origin, 0), saddle("mid", {120, 0, middle}, 0),
                              anchor("b", {220, 0, end})},
                             0, 25, 2e7));
  m.reevings[0].value = 1.01 * (std::hypot(120, middle - start) + std::hypot(100, end - middle));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  return m;
}

EquilibriumResult solved(const machine::Model& m) {
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 60};
  const EquilibriumResult r = equilibrium(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

const double heights[][3] = {{0, 30, 60}, {60, 30, 0}, {0, 50, 10}, {40, 0, 35}, {0, 0, 0}};

/// The wrong shape where a line's ends are not ordered low to high: its own points have to lie on the catenary, whose
/// tension grows with height by the weight of the rope.
TEST(Traps, ShapeWithEndsInAnyOrder) {
  for (const auto& h : heights) {
    const EquilibriumResult r = solved(line(h[0], h[1], h[2]));
    for (const BranchResult& s : r.branches) {
      EXPECT_LT((s.start + taut::rope::point_at(s.shape, s.shape.rope.length) - s.end).norm(), 1e-9 * 220);
      for (const double part : {0.0, 0.3, 0.7, 1.0}) {
        const double at = part * s.shape.rope.length;
        const double z = s.start.z() + taut::rope::point_at(s.shape, at).z();
        const double T = taut::rope::tension_at(s.shape, at).norm();
        // T + T^2/2EA - w z is one number along a rope that stretches
        const double here = T + T * T / 4e7 - 25 * z, there = s.T_from + s.T_from * s.T_from / 4e7 - 25 * s.start.z();
        EXPECT_NEAR(here, there, 1e-9 * s.T_from);
      }
    }
  }
}

TEST(Traps, UnstretchedIsShorterThanLoaded) {
  for (const auto& h : heights) {
    const EquilibriumResult r = solved(line(h[0], h[1], h[2]));
    for (const BranchResult& s : r.branches) {
      EXPECT_GT(s.stretched, s.unstretched);
      EXPECT_GE(s.stretched, s.chord);
      EXPECT_NEAR(s.stretched / s.unstretched - 1, (s.T_from + s.T_to) / 2 / 2e7, 2e-2 * s.T_from / 2e7);
    }
  }
}

/// The load hangs where its two ropes end, and is carried by their vertical pulls and the hold there.
TEST(Traps, HeightOfTheLoadBelongsToItsTensions) {
  for (const auto& h : heights) {
    const EquilibriumResult r = solved(line(h[0], h[1], h[2]));
    const Vector3& car = r.state.bodies[0].position;
    EXPECT_LT((r.branches[0].end - car).norm(), 1e-9);
    EXPECT_LT((r.branches[1].start - car).norm(), 1e-9);
    const auto left = taut::rope::solve_span(r.branches[0].shape.rope, car - Vector3(0, 0, h[0]));
    ASSERT_TRUE(left);
    EXPECT_NEAR(taut::rope::tension_at_end(*left) / r.branches[0].T_to, 1, 1e-9);
    EXPECT_NEAR(r.branches[1].V_from - r.branches[0].V_to + r.hold.z(), 1500 * 9.80665, 1e-5);
  }
}

/// An iteration that stops at a centimetre of rope is 0.7 % of tension off: the length closes to a nanometre, and the
/// tension is that of the length given, not of one a centimetre away.
TEST(Traps, LengthClosesFarBelowACentimetre) {
  for (const auto& h : heights) {
    const machine::Model m = line(h[0], h[1], h[2]);
    const EquilibriumResult r = solved(m);
    double length = 0;
    for (const BranchResult& s : r.branches) length += s.unstretched;
    EXPECT_NEAR(length, m.reevings[0].value, 1e-9);
    machine::Model longer = m;
    longer.reevings[0].value += 0.01;
    const double change = r.ropes[0].T_max / solved(longer).ropes[0].T_max - 1;
    EXPECT_GT(change, 5e-4);
    EXPECT_LT(r.closure.rope, 1e-7 * 0.01);
  }
}

}  // namespace traps_test
