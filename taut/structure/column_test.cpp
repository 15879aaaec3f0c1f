#include "taut/structure/column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace taut::structure::column_test {

using std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

Column prismatic(double L, double EI, double N, bool clamped = true, double top = 0) {
  Column c;
  c.pieces = {{.length = L, .EI = EI, .EI_top = {}, .weight = 0}};
  c.loads = {{.piece = 0, .down = N, .across = 0, .moment = 0}};
  c.clamped_base = clamped;
  c.top_stiffness = top;
  return c;
}

TEST(Column, EulersFourCases) {
  const double L = 7, EI = 3e7, N = 1e5, pinned = pi * pi * EI / (L * L) / N;
  EXPECT_NEAR(critical_factor(prismatic(L, EI, N)) / (pinned / 4), 1, 1e-6);
  EXPECT_NEAR(critical_factor(prismatic(L, EI, N, false, infinite)) / pinned, 1, 1e-6);
  const double root = 4.493409457909064;  // tan x = x
  EXPECT_NEAR(critical_factor(prismatic(L, EI, N, true, infinite)) / (root * root * EI / (L * L) / N), 1, 1e-6);
  EXPECT_EQ(critical_factor(prismatic(L, EI, N, false, 0)), 0);
  EXPECT_EQ(critical_factor(prismatic(L, EI, -N)), infinite);
  EXPECT_NEAR(buckling_length(EI, pinned / 4, N), 2 * L, 1e-9);
}

// Cut into pieces of any length it is the same column: short ones are stiff beyond what numbers hold.
TEST(Column, CutAnywhere) {
  for (const double top : {0.0, 4e5, infinite}) {
    const double whole = critical_factor(prismatic(7, 3e7, 1e5, true, top));
    for (const double cut : {3.0, 0.02, 1e-3, 1e-4, 1e-7}) {
      Column c = prismatic(7, 3e7, 1e5, true, top);
      c.pieces = {{.length = 3.5, .EI = 3e7, .EI_top = {}, .weight = 0},
                  {.length = cut, .EI = 3e7, .EI_top = {}, .weight = 0},
                  {.length = 3.5 - cut, .EI = 3e7, .EI_top = {}, .weight = 0}};
      c.loads[0].piece = 2;
      EXPECT_NEAR(critical_factor(c) / whole, 1, 3e-4) << top << " " << cut;
    }
    Column many = prismatic(7, 3e7, 1e5, true, top);
    many.pieces.assign(300, {7.0 / 300, 3e7, {}, 0});
    many.loads[0].piece = 299;
    EXPECT_NEAR(critical_factor(many) / whole, 1, 1e-5) << top;
  }
}

// On a hinge with a spring at its top it leans over at k L, or buckles as if both ends were held: whichever is less,
// also where both are the same.
TEST(Column, SpringAtTheTopOfAHingedColumn) {
  const double L = 10, EI = 2e7, pinned = pi * pi * EI / (L * L);
  for (const double share : {0.3, 0.9, 1.0, 1.1, 4.0}) {
    EXPECT_NEAR(critical_factor(prismatic(L, EI, 1, false, share * pinned / L)) / (std::min(share, 1.0) * pinned), 1,
                1e-6)
        << share;
  }
}

// Timoshenko and Gere, Theory of Elastic Stability, 2.13: clamped below, a half of it twice, four times as stiff:
// tan(k1 l1) tan(k2 l2) = k1/k2.
TEST(Column, SteppedCantilever) {
  for (const double ratio : {2.0, 4.0}) {
    Column c;
    c.pieces = {{.length = 4, .EI = ratio * 1e7, .EI_top = {}, .weight = 0},
                {.length = 4, .EI = 1e7, .EI_top = {}, .weight = 0}};
    c.loads = {{.piece = 1, .down = 1e5, .across = 0, .moment = 0}};
    const double P = critical_factor(c) * 1e5;
    const double k_low = std::sqrt(P / (ratio * 1e7)), k_high = std::sqrt(P / 1e7);
    EXPECT_NEAR(std::tan(k_low * 4) * std::tan(k_high * 4), k_high / k_low, 1e-4) << ratio;
    EXPECT_LT(P, ratio * 1e7 * pi * pi / 256);
    EXPECT_GT(P, 1e7 * pi * pi / 256);
  }
}

// A column's own weight: 7.8373 E I/L^2.
TEST(Column, OwnWeight) {
  Column c = prismatic(12, 5e6, 0);
  c.loads.clear();
  c.pieces[0].weight = 1000;
  EXPECT_NEAR(critical_factor(c) * 1000 * 12 / (7.837347 * 5e6 / 144), 1, 1e-6);
}

TEST(Column, CantileverInItsBentShape) {
  const double L = 8, EI = 210e9 * 7.490904e-4, N = 162638.979, H = 106508.023;
  Column c = prismatic(L, EI, N);
  c.loads[0].across = H;
  const auto points = bent_shape(c);
  ASSERT_TRUE(points);
  EXPECT_NEAR(points->front().M, 871368.542, 0.05);  // H tan(kL)/k, by hand
  EXPECT_NEAR(points->front().V, H, 1e-6);
  EXPECT_NEAR(points->back().M, 0, 1e-6);
  EXPECT_NEAR(points->front().M, H * L + N * points->back().w, 1e-4);
  EXPECT_FALSE(bent_shape(c, 1.001 * critical_factor(c)));
}

TEST(Column, BuiltCrooked) {
  const double L = 8, EI = 1.5e8, N = 400e3, critical = pi * pi * EI / (4 * L * L);
  Column c = prismatic(L, EI, N);
  c.bow = 0.04;
  EXPECT_NEAR(bent_shape(c)->front().M, N * 0.04 / (1 - N / critical), 1e-2);
  c.bow = 0;
  c.sway = 0.004;  // as a force N phi
  const double k = std::sqrt(N / EI);
  EXPECT_NEAR(bent_shape(c)->front().M, N * 0.004 * std::tan(k * L) / k, 1e-3);
  Column held = prismatic(L, EI, N, false, infinite);
  held.bow = 0.03;
  const auto points = bent_shape(held);
  EXPECT_NEAR((*points)[points->size() / 2].M, -N * 0.03 / (1 - N / (4 * critical)), 1.0);
}

TEST(Column, HeldTopTakesTheLoadAcross) {
  Column c = prismatic(6, 1e8, 100, true, infinite);
  c.pieces = {{.length = 3, .EI = 1e8, .EI_top = {}, .weight = 0}, {.length = 3, .EI = 1e8, .EI_top = {}, .weight = 0}};
  c.loads = {{.piece = 1, .down = 1, .across = 0, .moment = 0},
             {.piece = 0,
              .down = 0,
              .across = 16e3,
              .moment = 0}};  // propped cantilever, load in its middle: 3 P L/16 at the clamp
  EXPECT_NEAR(bent_shape(c)->front().M, 3 * 16e3 * 6 / 16, 1e-1);
  c.top_stiffness = 3 * 1e8 / 216;  // as stiff as the cantilever itself: half of the prop's force
  EXPECT_NEAR(bent_shape(c)->front().M, 16e3 * 3 - 5.0 / 16 * 16e3 / 2 * 6, 1e-1);
}

TEST(Column, TaperIsTheLimitOfSteps) {
  Column taper = prismatic(10, 4e7, 1e5), steps = taper;
  taper.pieces[0].EI_top = 1e7;
  steps.pieces.clear();
  constexpr int n = 60;
  for (int i = 0; i < n; ++i) steps.pieces.push_back({10.0 / n, 4e7 - 3e7 * (i + 0.5) / n, {}, 0});
  steps.loads[0].piece = n - 1;
  EXPECT_NEAR(critical_factor(steps) / critical_factor(taper), 1, 1e-4);
  taper.loads[0].across = steps.loads[0].across = 5e3;
  EXPECT_NEAR(bent_shape(steps)->back().w / bent_shape(taper)->back().w, 1, 1e-3);
}

TEST(Column, ForceAlongTheHeightCountsBelowIt) {
  Column c;
  c.pieces = {{.length = 5, .EI = 1e11, .EI_top = {}, .weight = 200},
              {.length = 3, .EI = 1e11, .EI_top = {}, .weight = 100}};
  c.loads = {{.piece = 0, .down = 3e3, .across = 1e3, .moment = 0},
             {.piece = 1, .down = 2e3, .across = 500, .moment = 250}};
  const auto points = bent_shape(c);
  EXPECT_NEAR(points->front().N, 5e3 + 1000 + 300, 1e-9);
  EXPECT_NEAR(points->back().N, 2e3, 1e-6);
  EXPECT_NEAR(points->front().M, 1e3 * 5 + 500 * 8 + 250, 0.01);  // too stiff to bend
  EXPECT_NEAR(points->back().M, 250, 1e-6);
}

}  // namespace taut::structure::column_test
