#pragma once
#include <numbers>

#include "taut/methods/closed_loop/closed_loop.hpp"
#include "test/support/solved.hpp"

namespace taut_test {

inline constexpr double kgf = 9.80665;
inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double mm2 = 1e-6;
inline constexpr double kgf_per_mm2 = kgf / mm2;

/// The paper's example: S = 3000 kgf, q_b = 1, q_T = 1.5 kgf/m, l = 200, f = 10, x = 100 m, gamma = 30 deg, alpha = 0,
/// eta = 0.9.
inline taut::closed_loop::Input example() {
  taut::closed_loop::Input in;
  in.span = 200;
  in.position = {100};
  in.sag = 10;
  in.gathering_force = 3000 * kgf;
  in.gathering_angle = 30 * degree;
  in.return_weight = 1 * kgf;
  in.traction_weight = 1.5 * kgf;
  in.tail_efficiency = 0.9;
  return in;
}

/// The same with the two-section carriage, d = 3 m.
inline taut::closed_loop::Input two_section_example() {
  auto in = example();
  in.carriage = taut::closed_loop::Carriage::two_section;
  in.section_distance = 3;
  return in;
}

/// The same, its section points so near each other that they are one carriage, on a slope; and that carriage.
struct NearSections {
  taut::closed_loop::Input two, one;
};

inline NearSections near_sections(double slope) {
  NearSections near{.two = two_section_example(), .one = example()};
  near.two.slope = near.one.slope = slope;
  near.two.section_distance = 1e-4;
  return near;
}

/// Solved, as it must be.
inline taut::closed_loop::Output solved(const taut::closed_loop::Input& in) {
  return solved_as<taut::closed_loop::Output>(in);
}

}  // namespace taut_test
