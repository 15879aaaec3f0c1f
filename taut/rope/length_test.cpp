#include "taut/rope/length.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"

namespace taut::rope::length_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Length, KeepsTheThreeApart) {
  const std::vector<TensionPiece> path{{.unstretched = 100, .T_from = 2e4, .T_to = 3e4},
                                       {.unstretched = 50, .T_from = 3e4, .T_to = 3e4}};
  const double heat = steel_expansion * 20;
  const RopeLengths l = path_lengths(path, 1e7, heat);
  EXPECT_EQ(l.unstretched, 150);
  EXPECT_NEAR(l.installed, 150 * (1 + heat), 1e-12);
  EXPECT_NEAR(l.stretched, (100 * (1 + 2.5e-3) + 50 * (1 + 3e-3)) * (1 + heat), 1e-11);
  EXPECT_LT(l.installed, l.stretched);  // never the other way round
  EXPECT_EQ(path_lengths(path, infinite).stretched, 150);
  EXPECT_EQ(path_lengths({}, 1e7).stretched, 0);
}

RC_GTEST_PROP(Length, UnstretchedIsTheInverse, ()) {
  const TensionPiece piece{.unstretched = *rc::gen::inRange(1, 100000) / 100.0,
                           .T_from = *rc::gen::inRange(0, 100000) * 1.0,
                           .T_to = *rc::gen::inRange(0, 100000) * 1.0};
  const double heat = *rc::gen::inRange(-60, 60) * steel_expansion;
  const double stretched = path_lengths(std::vector{piece}, 5e6, heat).stretched;
  const double back = unstretched_length(stretched, piece.T_from, piece.T_to, 5e6, heat);
  RC_ASSERT(std::abs(back - piece.unstretched) < 1e-13 * piece.unstretched);
  const TensionPiece swapped{.unstretched = piece.unstretched, .T_from = piece.T_to, .T_to = piece.T_from};
  RC_ASSERT(path_lengths(std::vector{swapped}, 5e6, heat).stretched == stretched);
}

TEST(Length, OfASpanIsThatOfItsPieces) {
  // witness: the span cut into 4000 pieces with their own tensions, at the temperature
  const CatenaryRope rope{.length = 105, .weight = 20, .stiffness = 3e6};
  const double heat = 40 * steel_expansion;
  const CatenaryRope warm = heated(rope, heat);
  const CatenaryForce f = solve_catenary(warm, 90, 40)->force;
  const int n = 4000;
  std::vector<TensionPiece> pieces;
  pieces.reserve(n);
  const auto T = [&](int i) { return std::hypot(f.H, f.V + warm.weight * warm.length * (1.0 * i / n - 0.5)); };
  for (int i = 0; i < n; ++i) pieces.push_back({rope.length / n, T(i), T(i + 1)});
  const RopeLengths sum = path_lengths(pieces, rope.stiffness, heat), span = stretched_span(rope, f, heat);
  EXPECT_NEAR(span.unstretched, sum.unstretched, 1e-10);
  EXPECT_NEAR(span.installed, sum.installed, 1e-10);
  EXPECT_NEAR(span.stretched, sum.stretched, 1e-8);
}

TEST(Length, OnAnArcFollowsTheCapstanLaw) {
  // witness: summation of R dphi/(1 + T/EA) with T = T_from exp(k phi)
  const double arc = 0.9, EA = 2e5;
  for (const double T_to : {1e4, 1.00001e4, 2.4e4, 3e3}) {
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += arc / n / (1 + 1e4 * std::pow(T_to / 1e4, (i + 0.5) / n) / EA);
    EXPECT_NEAR(unstretched_on_arc(arc, 1e4, T_to, EA), sum, 1e-10) << T_to;
    EXPECT_NEAR(unstretched_on_arc(arc, T_to, 1e4, EA), sum, 1e-10) << T_to;
  }
  EXPECT_EQ(unstretched_on_arc(arc, 1e4, 2e4, infinite), arc);
}

TEST(Length, TensionOfAStretch) {
  EXPECT_NEAR(tension_of_stretch(100, 100.5, 1e7), 5e4, 1e-6);
  EXPECT_NEAR(tension_of_stretch(100, path_lengths(std::vector<TensionPiece>{{100, 7e3, 7e3}}, 1e7).stretched, 1e7),
              7e3, 1e-6);
}

TEST(Length, RefusesWhatIsNone) {
  EXPECT_THROW(path_lengths(std::vector<TensionPiece>{{-1, 0, 0}}, 1e7), ContractViolation);
  EXPECT_THROW(path_lengths({}, 0), ContractViolation);
  EXPECT_THROW(unstretched_on_arc(1, 0, 1, 1e7), ContractViolation);
}

}  // namespace taut::rope::length_test
