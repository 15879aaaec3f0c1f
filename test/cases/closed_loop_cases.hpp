#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "taut/methods/closed_loop/closed_loop.hpp"
#include "test/cases/closed_loop_witness.hpp"

// The method and its witness on the same cases.

namespace taut::closed_loop::closed_loop_cases {

using taut_test::LoopCase;
using taut_test::LoopForces;
inline constexpr double degree = std::numbers::pi / 180;

/// The library's input for a witness case (any coherent unit of force).
inline Input input_of(const LoopCase& c) {
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

inline Output solved(const LoopCase& c) {
  Output out;
  const Outcome o = solve(input_of(c), out);
  EXPECT_TRUE(o.ok()) << o.message;
  return out;
}

inline LoopForces exact(const LoopCase& c, const Output& start) {
  const LoopForces e = c.d > 0
                           ? taut_test::solve_two_sections(
                                 c, {start.H_1, start.H_2 + c.S * std::sin(c.gamma), start.H_2, start.H_3, start.H_4},
                                 c.m * start.x_2 - start.f_2)
                           : taut_test::solve_loop(c, {start.H_1, start.H_2, start.H_3, start.H_4});
  EXPECT_TRUE(e.converged);
  return e;
}

inline std::vector<LoopCase> assorted() {
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
inline double lower_branch_H2(const LoopCase& c, double P, double K, double P_b) {
  const double cos_a = std::cos(std::atan(c.m));
  const double w_b = c.q_b / cos_a;
  const double w_T = c.q_T / cos_a;
  const double y = c.l - c.x;
  const double reaction_B = ((P - P_b) * c.x - K * c.f * cos_a + w_T * c.x * c.x / 2 + w_b * y * (c.x + y / 2)) / c.l;
  return (reaction_B * y - w_b * y * y / 2) / c.f;
}

}  // namespace taut::closed_loop::closed_loop_cases
