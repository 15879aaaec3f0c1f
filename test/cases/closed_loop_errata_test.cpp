#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/math/roots.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "test/cases/closed_loop_witness.hpp"

// The paper's mistakes shown wrong by witnesses that do not come from the paper: moments of a thread, energy,
// catenaries.

namespace taut::closed_loop::closed_loop_errata_test {

using taut_test::LoopCase;
using taut_test::LoopForces;
constexpr double degree = std::numbers::pi / 180;

/// The library's input for a witness case (any coherent unit of force).
Input input_of(const LoopCase& c) {
  Input in;
  in.span = c.l;
  in.slope = std::atan(c.m);
  in.position = {c.x};
  in.sag = c.f;
  in.gathering_force = c.S;
  in.gathering_angle = c.gamma;
  in.return_weight = c.q_b;
  in.traction_weight = c.q_T;
  in.tail_efficiency = c.eta;
  in.carriage_weight = c.W_c;
  in.roller = c.vertical ? Roller::vertical : Roller::free;
  if (c.d > 0) {
    in.carriage = Carriage::two_section;
    in.section_distance = c.d;
  }
  return in;
}

Output solved(const LoopCase& c) {
  Output out;
  const Outcome o = solve(input_of(c), out);
  EXPECT_TRUE(o.ok()) << o.message;
  return out;
}

LoopForces exact(const LoopCase& c, const Output& start) {
  const LoopForces e = c.d > 0
                           ? taut_test::solve_two_sections(
                                 c, {start.H_1, start.H_2 + c.S * std::sin(c.gamma), start.H_2, start.H_3, start.H_4},
                                 c.m * start.x_2 - start.f_2)
                           : taut_test::solve_loop(c, {start.H_1, start.H_2, start.H_3, start.H_4});
  EXPECT_TRUE(e.converged);
  return e;
}

std::vector<LoopCase> assorted() {
  std::vector<LoopCase> all;
  for (double alpha : {-25.0, -8.0, 0.0, 12.0, 25.0}) {
    for (double x : {60.0, 100.0, 150.0}) {
      for (double eta : {0.8, 0.95}) {
        LoopCase c;
        c.m = std::tan(alpha * degree);
        c.x = x;
        c.eta = eta;
        all.push_back(c);
      }
    }
  }
  return all;
}

/// Horizontal tension of a thread: bending moment of the simply supported beam / sag.
double lower_branch_H2(const LoopCase& c, double P, double K, double P_b) {
  const double cos_a = std::cos(std::atan(c.m));
  const double w_b = c.q_b / cos_a;
  const double w_T = c.q_T / cos_a;
  const double y = c.l - c.x;
  const double reaction_B = ((P - P_b) * c.x - K * c.f * cos_a + w_T * c.x * c.x / 2 + w_b * y * (c.x + y / 2)) / c.l;
  return (reaction_B * y - w_b * y * y / 2) / c.f;
}

TEST(ClosedLoopErrata, Equation1BalancesBothBranches) {
  for (const LoopCase& c : assorted()) {
    const Output o = solved(c);
    const double cos_a = std::cos(std::atan(c.m));
    const double T_B2 = lower_branch_H2(c, o.P, o.K, o.P_b) / cos_a;
    const double upper_moment = o.P_b * c.x * (c.l - c.x) / c.l + c.q_b / cos_a * c.x * (c.l - c.x) / 2;
    EXPECT_NEAR(upper_moment / c.f / cos_a, c.eta * T_B2, 1e-9 * T_B2);
    EXPECT_NEAR(o.T_b, c.eta * T_B2, 1e-9 * T_B2);
    EXPECT_NEAR(o.T_n, T_B2 + o.K, 1e-9 * T_B2);
  }
  LoopCase c;
  c.eta = 1;
  c.q_T = c.q_b;
  const Output o = solved(c);
  EXPECT_NEAR(o.P_b, (o.P - o.K * c.f / c.x) / 2, 1e-9 * o.P);
}

TEST(ClosedLoopErrata, Equation6FollowsTheRopeOverTheSheave) {
  LoopCase c;
  const Output o = solved(c);
  const LoopForces e = exact(c, o);
  EXPECT_NEAR(o.T_n, e.T_lA, 0.01 * e.T_lA);
  EXPECT_GT(std::abs(o.T_n_printed / e.T_lA - 1), 0.035);  // S cos(gamma) in place of S sin(gamma)
  EXPECT_LT((o.T_b + o.K) / e.T_lA, 0.93);                 // T_b not divided by eta: unsafe
  c.gamma = 60 * degree;
  const Output flat = solved(c);
  EXPECT_LT(flat.T_n_printed / exact(c, flat).T_lA, 0.8);
}

TEST(ClosedLoopErrata, Equation9AgreesWithTheLevelChord) {
  LoopCase c;
  const Output o = solved(c);
  const double H_1 = lower_branch_H2(c, o.P, o.K, o.P_b) + c.S * std::sin(c.gamma);
  EXPECT_NEAR(o.T_lA_paper, H_1, 1e-9 * H_1);
  EXPECT_LT(o.T_lA_printed, 0.4 * H_1);
}

TEST(ClosedLoopErrata, Equations8And10MakeTensionTimesSafetyTheStrength) {
  for (double alpha : {-20.0, 0.0, 15.0}) {
    LoopCase c;
    c.m = std::tan(alpha * degree);
    Input in = input_of(c);
    in.safety_factor = 3.5;
    in.wire_strength = 140e6;  // 140 per mm2, weights 0.01 per m and mm2
    in.weight_per_area = 0.01e6;
    Output o;
    ASSERT_TRUE(solve(in, o).ok());
    const double a = std::abs(alpha) * degree;
    const double cos_a = std::cos(a);
    const double up = 1;  // the end slope at the upper support
    const double P_b = o.P_b_no_weight;
    const double q_b = in.weight_per_area * o.F_return_paper;
    const double H = c.l * c.l / (8 * c.f) * (q_b / cos_a + 2 * P_b / c.l);
    const double V = P_b / 2 + q_b / cos_a * c.l / 2;
    EXPECT_NEAR(3.5 * (H / cos_a + up * std::sin(a) * V), *in.wire_strength * o.F_return_paper, 1e-6 * 3.5 * H);
    LoopCase own = c;
    own.q_b = q_b;
    own.q_T = in.weight_per_area * o.F_traction_paper;
    const double H_1 = lower_branch_H2(own, o.P, o.K, P_b) + c.S * std::sin(c.gamma);
    const double V_A = H_1 * c.f / c.x + own.q_T / cos_a * c.x / 2;
    EXPECT_NEAR(3.5 * (H_1 / cos_a - std::sin(alpha * degree) * V_A), *in.wire_strength * o.F_traction_paper,
                1e-6 * 3.5 * H_1);
  }
}

TEST(ClosedLoopErrata, FreeRollerPullsTheLoadUpTheSlope) {
  // No friction, load straight down: moving it along the chord by s raises it by s sin(alpha), and the winches give
  // (T_lA - T_uA) s. The paper's formulas give no net pull at all.
  for (double alpha : {-30.0, -15.0, 15.0, 30.0}) {
    LoopCase c;
    c.m = std::tan(alpha * degree);
    c.gamma = 0;
    c.eta = 1;
    c.q_b = c.q_T = 1e-6;
    c.f = 4;
    const Output o = solved(c);
    const double net = -o.P * std::sin(alpha * degree);
    EXPECT_NEAR(o.T_lA - o.T_uA, net, 0.002 * std::abs(net)) << alpha;
    const double T_uA_paper = o.T_b - std::sin(alpha * degree) * o.P_b / 2;
    EXPECT_NEAR(o.T_lA_paper - T_uA_paper, 0, 1e-3 * std::abs(net)) << alpha;
    const LoopForces e = exact(c, o);
    EXPECT_NEAR(e.T_lA - e.T_uA, net, 0.002 * std::abs(net)) << alpha;
    EXPECT_NEAR(o.T_lA_paper - o.P_b * std::sin(alpha * degree), e.T_lA, 0.01 * e.T_lA) << alpha;
  }
}

TEST(ClosedLoopErrata, TwoSectionSystemAgreesWithCatenaries) {
  LoopCase c;
  c.d = 3;
  const Output o = solved(c);
  const LoopForces e = exact(c, o);
  EXPECT_NEAR(e.P_b, 1134.84, 0.0005 * 1134.84);
  const double delta_f = c.m * o.x_2 - (c.f * (o.x_2 - c.l) / (c.x - c.l)) - e.y2;
  EXPECT_NEAR(delta_f, 0.980, 0.0005);
  EXPECT_NEAR(o.P_b, e.P_b, 0.001 * e.P_b);
  EXPECT_NEAR(o.delta_f, delta_f, 0.001 * delta_f);
  EXPECT_GT(std::abs(o.P_b_printed / e.P_b - 1), 0.015);
  EXPECT_GT(std::abs(o.delta_f_printed / delta_f - 1), 0.03);
}

TEST(ClosedLoopErrata, PublishedTwoSectionAnswerSolvesNothing) {
  const auto line_1 = [](double P_b) { return 5.5 * P_b + 550; };
  const auto line_2 = [](double P_b, double df) { return (13.6e4 - 48.5 * P_b) / (10 + df) - 750; };
  const auto line_3 = [](double df) { return 700 / df - 14.5e3; };
  EXPECT_NEAR(line_1(1230), 7315, 0.5);
  EXPECT_NEAR(line_2(1230, 0.097), 6811, 0.5);
  EXPECT_NEAR(line_3(0.097), -7284, 1);
  const auto P_b_of = [](double df) { return ((13.6e4 / (10 + df) - 750) - 550) / (5.5 + 48.5 / (10 + df)); };
  const auto printed = find_root([&](double df) { return line_1(P_b_of(df)) - line_3(df); }, 1e-3, 1);
  ASSERT_TRUE(printed);
  EXPECT_NEAR(*printed, 0.03245, 5e-6);
  EXPECT_NEAR(P_b_of(*printed), 1185.95, 0.005);
  const auto repaired = find_root([&](double df) { return line_1(P_b_of(df)) - (7700 / df - 1450); }, 1e-3, 10);
  ASSERT_TRUE(repaired);
  EXPECT_NEAR(*repaired, 0.943, 0.0005);
  EXPECT_NEAR(P_b_of(*repaired), 1120.4, 0.05);
}

TEST(ClosedLoopErrata, SectionAheadLowersTheLoad) {
  LoopCase single;
  LoopCase two = single;
  two.d = 3;
  const Output a = solved(single);
  const Output b = solved(two);
  EXPECT_LT(b.P_b - a.P_b, -28);
  EXPECT_GT(b.P_b - a.P_b, -33);
  const LoopForces e_a = exact(single, a);
  two.x = 97;  // the load stays at midspan
  const LoopForces e_b = exact(two, solved(two));
  EXPECT_NEAR(e_b.T_uB / e_a.T_uB - 1, -0.027, 0.001);
}

// The witness against the reference numbers of the example, and the tiers against the witness.

TEST(ClosedLoopWitness, ReferenceNumbersOfTheExample) {
  const LoopCase c;
  const LoopForces e = exact(c, solved(c));
  EXPECT_NEAR(e.P_b, 1166.17, 0.0005 * 1166.17);
  EXPECT_NEAR(e.T_uB, 6370.0, 0.0005 * 6370);
  EXPECT_NEAR(e.T_lB, 7077.8, 0.0005 * 7077.8);
  EXPECT_NEAR(e.T_lA, 8587.9, 0.0005 * 8587.9);
}

TEST(ClosedLoopWitness, TwoSectionsOverSlopesAndLoads) {
  for (double alpha : {-20.0, 0.0, 20.0}) {
    for (double W_c : {0.0, 400.0}) {
      for (bool vertical : {false, true}) {
        LoopCase c;
        c.m = std::tan(alpha * degree);
        c.d = 4;
        c.x = 80;
        c.W_c = W_c;
        c.vertical = vertical;
        const Output o = solved(c);
        const LoopForces e = exact(c, o);
        EXPECT_NEAR(o.P_b_closed, e.P_b, 0.005 * e.P_b) << alpha << ' ' << W_c << ' ' << vertical;
        EXPECT_NEAR(o.T_lA, e.T_lA, 0.01 * e.T_lA) << alpha << ' ' << W_c << ' ' << vertical;
        EXPECT_NEAR(o.T_lB, e.T_lB, 0.01 * e.T_lB) << alpha << ' ' << W_c << ' ' << vertical;
        EXPECT_NEAR(o.T_uA, e.T_uA, 0.01 * e.T_uA) << alpha << ' ' << W_c << ' ' << vertical;
        EXPECT_NEAR(o.T_uB, e.T_uB, 0.01 * e.T_uB) << alpha << ' ' << W_c << ' ' << vertical;
      }
    }
  }
}

/// Smallest and largest error of three formulas over gamma and rope weight, load at midspan.
struct Band {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double error) {
    low = std::min(low, 100 * error);
    high = std::max(high, 100 * error);
  }
};
struct Bands {
  Band P_b, T_up, T_lA;
};

Bands bands_at(double alpha, double share) {
  Bands b;
  for (double gamma : {10.0, 20.0, 30.0, 40.0, 50.0, 60.0}) {
    for (double weight : {0.02, 1.0 / 15, 0.2}) {
      LoopCase c;
      c.m = std::tan(alpha * degree);
      c.f = share * c.l;
      c.gamma = gamma * degree;
      c.q_b = weight * c.S / c.l;
      c.q_T = 1.5 * c.q_b;
      Output o;
      if (!solve(input_of(c), o).ok()) continue;
      const LoopForces e = exact(c, o);
      if (e.P_b <= 0.05 * c.S) continue;
      b.P_b.take(o.P_b / e.P_b - 1);
      b.T_up.take(o.T_up / (alpha < 0 ? e.T_uA : e.T_uB) - 1);
      b.T_lA.take(o.T_lA_paper / e.T_lA - 1);
    }
  }
  return b;
}

struct TabledBand {
  double alpha, share, low, high;
};

void expect_band(const char* what, const Band& band, const TabledBand& t) {
  EXPECT_NEAR(band.low, t.low, 0.051) << what << " low, alpha " << t.alpha << ", f/l " << t.share;
  EXPECT_NEAR(band.high, t.high, 0.051) << what << " high, alpha " << t.alpha << ", f/l " << t.share;
}

TEST(ClosedLoopWitness, ErrorOfEquation1AtMidspan) {
  for (const TabledBand& t : std::vector<TabledBand>{
           {-30, 0.02, 1.4, 1.7},  {-30, 0.05, 3.1, 4.3},  {-30, 0.10, 7.2, 8.4},  {-30, 0.15, 9.8, 12.3},
           {-10, 0.02, 0.6, 0.7},  {-10, 0.05, 1.5, 1.7},  {-10, 0.10, 2.8, 3.3},  {-10, 0.15, 4.3, 4.7},
           {0, 0.02, 0, 0},        {0, 0.05, 0, 0},        {0, 0.10, 0, 0.1},      {0, 0.15, 0, 0.2},
           {10, 0.02, -0.7, -0.6}, {10, 0.05, -1.7, -1.6}, {10, 0.10, -3.3, -3.0}, {10, 0.15, -4.7, -4.2},
           {30, 0.02, -1.7, -1.7}, {30, 0.05, -4.3, -4.1}, {30, 0.10, -8.4, -8.1}, {30, 0.15, -12.3, -11.7}}) {
    expect_band("P_b", bands_at(t.alpha, t.share).P_b, t);
  }
}

TEST(ClosedLoopWitness, ErrorOfEquation7AtMidspan) {
  for (const TabledBand& t : std::vector<TabledBand>{
           {-30, 0.02, 1.2, 3.4}, {-30, 0.05, 1.7, 8.4},  {-30, 0.10, 5.2, 16.6}, {-30, 0.15, 2.9, 24.2},
           {-20, 0.02, 0.8, 2.5}, {-20, 0.05, 0.5, 6.0},  {-20, 0.10, 1.5, 11.2}, {-20, 0.15, -3.6, 15.4},
           {-10, 0.02, 0.6, 1.3}, {-10, 0.05, 0.7, 2.9},  {-10, 0.10, -2.1, 4.7}, {-10, 0.15, -4.0, 5.4},
           {0, 0.02, -0.2, -0.1}, {0, 0.05, -1.0, -0.5},  {0, 0.10, -4.2, -2.1},  {0, 0.15, -9.8, -4.5},
           {30, 0.02, 0, 0},      {30, 0.05, -0.3, -0.3}, {30, 0.10, -1.5, -1.0}, {30, 0.15, -3.3, -2.1}}) {
    expect_band("T_up", bands_at(t.alpha, t.share).T_up, t);
  }
}

TEST(ClosedLoopWitness, ErrorOfEquation9AtMidspan) {
  for (const TabledBand& t : std::vector<TabledBand>{
           {-30, 0.02, -2.9, -1.2}, {-30, 0.05, -6.6, -2.3}, {-30, 0.10, -11.5, -5.6}, {-30, 0.15, -15.3, -6.1},
           {-20, 0.02, -2.2, -0.9}, {-20, 0.05, -5.2, -1.9}, {-20, 0.10, -9.6, -4.1},  {-20, 0.15, -13.5, -4.9},
           {-10, 0.02, -1.2, -0.8}, {-10, 0.05, -3.1, -1.8}, {-10, 0.10, -6.8, -3.0},  {-10, 0.15, -10.9, -5.7},
           {0, 0.02, -0.2, -0.1},   {0, 0.05, -0.9, -0.5},   {0, 0.10, -3.3, -2.1},    {0, 0.15, -6.8, -4.5},
           {10, 0.02, 0.7, 1.1},    {10, 0.05, 0.8, 2.4},    {10, 0.10, -0.9, 3.4},    {10, 0.15, -4.4, 2.8},
           {20, 0.02, 1.5, 2.2},    {20, 0.05, 2.8, 5.3},    {20, 0.10, 2.5, 9.5},     {20, 0.15, -0.3, 12.0},
           {30, 0.02, 2.3, 3.1},    {30, 0.05, 4.8, 7.7},    {30, 0.10, 6.5, 15.3},    {30, 0.15, 5.4, 22.1}}) {
    expect_band("T_lA", bands_at(t.alpha, t.share).T_lA, t);
  }
}

TEST(ClosedLoopWitness, AtSteepSlopesTheMidspanCorrectionOfEquation9Holds) {
  Band plain;
  Band corrected;
  Band other_end;
  for (double alpha : {-30.0, -20.0, -10.0, 0.0, 10.0, 20.0, 30.0}) {
    for (double share : {0.02, 0.04, 0.06, 0.09}) {
      for (double gamma : {10.0, 20.0, 30.0, 40.0, 50.0}) {
        LoopCase c;
        c.m = std::tan(alpha * degree);
        c.f = share * c.l;
        c.gamma = gamma * degree;
        Output o;
        if (!solve(input_of(c), o).ok()) continue;
        const LoopForces e = exact(c, o);
        if (e.P_b <= 0.05 * c.S) continue;
        plain.take(o.T_lA_paper / e.T_lA - 1);
        corrected.take((o.T_lA_paper - o.P_b * std::sin(alpha * degree)) / e.T_lA - 1);
        other_end.take((e.T_uB - c.q_b * c.l * c.m) / e.T_uA - 1);
      }
    }
  }
  EXPECT_LT(plain.low, -7.8);
  EXPECT_GT(plain.high, 11.0);
  EXPECT_NEAR(corrected.low, -2.1, 0.05);
  EXPECT_NEAR(corrected.high, -0.1, 0.05);
  EXPECT_NEAR(other_end.low, 0, 1e-6);  // a free roller: the upper tension changes by weight times height only
  EXPECT_NEAR(other_end.high, 0, 1e-6);
}

TEST(ClosedLoopWitness, WithAVerticalRollerEquation1IsRight) {
  for (double alpha : {-30.0, -10.0, 0.0, 10.0, 30.0}) {
    for (double share : {0.02, 0.05, 0.10, 0.15}) {
      for (double gamma : {10.0, 30.0, 50.0}) {
        LoopCase c;
        c.m = std::tan(alpha * degree);
        c.f = share * c.l;
        c.gamma = gamma * degree;
        c.vertical = true;
        Output o;
        if (!solve(input_of(c), o).ok()) continue;
        const LoopForces e = exact(c, o);
        if (e.P_b <= 0.05 * c.S) continue;
        const double error = 100 * (o.P_b / e.P_b - 1);
        EXPECT_GT(error, share > 0.1 ? -2.2 : -1.2) << alpha << ' ' << share << ' ' << gamma;
        EXPECT_LT(error, 0.5) << alpha << ' ' << share << ' ' << gamma;
      }
    }
  }
}

TEST(ClosedLoopWitness, OffMidspanThePaperHoldsToALocalSlopeOfAFifth) {
  for (double alpha : {-10.0, 0.0, 10.0}) {
    for (double place : {0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9}) {
      for (double local : {0.05, 0.10, 0.15, 0.20}) {
        for (double gamma : {10.0, 30.0, 50.0}) {
          LoopCase c;
          c.m = std::tan(alpha * degree);
          c.x = place * c.l;
          c.f = local * std::min(c.x, c.l - c.x);
          c.gamma = gamma * degree;
          Output o;
          if (!solve(input_of(c), o).ok()) continue;
          const LoopForces e = exact(c, o);
          if (e.P_b <= 0.05 * c.S) continue;
          EXPECT_NEAR(o.P_b / e.P_b, 1, 0.07) << alpha << ' ' << place << ' ' << local << ' ' << gamma;
          EXPECT_NEAR(o.T_lA_paper / e.T_lA, 1, 0.07) << alpha << ' ' << place << ' ' << local << ' ' << gamma;
        }
      }
    }
  }
}

TEST(ClosedLoopWitness, ClosedFormTierOverTheGrid) {
  std::vector<double> worst_lA;
  std::vector<double> ends;
  std::vector<double> loads;
  for (double alpha : {-30.0, -20.0, -10.0, 0.0, 10.0, 20.0, 30.0}) {
    for (double share : {0.02, 0.05, 0.10, 0.15}) {
      for (double gamma : {10.0, 20.0, 30.0, 40.0, 50.0, 60.0}) {
        for (double place : {0.1, 0.3, 0.5, 0.7, 0.9}) {
          LoopCase c;
          c.m = std::tan(alpha * degree);
          c.x = place * c.l;
          c.f = share * c.l;
          c.gamma = gamma * degree;
          c.q_b = c.S / c.l / 15;
          c.q_T = 1.5 * c.q_b;
          Output o;
          if (!solve(input_of(c), o).ok()) continue;
          const LoopForces e = taut_test::solve_loop(c, {o.H_1, o.H_2, o.H_3, o.H_4});
          if (!e.converged || e.P_b <= 0.05 * c.S) continue;
          worst_lA.push_back(std::abs(o.T_lA / e.T_lA - 1));
          loads.push_back(std::abs(o.P_b_closed / e.P_b - 1));
          ends.push_back(std::abs(o.T_uA / e.T_uA - 1));
          ends.push_back(std::abs(o.T_uB / e.T_uB - 1));
          ends.push_back(std::abs(o.T_lB / e.T_lB - 1));
        }
      }
    }
  }
  const auto share_below = [](const std::vector<double>& v, double limit) {
    return static_cast<double>(std::count_if(v.begin(), v.end(), [&](double e) { return e <= limit; })) /
           static_cast<double>(v.size());
  };
  ASSERT_GT(worst_lA.size(), 600U);
  EXPECT_LT(*std::max_element(worst_lA.begin(), worst_lA.end()), 0.018);
  EXPECT_GT(share_below(ends, 0.015), 0.95);
  EXPECT_GT(share_below(loads, 0.005), 0.95);
}

}  // namespace taut::closed_loop::closed_loop_errata_test
