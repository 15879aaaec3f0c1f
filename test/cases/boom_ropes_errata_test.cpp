// The mistakes of Reutov (2021), each shown by a witness of its own: Table 2, statics, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/methods/boom_ropes/slip.hpp"
#include "test/support/solved.hpp"

namespace boom_ropes_errata_test {

using namespace taut::boom_ropes;

constexpr double degree = std::numbers::pi / 180;
constexpr double tonne = 9.81e3;

struct Pair {
  double S1, S2;
};
/// Table 2 of the paper, rows 1 to 9, N.
constexpr Pair table_2[] = {{.S1 = 95.5e3, .S2 = 181e3}, {.S1 = 178e3, .S2 = 9.8e3},  {.S1 = 162.5e3, .S2 = 43e3},
                            {.S1 = 105e3, .S2 = 168e3},  {.S1 = 114e3, .S2 = 156e3},  {.S1 = 104e3, .S2 = 174e3},
                            {.S1 = 113e3, .S2 = 159e3},  {.S1 = 82.5e3, .S2 = 208e3}, {.S1 = 100e3, .S2 = 186e3}};

TEST(BoomRopesErrata, StiffnessIsInMeganewtons) {
  // Elongation of the retraction rope and of half the extension rope by their own pretension, in metres.
  EXPECT_GT(95.5e3 / 2.72e3, 35);
  EXPECT_GT(181e3 / 1.61e3, 110);
  EXPECT_LT(95.5e3 / printed_C1, 0.04);
  EXPECT_LT(181e3 / printed_C2, 0.12);
}

TEST(BoomRopesErrata, PrintedC1ContradictsTable2) {
  // Both ropes see the same X, so that the tensions of any two states give C2/C1.
  const auto kappa = [](int a, int b) { return -(table_2[b].S2 - table_2[a].S2) / (table_2[b].S1 - table_2[a].S1); };
  EXPECT_NEAR(kappa(0, 1), 2.08, 0.005);
  EXPECT_NEAR(kappa(0, 2), 2.06, 0.005);
  EXPECT_NEAR(kappa(0, 7), 2.08, 0.005);
  EXPECT_NEAR(printed_C2 / kappa(0, 1), 0.778e6, 0.01e6);
  // Row 3 predicted from row 1: with the printed C1 far off, whether F is that of (4) or that of row 3 itself.
  const double F_1 = table_2[0].S2 - 2 * table_2[0].S1;
  const auto row_3 = [&](double C1, double F) {
    const double both = 2 * C1 + printed_C2;
    return Pair{.S1 = table_2[0].S1 + (F_1 - F) * C1 / both, .S2 = table_2[0].S2 - (F_1 - F) * printed_C2 / both};
  };
  const double F_4 = -274.06e3;
  const double F_3 = table_2[2].S2 - 2 * table_2[2].S1;
  EXPECT_NEAR(row_3(printed_C1, F_4).S1, 197.4e3, 50);
  EXPECT_NEAR(row_3(printed_C1, F_4).S2, 120.7e3, 50);
  EXPECT_GT(row_3(printed_C1, F_3).S2, 2.5 * table_2[2].S2);
  EXPECT_NEAR(row_3(printed_C2 / table_2_ratio, F_3).S1, table_2[2].S1, 0.5e3);
  EXPECT_NEAR(row_3(printed_C2 / table_2_ratio, F_3).S2, table_2[2].S2, 0.5e3);
}

TEST(BoomRopesErrata, StiffnessExplainsThePretension) {
  const Output out = taut_test::solved_as<Output>(governing_boom());
  EXPECT_NEAR(out.lambda_2_corrected, 0.509, 0.0005);
  EXPECT_NEAR(out.S20_min_corrected, 166.5e3, 50);
  EXPECT_GT(out.S20_min_corrected, 2.2 * out.S20_min);
  // Jamming does not: rated lift, boom retracted.
  Input in = governing_boom();
  Sliding q;
  q.operation = Operation::lift;
  q.luffing_angle = {77 * degree};
  q.boom_length = {9};
  q.suspended_weight = {25.3 * tonne};
  taut::Sheet<double> s;
  SlidingPoint p;
  ASSERT_TRUE(slide(in, q, {}, s, p).ok());
  EXPECT_FALSE(p.jamming());
  // Nor in the static test, where the upper rear pad just touches: 0.1 % more friction than weight.
  q.suspended_weight = {30.25 * tonne};
  ASSERT_TRUE(slide(in, q, {}, s, p).ok());
  EXPECT_NEAR(std::abs(p.Nf) + std::abs(p.Nr), p.Nf + p.Nr, 1e-3 * p.Nf);
}

TEST(BoomRopesErrata, LightestLoadIsTheHookBlock) {
  EXPECT_NEAR(free_slip_angle(8.44e3, 0.3 * tonne, 0.155, 0.95, 6) / degree, 6.49, 0.005);
  EXPECT_NEAR(free_slip_angle(8.44e3, 0, 0.155, 0.95, 6) / degree, 8.81, 0.005);
}

TEST(BoomRopesErrata, HalfSheaveBelongsToSection3) {
  // Elastic energy of both ropes over the place y3 of section 3, X = 2 y2 - y3 with the half-sheave on section 3: its
  // slope is the force (1) has. With the half-sheave on section 2 the extension rope would not see y3 at all.
  const double C1 = 0.778e6;
  const double C2 = 1.61e6;
  const double S10 = 95.5e3;
  const double S20 = 187e3;
  const auto energy = [&](double y3) {
    const double X = -y3;
    return 2 * (S10 * X + C1 * X * X / 2) - (S20 * X - C2 * X * X / 2);
  };
  const double y3 = 0.01;
  const double h = 1e-5;
  const double pull = -(energy(y3 + h) - energy(y3 - h)) / (2 * h);
  EXPECT_NEAR(pull, 2 * (S10 - C1 * y3) - (S20 + C2 * y3), 1);
}

TEST(BoomRopesErrata, SumOfProjections) {
  const Case lift{
      .name = "", .operation = Operation::lift, .luffing_angle = 77 * degree, .suspended_weight = 248.2e3, .falls = 8};
  const double weight = 248.2e3 + 8.44e3;
  const double literal =
      248.2e3 / (8 * 0.95) + 0.15 * weight * std::cos(lift.luffing_angle) + weight * std::sin(lift.luffing_angle);
  EXPECT_GT(literal, 0);
  EXPECT_LT(force(governing_boom(), lift), 0);
}

TEST(BoomRopesErrata, SheaveMomentNeedsHalfTurn) {
  const double eta = 0.98;
  const double T_in = 100e3;
  const double T_out = eta * T_in;
  const double D = 0.3;
  const double moment = (T_in - T_out) * D / 2;
  const auto printed = [&](double wrap) {
    const double R = std::sqrt(T_in * T_in + T_out * T_out - 2 * T_in * T_out * std::cos(wrap));
    return R * D * (1 - eta) / (2 * (1 + eta));
  };
  EXPECT_NEAR(printed(std::numbers::pi), moment, 1e-9 * moment);
  EXPECT_LT(printed(std::numbers::pi / 2), 0.75 * moment);
}

TEST(BoomRopesErrata, PublishedPretensionSlides) {
  Input in = governing_boom();
  in.extension_stiffness = printed_C2 / table_2_ratio;
  in.S10 = 95.5e3;
  in.S20 = 181e3;
  const Output out = taut_test::solved_as<Output>(in);
  EXPECT_NEAR(out.S10_set, 93.4e3, 50);
  EXPECT_NEAR(out.S20_set, 185.4e3, 50);
  EXPECT_NEAR(std::abs(out.S20_set - 2 * out.S10_set), 1.266e3, 0.5);
}

TEST(BoomRopesErrata, WeightedSumIsConstant) {
  const auto sum = [](const Pair& p) { return table_2_ratio * p.S1 + p.S2; };
  for (const int row : {0, 1, 2, 7}) EXPECT_NEAR(sum(table_2[row]), 378.8e3, 0.65e3);
  for (const int row : {3, 4, 5, 6, 8}) {
    EXPECT_GT(sum(table_2[row]), 384e3);
    EXPECT_LT(sum(table_2[row]), 394e3);
  }
}

TEST(BoomRopesErrata, NoSlipAtTheHorizontal) {
  const double lead = 3.3 * tonne * 0.95 / 6;
  EXPECT_NEAR(lead, 5.1e3, 50);
  EXPECT_NEAR(0.155 * (8.44e3 + 3.3 * tonne), 6.3e3, 50);
  EXPECT_NEAR(slip_angle(governing_boom(), {}, {17, 3.3 * tonne, 0.3, 6}).angle / degree, 15.5, 0.5);
}

TEST(BoomRopesErrata, SlipAnglesNeedTheOverlap) {
  EXPECT_NEAR(slip_angle(governing_boom(), {}, {21, 0.3 * tonne, 0, 6}).angle / degree, 39, 0.5);
  EXPECT_NEAR(slip_angle(governing_boom(), {}, {21, 3.3 * tonne, 0, 6}).angle / degree, 50, 0.5);
}

TEST(BoomRopesErrata, StaticTestIsOnePointTwo) {
  EXPECT_NEAR(296.8e3 / tonne, 30.25, 0.01);
  EXPECT_NEAR((296.8e3 / tonne - 0.3) / 25, 1.2, 0.002);
}

TEST(BoomRopesErrata, TwoStaticFrictions) {
  // 0.155 gives the slip angles, 0.15 the forces of (5).
  EXPECT_NEAR(free_slip_angle(8.44e3, 3.3 * tonne, 0.155, 0.95, 6) / degree, 1.67, 0.015);
  EXPECT_LT(free_slip_angle(8.44e3, 3.3 * tonne, 0.15, 0.95, 6) / degree, 1.45);
  EXPECT_NEAR(taut_test::solved_as<Output>(governing_boom()).F[1], 0.243e3, 0.5);
}

TEST(BoomRopesErrata, CylinderHoldsTwiceTheForce) {
  Sliding q;
  q.operation = Operation::lift;
  q.luffing_angle = {77 * degree};
  q.boom_length = {9};
  q.suspended_weight = {30.25 * tonne};
  taut::Sheet<double> s;
  SlidingPoint p;
  ASSERT_TRUE(slide(governing_boom(), q, {}, s, p).ok());
  EXPECT_NEAR(p.Fh, 2 * 326.2e3, 0.02 * 2 * 326.2e3);
}

}  // namespace boom_ropes_errata_test
