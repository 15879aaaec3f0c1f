#include "taut/methods/closed_loop/closed_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/methods/closed_loop/position.hpp"
#include "test/cases/closed_loop_example.hpp"
#include "test/cases/closed_loop_witness.hpp"
#include "test/cross/closed_loop_tiers.hpp"

// The published closed loop against the engine: what the repaired formulas, the closed form and an independent solution
// give beside exact catenaries.

namespace taut::closed_loop::cross::closed_loop_test {

using namespace taut_test;
using exact_tiers::Solved;
using exact_tiers::solved;

Output exact(const Input& in) {
  const Solved s = solved(in);
  EXPECT_TRUE(s.outcome.ok()) << s.outcome.message;
  EXPECT_TRUE(std::isfinite(s.out.T_lA_exact));
  return s.out;
}

constexpr double within = 0.0005;

TEST(ClosedLoopExact, TheExample) {
  const Output o = exact(example());
  EXPECT_NEAR(o.P_b_exact / kgf, 1166.17, within * 1166.17);
  EXPECT_NEAR(o.T_uB_exact / kgf, 6370.0, within * 6370);
  EXPECT_NEAR(o.T_lB_exact / kgf, 7077.8, within * 7077.8);
  EXPECT_NEAR(o.T_lA_exact / kgf, 8587.9, within * 8587.9);
  EXPECT_NEAR(o.loop_length_exact, 401.999, 0.0005);
  EXPECT_NEAR(o.N_exact, o.P_v_exact, 1e-6);
}

TEST(ClosedLoopExact, TwoSections) {
  Input in = two_section_example();
  Output o = exact(in);
  EXPECT_NEAR(o.P_b_exact / kgf, 1134.84, 0.005);
  EXPECT_NEAR(o.delta_f_exact, 0.980, 0.0005);
  in.position_of = Section::second;
  o = exact(in);
  EXPECT_NEAR(o.P_b_exact / kgf, 1132.88, 0.005);
  EXPECT_NEAR(o.delta_f_exact, 0.981, 0.0005);
  in.sag_of = Section::second;
  o = exact(in);
  EXPECT_NEAR(o.P_b_exact / kgf, 1137.33, 0.005);
  EXPECT_NEAR(o.delta_f_exact, 0.922, 0.0005);
}

struct Band {
  double low = 1e9;
  double high = -1e9;
  void take(double error) {
    low = std::min(low, 100 * error);
    high = std::max(high, 100 * error);
  }
};
struct Bands {
  Band P_b, T_up, T_lA, largest;
};

Bands bands_at(double alpha, double share) {
  Bands b;
  for (const double gamma : {10.0, 20.0, 30.0, 40.0, 50.0, 60.0}) {
    for (const double weight : {0.02, 1.0 / 15, 0.2}) {
      Input in = example();
      in.slope = alpha * degree;
      in.sag = share * in.span;
      in.gathering_angle = gamma * degree;
      in.return_weight = weight * in.gathering_force / in.span;
      in.traction_weight = 1.5 * *in.return_weight;
      const Solved s = solved(in);
      if (!s.outcome.ok() || s.out.P_b_exact <= 0.05 * in.gathering_force) continue;
      const Output& o = s.out;
      b.P_b.take(o.P_b / o.P_b_exact - 1);
      b.T_up.take(o.T_up / (alpha < 0 ? o.T_uA_exact : o.T_uB_exact) - 1);
      b.T_lA.take(o.T_lA_paper / o.T_lA_exact - 1);
      b.largest.take(o.T_up / peaks_of(o).return_rope.tension - 1);
    }
  }
  return b;
}

struct Tabled {
  double alpha, share;
  double P_b_low, P_b_high, T_up_low, T_up_high, T_lA_low, T_lA_high;
};

constexpr double printed = 0.051;  // one decimal of a percent

TEST(ClosedLoopExact, AccuracyOfTheRepairedFormulasAtMidspan) {
  for (const Tabled& t : std::vector<Tabled>{{.alpha = -30,
                         .share = 0.02,
                         .P_b_low = 1.4,
                         .P_b_high = 1.7,
                         .T_up_low = 1.2,
                         .T_up_high = 3.4,
                         .T_lA_low = -2.9,
                         .T_lA_high = -1.2},
                                             {.alpha = -30,
                                             .share = 0.05,
                                             .P_b_low = 3.1,
                                             .P_b_high = 4.3,
                                             .T_up_low = 1.7,
                                             .T_up_high = 8.4,
                                             .T_lA_low = -6.6,
                                             .T_lA_high = -2.3},
                                             {.alpha = -30,
                                             .share = 0.10,
                                             .P_b_low = 7.2,
                                             .P_b_high = 8.4,
                                             .T_up_low = 5.2,
                                             .T_up_high = 16.6,
                                             .T_lA_low = -11.5,
                                             .T_lA_high = -5.6},
                                             {.alpha = -30,
                                             .share = 0.15,
                                             .P_b_low = 9.8,
                                             .P_b_high = 12.3,
                                             .T_up_low = 2.9,
                                             .T_up_high = 24.2,
                                             .T_lA_low = -15.3,
                                             .T_lA_high = -6.1},
                                             {.alpha = -10,
                                             .share = 0.02,
                                             .P_b_low = 0.6,
                                             .P_b_high = 0.7,
                                             .T_up_low = 0.6,
                                             .T_up_high = 1.3,
                                             .T_lA_low = -1.2,
                                             .T_lA_high = -0.8},
                                             {.alpha = -10,
                                             .share = 0.05,
                                             .P_b_low = 1.5,
                                             .P_b_high = 1.7,
                                             .T_up_low = 0.7,
                                             .T_up_high = 2.9,
                                             .T_lA_low = -3.1,
                                             .T_lA_high = -1.8},
                                             {.alpha = -10,
                                             .share = 0.10,
                                             .P_b_low = 2.8,
                                             .P_b_high = 3.3,
                                             .T_up_low = -2.1,
                                             .T_up_high = 4.7,
                                             .T_lA_low = -6.8,
                                             .T_lA_high = -3.0},
                                             {.alpha = -10,
                                             .share = 0.15,
                                             .P_b_low = 4.3,
                                             .P_b_high = 4.7,
                                             .T_up_low = -4.0,
                                             .T_up_high = 5.4,
                                             .T_lA_low = -10.9,
                                             .T_lA_high = -5.7},
                                             {.alpha = 0,
                                             .share = 0.02,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = -0.2,
                                             .T_up_high = -0.1,
                                             .T_lA_low = -0.2,
                                             .T_lA_high = -0.1},
                                             {.alpha = 0,
                                             .share = 0.05,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = -1.0,
                                             .T_up_high = -0.5,
                                             .T_lA_low = -0.9,
                                             .T_lA_high = -0.5},
                                             {.alpha = 0,
                                             .share = 0.10,
                                             .P_b_low = 0,
                                             .P_b_high = 0.1,
                                             .T_up_low = -4.2,
                                             .T_up_high = -2.1,
                                             .T_lA_low = -3.3,
                                             .T_lA_high = -2.1},
                                             {.alpha = 0,
                                             .share = 0.15,
                                             .P_b_low = 0,
                                             .P_b_high = 0.2,
                                             .T_up_low = -9.8,
                                             .T_up_high = -4.5,
                                             .T_lA_low = -6.8,
                                             .T_lA_high = -4.5},
                                             {.alpha = 30,
                                             .share = 0.02,
                                             .P_b_low = -1.7,
                                             .P_b_high = -1.7,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = 2.3,
                                             .T_lA_high = 3.1},
                                             {.alpha = 30,
                                             .share = 0.05,
                                             .P_b_low = -4.3,
                                             .P_b_high = -4.1,
                                             .T_up_low = -0.3,
                                             .T_up_high = -0.3,
                                             .T_lA_low = 4.8,
                                             .T_lA_high = 7.7},
                                             {.alpha = 30,
                                             .share = 0.10,
                                             .P_b_low = -8.4,
                                             .P_b_high = -8.1,
                                             .T_up_low = -1.5,
                                             .T_up_high = -1.0,
                                             .T_lA_low = 6.5,
                                             .T_lA_high = 15.3},
                                             {.alpha = 30,
                                             .share = 0.15,
                                             .P_b_low = -12.3,
                                             .P_b_high = -11.7,
                                             .T_up_low = -3.3,
                                             .T_up_high = -2.1,
                                             .T_lA_low = 5.4,
                                             .T_lA_high = 22.1}}) {
    SCOPED_TRACE(testing::Message() << "alpha " << t.alpha << ", f/l " << t.share);
    const Bands b = bands_at(t.alpha, t.share);
    EXPECT_NEAR(b.P_b.low, t.P_b_low, printed);
    EXPECT_NEAR(b.P_b.high, t.P_b_high, printed);
    EXPECT_NEAR(b.T_up.low, t.T_up_low, printed);
    EXPECT_NEAR(b.T_up.high, t.T_up_high, printed);
    EXPECT_NEAR(b.T_lA.low, t.T_lA_low, printed);
    EXPECT_NEAR(b.T_lA.high, t.T_lA_high, printed);
  }
}

TEST(ClosedLoopExact, AccuracyWhereOnlySomeColumnsAreTabled) {
  for (const Tabled& t : std::vector<Tabled>{{.alpha = -20,
                         .share = 0.02,
                         .P_b_low = 0,
                         .P_b_high = 0,
                         .T_up_low = 0.8,
                         .T_up_high = 2.5,
                         .T_lA_low = -2.2,
                         .T_lA_high = -0.9},
                                             {.alpha = -20,
                                             .share = 0.05,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = 0.5,
                                             .T_up_high = 6.0,
                                             .T_lA_low = -5.2,
                                             .T_lA_high = -1.9},
                                             {.alpha = -20,
                                             .share = 0.10,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = 1.5,
                                             .T_up_high = 11.2,
                                             .T_lA_low = -9.6,
                                             .T_lA_high = -4.1},
                                             {.alpha = -20,
                                             .share = 0.15,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = -3.6,
                                             .T_up_high = 15.4,
                                             .T_lA_low = -13.5,
                                             .T_lA_high = -4.9}}) {
    const Bands b = bands_at(t.alpha, t.share);
    EXPECT_NEAR(b.T_up.low, t.T_up_low, printed);
    EXPECT_NEAR(b.T_up.high, t.T_up_high, printed);
    EXPECT_NEAR(b.T_lA.low, t.T_lA_low, printed);
    EXPECT_NEAR(b.T_lA.high, t.T_lA_high, printed);
  }
  for (const Tabled& t : std::vector<Tabled>{{.alpha = 10,
                         .share = 0.02,
                         .P_b_low = -0.7,
                         .P_b_high = -0.6,
                         .T_up_low = 0,
                         .T_up_high = 0,
                         .T_lA_low = 0.7,
                         .T_lA_high = 1.1},
                                             {.alpha = 10,
                                             .share = 0.05,
                                             .P_b_low = -1.7,
                                             .P_b_high = -1.6,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = 0.8,
                                             .T_lA_high = 2.4},
                                             {.alpha = 10,
                                             .share = 0.10,
                                             .P_b_low = -3.3,
                                             .P_b_high = -3.0,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = -0.9,
                                             .T_lA_high = 3.4},
                                             {.alpha = 10,
                                             .share = 0.15,
                                             .P_b_low = -4.7,
                                             .P_b_high = -4.2,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = -4.4,
                                             .T_lA_high = 2.8}}) {
    const Bands b = bands_at(t.alpha, t.share);
    EXPECT_NEAR(b.P_b.low, t.P_b_low, printed);
    EXPECT_NEAR(b.P_b.high, t.P_b_high, printed);
    EXPECT_NEAR(b.T_lA.low, t.T_lA_low, printed);
    EXPECT_NEAR(b.T_lA.high, t.T_lA_high, printed);
  }
  for (const Tabled& t : std::vector<Tabled>{{.alpha = 20,
                         .share = 0.02,
                         .P_b_low = 0,
                         .P_b_high = 0,
                         .T_up_low = 0,
                         .T_up_high = 0,
                         .T_lA_low = 1.5,
                         .T_lA_high = 2.2},
                                             {.alpha = 20,
                                             .share = 0.05,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = 2.8,
                                             .T_lA_high = 5.3},
                                             {.alpha = 20,
                                             .share = 0.10,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = 2.5,
                                             .T_lA_high = 9.5},
                                             {.alpha = 20,
                                             .share = 0.15,
                                             .P_b_low = 0,
                                             .P_b_high = 0,
                                             .T_up_low = 0,
                                             .T_up_high = 0,
                                             .T_lA_low = -0.3,
                                             .T_lA_high = 12.0}}) {
    const Bands b = bands_at(t.alpha, t.share);
    EXPECT_NEAR(b.T_lA.low, t.T_lA_low, printed);
    EXPECT_NEAR(b.T_lA.high, t.T_lA_high, printed);
  }
}

TEST(ClosedLoopExact, Equation7MissesTheLargestTensionOfTheReturnRope) {
  Band level;
  for (const double share : {0.02, 0.05, 0.10, 0.15}) {
    const Band b = bands_at(0, share).largest;
    level.low = std::min(level.low, b.low);
    level.high = std::max(level.high, b.high);
  }
  EXPECT_NEAR(level.low, -18.8, printed);
  EXPECT_NEAR(level.high, -10.1, printed);
}

TEST(ClosedLoopExact, AgreesWithAnIndependentSolution) {
  for (const double alpha : {-25.0, 0.0, 12.0}) {
    for (const double x : {50.0, 100.0, 140.0}) {
      for (const bool vertical : {false, true}) {
        for (const double d : {0.0, 4.0}) {
          LoopCase c;
          c.m = std::tan(alpha * degree);
          c.x = x;
          c.vertical = vertical;
          c.d = d;
          c.W_c = 250;
          c.S *= kgf;
          c.q_b *= kgf;
          c.q_T *= kgf;
          Input in = example();
          in.slope = alpha * degree;
          in.position = {x};
          in.roller = vertical ? Roller::vertical : Roller::free;
          in.carriage_weight = c.W_c;
          if (d > 0) {
            in.carriage = Carriage::two_section;
            in.section_distance = d;
          }
          const Output o = exact(in);
          const LoopForces w =
              d > 0 ? solve_two_sections(c, {o.H_1, o.H_2 + c.S * std::sin(c.gamma), o.H_2, o.H_3, o.H_4},
                                         c.m * o.x_2 - o.f_2)
                    : solve_loop(c, {o.H_1, o.H_2, o.H_3, o.H_4});
          ASSERT_TRUE(w.converged);
          EXPECT_NEAR(o.P_b_exact, w.P_b, 1e-7 * w.P_b);
          EXPECT_NEAR(o.T_uA_exact, w.T_uA, 1e-7 * w.T_uA);
          EXPECT_NEAR(o.T_lA_exact, w.T_lA, 1e-7 * w.T_lA);
          EXPECT_NEAR(o.T_lB_exact, w.T_lB, 1e-7 * w.T_lB);
          EXPECT_NEAR(o.T_lLB_exact, w.T_lLB, 1e-7 * w.T_lLB);
        }
      }
    }
  }
}

TEST(ClosedLoopExact, Equation1IsTheLimitOfSmallSags) {
  for (const double x : {60.0, 100.0, 150.0}) {
    Input in = example();
    in.position = {x};
    double before = 1;
    for (const double f : {8.0, 2.0, 0.5, 0.125}) {
      in.sag = f;
      const Output o = exact(in);
      const double off = std::abs(o.P_b / o.P_b_exact - 1);
      EXPECT_LT(off, before);
      before = off;
    }
    EXPECT_LT(before, 1e-5);
  }
}

double largest_change(const Output& a, const Output& b) {
  return std::max({std::abs(a.T_uA_exact / b.T_uA_exact - 1), std::abs(a.T_uB_exact / b.T_uB_exact - 1),
                   std::abs(a.T_lA_exact / b.T_lA_exact - 1), std::abs(a.T_lB_exact / b.T_lB_exact - 1)});
}

TEST(ClosedLoopExact, BranchDistanceAndStretchMatterLittleAtAGivenSag) {
  Input in = example();
  const Output plain = exact(in);
  in.branch_distance = 2;
  EXPECT_LT(largest_change(exact(in), plain), 0.002);
  in.branch_distance = 0;
  in.return_stiffness = 1.1e6 * kgf;
  in.traction_stiffness = 1.65e6 * kgf;
  const Output elastic = exact(in);
  EXPECT_LT(largest_change(elastic, plain), 0.001);
  EXPECT_LT(elastic.loop_length_exact, plain.loop_length_exact - 1);

  Input steep = example();
  steep.slope = 25 * degree;
  const Output single = exact(steep);
  steep.branch_distance = 1;
  EXPECT_LT(largest_change(exact(steep), single), 0.002);
  steep.branch_offset = BranchOffset::vertical;
  const Output offset = exact(steep);
  EXPECT_NEAR(largest_change(offset, single), 0.005, 0.002);
  EXPECT_NEAR(std::abs(offset.upper_sag_exact - single.upper_sag_exact), 1 / std::cos(25 * degree) - 1, 0.02);
}

Input by_mode(Mode mode) {
  Input in = example();
  in.sag.reset();
  in.mode = mode;
  return in;
}

double value_of(const Result& r, const char* name) {
  const Value* v = r.find_value(name);
  EXPECT_NE(v, nullptr) << name;
  return v == nullptr ? 0 : v->value;
}

TEST(ClosedLoopExact, EveryModeByCatenaries) {
  Result r = taut::app::run_closed_loop(by_mode(Mode::free_running));
  EXPECT_NEAR(value_of(r, "f"), 22.3, 0.05);
  EXPECT_NEAR(value_of(r, "T_lLB_exact") / kgf, 3000, 1e-6);

  Input in = by_mode(Mode::winch_pull);
  in.winch_pull = 9000 * kgf;
  in.head_efficiency = 0.95;
  r = taut::app::run_closed_loop(in);
  EXPECT_NEAR(value_of(r, "T_lA_exact") / kgf, 0.95 * 9000, 1e-6);

  in = by_mode(Mode::loop_length);
  in.loop_length = 401.999;
  EXPECT_NEAR(value_of(taut::app::run_closed_loop(in), "f"), 10.0, 0.05);
  in.return_stiffness = 1.1e6 * kgf;
  in.traction_stiffness = 1.65e6 * kgf;
  r = taut::app::run_closed_loop(in);
  EXPECT_NEAR(value_of(r, "f"), 13.6, 0.05);
  EXPECT_NEAR(value_of(r, "loop_length_exact"), 401.999, 1e-9);
  in.return_stiffness = 5e5 * kgf;
  in.traction_stiffness = 7.5e5 * kgf;
  EXPECT_NEAR(value_of(taut::app::run_closed_loop(in), "f"), 16.1, 0.05);
  in.loop_length = 390;
  EXPECT_NE(taut::app::run_closed_loop(in).find_value("f"), nullptr);  // the ropes stretch to reach
  in.return_stiffness = in.traction_stiffness = std::numeric_limits<double>::infinity();
  r = taut::app::run_closed_loop(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("390 m is not possible"), std::string::npos) << r.message;
}

TEST(ClosedLoopExact, TwoSectionsInEveryMode) {
  Input in = by_mode(Mode::loop_length);
  in.carriage = Carriage::two_section;
  in.section_distance = 3;
  in.loop_length = exact(two_section_example()).loop_length_exact;
  EXPECT_NEAR(exact(in).f, 10, 1e-6);
}

TEST(ClosedLoopExact, PositionsHaveExactColumns) {
  Input in = by_mode(Mode::loop_length);
  in.loop_length = 402.5;
  in.return_stiffness = in.traction_stiffness = 2e7;
  in.position = {30, 60, 100, 150};
  const Result r = taut::app::run_closed_loop(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const Table* t = r.find_table("positions");
  ASSERT_NE(t, nullptr);
  const auto column = [&](const std::string& name) {
    const auto at = std::find_if(t->columns.begin(), t->columns.end(), [&](const Column& c) { return c.name == name; });
    return static_cast<std::size_t>(at - t->columns.begin());
  };
  EXPECT_EQ(column("reason"), t->columns.size() - 1);
  double largest = 0;
  for (const auto& row : t->rows) {
    ASSERT_EQ(row.size(), t->columns.size());
    EXPECT_NEAR(std::get<double>(row[column("loop_length_exact")]), 402.5, 1e-8);
    for (const char* end : {"T_uA_exact", "T_uB_exact", "T_lA_exact", "T_lB_exact"}) {
      largest = std::max(largest, std::get<double>(row[column(end)]));
    }
  }
  const double worst = std::max(
      {value_of(r, "T_uA_exact"), value_of(r, "T_uB_exact"), value_of(r, "T_lA_exact"), value_of(r, "T_lB_exact")});
  EXPECT_EQ(worst, largest);
}

TEST(ClosedLoopExact, ChosenRopesPassByCatenariesNotByTheClosedForm) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.safety_factor = 3.5;
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = "IWRC", .grade = 1960e6};
  const auto factor = [](const Result& r) { return r.checks.at(0).value; };
  const auto rope = [](const Result& r) { return std::get<std::string>(r.find_table("ropes")->rows.at(0).at(1)); };
  const Result closed = run(in);
  const Result catenaries = taut::app::run_closed_loop(in);
  ASSERT_EQ(rope(closed), rope(catenaries));
  ASSERT_LT(factor(catenaries), factor(closed));
  // a factor that this rope has by the closed form only
  in.safety_factor = (factor(closed) + factor(catenaries)) / 2;
  EXPECT_EQ(rope(run(in)), rope(closed));
  const Result stepped = taut::app::run_closed_loop(in);
  EXPECT_NE(rope(stepped), rope(closed));
  EXPECT_GE(factor(stepped), *in.safety_factor);
}

TEST(ClosedLoopExact, ComparisonsShowTheExactValue) {
  const Result r = taut::app::run_closed_loop(example());
  int exact_ones = 0;
  for (const Comparison& c : r.comparisons) {
    if (!std::isfinite(c.exact)) continue;
    ++exact_ones;
    EXPECT_NEAR(c.corrected, c.exact, 0.002 * c.exact) << c.quantity;
  }
  EXPECT_EQ(exact_ones, 4);
}

TEST(ClosedLoopExact, LiftOffIsRefused) {
  Input in = example();
  in.slope = -30 * degree;
  in.gathering_angle = 60 * degree;
  const Result r = taut::app::run_closed_loop(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_EQ(r.find_value("T_lA_exact"), nullptr);
}

// The rope between the sections holds what is right of it: the return rope and the gathering force. Forces by the
// lengths of a triangle, with the direction of the rope beyond section 2 from its horizontal tension of the closed
// form.
TEST(ClosedLoopExact, TheRopeBetweenTheSections) {
  const Input in = two_section_example();
  const Output o = exact(in);
  const double gamma = in.gathering_angle, S = in.gathering_force;
  const double rise = std::sqrt(o.T_lLB_exact * o.T_lLB_exact - o.H_2 * o.H_2);  // the rope leaves upwards, toward B
  const double T_12 = std::hypot(o.H_2 + S * std::sin(gamma), rise - S * std::cos(gamma));
  EXPECT_NEAR(o.T_12_exact, T_12, 0.002 * T_12);
  EXPECT_NEAR(o.T_12_exact, o.T_12, 0.002 * o.T_12);
  EXPECT_TRUE(std::isnan(exact(example()).T_12_exact));
}

}  // namespace taut::closed_loop::cross::closed_loop_test
