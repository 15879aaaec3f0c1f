#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Drums whose drive gives their rope a pull.
namespace taut_test::transient_pull {
namespace {

using taut::solve::Start;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double g = 9.81;

/// 100 kg on a winch that pulls with 1.2 times its weight.
machine::Model pulled(double inertia) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("load", {0.3, 0, -10}, 100, "z"));
  machine::Node drum = anchor("winch", {0, 0, 0});
  drum.radius = 0.3;
  drum.drum = 0;
  drum.side = 1;
  m.reevings.push_back(reeve("hoist", {drum, anchor_on("load", 0)}, 10, 0, 1e7));
  m.reevings[0].damping_time = 1e-3;
  machine::Drum winch;
  winch.name = "winch";
  winch.core_radius = 0.29;
  winch.inertia = inertia;
  winch.drive.kind = machine::DriveKind::pull;
  winch.drive.signal.law = 1.2 * 100 * g;
  m.drums.push_back(winch);
  return m;
}

TransientOptions until(double end) {
  TransientOptions o;
  o.duration = end;
  o.output_step = end / 50;
  o.tolerance = 1e-5;
  o.start = Start::assembled;
  return o;
}

/// The rope has the tension whatever the drum's inertia: the load goes up with 0.2 g, all that is supplied is work of
/// the pull, and nothing is lost on the drum.
TEST(TransientPull, InertiaOfTheDrumDoesNotCount) {
  for (const double inertia : {0.0, 30.0}) {
    SCOPED_TRACE(inertia);
    const TransientResult r = run_to_end(pulled(inertia), until(1));
    const TransientFrame& end = r.frames.back();
    EXPECT_NEAR(end.bodies[0].velocity.z(), 0.2 * g, 2e-3);
    EXPECT_NEAR(end.drums[0].T, 1.2 * 100 * g, 1e-6);
    EXPECT_NEAR(end.drums[0].speed, 0.2 * g, 4e-3);
    EXPECT_NEAR(end.energy.kinetic, 100 * std::pow(0.2 * g, 2) / 2, 0.4);
    EXPECT_NEAR(end.energy.supplied, 1.2 * 100 * g * 0.1 * g, 0.002 * 1.2 * 100 * g);
    EXPECT_NEAR(end.energy.slipped, 0, 0.01);
    EXPECT_NEAR(end.energy.residual, 0, 1e-3 * end.energy.turnover);
  }
}

/// From a pull to a torque: the drum goes on as its rope went, without a snatch.
TEST(TransientPull, ADrumThatLetsGoOfItsPullTurnsWithItsRope) {
  machine::Model m = pulled(3);
  machine::Event event;
  event.words = "torque";
  event.kind = machine::EventKind::drive;
  event.at = 0.5;
  event.index = 0;
  event.drive.kind = machine::DriveKind::torque;
  event.drive.signal.law = 100 * g * 0.3;
  m.events.push_back(event);
  const TransientResult r = run_to_end(m, until(1));
  const TransientFrame& end = r.frames.back();
  EXPECT_NEAR(end.bodies[0].velocity.z(), 0.2 * g * 0.5, 0.02);  // goes on at its speed: the torque holds the load
  EXPECT_NEAR(end.drums[0].speed, 0.2 * g * 0.5, 0.02);
  EXPECT_NEAR(end.energy.residual, 0, 1e-3 * end.energy.turnover);
  EXPECT_GE(end.energy.slipped, -1e-6);
}

/// A shaft is far deeper than the machine is large where the motion begins.
TEST(TransientPull, ALoadIsLoweredMoreThanAThousandTimesItsFirstRope) {
  machine::Model m = pulled(0);
  m.bodies[0].position.z() = -0.5;
  m.reevings[0].value = 0.5;
  m.drums[0].drive.kind = machine::DriveKind::speed;
  m.drums[0].drive.signal = smooth_move(0, -20, 0, 10);
  const TransientResult r = run_to_end(m, lasting(65, 1e-3));
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), -0.5 - 20 * (65 - 5), 1);
}

}  // namespace
}  // namespace taut_test::transient_pull
