#include "taut/solve/motion/parts/along.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/solve/motion/run/run.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"
#include "test/support/transient_slopes.hpp"

/// Inertia of ropes along themselves against closed forms: machines without gravity, with stiff ropes.
namespace taut::solve::dynamics::along_test {

using namespace taut_test;
using std::numbers::pi;

constexpr double radius = 0.5, per_metre = 6;

machine::Reeving rope_of(const std::vector<machine::Node>& nodes, double length, double stiffness = 4e7) {
  machine::Reeving rope = reeve("rope", nodes, length, 0, stiffness);
  rope.mass = per_metre;
  rope.damping_time = 0.01;
  return rope;
}

machine::Drum winch(double inertia, const machine::Drive& drive) {
  machine::Drum drum;
  drum.name = "winch";
  drum.inertia = inertia;
  drum.drive = drive;
  return drum;
}

machine::Node rim(const std::string& name, const Vector3& at, double inertia, int body = machine::ground) {
  machine::Node round = sheave(name, at, radius, 1, 1, body);
  round.inertia = inertia;
  round.law.friction = 0.5;
  return round;
}

/// What a run says last, its books closed.
TransientFrame last_of(const machine::Model& m, double duration, TimeMethod method = TimeMethod::implicit) {
  TransientOptions options = lasting(duration, 1e-6);
  options.method = method;
  const TransientResult r = run_to_end(m, options);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-5 * r.frames.back().energy.turnover);
  return r.frames.back();
}

/// An endless rope with a motor of given torque at one end.
machine::Model endless(double torque, double span) {
  machine::Model m;
  m.gravity = 9.81;
  machine::Node driven = rim("motor", origin, 40);
  driven.kind = machine::NodeKind::drive;
  driven.motor = 0;
  driven.tension_drop = 0;
  m.motors = {
      {.name = "motor", .drive = {machine::DriveKind::torque, smooth_move(0, torque, 0.1, 0.2)}, .working_arc = {}}};
  m.reevings.push_back(rope_of({driven, rim("tail", {span, 0, 0}, 40)}, 2 * span + 2 * pi * radius - 0.2));
  m.reevings[0].closed = true;
  return m;
}

/// Angular momentum: the impulse of the torque turns both sheaves and all of the rope.
TEST(Along, AnEndlessRopeTakesPartWithAllOfItsMass) {
  constexpr double torque = 3000, span = 200;
  const machine::Model m = endless(torque, span);
  const double rope = per_metre * m.reevings[0].value * radius * radius;
  const TransientFrame last = last_of(m, 1.2);
  const double impulse = torque * (1.2 - 0.2);  // a smooth move of 0.2 s from 0.1 s on is half done at 0.2 s
  for (const auto& contact : last.contacts)
    EXPECT_NEAR(contact.spin, impulse / (80 + rope), 2e-2 * impulse / (80 + rope));
}

/// A force along the rope, here of no size, takes nothing of its mass, nor of what lies on the rounds beside it: those
/// arcs are 12.6 m of 125 m of rope. Half of them was missing, which made it faster by 5 %.
TEST(Along, APlaceOfAForceOnItTakesNothingOfTheRope) {
  constexpr double torque = 3000, R = 4, span = 50;
  const auto run = [&](bool loaded) {
    machine::Model m = endless(torque, span);
    machine::Reeving& loop = m.reevings[0];
    for (machine::Node& node : loop.nodes) node.radius = R;
    loop.value = 2 * span + 2 * pi * R - 0.2;
    if (loaded) {
      machine::Body place = body("cut", {0.3 * span, 0, R}, 0, "xyz");
      place.of_rope = true;
      machine::Node cut = anchor_on("cut", static_cast<int>(m.bodies.size()));
      cut.kind = machine::NodeKind::load;
      cut.load.share = 0.3;
      m.bodies.push_back(place);
      loop.nodes.insert(loop.nodes.begin() + 1, cut);
    }
    return last_of(m, 1.2);
  };
  const double rope = per_metre * (2 * span + 2 * pi * R - 0.2) * R * R, spin = torque / (80 + rope);
  const double without = run(false).contacts[0].spin, with = run(true).contacts[0].spin;
  EXPECT_NEAR(without, spin, 2e-2 * spin);
  EXPECT_NEAR(with, without, 2e-3 * without);
}

/// A winch pulls a body of 300 kg along x over a light sheave that stands.
machine::Model haul(const machine::Drive& drive, double inertia) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("car", {60, 0, 0}, 300, "x")};
  m.drums = {winch(inertia, drive)};
  machine::Node start = sheave("winch", {0, 0, -40}, radius, 1);
  start.drum = 0;
  m.reevings.push_back(rope_of({start, sheave("head", origin, 0.3, 1), anchor_on("car", 0)}, 0));
  m.reevings[0].given = machine::Given::tension_at_end;
  m.reevings[0].value = 500;
  m.loads.push_back({{.body = 0, .at = origin}, {500, 0, 0}});
  return m;
}

TEST(Along, ARopeOverALightSheaveTurnsWithTheDrum) {
  constexpr double torque = 1200, inertia = 30;
  const machine::Drive drive{machine::DriveKind::torque, smooth_move(500 * radius, torque, 0.1, 0.2)};
  const TransientFrame last = last_of(haul(drive, inertia), 0.8);
  // the half of the last branch at the car goes with it, the other three halves with the drum; 1 m comes in meanwhile
  const double rope = per_metre * (60 + 40);
  const double a = (torque / radius - 500) / (300 + inertia / (radius * radius) + rope);
  EXPECT_NEAR(last.bodies[0].acceleration.x(), -a, 2e-2 * a);
}

/// Where a drum's speed is given, the tension on it is that of the branch and what the rope before it takes.
TEST(Along, ADrumPullsTheRopeItself) {
  constexpr double a = 2;
  const machine::Drive drive{machine::DriveKind::speed, smooth_move(0, 2 * a, 0, 2)};
  const TransientFrame last = last_of(haul(drive, 0), 1);  // in the middle of a smooth move, at its steepest
  const double peak = -last.bodies[0].acceleration.x();
  EXPECT_GT(peak, a);
  const double at_car = 500 + (300 + per_metre * 60 / 2) * peak;
  EXPECT_NEAR(last.branches.back().T_to, 500 + 300 * peak, 0.02 * at_car + per_metre * 30 * peak);
  EXPECT_NEAR(last.drums[0].T, 500 + (300 + per_metre * 100) * peak, 0.03 * last.drums[0].T);
}

/// A carriage on a rope between two anchors: the rope stands, so it takes the carriage's mass alone.
TEST(Along, ACarriageRunsAlongAHeldRope) {
  for (const double own : {0.0, 50.0}) {  // a carriage without mass of its own carries the rope's
    machine::Model m;
    m.gravity = 9.81;
    m.bodies = {body("carriage", {30, 0, 0}, own, "x")};
    m.reevings.push_back(
        rope_of({anchor("a", origin), sheave("wheel", origin, 0, 1, 1, 0), anchor("b", {100, 0, 0})}, 99.8));
    m.loads.push_back({{.body = 0, .at = origin}, {20, 0, 0}});
    const TransientFrame last = last_of(m, 0.5);
    const double mass = own > 0 ? own : per_metre * 99.8 / 2;
    EXPECT_NEAR(last.bodies[0].acceleration.x(), 20 / mass, 1e-3 * 20 / mass) << own;
  }
}

/// A carriage without mass of its own goes with what pulls it, as one of a gram does, and takes none of its line along.
TEST(Along, ACarriageWithoutMassGoesWithItsLoad) {
  constexpr double load = 500, pull = 200;
  for (const double own : {0.0, 1e-3}) {
    machine::Model m;
    m.gravity = 9.81;
    m.bodies = {body("carriage", {30, 0, 0}, own, "x"), body("load", {31, 0, 0}, load, "x")};
    m.reevings.push_back(
        rope_of({anchor("a", origin), sheave("wheel", origin, 0, 1, 1, 0), anchor("b", {100, 0, 0})}, 99.8));
    m.reevings.push_back(reeve("tow", {anchor_on("hook", 0), anchor_on("load", 1)}, 1 / (1 + pull / 4e7), 0, 4e7));
    m.reevings[1].damping_time = 0.01;
    m.loads.push_back({{.body = 0, .at = origin}, {-pull, 0, 0}});
    const TransientFrame last = last_of(m, 0.5);
    EXPECT_NEAR(last.bodies[1].acceleration.x(), -pull / load, 1e-3 * pull / load) << own;
    EXPECT_NEAR(last.bodies[0].velocity.x(), -0.5 * pull / load, 1e-3 * pull / load) << own;
  }
}

/// A car that carries its winch pulls itself along a rope to an anchor. Only the car with its half of the rope and the
/// drum have inertia; the rope stands.
TEST(Along, AWinchOnACarDrawsItAlongARopeThatStands) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("car", {80, 0, 0}, 400, "x")};
  constexpr double torque = 600, inertia = 25, hold = 200;
  m.drums = {winch(inertia, {machine::DriveKind::torque, smooth_move(hold * radius, torque, 0.1, 0.2)})};
  m.loads.push_back({{.body = 0, .at = origin}, {hold, 0, 0}});
  machine::Node end = sheave("winch", origin, radius, 1, 1, 0);
  end.drum = 0;
  m.reevings.push_back(rope_of({anchor("a", {0, 0, radius}), end}, 0));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = hold;
  const TransientFrame last = last_of(m, 1);
  const double a = (torque / radius - hold) / (400 + inertia / (radius * radius));
  EXPECT_NEAR(last.bodies[0].acceleration.x(), -a, 3e-2 * a);
}

/// Slack rope has no inertia along itself: what is missing is no more than its tension bears.
TEST(Along, IsBoundByTheTension) {
  LineValues line;
  line.end_T = {100, 100};
  line.surge = {30, -20};
  EXPECT_EQ(tension_of_branch(line, 0), 130);
  EXPECT_EQ(tension_of_branch(line, 1), 120);
  const machine::Model m = endless(3e6, 200);  // the torque would want 60 MN
  const TransientOptions options;
  dynamics::Run run{.model = m, .options = options};
  ASSERT_TRUE(open_run(run));
  Values now = run.before;
  now.spins[0].alpha = 1e6;
  Scheme s = run.scheme;
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    for (const std::size_t end : {0U, 1U}) {
      now.lines[i].end_T[end] = 1000;
    }
    add_surge(run.m, s, run.before, i, now);
    for (const std::size_t end : {0U, 1U}) {
      EXPECT_LE(std::abs(now.lines[i].surge[end]), most_hung * 1000);
      EXPECT_GT(now.lines[i].end_T[end], 0);
    }
    s.at_rest = true;
    now.lines[i].end_T = {1000, 1000};
    add_surge(run.m, s, run.before, i, now);
    EXPECT_EQ(now.lines[i].surge[0], 0);
    s.at_rest = false;
  }
}

/// The steps and the reference integrator solve the same equations.
TEST(Along, IsTheSameInTheReference) {
  const machine::Model m = endless(2000, 50);
  const TransientFrame a = last_of(m, 0.5), b = last_of(m, 0.5, TimeMethod::reference);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_NEAR(a.contacts[k].spin, b.contacts[k].spin, 1e-4 * b.contacts[k].spin);
    EXPECT_NEAR(a.contacts[k].T_in, b.contacts[k].T_in, 1e-4 * b.contacts[k].T_in);
  }
}

/// Rows against differences: how they follow the length of a line and the turning of its direction is left out.
TEST(Along, SlopesAgreeWithDifferences) {
  const auto slope = [](const machine::Model& m, Grip grip, Start start) {
    return worst_slope(m, {.grip = grip, .along = true, .start = start});
  };
  const machine::Model car = haul({machine::DriveKind::torque, smooth_move(100, 200, 0, 1)}, 20);
  EXPECT_LT(slope(car, Grip::equal, Start::assembled), 1e-4);
  EXPECT_LT(slope(endless(500, 50), Grip::forward, Start::assembled), 1e-4);
  EXPECT_LT(slope(endless(500, 50), Grip::stuck, Start::assembled), 1e-4);
  EXPECT_LT(slope(with_carriage(true, 0.1), Grip::forward, Start::settled), 1e-4);
}

}  // namespace taut::solve::dynamics::along_test
