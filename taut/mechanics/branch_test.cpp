#include "taut/mechanics/branch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "taut/mechanics/branch_force.hpp"
#include "taut/rope/exact_end.hpp"

namespace branch_test {

using namespace taut;
using namespace taut::mechanics;

struct Case {
  rope::CatenaryRope rope;
  BranchEnd from, to;
};

/// Rounds up to 0.3 of the distance between their centres, rope 2 % short to 50 % long.
Case any_case(unsigned seed) {
  std::mt19937 source(seed);
  const auto in = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(source()) / 4294967296.0);
  };
  const double c = std::pow(10, in(0.7, 2.3)), slope = in(-1, 1);
  const Vector3 to(c * std::cos(slope), in(-0.05, 0.05) * c, c * std::sin(slope));
  const auto radius = [&] { return in(0, 1) < 0.3 ? 0 : std::pow(10, in(-2.5, -0.5)) * c * (in(0, 1) < 0.5 ? -1 : 1); };
  const double r0 = radius(), r1 = radius(), excess = in(0, 1) < 0.5 ? in(0.98, 1.5) : in(0.999, 1.02);
  return {.rope = {.length = c * excess, .weight = std::pow(10, in(0, 2)), .stiffness = std::pow(10, in(5.5, 9))},
          .from = {.centre = Vector3::Zero(), .axis = Vector3::UnitY(), .radius = r0},
          .to = {.centre = to, .axis = Vector3::UnitY(), .radius = r1}};
}

/// Asked until its span is closed too.
tl::expected<Branch, rope::NoCatenary> solved(const Case& c, machine::BranchState at) {
  auto b = solve_branch(c.rope, c.from, c.to, at);
  for (int i = 0; b && i < 3; ++i) {
    at = {.length = b->length, .leaves = b->leaves, .arrives = b->arrives, .force = b->span.force};
    rope::CatenaryRope rope = c.rope;
    rope.length = b->length;
    b = solve_branch(rope, c.from, c.to, at);
  }
  return b;
}

TEST(Branch, FoundColdBetweenRoundsOfAnySize) {
  int found = 0;
  const int cases = 4000;
  for (unsigned seed = 0; seed < cases; ++seed) {
    const Case c = any_case(seed);
    const auto b = solved(c, {});
    if (!b) continue;
    ++found;
    const double size = (c.to.centre - c.from.centre).norm();
    // the end of the rope, by the given forces, where the tangent points are
    const rope::ExactEnd end = rope::exact_end(b->span.rope, b->span.force);
    const Vector3 chord = static_cast<double>(end.x) * b->span.along + static_cast<double>(end.z) * up();
    EXPECT_LT((c.from.centre + b->offset_from + chord - c.to.centre - b->offset_to).norm(), 1e-10 * size) << seed;
    // it leaves and arrives along the rounds
    EXPECT_LT(std::abs(b->offset_from.dot(b->leaves)), 1e-12 * size) << seed;
    EXPECT_LT(std::abs(b->offset_to.dot(b->arrives)), 1e-12 * size) << seed;
    EXPECT_NEAR(b->offset_to.norm(), std::abs(c.to.radius), 1e-12 * size);
    // what is not free lies on the rounds
    const BranchDirections straight = straight_directions(c.from, c.to),
                           now{.leaves = b->leaves, .arrives = b->arrives};
    EXPECT_NEAR(b->length + arcs_between(c.from, c.to, straight, now), c.rope.length, 1e-10 * size) << seed;
  }
  EXPECT_GE(found, cases * 998 / 1000);
}

TEST(Branch, RunTheOtherWayItIsTheSame) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Case c = any_case(seed);
    const auto b = solved(c, {});
    std::swap(c.from, c.to);
    c.from.radius *= -1;
    c.to.radius *= -1;
    const auto back = solved(c, {});
    ASSERT_EQ(b.has_value(), back.has_value()) << seed;
    if (!b) continue;
    EXPECT_NEAR(b->length / back->length, 1, 1e-9) << seed;
    EXPECT_NEAR(b->T_from / back->T_to, 1, 1e-7) << seed;  // digits that EA/T leaves
  }
}

TEST(Branch, RatesAreDerivatives) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Case c = any_case(seed);
    const auto b = solved(c, {});
    if (!b || b->length < 1.01 * b->chord.norm()) continue;  // a taut rope is too curved for differences
    const BranchRates r = rates(b->span.rope, c.from, c.to, *b);
    const double h = 1e-6 * b->length;
    const auto moved = [&](const Vector3& by, double feed) {
      Case there = c;
      there.rope.length = b->length + feed;
      there.to.centre += by;
      return *solved(there, {.length = b->length, .leaves = b->leaves, .arrives = b->arrives, .force = b->span.force});
    };
    const Vector3 way = Vector3(0.4, 0.2, -0.7);
    const Branch ahead = moved(h * way, 0), behind = moved(-h * way, 0), more = moved({0, 0, 0}, h),
                 less = moved({0, 0, 0}, -h);
    const double force = r.pull_from_X.norm() + r.pull_from_u.norm();
    EXPECT_LT(((ahead.pull_to - behind.pull_to) / (2 * h) - r.pull_to_X * way).norm(), 1e-5 * force) << seed;
    EXPECT_LT(((more.pull_from - less.pull_from) / (2 * h) - r.pull_from_u).norm(), 1e-5 * force) << seed;
    EXPECT_NEAR((ahead.length - behind.length) / (2 * h), r.length_X.dot(way), 1e-5 * (1 + r.length_X.norm())) << seed;
    EXPECT_NEAR((more.length - less.length) / (2 * h), r.length_u, 1e-5 * (1 + std::abs(r.length_u))) << seed;
  }
}

}  // namespace branch_test
