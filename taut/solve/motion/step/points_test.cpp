#include "taut/solve/motion/step/points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Verlet's steps of points side by side are the same as one by one.
namespace taut_test::points_test {
namespace {

using taut::solve::TimeMethod;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// Chains of two and of one copy, a rope in one piece with weight, a rope that breaks, one between two bodies, and a
/// body that nothing holds.
machine::Model many_ropes(double damping_time) {
  machine::Model m;
  m.bodies.push_back(body("load", {0.3, 0.2, -20}, 400, "xyz"));
  m.bodies.push_back(body("weight", {4, -1, -30}, 150, "xyz"));
  m.bodies.push_back(body("stone", {50, 0, 0}, 3, "xyz"));
  m.reevings.push_back(reeve("left", {anchor("a", {-15, 0, 0}), anchor_on("load", 0)}, 24.8, 6, 4e6));
  m.reevings.push_back(reeve("right", {anchor_on("load", 0, {0.1, 0, 0.2}), anchor("b", {15, 0, 1})}, 25.2, 9, 6e6));
  m.reevings.push_back(reeve("between", {anchor_on("load", 0), anchor_on("weight", 1)}, 10.9, 3, 2e6));
  m.reevings.push_back(reeve("tag", {anchor_on("weight", 1), anchor("c", {20, -10, -30})}, 18.2, 4, 1e6));
  m.reevings[0].segments = 7;
  m.reevings[0].copies = 2;
  m.reevings[2].segments = 3;
  m.reevings[3].segments = 5;
  for (machine::Reeving& rope : m.reevings) rope.damping_time = damping_time;
  machine::Event breaks;
  breaks.kind = machine::EventKind::breaks;
  breaks.index = 1;
  breaks.at = 0.7;
  m.events.push_back(breaks);
  return m;
}

/// A condition that never comes true: every step is taken by itself and looked at.
machine::Event never() {
  machine::Event event;
  event.when = machine::Condition{};
  event.when->of.quantity = machine::Observed::x;
  event.when->of.index = 2;
  event.when->threshold = 1e9;
  return event;
}

void expect_same(const TransientFrame& one, const TransientFrame& other) {
  for (std::size_t b = 0; b < one.bodies.size(); ++b) {
    EXPECT_LT((one.bodies[b].position - other.bodies[b].position).norm(), 1e-9) << one.t;
    EXPECT_LT((one.bodies[b].velocity - other.bodies[b].velocity).norm(), 1e-6) << one.t;
  }
  for (std::size_t i = 0; i < one.branches.size(); ++i) {
    EXPECT_NEAR(one.branches[i].T_from, other.branches[i].T_from, 1e-3) << one.t;  // of some 5 kN
    EXPECT_NEAR(one.branches[i].T_to, other.branches[i].T_to, 1e-3) << one.t;
  }
  EXPECT_NEAR(one.energy.kinetic, other.energy.kinetic, 1e-7 * one.energy.turnover);
  // one by one the dampers' work is booked by the velocities at the ends of the step, here by the strains there
  EXPECT_NEAR(one.energy.damped, other.energy.damped, 1e-3 * (one.energy.turnover + 1e-6));
  EXPECT_NEAR(one.energy.residual, 0, 1e-3 * (one.energy.turnover + 1e-6));
}

TEST(TransientPoints, StepsSideBySideAreTheSameAsOneByOne) {
  for (const double damping_time : {0.0, 2e-4}) {
    machine::Model m = many_ropes(damping_time);
    m.observed.push_back(
        {.name = "left[1].T", .quantity = machine::Observed::branch_T, .unit = taut::si::N, .index = 0, .part = 0});
    TransientOptions options = lasting(0.9, 1, 9);  // later, rounding has grown: slack chains swing by chance
    options.method = TimeMethod::verlet;
    options.step = 1e-4;
    const TransientResult together = run_to_end(m, options);
    m.events.push_back(never());
    const TransientResult one_by_one = run_to_end(m, options);
    EXPECT_EQ(together.steps, one_by_one.steps);
    ASSERT_EQ(together.frames.size(), one_by_one.frames.size());
    for (std::size_t i = 0; i < together.frames.size(); ++i) expect_same(together.frames[i], one_by_one.frames[i]);
    for (std::size_t r = 0; r < m.reevings.size(); ++r) {
      EXPECT_NEAR(together.ropes[r].T.max, one_by_one.ropes[r].T.max, 1e-3);
      EXPECT_NEAR(together.ropes[r].T.min, one_by_one.ropes[r].T.min, 1e-3);
      EXPECT_EQ(together.ropes[r].branch, one_by_one.ropes[r].branch);
    }
    EXPECT_NEAR(together.tension_error, one_by_one.tension_error, 1e-6);
    EXPECT_NEAR(together.extremes[0].max, one_by_one.extremes[0].max, 1e-3);
    EXPECT_NEAR(together.extremes[0].min, one_by_one.extremes[0].min, 1e-3);
    EXPECT_NEAR(together.extremes[0].t_max, one_by_one.extremes[0].t_max, 1e-9);
    EXPECT_LT(together.extremes[0].t_min, 1000 * options.step) << "within the first steps taken at once";
    EXPECT_EQ(together.events.size(), one_by_one.events.size());
    EXPECT_GT(together.events.size(), 2U);  // it breaks, ropes get slack
    const auto& stone = together.frames.back().bodies[2];
    EXPECT_NEAR(stone.position.z(), -m.gravity * 0.9 * 0.9 / 2, 1e-9);
  }
}

}  // namespace
}  // namespace taut_test::points_test
