#pragma once
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"

/// Motions that have to end well, for the tests of motion.
namespace taut_test {

/// From the machine as described. A run that would not end is no test: it is cut off.
inline taut::solve::TransientOptions lasting(double duration, double tolerance, int outputs = 1) {
  taut::solve::TransientOptions options;
  options.duration = duration;
  options.output_step = duration / outputs;
  options.tolerance = tolerance;
  options.most_steps = 2'000'000;
  options.start = taut::solve::Start::assembled;
  return options;
}

/// The same in steps of one size; 0: by their errors.
inline taut::solve::TransientOptions in_steps(double duration, double step, int outputs = 10) {
  taut::solve::TransientOptions options = lasting(duration, 1e-6, outputs);
  options.step = step;
  return options;
}

/// Without inertia, in so many steps.
inline taut::solve::TransientOptions slowly(double duration, int steps,
                                            taut::solve::Start start = taut::solve::Start::settled) {
  taut::solve::TransientOptions options = lasting(duration, 1e-8, steps);
  options.quasi_static = true;
  options.start = start;
  return options;
}

inline taut::solve::TransientResult run_to_end(const taut::machine::Model& m,
                                               const taut::solve::TransientOptions& options) {
  taut::solve::TransientResult r = taut::solve::transient(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  if (r.frames.empty()) r.frames.emplace_back();
  return r;
}

/// From one value to another without a jump of rate or acceleration.
inline taut::machine::Signal smooth_move(double from, double to, double start, double over) {
  taut::machine::Signal s;
  s.law = taut::machine::Moves{
      .from = from, .moves = {{.at = start, .to = to, .over = over, .change = taut::machine::Change::smooth}}};
  return s;
}

/// 1 t lowered at 1 m/s on a drum of 0.2 m with 40 kg m2, so that 2 t move; at 2 s its brake takes 20 kN at the rope
/// against 10 kN: 5 m/s2 for 0.2 s. It goes 0.25 m as it begins, then 1 m, then 0.1 m in the brake, and stands.
inline taut::machine::Model braked_load() {
  taut::machine::Model m;
  m.gravity = 10;
  m.bodies.push_back(body("load", {0.2, 0, -10}, 1000, "z"));
  m.reevings.push_back(reeve("hoist", {add_drum(m, "winch", origin, 0.2), anchor_on("load", 0)}, 10, 0, 1e8));
  m.reevings[0].damping_ratio = 0.3;
  m.drums[0].inertia = 40;
  m.drums[0].brake = taut::machine::Brake{.torque = 4000};
  m.drums[0].drive = {taut::machine::DriveKind::speed, smooth_move(0, -1, 0.5, 0.5)};
  taut::machine::Event brake;
  brake.kind = taut::machine::EventKind::brake;
  brake.at = 2;
  brake.index = 0;
  m.events = {brake};
  return m;
}

/// Place and speed of x'' = a(t, x, x') after `duration`.
inline std::array<double, 2> runge_kutta(double x, double v, double duration,
                                         const std::function<double(double, double, double)>& a) {
  constexpr int steps = 4000;
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const double k1 = a(t, x, v), l1 = v;
    const double k2 = a(t + h / 2, x + h / 2 * l1, v + h / 2 * k1), l2 = v + h / 2 * k1;
    const double k3 = a(t + h / 2, x + h / 2 * l2, v + h / 2 * k2), l3 = v + h / 2 * k2;
    const double k4 = a(t + h, x + h * l3, v + h * k3), l4 = v + h * k3;
    x += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {x, v};
}

}  // namespace taut_test
