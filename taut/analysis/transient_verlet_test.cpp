#include <gtest/gtest.h>

#include "taut/analysis/machines_test.hpp"
#include "taut/analysis/transient.hpp"
#include "taut/analysis/transient_runs_test.hpp"

/// The explicit scheme: stable, second order, no energy from nowhere.
namespace taut_test::transient_verlet_test {
namespace {

using taut::analysis::Start;
using taut::analysis::TimeMethod;
using taut::analysis::transient;
using taut::analysis::TransientOptions;
using taut::analysis::TransientResult;

TransientOptions by_verlet(double duration) {
  TransientOptions options = lasting(duration, 1e-6);
  options.method = TimeMethod::verlet;
  options.start = Start::settled;
  return options;
}

/// Lines written down 1.6 of Verlet's own steps apart: a short step after each long one would excite what vibrates
/// fastest.
TEST(TransientVerlet, StepsAreEqualBetweenTheLinesWrittenDown) {
  model::Model m;
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
  model::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0.2, 0, -10}, 500, "z"));
  m.reevings.push_back(reeve("hoist", {add_drum(m, "winch", origin, 0.2), anchor_on("load", 0)}, 10, 0, 5e6));
  m.drums[0].drive = {model::DriveKind::speed, smooth_move(0, 0.5, 0, 0.5)};
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

/// A tackle with heavy sheaves, hoisted: they take the rope along by where they turn at the half step.
TEST(TransientVerlet, SheavesWithInertiaGainNoEnergy) {
  model::Model m = tackle(6, 0.97, 3000);
  m.gravity = 9.81;
  for (model::Node& node : m.reevings[0].nodes) node.inertia = node.radius > 0 ? 0.4 : 0;
  m.tensioners.push_back({0, true, smooth_move(0, -0.3, 0, 0.5)});
  TransientOptions options = by_verlet(1);
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

}  // namespace
}  // namespace taut_test::transient_verlet_test
