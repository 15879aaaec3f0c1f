#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "test/cases/closed_loop_cases.hpp"

// How far the paper and the closed forms are from catenaries.

namespace taut::closed_loop::closed_loop_witness_test {

using namespace closed_loop_cases;

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
  for (const TabledBand& t : std::vector<TabledBand>{{.alpha = -30, .share = 0.02, .low = 1.4, .high = 1.7},
                                                     {.alpha = -30, .share = 0.05, .low = 3.1, .high = 4.3},
                                                     {.alpha = -30, .share = 0.10, .low = 7.2, .high = 8.4},
                                                     {.alpha = -30, .share = 0.15, .low = 9.8, .high = 12.3},
                                                     {.alpha = -10, .share = 0.02, .low = 0.6, .high = 0.7},
                                                     {.alpha = -10, .share = 0.05, .low = 1.5, .high = 1.7},
                                                     {.alpha = -10, .share = 0.10, .low = 2.8, .high = 3.3},
                                                     {.alpha = -10, .share = 0.15, .low = 4.3, .high = 4.7},
                                                     {.alpha = 0, .share = 0.02, .low = 0, .high = 0},
                                                     {.alpha = 0, .share = 0.05, .low = 0, .high = 0},
                                                     {.alpha = 0, .share = 0.10, .low = 0, .high = 0.1},
                                                     {.alpha = 0, .share = 0.15, .low = 0, .high = 0.2},
                                                     {.alpha = 10, .share = 0.02, .low = -0.7, .high = -0.6},
                                                     {.alpha = 10, .share = 0.05, .low = -1.7, .high = -1.6},
                                                     {.alpha = 10, .share = 0.10, .low = -3.3, .high = -3.0},
                                                     {.alpha = 10, .share = 0.15, .low = -4.7, .high = -4.2},
                                                     {.alpha = 30, .share = 0.02, .low = -1.7, .high = -1.7},
                                                     {.alpha = 30, .share = 0.05, .low = -4.3, .high = -4.1},
                                                     {.alpha = 30, .share = 0.10, .low = -8.4, .high = -8.1},
                                                     {.alpha = 30, .share = 0.15, .low = -12.3, .high = -11.7}}) {
    expect_band("P_b", bands_at(t.alpha, t.share).P_b, t);
  }
}

TEST(ClosedLoopWitness, ErrorOfEquation7AtMidspan) {
  for (const TabledBand& t : std::vector<TabledBand>{{.alpha = -30, .share = 0.02, .low = 1.2, .high = 3.4},
                                                     {.alpha = -30, .share = 0.05, .low = 1.7, .high = 8.4},
                                                     {.alpha = -30, .share = 0.10, .low = 5.2, .high = 16.6},
                                                     {.alpha = -30, .share = 0.15, .low = 2.9, .high = 24.2},
                                                     {.alpha = -20, .share = 0.02, .low = 0.8, .high = 2.5},
                                                     {.alpha = -20, .share = 0.05, .low = 0.5, .high = 6.0},
                                                     {.alpha = -20, .share = 0.10, .low = 1.5, .high = 11.2},
                                                     {.alpha = -20, .share = 0.15, .low = -3.6, .high = 15.4},
                                                     {.alpha = -10, .share = 0.02, .low = 0.6, .high = 1.3},
                                                     {.alpha = -10, .share = 0.05, .low = 0.7, .high = 2.9},
                                                     {.alpha = -10, .share = 0.10, .low = -2.1, .high = 4.7},
                                                     {.alpha = -10, .share = 0.15, .low = -4.0, .high = 5.4},
                                                     {.alpha = 0, .share = 0.02, .low = -0.2, .high = -0.1},
                                                     {.alpha = 0, .share = 0.05, .low = -1.0, .high = -0.5},
                                                     {.alpha = 0, .share = 0.10, .low = -4.2, .high = -2.1},
                                                     {.alpha = 0, .share = 0.15, .low = -9.8, .high = -4.5},
                                                     {.alpha = 30, .share = 0.02, .low = 0, .high = 0},
                                                     {.alpha = 30, .share = 0.05, .low = -0.3, .high = -0.3},
                                                     {.alpha = 30, .share = 0.10, .low = -1.5, .high = -1.0},
                                                     {.alpha = 30, .share = 0.15, .low = -3.3, .high = -2.1}}) {
    expect_band("T_up", bands_at(t.alpha, t.share).T_up, t);
  }
}

TEST(ClosedLoopWitness, ErrorOfEquation9AtMidspan) {
  for (const TabledBand& t : std::vector<TabledBand>{{.alpha = -30, .share = 0.02, .low = -2.9, .high = -1.2},
                                                     {.alpha = -30, .share = 0.05, .low = -6.6, .high = -2.3},
                                                     {.alpha = -30, .share = 0.10, .low = -11.5, .high = -5.6},
                                                     {.alpha = -30, .share = 0.15, .low = -15.3, .high = -6.1},
                                                     {.alpha = -20, .share = 0.02, .low = -2.2, .high = -0.9},
                                                     {.alpha = -20, .share = 0.05, .low = -5.2, .high = -1.9},
                                                     {.alpha = -20, .share = 0.10, .low = -9.6, .high = -4.1},
                                                     {.alpha = -20, .share = 0.15, .low = -13.5, .high = -4.9},
                                                     {.alpha = -10, .share = 0.02, .low = -1.2, .high = -0.8},
                                                     {.alpha = -10, .share = 0.05, .low = -3.1, .high = -1.8},
                                                     {.alpha = -10, .share = 0.10, .low = -6.8, .high = -3.0},
                                                     {.alpha = -10, .share = 0.15, .low = -10.9, .high = -5.7},
                                                     {.alpha = 0, .share = 0.02, .low = -0.2, .high = -0.1},
                                                     {.alpha = 0, .share = 0.05, .low = -0.9, .high = -0.5},
                                                     {.alpha = 0, .share = 0.10, .low = -3.3, .high = -2.1},
                                                     {.alpha = 0, .share = 0.15, .low = -6.8, .high = -4.5},
                                                     {.alpha = 10, .share = 0.02, .low = 0.7, .high = 1.1},
                                                     {.alpha = 10, .share = 0.05, .low = 0.8, .high = 2.4},
                                                     {.alpha = 10, .share = 0.10, .low = -0.9, .high = 3.4},
                                                     {.alpha = 10, .share = 0.15, .low = -4.4, .high = 2.8},
                                                     {.alpha = 20, .share = 0.02, .low = 1.5, .high = 2.2},
                                                     {.alpha = 20, .share = 0.05, .low = 2.8, .high = 5.3},
                                                     {.alpha = 20, .share = 0.10, .low = 2.5, .high = 9.5},
                                                     {.alpha = 20, .share = 0.15, .low = -0.3, .high = 12.0},
                                                     {.alpha = 30, .share = 0.02, .low = 2.3, .high = 3.1},
                                                     {.alpha = 30, .share = 0.05, .low = 4.8, .high = 7.7},
                                                     {.alpha = 30, .share = 0.10, .low = 6.5, .high = 15.3},
                                                     {.alpha = 30, .share = 0.15, .low = 5.4, .high = 22.1}}) {
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

}  // namespace taut::closed_loop::closed_loop_witness_test
