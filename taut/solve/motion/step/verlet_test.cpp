#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "taut/solve/motion/step/stable.hpp"
#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// The explicit scheme: stable, second order, no energy from nowhere.
namespace taut_test::transient_verlet_test {
namespace {

using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// As long as they are stable, whatever they err; else by the tolerance.
TransientOptions by_verlet(double duration, double tolerance = 1) {
  TransientOptions options = lasting(duration, tolerance);
  options.method = TimeMethod::verlet;
  options.start = Start::settled;
  return options;
}

/// Lines written down 1.6 of Verlet's own steps apart: a short step after each long one would excite what vibrates
/// fastest.
TEST(TransientVerlet, StepsAreEqualBetweenTheLinesWrittenDown) {
  machine::Model m;
  m.gravity = 0;
  m.reevings = {reeve("rope", {anchor("a", {0, 0, 0}), anchor("b", {20.1, 0, 0})}, 20, 0, 1e7)};
  m.reevings[0].mass = 1;
  m.reevings[0].segments = 20;
  m.tensioners.push_back({0, true, smooth_move(0, -1e-3, 0, 1e-3)});
  TransientOptions options = by_verlet(0.4);
  options.start = Start::assembled;
  for (const double lines : {3.8e-4, 4e-4, 4.2e-4}) {
    options.output_step = lines;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_LT(r.ropes[0].T.max, 6e4) << lines;
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover) << lines;
  }
}

/// A load hoisted until a tenth of its rope is left: stiffer and stiffer, so that Verlet's first step is too long.
TEST(TransientVerlet, StaysStableWhereBranchesGetShort) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0.2, 0, -10}, 500, "z"));
  m.reevings.push_back(reeve("hoist", {add_drum(m, "winch", origin, 0.2), anchor_on("load", 0)}, 10, 0, 5e6));
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, 0.5, 0, 0.5)};
  TransientOptions options = by_verlet(18.2);
  options.output_step = 0.1;
  const TransientResult r = run_to_end(m, options);
  const double strain = 500 * 9.81 / 5e6, taken = 0.5 * (18.2 - 0.25);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), taken - 10 * (1 + strain), 0.02);
  EXPECT_LT(r.ropes[0].T.max, 1.3 * 500 * 9.81);
  EXPECT_LT(r.smallest_step, 0.5 * r.stability_limit);
  options.step = 1.01 * r.stability_limit;
  const TransientResult refused = transient(m, options);
  EXPECT_FALSE(refused.outcome.ok());
  EXPECT_NE(refused.outcome.message.find("too long for Verlet"), std::string::npos) << refused.outcome.message;
}

/// The load stands behind its 1.35 m, however long: an explicit friction went back and forth and let it creep.
TEST(TransientVerlet, ABrakeStopsADrumAndHoldsIt) {
  const machine::Model m = braked_load();
  TransientOptions options = by_verlet(2.2, 1e-4);
  options.output_step = 0.1;
  for (const double duration : {2.4, 4.0}) {
    options.duration = duration;
    const TransientResult r = run_to_end(m, options);
    const double way = r.frames.front().bodies[0].position.z() - r.frames.back().bodies[0].position.z();
    EXPECT_NEAR(way, 0.25 + 1 + 0.1, 1e-3) << duration;  // as if the rope were rigid: 5 kN stretch it by 0.6 mm
    EXPECT_EQ(r.frames.back().drums[0].speed, 0) << duration;
    EXPECT_EQ(r.brake_ways.at(0).way, 0) << duration;
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover);
  }
}

/// An Atwood machine of 101.5 and 100 kg, at 0.3 m/s, in a bearing that loses up to 0.04/1.96 of 2015 N, 41 N, at the
/// rim: more than the 15 N that drive it. It comes to rest and stays there.
TEST(TransientVerlet, ABearingThatSticksHolds) {
  machine::Model m;
  m.gravity = 10;
  m.bodies = {body("a", {-0.5, 0, -10}, 101.5, "z"), body("b", {0.5, 0, -10}, 100, "z")};
  machine::Node over = sheave("s", origin, 0.5, 1, 0.96);
  over.inertia = 1;
  m.reevings = {reeve("rope", {anchor_on("a", 0), over, anchor_on("b", 1)}, 20 + M_PI * 0.5 - 2e-3, 0, 1e7)};
  m.reevings[0].damping_ratio = 0.3;
  TransientOptions options = by_verlet(2, 1e-3);
  options.start = Start::assembled;
  options.output_step = 0.1;
  std::array<double, 2> heights{};
  for (const int k : {0, 1}) {
    options.duration = k == 0 ? 4 : 12;
    const TransientResult r = run_to_end(m, options);
    heights[static_cast<std::size_t>(k)] = r.frames.back().bodies[0].position.z();
    EXPECT_EQ(r.frames.back().contacts[0].spin, 0) << k;
  }
  EXPECT_NEAR(heights[1], heights[0], 1e-6);
}

/// A tackle with heavy sheaves, hoisted: they take the rope along by where they turn at the half step.
TEST(TransientVerlet, SheavesWithInertiaGainNoEnergy) {
  machine::Model m = tackle(6, 0.97, 3000);
  m.gravity = 9.81;
  for (machine::Node& node : m.reevings[0].nodes) node.inertia = node.radius > 0 ? 0.4 : 0;
  m.tensioners.push_back({0, true, smooth_move(0, -0.3, 0, 0.5)});
  TransientOptions options = by_verlet(1, 1e-3);
  options.output_step = 0.1;
  const TransientResult r = run_to_end(m, options);
  const auto& energy = r.frames.back().energy;
  EXPECT_LT(std::abs(energy.residual), 1e-5 * energy.turnover);
  options.method = TimeMethod::implicit;
  options.tolerance = 1e-5;
  const TransientResult fine = run_to_end(m, options);
  EXPECT_NEAR(r.ropes[0].T.max / fine.ropes[0].T.max, 1, 0.01);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), fine.frames.back().bodies[0].position.z(), 5e-4);
}

/// A body that falls 1 m into its rope: T = m g + sqrt((m g)^2 + 2 k m g 1 m).
machine::Model jerked(double damping_time = 0) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0, 0, -0.5}, 500, "z"));
  m.reevings.push_back(reeve("rope", {anchor("top", origin), anchor_on("load", 0)}, 1.5, 0, 5e6));
  m.reevings[0].damping_time = damping_time;
  return m;
}

TEST(TransientVerlet, ItsOwnStepFollowsTheTolerance) {
  const double weight = 500 * 9.81, k = 5e6 / 1.5;
  const double T = weight + std::sqrt(weight * weight + 2 * k * weight * 1);
  long before = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    TransientOptions options = by_verlet(0.6, tolerance);
    options.start = Start::assembled;
    options.output_step = 0.01;
    const TransientResult r = run_to_end(jerked(), options);
    EXPECT_LT(std::abs(r.ropes[0].T.max / T - 1), 2 * tolerance) << "a kink may cost as much once more";
    EXPECT_LE(r.open, tolerance);
    EXPECT_LE(r.tension_error, tolerance);
    EXPECT_GT(r.steps, before);
    before = r.steps;
  }
}

/// Its damper goes by the velocity of half a step before: an error of first order that no energy shows.
TEST(TransientVerlet, DampersAgreeWithTheImplicitScheme) {
  TransientOptions options = by_verlet(0.6, 1e-4);
  options.start = Start::assembled;
  options.output_step = 0.01;
  const TransientResult r = run_to_end(jerked(5e-3), options);
  options.method = TimeMethod::implicit;
  options.tolerance = 1e-7;
  const TransientResult fine = run_to_end(jerked(5e-3), options);
  EXPECT_NEAR(r.ropes[0].T.max / fine.ropes[0].T.max, 1, 2e-4);
}

TEST(TransientVerlet, AToleranceOfTooManyStepsIsRefused) {
  TransientOptions options = by_verlet(0.6, 1e-6);
  options.start = Start::assembled;
  options.most_steps = 2000;
  const TransientResult r = transient(jerked(), options);
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_NE(r.outcome.message.find("million steps"), std::string::npos) << r.outcome.message;
  EXPECT_TRUE(r.frames.empty()) << "nothing of what is too coarse";
}

/// What is taken as it goes is all of the motion, once; the result stays small.
TEST(TransientVerlet, BeginsAnewWithShorterSteps) {
  TransientOptions options = by_verlet(0.6, 1e-3);
  options.start = Start::assembled;
  options.output_step = 0.01;
  const TransientResult whole = run_to_end(jerked(), options);
  std::vector<double> times;
  int begun = 0;
  options.anew = [&] {
    ++begun;
    times.clear();
  };
  options.take = [&](const TransientResult& so_far) { times.push_back(so_far.frames.back().t); };
  const TransientResult r = run_to_end(jerked(), options);
  EXPECT_GT(begun, 1);
  ASSERT_EQ(times.size(), whole.frames.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], whole.frames[i].t);
  EXPECT_EQ(r.frames.size(), 2U);
  EXPECT_EQ(r.frames.back().bodies[0].position, whole.frames.back().bodies[0].position);
  EXPECT_EQ(r.ropes[0].T.max, whole.ropes[0].T.max);
}

TEST(TransientVerlet, TheNextStepFollowsFromTheOrderOfTheError) {
  using taut::solve::dynamics::shorter_step;
  TransientOptions options;
  options.duration = options.output_step = 1e9;
  EXPECT_DOUBLE_EQ(shorter_step(options, {}, {1, 16}), 0.8 / 4);
  EXPECT_DOUBLE_EQ(shorter_step(options, {1, 64}, {0.25, 16}), 0.25 * 0.8 / 16) << "of first order";
  EXPECT_DOUBLE_EQ(shorter_step(options, {1, 256}, {0.25, 16}), 0.25 * 0.8 / 4) << "of second order";
  EXPECT_DOUBLE_EQ(shorter_step(options, {1, 4}, {0.5, 16}), 0.5 * 0.8 / 4) << "not below what is known of it";
  EXPECT_DOUBLE_EQ(shorter_step(options, {}, {1, 1.01}), 0.7) << "it has to get shorter";
  EXPECT_DOUBLE_EQ(shorter_step(options, {}, {1, HUGE_VAL}), 0.1);
}

/// Of a step that is given nothing is changed, but its errors are told.
TEST(TransientVerlet, AGivenStepHasItsErrors) {
  TransientOptions options = by_verlet(0.6, 1e-6);
  options.start = Start::assembled;
  options.step = 2e-3;
  const TransientResult r = run_to_end(jerked(), options);
  EXPECT_DOUBLE_EQ(r.largest_step, 2e-3);
  EXPECT_GT(r.tension_error, 1e-3);
  EXPECT_GT(r.open, 1e-6);
}

}  // namespace
}  // namespace taut_test::transient_verlet_test
