#include "taut/rope/loaded_span.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "taut/base/expects.hpp"
#include "taut/rope/span.hpp"

namespace taut::rope::loaded_span_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

Vector3 weight(double P) { return {0, 0, -P}; }

// Loads of any direction; `sideways`: their horizontal part against the vertical one.
LoadedSpan random_span(unsigned seed, double sideways = 0.3) {
  std::mt19937_64 source(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  const Vector3 chord(in(-100, 100), in(-100, 100), in(-60, 60));
  const CatenaryRope rope{
      .length = chord.norm() * in(0.99, 1.3), .weight = in(1, 50), .stiffness = std::pow(10, in(6, 9))};
  std::vector<PointLoad> loads(1 + seed % 4);
  for (PointLoad& load : loads) {
    const double P = std::pow(10, in(2, 5));
    load = {.s = rope.length * in(0.02, 0.98),
            .force = Vector3(in(-1, 1) * sideways * P, in(-1, 1) * sideways * P, -P)};
  }
  return *solve_loaded_span(rope, chord, loads);
}

Vector3 sum_of_loads(const LoadedSpan& s) {
  Vector3 sum = Vector3::Zero();
  for (const PointLoad& load : s.loads) sum += load.force;
  return sum;
}

TEST(LoadedSpan, SolvesWhateverLoads) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const LoadedSpan s = random_span(seed, 3.0);
    EXPECT_LT(s.closure, 1e-12 * std::max(s.chord.norm(), s.rope.length)) << seed;
    EXPECT_LT((point_at(s, s.rope.length) - s.chord).norm(), 1e-12 * s.rope.length) << seed;
    const Vector3 balance =
        force_on_start(s) + force_on_end(s) - sum_of_loads(s) + s.rope.weight * s.rope.length * up();
    EXPECT_LT(balance.norm(), 1e-12 * largest_tension(s)) << seed;
  }
}

TEST(LoadedSpan, WithoutLoadsIsTheCatenary) {
  const CatenaryRope rope{.length = 110, .weight = 20, .stiffness = 1e7};
  const Vector3 chord(60, -70, 25);
  const Span plain = *solve_span(rope, chord);
  const LoadedSpan s = *solve_loaded_span(rope, chord, {});
  EXPECT_LT((force_on_start(s) - force_on_start(plain)).norm(), 1e-10 * largest_tension(plain));
  EXPECT_LT((force_on_end(s) - force_on_end(plain)).norm(), 1e-10 * largest_tension(plain));
  EXPECT_LT((stiffness(s) - stiffness(plain)).norm(), 1e-9 * stiffness(plain).norm());
  EXPECT_LT((length_rates(s)[0] - length_rates(plain).start).norm(), 1e-9 * length_rates(plain).start.norm());
  EXPECT_NEAR(stretched_length(s), stretched_length(plain), 1e-10);
  EXPECT_LT((point_at(s, 30) - point_at(plain, 30)).norm(), 1e-10);
  EXPECT_LT((tension_at(s, 30) - tension_at(plain, 30)).norm(), 1e-10 * largest_tension(plain));
}

// Closed form: two straight springs that meet at the load.
TEST(LoadedSpan, OfAWeightlessRopeIsATriangle) {
  const double L = 10, EA = 1e6, P = 5e3, half = 4.9;
  const LoadedSpan s = *solve_loaded_span({.length = L, .weight = 0, .stiffness = EA}, {2 * half, 0, 0},
                                          std::vector{PointLoad{.s = 5, .force = weight(P)}});
  const double T = s.force.norm();
  const double stretched = 5 * (1 + T / EA);
  const double sag = -point_at(s, 5).z();
  EXPECT_NEAR(std::hypot(half, sag), stretched, 1e-12);
  EXPECT_NEAR(2 * T * sag / stretched, P, 1e-8);
  // a piece that carries nothing leaves the shape open
  EXPECT_EQ(solve_loaded_span({L, 0, EA}, {9, 0, 0}, {}).error(), NoCatenary::slack);
  EXPECT_EQ(solve_loaded_span({L, 0, EA}, {8, 0, 0}, std::vector{PointLoad{1, weight(P)}}).error(), NoCatenary::slack);
}

// Independent witness: a lumped chain of 2000 springs, each end of it by marching from the start's force.
TEST(LoadedSpan, IsTheLimitOfALumpedChain) {
  const CatenaryRope rope{.length = 105, .weight = 30, .stiffness = 2e7};
  const std::vector<PointLoad> loads{{.s = 40, .force = Vector3(500, 2000, -20000)}, {.s = 70, .force = weight(8000)}};
  const LoadedSpan s = *solve_loaded_span(rope, {90, 20, 30}, loads);
  const int n = 4200;  // loads lie on nodes
  const double l = rope.length / n;
  Vector3 T = s.force + rope.weight * l / 2 * up(), at = Vector3::Zero();
  for (int i = 0; i < n; ++i) {
    at += T.normalized() * l * (1 + T.norm() / rope.stiffness);
    T += rope.weight * l * up();
    for (const PointLoad& load : loads) {
      if (std::abs(load.s - l * (i + 1)) < l / 2) T -= load.force;
    }
  }
  EXPECT_LT((at - s.chord).norm(), 1e-6 * rope.length);
}

RC_GTEST_PROP(LoadedSpan, SwappedEndsSwapTheForces, ()) {
  const LoadedSpan s = random_span(*rc::gen::arbitrary<unsigned>());
  std::vector<PointLoad> loads;
  loads.reserve(s.loads.size());
  for (const PointLoad& load : s.loads) loads.push_back({s.rope.length - load.s, load.force});
  const LoadedSpan swapped = *solve_loaded_span(s.rope, -s.chord, loads);
  RC_ASSERT((force_on_start(s) - force_on_end(swapped)).norm() < 1e-9 * largest_tension(s));
  RC_ASSERT(std::abs(largest_tension(s) - largest_tension(swapped)) < 1e-9 * largest_tension(s));
}

RC_GTEST_PROP(LoadedSpan, TurnsAndMirrorsWithItsEndsAndLoads, ()) {
  const LoadedSpan s = random_span(*rc::gen::arbitrary<unsigned>());
  const double angle = *rc::gen::inRange(0, 360) * std::numbers::pi / 180;
  const Matrix3 turn = Eigen::AngleAxisd(angle, up()) * Vector3(1, -1, 1).asDiagonal();
  std::vector<PointLoad> loads = s.loads;
  for (PointLoad& load : loads) load.force = turn * load.force;
  const LoadedSpan turned = *solve_loaded_span(s.rope, turn * s.chord, loads);
  RC_ASSERT((force_on_start(turned) - turn * force_on_start(s)).norm() < 1e-9 * largest_tension(s));
}

RC_GTEST_PROP(LoadedSpan, WarmStartChangesNothing, ()) {
  const LoadedSpan s = random_span(*rc::gen::arbitrary<unsigned>());
  const LoadedSpan warm = *solve_loaded_span(s.rope, s.chord, s.loads, Vector3(1.1 * s.force + Vector3(10, 20, 30)));
  RC_ASSERT((force_on_start(warm) - force_on_start(s)).norm() < 1e-9 * largest_tension(s));
}

RC_GTEST_PROP(LoadedSpan, StiffnessAndLengthRatesAreDerivatives, ()) {
  const LoadedSpan s = random_span(*rc::gen::arbitrary<unsigned>());
  const double h = 1e-5 * s.rope.length * std::max(0.1, 1 - s.chord.norm() / s.rope.length);
  // A segment shorter than the step would turn over within the difference.
  for (std::size_t k = 1; k < s.loads.size(); ++k) RC_PRE(s.loads[k].s - s.loads[k - 1].s > 100 * h);
  const Matrix3 K = stiffness(s);
  for (int i = 0; i < 3; ++i) {
    const auto a = solve_loaded_span(s.rope, s.chord + h * Vector3::Unit(i), s.loads, s.force);
    const auto b = solve_loaded_span(s.rope, s.chord - h * Vector3::Unit(i), s.loads, s.force);
    RC_ASSERT(((a->force - b->force) / (2 * h) - K.col(i)).norm() < 1e-3 * K.norm());
  }
  const auto rates = length_rates(s);
  RC_ASSERT(rates.size() == s.loads.size() + 1);
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const auto longer = [&](double by) {
      CatenaryRope rope = s.rope;
      rope.length += by;
      std::vector<PointLoad> loads = s.loads;
      for (std::size_t j = k; j < loads.size(); ++j) loads[j].s += by;
      return *solve_loaded_span(rope, s.chord, loads, s.force);
    };
    const Vector3 slope = (longer(h).force - longer(-h).force) / (2 * h);
    RC_ASSERT((slope - rates[k]).norm() < 1e-3 * (rates[k].norm() + s.rope.weight));
  }
}

TEST(LoadedSpan, TakesLoadsAtItsEndsAndInAnyOrder) {
  const CatenaryRope rope{.length = 105, .weight = 30, .stiffness = 2e7};
  const Vector3 chord(90, 20, 30);
  const LoadedSpan plain = *solve_loaded_span(rope, chord, {});
  const std::vector<PointLoad> ends{{.s = 105, .force = weight(700)}, {.s = 0, .force = weight(900)}};
  const LoadedSpan s = *solve_loaded_span(rope, chord, ends);
  EXPECT_LT((force_on_start(s) - force_on_start(plain) - weight(900)).norm(), 1e-9 * largest_tension(s));
  EXPECT_LT((force_on_end(s) - force_on_end(plain) - weight(700)).norm(), 1e-9 * largest_tension(s));
  EXPECT_EQ(length_rates(s).size(), 3U);
  EXPECT_TRUE(length_rates(s)[0].allFinite());
}

TEST(LoadedSpan, HangsStraightDown) {
  const CatenaryRope rope{.length = 10, .weight = 5, .stiffness = 1e4};
  const LoadedSpan s = *solve_loaded_span(rope, {0, 0, -12}, std::vector{PointLoad{.s = 4, .force = weight(300)}});
  // stretch 2 m = (weight below each point, and the end's pull F) over EA
  const double F = (2 - (5 * 50 + 4 * 300) / 1e4) / (10 / 1e4);
  EXPECT_NEAR(force_on_end(s).z(), F, 1e-6);
  EXPECT_NEAR(largest_tension(s), F + 350, 1e-6);
}

TEST(LoadedSpan, SaysWhyThereIsNone) {
  EXPECT_EQ(solve_loaded_span({9, 5, infinite}, {9, 0, 0}, {}).error(), NoCatenary::too_short);
  EXPECT_THROW(solve_loaded_span({9, 5, 1e6}, {9, 0, 0}, std::vector{PointLoad{10, weight(1)}}), ContractViolation);
  EXPECT_THROW(point_at(*solve_loaded_span({10, 5, 1e6}, {9, 0, 0}, {}), -1), ContractViolation);
}

}  // namespace taut::rope::loaded_span_test
