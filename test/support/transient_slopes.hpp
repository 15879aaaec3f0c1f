#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "taut/solve/motion/run/run.hpp"

/// The derivatives of a step of motion against differences, for the tests of all that adds to them.
namespace taut_test {

struct SlopesAt {
  taut::solve::Branches branches = taut::solve::Branches::straight;
  /// Of every contact between two lines; what ends on a drum is stuck.
  taut::solve::dynamics::Grip grip = taut::solve::dynamics::Grip::equal;
  int turns = 0;       ///< of every bearing, the sense in which it slides; 0: it sticks
  double speed = 0.1;  ///< of every freedom, up to this, m/s, 1/s
  bool still = false;  ///< nothing moves nor slips
  bool along = false;  ///< with the inertia of ropes along themselves
  taut::solve::Start start = taut::solve::Start::settled;
  int dice = 3;
};

/// Somewhere in a step of a motion from the settled state: nothing of it is a solution.
struct SlopesOfAStep {
  taut::solve::TransientOptions options;
  taut::solve::dynamics::Run run;
  taut::solve::dynamics::Scheme s{};
  taut::solve::dynamics::Values now{};
  std::vector<char> is_flow{};
  int turns = 0;
  bool opened = false;

  static taut::solve::TransientOptions options_of(const SlopesAt& at) {
    taut::solve::TransientOptions options;
    options.duration = 1;
    options.branches = at.branches;
    options.start = at.start;
    return options;
  }

  SlopesOfAStep(const taut::machine::Model& m, const SlopesAt& at)
      : options(options_of(at)), run{.model = m, .options = options}, turns(at.turns) {
    opened = taut::solve::dynamics::open_run(run);
    if (opened) begin(at);
  }

  void begin(const SlopesAt& at) {
    for (auto& contact : run.m.contacts) contact.mass = 0;  // the thrust's rate is left out of every tangent
    for (auto& line : run.m.lines) {
      if (at.along) continue;
      line.has_along = false;
      line.rim = line.held = {false, false};
    }
    s = run.scheme;
    s.h = s.reach = 0.02;
    s.slip_now = 1 / s.h;
    s.slip_before = 0;
    std::mt19937 dice(static_cast<unsigned>(at.dice));
    std::uniform_real_distribution<double> by(-1, 1);
    for (double& rate : run.before.nu) rate = at.still ? 0 : at.speed * by(dice);
    for (auto& contact : run.before.contacts) contact.winding = contact.lambda;
    begin_step(run.m, s, run.before, run.w);
    now = run.before;
    for (double& rate : now.rate) rate = at.still ? 0 : 2 * by(dice);
    is_flow.assign(now.q.size(), 0);
    for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
      const auto c = static_cast<std::size_t>(run.m.contacts[i].column);
      const bool passes = run.m.contacts[i].in >= 0 && run.m.contacts[i].out >= 0;
      is_flow[c] = 1;
      now.q[c] = run.before.q[c] + (at.still ? 0 : 1e-3 * by(dice));
      now.contacts[i].grip = passes ? at.grip : taut::solve::dynamics::Grip::stuck;
    }
    turn_nothing();
    for (int once = 0; once < 3; ++once) go_with_rims();
  }

  /// At no rotation in the step its vector is the turn itself.
  void turn_nothing() {
    for (const auto& body : run.m.bodies) {
      for (int f = 0; f < body.count && body.turns; ++f) {
        const auto c = static_cast<std::size_t>(body.first) + static_cast<std::size_t>(f);
        run.w.q_star[c] = run.before.q[c] - s.reach * (run.w.nu_star[c] + s.reach * now.rate[c]);
      }
    }
  }

  /// What sticks goes with its rim: its row has a scale of its own, which changes.
  void go_with_rims() {
    EXPECT_TRUE(follow(run.m, s, run.before, run.w, s.h, now));
    for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
      if (now.contacts[i].grip != taut::solve::dynamics::Grip::stuck) continue;
      const auto c = static_cast<std::size_t>(run.m.contacts[i].column);
      now.q[c] = run.before.contacts[i].slipped + run.w.q_star[c] + s.reach * now.contacts[i].roll_rate;
    }
  }

  std::vector<double> residual(std::size_t column, double change) {
    taut::solve::dynamics::Values v = now;
    if (change != 0) (is_flow[column] ? v.q : v.rate)[column] += change;
    EXPECT_TRUE(follow(run.m, s, run.before, run.w, s.h, v));
    for (std::size_t i = 0; i < v.spins.size(); ++i) {
      v.spins[i].turns = static_cast<std::int8_t>(turns);
      v.spins[i].capacity = 0;
      for (const auto& one : run.m.spins[i].contacts) {
        const auto& of = run.m.contacts[static_cast<std::size_t>(one.first)];
        v.spins[i].capacity += bearing_slope(run.m, of, run.before, v).capacity;
      }
    }
    assemble(run.m, s, run.before, v, run.w);
    return run.w.residual;
  }
};

/// The largest difference between the tangent and what a step's residual does, as a share of its row's largest entry.
inline double worst_slope(const taut::machine::Model& m, const SlopesAt& at = {}) {
  SlopesOfAStep step(m, at);
  if (!step.opened) return INFINITY;
  step.residual(0, 0);
  const std::vector<double> tangent = step.run.m.solver.dense();
  const std::size_t n = step.now.q.size();
  double worst = 0;
  for (std::size_t c = 0; c < n; ++c) {
    const double by = step.is_flow[c] ? 1e-6 : 1e-3;
    const auto more = step.residual(c, by), less = step.residual(c, -by);
    for (std::size_t r = 0; r < n; ++r) {
      double largest = 0;
      for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(tangent[r * n + k]));
      worst = std::max(worst, std::abs((more[r] - less[r]) / (2 * by) - tangent[r * n + c]) / largest);
    }
  }
  return worst;
}

}  // namespace taut_test
