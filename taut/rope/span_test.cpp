#include "taut/rope/span.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "taut/base/expects.hpp"

namespace taut::rope::span_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

rc::Gen<Span> any_span() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(-150, 151), rc::gen::inRange(0, 360), rc::gen::inRange(980, 1500),
                                     rc::gen::inRange(60, 91), rc::gen::inRange(1, 200)),
                      [](const auto& t) {
                        const auto [z, turn, ratio, EA, w] = t;
                        const double a = turn * std::numbers::pi / 180;
                        const Vector3 chord(100 * std::cos(a), 100 * std::sin(a), z);
                        const CatenaryRope rope{chord.norm() * ratio / 1000, 1.0 * w, std::pow(10, EA / 10.0)};
                        return *solve_span(rope, chord);
                      });
}

RC_GTEST_PROP(Span, ForcesHoldTheWeight, ()) {
  const Span s = *any_span();
  const Vector3 sum = force_on_start(s) + force_on_end(s) + s.rope.weight * s.rope.length * up();
  RC_ASSERT(sum.norm() < 1e-13 * largest_tension(s));
  RC_ASSERT(std::abs(force_on_start(s).norm() / tension_at_start(s) - 1) < 1e-14);
  RC_ASSERT(std::abs(force_on_end(s).norm() / tension_at_end(s) - 1) < 1e-14);
  RC_ASSERT((tension_at(s, 0) - force_on_start(s)).norm() < 1e-13 * largest_tension(s));
  RC_ASSERT((tension_at(s, s.rope.length) + force_on_end(s)).norm() < 1e-13 * largest_tension(s));
}

RC_GTEST_PROP(Span, SwappedEndsSwapTheForces, ()) {
  const Span s = *any_span();
  const Span swapped = *solve_span(s.rope, -s.chord);
  RC_ASSERT(force_on_start(s) == force_on_end(swapped));
  RC_ASSERT(force_on_end(s) == force_on_start(swapped));
  RC_ASSERT((stiffness(s) - stiffness(swapped)).norm() <= 1e-13 * stiffness(s).norm());
}

RC_GTEST_PROP(Span, TurnsAndMirrorsWithItsEnds, ()) {
  const Span s = *any_span();
  const double T = largest_tension(s);
  const Matrix3 turn = Eigen::AngleAxisd(*rc::gen::inRange(0, 360) * std::numbers::pi / 180, up()).toRotationMatrix();
  const Span turned = *solve_span(s.rope, turn * s.chord);
  RC_ASSERT((force_on_start(turned) - turn * force_on_start(s)).norm() < 1e-12 * T);
  RC_ASSERT((stiffness(turned) - turn * stiffness(s) * turn.transpose()).norm() < 1e-11 * stiffness(s).norm());
  const Matrix3 mirror = Vector3(1, -1, 1).asDiagonal();
  const Span mirrored = *solve_span(s.rope, mirror * s.chord);
  RC_ASSERT((force_on_start(mirrored) - mirror * force_on_start(s)).norm() <= 1e-15 * T);
}

/// What one ulp of a turned coordinate does to the tension of a taut stiff rope is EA times it.
TEST(Span, ThreeThousandTurnedAndMirrored) {
  std::mt19937_64 source(4);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  for (int i = 0; i < 3000; ++i) {
    const double c = in(10, 1000), slope = in(-1.1, 1.1);
    const CatenaryRope rope{.length = c * in(0.98, 1.5), .weight = in(1, 200), .stiffness = std::pow(10, in(6, 9))};
    const Vector3 chord(c * std::cos(slope), 0, c * std::sin(slope));
    const auto here = solve_span(rope, chord);
    ASSERT_TRUE(here) << i;
    const double tolerance = 1e-12 * largest_tension(*here) + 2e-16 * rope.stiffness;
    const Matrix3 turn = Eigen::AngleAxisd(in(0, 2 * std::numbers::pi), up()).toRotationMatrix();
    const Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
    for (const Matrix3& M : {turn, mirror, Matrix3(turn * mirror)}) {
      const auto there = solve_span(rope, M * chord);
      ASSERT_TRUE(there) << i;
      EXPECT_LT((force_on_start(*there) - M * force_on_start(*here)).norm(), tolerance) << i;
      EXPECT_LT((force_on_end(*there) - M * force_on_end(*here)).norm(), tolerance) << i;
      EXPECT_LT(there->closure, 1e-9 * c) << i;
    }
  }
}

RC_GTEST_PROP(Span, StiffnessAndRatesAreDerivatives, ()) {
  const Span s = *any_span();
  const double slackness = std::abs(s.rope.length / s.chord.norm() - 1) + largest_tension(s) / s.rope.stiffness;
  const double h = 1e-4 * slackness * 100;
  const Matrix3 K = stiffness(s);
  RC_ASSERT((K - K.transpose()).norm() == 0);
  for (int i = 0; i < 3; ++i) {
    const Span a = *solve_span(s.rope, s.chord + h * Vector3::Unit(i));
    const Span b = *solve_span(s.rope, s.chord - h * Vector3::Unit(i));
    RC_ASSERT(((force_on_start(a) - force_on_start(b)) / (2 * h) - K.col(i)).norm() < 1e-5 * K.norm());
    RC_ASSERT(((force_on_end(a) - force_on_end(b)) / (2 * h) + K.col(i)).norm() < 1e-5 * K.norm());
  }
  const auto longer = [&](double by) {
    CatenaryRope rope = s.rope;
    rope.length += by;
    return *solve_span(rope, s.chord);
  };
  const EndForceRates length = length_rates(s);
  const Span a = longer(h), b = longer(-h);
  RC_ASSERT(((force_on_start(a) - force_on_start(b)) / (2 * h) - length.start).norm() < 1e-5 * length.start.norm());
  RC_ASSERT(((force_on_end(a) - force_on_end(b)) / (2 * h) - length.end).norm() < 1e-5 * length.end.norm());
  const double heat = h / s.rope.length;
  const Span warm = *solve_span(heated(s.rope, heat), s.chord), cold = *solve_span(heated(s.rope, -heat), s.chord);
  const EndForceRates rate = heat_rates(s);
  RC_ASSERT(((force_on_start(warm) - force_on_start(cold)) / (2 * heat) - rate.start).norm() <
            1e-5 * rate.start.norm());
  RC_ASSERT((rate.start + rate.end).norm() == 0);
}

TEST(Span, WeightlessAndTautIsASpringInSpace) {
  const Vector3 chord(9, -6, 4);
  const Span s = *solve_span({.length = 11, .weight = 0, .stiffness = 1e6}, chord);
  const double c = chord.norm(), T = 1e6 * (c - 11) / 11;
  const Vector3 e = chord / c;
  EXPECT_LT((force_on_start(s) - T * e).norm(), 1e-8);
  const Matrix3 K = 1e6 / 11 * e * e.transpose() + T / c * (Matrix3::Identity() - e * e.transpose());
  EXPECT_LT((stiffness(s) - K).norm(), 1e-10 * K.norm());
  EXPECT_LT((point_at(s, 5.5) - chord / 2).norm(), 1e-13);
  EXPECT_NEAR(stretched_length(s), c, 1e-13);
}

TEST(Span, WeightlessAndSlackCarriesNothing) {
  const Span s = *solve_span({.length = 12, .weight = 0, .stiffness = 1e6}, {9, -6, 4});
  EXPECT_TRUE(s.slack);
  EXPECT_EQ(force_on_start(s).norm() + force_on_end(s).norm(), 0);
  EXPECT_EQ(stiffness(s).norm(), 0);
  EXPECT_EQ(length_rates(s).start.norm() + heat_rates(s).end.norm(), 0);
  EXPECT_EQ(largest_sag(s) + sag_at(s, 2), 0);
  EXPECT_EQ(largest_tension(s), 0);
  EXPECT_EQ(stretched_length(s), 12);
  EXPECT_LT((point_at(s, 6) - Vector3(4.5, -3, 2)).norm(), 1e-15);
}

TEST(Span, SaysWhyThereIsNone) {
  EXPECT_EQ(solve_span({10, 5, infinite}, {9, -6, 4}).error(), NoCatenary::too_short);
  EXPECT_THROW(point_at(*solve_span({12, 1, infinite}, {9, -6, 4}), 13), ContractViolation);
}

TEST(Span, HangsInAVerticalLine) {
  const Span s = *solve_span({.length = 10, .weight = 5, .stiffness = 1e4}, {0, 0, -12});
  EXPECT_LT((force_on_start(s) - Vector3(0, 0, -2000 - 25)).norm(), 1e-9);
  const Matrix3 K = stiffness(s);
  EXPECT_NEAR(K(2, 2), 1e3, 1e-9);
  EXPECT_NEAR(K(0, 0), K(1, 1), 1e-10);
  EXPECT_GT(K(0, 0), 0);
}

TEST(Span, SagsAsItsCatenary) {
  const Span s = *solve_span({.length = 100, .weight = 9.81, .stiffness = 1e7}, {48, 64, 0});
  EXPECT_NEAR(largest_sag(s), 26.547034967, 1e-8);
  EXPECT_NEAR(sag_at(s, 40), 26.547034967, 1e-8);
  EXPECT_NEAR(largest_tension(s), 592.144521698, 1e-8);
  EXPECT_LT((point_at(s, 50) - Vector3(24, 32, -26.547034967)).norm(), 1e-8);
}

}  // namespace taut::rope::span_test
