#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/paths.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Laws of contacts, drums and breaks against closed forms and other integrations; of the explicit scheme in
/// transient_verlet_test.cpp.
namespace taut_test::transient_laws {
namespace {

using std::numbers::pi;
using taut::solve::ContactState;
using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// Two masses over one round. The tensions settle by the rope's damping; then both move with one acceleration.
machine::Model two_masses(const machine::Node& round, double left, double right) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("left", {-0.2, 0, -20}, left, "z"), body("right", {0.2, 0, -20}, right, "z")};
  m.reevings.push_back(
      reeve("rope", {anchor_on("left", 0), round, anchor_on("right", 1)}, 40 + 0.2 * pi - 0.02, 0, 1e7));
  m.reevings[0].damping_time = 0.01;
  return m;
}

struct Steady {
  double T_in = 0, T_out = 0, a = 0;
  TransientResult result;
};
Steady steady(const machine::Model& m) {
  Steady s;
  s.result = transient(m, lasting(1, 1e-5));
  EXPECT_TRUE(s.result.outcome.ok()) << s.result.outcome.message;
  const auto& last = s.result.frames.back();
  s.T_in = last.branches[0].T_to;
  s.T_out = last.branches[1].T_from;
  s.a = last.bodies[0].acceleration.z();
  EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover);
  return s;
}

TEST(TransientLaws, RopeSlipsOverALockedSheaveByEulersLaw) {
  machine::Node round = sheave("drum", {0, 0, 0}, 0.2, 1, 0);
  round.law.friction = 0.2;
  const Steady s = steady(two_masses(round, 100, 250));
  const double r = std::exp(0.2 * pi), g = 9.81;
  const double a = g * (250 - r * 100) / (250 + r * 100);
  EXPECT_NEAR(s.T_out / s.T_in, r, 1e-5);
  EXPECT_NEAR(s.a, a, 1e-3 * a);
  EXPECT_EQ(s.result.frames.back().contacts[0].state, ContactState::slipping);
  EXPECT_GT(s.result.frames.back().energy.slipped, 0);
}

TEST(TransientLaws, RopeSticksOnALockedSheaveWithinEulersLaw) {
  machine::Node round = sheave("drum", {0, 0, 0}, 0.2, 1, 0);
  round.law.friction = 0.4;  // exp(0.4 pi) = 3.5
  const Steady s = steady(two_masses(round, 100, 250));
  EXPECT_NEAR(s.T_in, 981, 1);  // what is left of the fall into the rope
  EXPECT_NEAR(s.T_out, 2452.5, 1);
  EXPECT_NEAR(s.result.frames.back().bodies[0].velocity.z(), 0, 1e-4);
  EXPECT_EQ(s.result.frames.back().contacts[0].state, ContactState::stuck);
}

TEST(TransientLaws, LightSheaveLosesByItsEfficiency) {
  const Steady s = steady(two_masses(sheave("sheave", {0, 0, 0}, 0.2, 1, 0.95), 100, 250));
  const double g = 9.81, a = g * (250 - 100 / 0.95) / (250 + 100 / 0.95);
  EXPECT_NEAR(s.T_in / s.T_out, 0.95, 1e-7);
  EXPECT_NEAR(s.a, a, 1e-3 * a);
}

/// m1 a = T1 - m1 g, m2 a = m2 g - T2, J a/R^2 = T2 - T1 - (1 - eta)/(1 + eta) (T1 + T2).
TEST(TransientLaws, SheaveWithInertiaAndBearing) {
  machine::Node round = sheave("sheave", {0, 0, 0}, 0.2, 1, 0.95);
  round.inertia = 1.6;
  const Steady s = steady(two_masses(round, 100, 250));
  const double g = 9.81, k = 0.05 / 1.95;
  const double a = g * (250 * (1 - k) - 100 * (1 + k)) / (1.6 / 0.04 + 250 * (1 - k) + 100 * (1 + k));
  EXPECT_NEAR(s.a, a, 1e-3 * a);
  EXPECT_NEAR(s.T_in, 100 * (g + a), 1);
  EXPECT_GT(s.result.frames.back().energy.bearings, 0);
}

/// A sheave with inertia and little grip: it slips at first and is taken along at the bound of the groove.
TEST(TransientLaws, HeavySheaveIsTakenAlongAtTheGroovesBound) {
  machine::Node round = sheave("sheave", {0, 0, 0}, 0.2, 1, 1);
  round.inertia = 40;
  round.law.friction = 0.1;
  const Steady s = steady(two_masses(round, 100, 250));
  EXPECT_NEAR(s.T_out / s.T_in, std::exp(0.1 * pi), 1e-5);
  const auto& contact = s.result.frames.back().contacts[0];
  EXPECT_GT(contact.slip, 0.1);
  EXPECT_NEAR(contact.spin, 0.2 * (s.T_out - s.T_in) / 40, 0.05);  // after one second, less what the start takes
}

TEST(TransientLaws, EndsSwappedGiveTheSameMotion) {
  machine::Node round = sheave("sheave", {0, 0, 0}, 0.2, 1, 0.95);
  round.inertia = 1.6;
  machine::Model m = two_masses(round, 100, 250);
  const Steady one = steady(m);
  std::swap(m.reevings[0].nodes[0], m.reevings[0].nodes[2]);
  m.reevings[0].nodes[1].side = -1;
  const Steady other = steady(m);
  EXPECT_NEAR(one.T_in, other.T_out, 1e-6 * one.T_in);
  EXPECT_NEAR(one.a, other.a, 1e-6);
}

/// A rope that lets go: the wave runs at sqrt(EA/m), behind it the rope recoils with T0/sqrt(EA m).
TEST(TransientLaws, BrokenRopeRecoils) {
  constexpr double EA = 1e7, T0 = 5e4;
  constexpr int n = 200;
  const double c = std::sqrt(EA), length = 100 / (1 + T0 / EA);
  machine::Model m;
  m.gravity = 1e-9;
  m.bodies.push_back(body("end", {100, 0, 0}, 1e-9, "x"));
  m.reevings = {reeve("rope", {anchor("a", {0, 0, 0}), anchor_on("end", 0)}, length, m.gravity, EA),
                reeve("stop", {anchor_on("end", 0), anchor("b", {101, 0, 0})}, 1 / (1 + T0 / 1e9), 0, 1e9)};
  m.reevings[0].segments = n;
  machine::Event lets_go;
  lets_go.kind = machine::EventKind::breaks;
  lets_go.at = 1e-6;
  lets_go.index = 1;
  m.events.push_back(lets_go);
  for (const TimeMethod method : {TimeMethod::verlet, TimeMethod::implicit}) {
    if (taut_test::watched && method == TimeMethod::implicit) continue;
    TransientOptions options = lasting(1e-6, 1e-4);
    options.method = method;
    options.step = method == TimeMethod::implicit ? 1.5e-5 : 0;
    const auto go_on = [&](double duration) {
      options.duration += duration;
      TransientResult result = transient(m, options);
      options.from = result.state;
      options.duration = 0;
      return result;
    };
    // half way the front is in the middle: what lies before it does not know
    const TransientResult half = go_on(length / c / 2);
    ASSERT_TRUE(half.outcome.ok()) << half.outcome.message;
    EXPECT_EQ(half.events.front().what, "break");
    const auto& front = half.state.ropes[0].inside_velocity;
    EXPECT_NEAR(front[n / 2 - 10].x(), 0, 0.2);
    EXPECT_NEAR(-front[n / 2 + 20].x(), 15.811, 1.5);
    const TransientResult at_wall = go_on(length / c / 2);
    ASSERT_TRUE(at_wall.outcome.ok()) << at_wall.outcome.message;
    const auto& inside = at_wall.state.ropes[0].inside_velocity;
    double momentum = at_wall.state.bodies[0].velocity.x() * length / n / 2;
    for (const Vector3& v : inside) momentum += v.x() * length / n;
    EXPECT_NEAR(-momentum, T0 * length / c, 0.01 * 1581.1);
    EXPECT_NEAR(-inside[n / 2].x(), T0 / std::sqrt(EA), 0.01 * 15.811);
    EXPECT_LT(std::abs(at_wall.frames.back().energy.residual), 0.01 * at_wall.frames.back().energy.turnover);
    const TransientResult after = go_on(0.2 * length / c);
    ASSERT_TRUE(after.outcome.ok()) << after.outcome.message;
    double largest = 0;
    for (const auto& branch : after.frames.back().branches) {
      if (branch.reeving == 0) largest = std::max(largest, branch.T_from);
    }
    EXPECT_LT(largest, 0.01 * T0);
  }
}

/// A block on falls that are nearly parallel swings with hardly any stretch: the damping is that of its bounce.
TEST(TransientLaws, TheDampingRatioIsThatOfAModeThatStretches) {
  for (const double aside : {0.0, 0.25, 0.4}) {
    machine::Model m = tackle(2, 1, 3000);
    m.reevings[0].damping_ratio = 0.02;
    m.reevings[0].nodes.back().at.at.x() += aside;
    TransientOptions options = lasting(0.1, 1e-4);
    options.start = Start::settled;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto stiffness = [&](std::size_t branch) {  // of a fall with half of the rope on the round at either end
      double length = r.frames[0].branches[branch].unstretched;
      for (const auto& contact : r.frames[0].contacts) {
        const auto node = static_cast<std::size_t>(contact.node);
        if (node == branch || node == branch + 1) length += m.reevings[0].nodes[node].radius * contact.wrap / 2;
      }
      return 1e7 / length;
    };
    const double bounce = std::sqrt((stiffness(1) + stiffness(2)) / 3000);
    EXPECT_NEAR(r.frequency[0] / bounce, 1, 2e-3) << aside;
    EXPECT_NEAR(r.damping_time[0], 0.04 / r.frequency[0], 1e-12);
  }
}

/// Rope on rounds stretches as it does at rest: a block that bounces, damped, ends where the equilibrium has it.
TEST(TransientLaws, ATackleEndsAtTheEquilibriumOfItsStatics) {
  machine::Model m = tackle(8, 1, 3000);
  m.bodies[0] = body("block", {0, 0, 5.7}, 3000, "z");
  m.reevings[0].damping_time = 0.05;
  TransientOptions options = lasting(3, 1e-6, 2);
  options.start = Start::assembled;
  const TransientResult moved = transient(m, options);
  options.start = Start::settled;
  const TransientResult still = transient(m, options);
  ASSERT_TRUE(moved.outcome.ok() && still.outcome.ok()) << moved.outcome.message << still.outcome.message;
  const auto &end = moved.frames.back(), &rest = still.frames.front();
  EXPECT_GT(std::abs(moved.frames.front().branches[0].T_from / rest.branches[0].T_from - 1), 0.05);
  EXPECT_NEAR(end.bodies[0].position.z(), rest.bodies[0].position.z(), 1e-7);
  EXPECT_NEAR(end.branches[4].T_from / rest.branches[4].T_from, 1, 1e-6);
  // a rise of its load by 10 % stretches all of the rope, with what lies on the rounds
  m.bodies[0].mass = 3300;
  const double lower = transient(m, options).frames.front().bodies[0].position.z();
  double arcs = 0, free = 0;
  for (const auto& contact : rest.contacts) arcs += 0.25 * contact.wrap;
  for (const auto& branch : rest.branches) free += branch.stretched;
  const double T = rest.branches[4].T_from;
  EXPECT_NEAR((rest.bodies[0].position.z() - lower) * 8 / ((arcs + free) * 0.1 * T / 1e7), 1, 0.01);
}

/// A belt begins with the same tension as described and at rest.
TEST(TransientLaws, ABeltHasOneTensionAssembledAndSettled) {
  machine::Model m;
  m.gravity = 9.81;
  machine::Node left = sheave("left", {0, 0, 0}, 0.3, 1), right = sheave("right", {5, 0, 0}, 0.3, 1);
  left.kind = machine::NodeKind::drive;
  left.motor = 0;
  m.motors.resize(1);
  right.inertia = 1;
  m.reevings.push_back(reeve("belt", {left, right}, (10 + 2 * pi * 0.3) / (1 + 800 / 2e5), 0, 2e5));
  m.reevings[0].closed = true;
  for (const Start start : {Start::assembled, Start::settled}) {
    TransientOptions options = lasting(0.01, 1e-6, 1);
    options.start = start;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    for (const auto& branch : r.frames.front().branches) EXPECT_NEAR(branch.T_from, 800, 1e-6);
  }
}

/// A drum that takes in at 0.5 m/s; the strained rope that lies on it counts unstretched. The load hangs still.
TEST(TransientLaws, DrumTakesInByTheLayer) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0.21, 0, -10}, 1000, "z"));
  m.reevings.push_back(reeve("hoist", {add_drum(m, "winch", origin, 0.21), anchor_on("load", 0)}, 10, 0, 1e6));
  m.reevings[0].damping_time = 0.02;
  m.reevings[0].diameter = 0.02;
  machine::Drum& winch = m.drums[0];
  winch.core_radius = 0.2;  // the rope's middle lies a radius of its own farther out
  winch.automatic_layers = true;
  winch.width = 0.1;
  winch.pitch = 0.024;
  winch.layer_height = 0.017;
  winch.length_on_drum = 5;
  winch.drive = {machine::DriveKind::speed, smooth_move(0, 0.5, 0, 1)};
  TransientOptions options = lasting(8, 1e-4);
  options.start = Start::settled;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double taken = 0.5 * 7.5, strain = 9810 / 1e6;
  const auto& last = r.frames.back();
  EXPECT_NEAR(last.on_drums[0].content - 5, taken / (1 + strain), 2e-4);
  EXPECT_EQ(last.on_drums[0].layer, 2);
  EXPECT_NEAR(last.drums[0].T, 9810, 1);
  EXPECT_NEAR(last.drums[0].torque, 9810 * 0.227, 1);
  EXPECT_NEAR(last.drums[0].power, 9810 * 0.5, 1);
  EXPECT_NEAR(last.bodies[0].velocity.z(), 0.5, 1e-3);
  const auto layer = std::find_if(r.events.begin(), r.events.end(), [](const auto& e) { return e.what == "layer"; });
  ASSERT_NE(layer, r.events.end());
  // four turns in the first layer, each the helix of statics; 0.25 m in the first second
  const double full = 4 * std::hypot(2 * std::numbers::pi * 0.21, 0.024);
  EXPECT_NEAR(layer->t, 1 + ((full - 5) * (1 + strain) - 0.25) / 0.5, 2e-3);
}

/// A heavy rope is wound on a drum and let out by a tensioner at its other end: its weight goes with it.
TEST(TransientLaws, TheLedgerClosesWithAHeavyRopeOnADrum) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {3, 0, -20}, 100, "xz"));
  const machine::Node winch = add_drum(m, "winch", {0, 0, 2}, 0.25);
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, 2, 0, 1)};
  m.reevings.push_back(reeve("rope", {winch, anchor_on("load", 0)}, 0, 40, 1e7));
  m.reevings.push_back(reeve("guide", {anchor("pin", {8, 0, 3}), anchor_on("load", 0)}, 0, 15, 1e7));
  for (machine::Reeving& rope : m.reevings) {
    rope.given = machine::Given::tension_at_start;
    rope.value = 1000;
  }
  m.tensioners.push_back({1, true, smooth_move(0, 0.5, 0, 2)});
  TransientOptions options = lasting(4, 1e-7);
  options.step = 2e-4;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const auto& energy = r.frames.back().energy;
  EXPECT_GT(r.frames.front().branches[0].unstretched - r.frames.back().branches[0].unstretched, 5);
  EXPECT_LT(std::abs(energy.residual), 1e-5 * energy.turnover);
}

/// A mass falls into a slack rope and comes back: no push, and the events in order.
TEST(TransientLaws, SlackRopeNeverPushes) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, -9}, 100, "z"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("mass", 0)}, 10, 0, 1e6));
  m.reevings[0].damping_time = 0.005;
  TransientOptions options = lasting(1.2, 1e-6);
  options.output_step = 0.01;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  ASSERT_GE(r.events.size(), 2U);
  EXPECT_EQ(r.events[0].what, "taut");
  EXPECT_NEAR(r.events[0].t, std::sqrt(2 / 9.81), 1e-5);
  EXPECT_EQ(r.events[1].what, "slack");
  EXPECT_GE(r.ropes[0].T.min, 0);
  EXPECT_GT(r.ropes[0].T.max, 5000);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover);
}

/// A load that swings below a locked drum: the rope winds on and off its rim, by the angle.
TEST(TransientLaws, SwingingLoadWindsOnALockedDrum) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {4, 0, -3}, 500, "xz"));
  machine::Node drum = add_drum(m, "winch", origin, 0.5);
  for (const int side : {1, -1}) {
    drum.side = side;
    m.reevings = {reeve("rope", {drum, anchor_on("load", 0)}, 5, 0, 1e8)};
    m.reevings[0].given = machine::Given::tension_at_start;
    m.reevings[0].value = 3000;
    TransientOptions options = lasting(2, 1e-4);
    options.output_step = 0.02;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto angle = [](const auto& branch) {
      const Vector3 d = branch.end - branch.start;
      return std::atan2(-d.x(), -d.z());  // about y
    };
    const auto& first = r.frames.front().branches[0];
    for (const auto& frame : r.frames) {
      const auto& branch = frame.branches[0];
      const double turned = side * std::remainder(angle(branch) - angle(first), 2 * pi);
      EXPECT_NEAR(branch.unstretched - first.unstretched, -0.5 * turned, 2e-4);
    }
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-6 * r.frames.back().energy.turnover);
  }
}

TEST(TransientLaws, ARunIntoTheBlocksIsToldWithItsTime) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {0, 0, -2}, 100, "z"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("load", 0)}, 2, 0, 1e6));
  machine::Signal in;
  in.law = machine::Moves{0, {{0, -2, 1, machine::Change::linear}}};
  m.tensioners.push_back({0, true, in});
  const TransientResult r = transient(m, lasting(2, 1e-3));
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_NE(r.outcome.message.find("t = "), std::string::npos) << r.outcome.message;
  EXPECT_GT(r.t_end, 0.5);
  EXPECT_LE(r.t_end, 1.1);
  EXPECT_EQ(r.frames.back().t, r.t_end);
}

}  // namespace
}  // namespace taut_test::transient_laws
