#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Forces along a running rope: against hand-written equations of one unknown, against the closed form of a belt, and
/// against the same machine without them.
namespace taut_test::transient_rope_load_test {
namespace {

using std::numbers::pi;
using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double g = 9.81;

/// A node of kind load with its body.
machine::Node load_on(machine::Model& m, const std::string& name, double share, double force, const Vector3& at) {
  machine::Body place = body(name, at, 0, "xyz");
  place.of_rope = true;
  machine::Node node = anchor_on(name, static_cast<int>(m.bodies.size()));
  node.kind = machine::NodeKind::load;
  node.load.share = share;
  node.load.force = force;
  m.bodies.push_back(place);
  return node;
}

double smoothed(double x) { return x <= 0 ? 0 : x >= 1 ? 1 : x * x * x * (10 - 15 * x + 6 * x * x); }

/// A mass on a rope 10 m long below a fixed point, with a force along the rope 3 m (share 0.3) below that point.
machine::Model hanging(double force, bool swapped = false) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("mass", {0, 0, -10}, 200, "z"));
  machine::Node load = load_on(m, "brake", swapped ? 0.7 : 0.3, force, {0, 0, -3});
  std::vector<machine::Node> nodes{anchor("top", {0, 0, 0}), load, anchor_on("mass", 0)};
  if (swapped) std::reverse(nodes.begin(), nodes.end());
  m.reevings.push_back(reeve("rope", nodes, 10 / (1 + 200 * g / 4e4), 0, 4e4));
  return m;
}

/// Tension below the place at d of a rope of unstretched length L and length l that is pulled down with F there:
/// d/(1 + (T + F)/EA) + (l - d)/(1 + T/EA) = L.
double tension_below(double l, double L, double d, double F, double EA) {
  double T = EA * (l / L - 1);
  for (int i = 0; i < 50; ++i) {
    const double a = 1 + (T + F) / EA, b = 1 + T / EA;
    T += (d / a + (l - d) / b - L) / ((d / (a * a) + (l - d) / (b * b)) / EA);
  }
  return T;
}

/// The rope passes the place, which keeps its distance from the fixed point: not its share of the rope.
TEST(TransientRopeLoad, AForceOfItsOwnDirectionPullsAMassDown) {
  const double EA = 4e4, L = 10 / (1 + 200 * g / EA);
  const auto force = [](double t) { return 900 * smoothed(t / 0.3); };
  const auto [z, v] = runge_kutta(
      10, 0, 0.6, [&](double t, double l, double) { return g - tension_below(l, L, 3, force(t), EA) / 200; });
  for (const bool swapped : {false, true}) {
    machine::Model m = hanging(0, swapped);
    m.reevings[0].nodes[1].load.signal = smooth_move(0, 900, 0, 0.3);
    m.reevings[0].nodes[1].load.sense = swapped ? -1 : 1;
    const TransientResult r = run_to_end(m, lasting(0.6, 1e-7));
    const auto& last = r.frames.back();
    EXPECT_NEAR(last.bodies[0].position.z(), -z, 1e-7);
    EXPECT_NEAR(last.bodies[0].velocity.z(), -v, 1e-6);
    EXPECT_NEAR(last.bodies[1].position.z(), -3, 1e-9);
    const auto& below = last.branches[swapped ? 0 : 1];
    EXPECT_NEAR(below.T_from, tension_below(z, L, 3, 900, EA), 1e-3);
    EXPECT_NEAR(last.branches[swapped ? 1 : 0].T_from - below.T_from, 900, 1e-6);
    EXPECT_NEAR(below.stretched, z - 3, 1e-7);
    EXPECT_LT(std::abs(last.energy.residual), 1e-7 * last.energy.turnover);
    EXPECT_NE(last.energy.supplied, 0);
  }
}

/// Friction of a given size at the place: the mass is let go 0.2 m above its equilibrium; event by event the rope
/// slides (T_above - T_below = -+ F) and holds (the upper part keeps its length).
TEST(TransientRopeLoad, FrictionOfAGivenSizeSlidesAndHolds) {
  const double EA = 4e4, mass = 200, F = 150, L = 10 / (1 + mass * g / EA) - 0.3, d = 3;
  machine::Model m = hanging(F);
  m.reevings[0].value = L;
  m.reevings[0].nodes[1].load.by_motion = true;
  m.reevings[0].nodes[1].load.sense = -1;
  const TransientResult r = run_to_end(m, lasting(2, 1e-6));
  // upper part L_1, lower part L - L_1; both have the same strain at the start
  double L_1 = d / 10 * L, l = 10, v = 0;
  const double h = 2e-6;
  const auto upper = [&](double length) { return EA * (d / length - 1); };
  const auto lower = [&](double length, double at) { return EA * ((at - d) / (L - length) - 1); };
  for (int i = 0; i < 1000000; ++i) {
    v += h / 2 * (g - lower(L_1, l) / mass);
    l += h * v;
    const double more = lower(L_1, l) - upper(L_1);
    if (std::abs(more) > F) {  // it slides until the difference is F again
      const double wanted = more > 0 ? F : -F;
      for (int k = 0; k < 4; ++k) {
        const double slope = EA * ((l - d) / std::pow(L - L_1, 2) + d / (L_1 * L_1));
        L_1 -= (lower(L_1, l) - upper(L_1) - wanted) / slope;
      }
    }
    v += h / 2 * (g - lower(L_1, l) / mass);
  }
  const auto& last = r.frames.back();
  EXPECT_NEAR(last.bodies[0].position.z(), -l, 3e-5);
  EXPECT_NEAR(last.bodies[0].velocity.z(), -v, 3e-4);
  EXPECT_GT(last.energy.slipped, 10);
  EXPECT_LT(std::abs(last.energy.residual), 1e-5 * last.energy.turnover);
  const auto count = [&](const char* what) {
    return std::count_if(r.events.begin(), r.events.end(),
                         [&](const auto& e) { return e.what == what && e.where == "brake"; });
  };
  EXPECT_GE(count("stick"), 2);
  EXPECT_GE(count("slip"), 2);
}

/// A closed rope over a drive and an idler on a slide that a weight pulls; the force acts in the drawn branch.
struct Saw {
  double force = 2000, pull = 13e3, speed = 15, friction = 0.35, share = 0.5, per_metre = 0.6;
  bool left = true, mirrored = false;
  int parts = 0;  ///< > 0: the force as a rate
};
machine::Model saw(const Saw& of) {
  constexpr double R = 0.25, EA = 6.5e6;
  machine::Model m;
  m.gravity = 0;
  const double s = of.mirrored ? -1 : 1;
  machine::Body slide = body("slide", {9 * s, 0, 0}, 60, "x");
  slide.centre = {0, 0, 0};
  m.bodies.push_back(slide);
  m.loads.push_back({{0, origin}, {of.pull * s, 0, 0}});
  const int side = of.left == !of.mirrored ? 1 : -1;
  machine::Node drive = sheave("drive", origin, R, side), idler = sheave("idler", origin, R, side, 1, 0);
  drive.kind = machine::NodeKind::drive;
  drive.motor = 0;
  drive.inertia = 2;
  drive.law.friction = of.friction;
  m.reevings.push_back(reeve("saw", {drive, idler}, (18 + 2 * pi * R) / (1 + of.pull / 2 / EA), of.per_metre * g, EA));
  machine::Reeving& rope = m.reevings[0];
  m.gravity = g;
  rope.closed = true;
  rope.damping_time = 2e-3;
  const auto add = [&](double share, double force) {
    // the returning branch lies below where the path runs left
    machine::Node node = load_on(m, "cut", share, force, {9 * s * (1 - share), 0, of.left ? -R : R});
    node.load.by_motion = true;
    node.load.sense = -1;
    rope.nodes.push_back(node);
  };
  if (of.parts == 0) add(of.share, of.force);
  for (int i = 0; i < of.parts; ++i) {
    add(0.2 + 0.6 * (i + 0.5) / of.parts, 0);
    rope.nodes.back().load.rate = of.force / (0.6 * 9);
    rope.nodes.back().load.part = 0.6 / of.parts;
  }
  m.motors.resize(1);
  m.motors[0].drive = {machine::DriveKind::speed, smooth_move(0, of.speed, 0, 1)};
  return m;
}

/// T_1 - T_2 = F at the drive; the weight on the slide holds the sum: with the place in the middle of the branch the
/// idler feels T_2 on both sides, 2 (T_2 - c) = W.
TEST(TransientRopeLoad, ASawRunsWithTheTensionsOfItsTakeUp) {
  for (const double share : {0.2, 0.5, 0.9}) {
    Saw of;
    of.share = share;
    const TransientResult r = run_to_end(saw(of), lasting(4, 1e-5));
    const auto& drive = r.frames.back().contacts[0];
    const double lambda = 1 + drive.T_out / 6.5e6;
    const double c = of.per_metre * std::pow(of.speed, 2) / lambda;
    EXPECT_NEAR(drive.T_in - drive.T_out, of.force, 1e-4 * of.force);
    EXPECT_NEAR(2 * (drive.T_out - c), of.pull, 2e-4 * of.pull);
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-4 * r.frames.back().energy.turnover);
    const auto& cut = r.frames.back().contacts[2];
    EXPECT_NEAR(cut.T_out - cut.T_in, of.force, 1e-6 * of.force);
    EXPECT_NEAR(cut.slip, of.speed, 0.01 * of.speed);
    EXPECT_LT(std::abs(drive.slip), 0.02);
  }
}

TEST(TransientRopeLoad, MirroredAndTheOtherWayRoundIsTheSame) {
  const TransientResult one = run_to_end(saw({}), lasting(1.5, 1e-5));
  for (const bool left : {true, false}) {
    for (const bool mirrored : {true, false}) {
      Saw of;
      of.left = left;
      of.mirrored = mirrored;
      const TransientResult r = run_to_end(saw(of), lasting(1.5, 1e-5));
      EXPECT_NEAR(r.frames.back().contacts[0].T_in, one.frames.back().contacts[0].T_in, 1);
      EXPECT_NEAR(r.ropes[0].T.max, one.ropes[0].T.max, 1);
    }
  }
}

/// As many small forces, together the same.
TEST(TransientRopeLoad, ARateAddsUp) {
  Saw of;
  of.parts = 5;
  of.per_metre = 0;
  const TransientResult r = run_to_end(saw(of), lasting(3, 1e-5));
  const auto& drive = r.frames.back().contacts[0];
  EXPECT_NEAR(drive.T_in - drive.T_out, of.force, 3e-3 * of.force);  // per unstretched metre
  EXPECT_NEAR(2 * drive.T_out, of.pull, 1e-3 * of.pull);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-4 * r.frames.back().energy.turnover);
}

/// At once, either way round, over light sheaves: the rope slips at all of its contacts for a while, where nothing but
/// its laws holds what runs round. It comes to the speed of the rim and the steady tensions.
TEST(TransientRopeLoad, DrivenAtOnceEitherWayRound) {
  for (const int parts : {0, 5}) {
    for (const double speed : {15.0, -15.0, 4.0, -4.0}) {
      SCOPED_TRACE(speed);
      Saw of;
      of.parts = parts;
      of.speed = speed;
      machine::Model m = saw(of);
      m.motors[0].drive.signal.law = speed;
      m.reevings[0].nodes[0].inertia = 0;
      m.reevings[0].nodes[1].law.efficiency = 0.98;
      TransientOptions options = lasting(3, 1e-4);
      options.start = Start::settled;
      const TransientResult r = run_to_end(m, options);
      const auto& last = r.frames.back();
      const auto& drive = last.contacts[0];
      const double drawn = speed > 0 ? drive.T_in : drive.T_out, slack = drive.T_in + drive.T_out - drawn;
      const double allowed = parts == 0 ? 1e-4 : 3e-3;  // per unstretched metre
      const double c = of.per_metre * speed * speed / (1 + slack / 6.5e6);
      EXPECT_NEAR(std::abs(drive.slip), 0, 0.02);
      // the idler's loss is drawn too: backwards the rope comes to it with the force
      const double idler = (slack + (speed > 0 ? 0 : of.force) - c) * (1 / 0.98 - 1);
      EXPECT_NEAR(drawn - slack, of.force + idler, allowed * of.force);
      EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover);
      EXPECT_LT(r.ropes[0].T.max, 60e3);
    }
  }
}

/// Above the grip the drive slips, and no more than e times the slack tension is drawn.
TEST(TransientRopeLoad, TooMuchForTheGripStopsTheRope) {
  Saw of;
  of.force = 20e3;
  of.per_metre = 0;
  const TransientResult r = run_to_end(saw(of), lasting(2, 1e-4));
  const auto& drive = r.frames.back().contacts[0];
  EXPECT_NEAR(drive.T_in / drive.T_out, std::exp(0.35 * pi), 1e-4);
  EXPECT_LT(drive.slip, -0.9 * of.speed);
  EXPECT_GT(r.frames.back().energy.slipped, 0);
}

/// A force of no size is none: the same motion as of the machine without it, with its weight.
TEST(TransientRopeLoad, NoForceIsNoLoad) {
  const auto machine = [](bool loaded) {
    machine::Model m;
    m.gravity = g;
    m.bodies.push_back(body("mass", {6, 1, -8}, 100, "xyz"));
    // never slack
    std::vector<machine::Node> nodes{anchor("top", {0, 0, 0}), anchor_on("mass", 0)};
    if (loaded) nodes.insert(nodes.begin() + 1, load_on(m, "none", 0.35, 0, {2.1, 0.35, -2.8}));
    m.reevings.push_back(reeve("rope", nodes, 10.0099, 8, 2e5));
    return m;
  };
  const TransientResult with = run_to_end(machine(true), lasting(1, 1e-7)),
                        without = run_to_end(machine(false), lasting(1, 1e-7));
  EXPECT_LT((with.frames.back().bodies[0].position - without.frames.back().bodies[0].position).norm(), 2e-5);
  const auto& energy = with.frames.back().energy;
  EXPECT_LT(std::abs(energy.residual), 1e-6 * energy.turnover);
}

/// An endless heavy rope over rounds that stand, of 1.5 m and 0.6 m, 12 m apart. At rest a force against its motion is
/// none, so that it begins as without one, wherever the place is: with what statics has, less the sag. Straight, its
/// strain is that of the way around, of which the rounds have R_a (pi + 2 b) and R_b (pi - 2 b), sin b = (R_a - R_b)/c.
TEST(TransientRopeLoad, ARopeThatSettlesKeepsItsLengthWhereverThePlaceIs) {
  constexpr double EA = 1e7, c = 12, R_a = 0.75, R_b = 0.3, T = 10e3;
  const double b = std::asin((R_a - R_b) / c);
  const double way = 2 * c * std::cos(b) + R_a * (pi + 2 * b) + R_b * (pi - 2 * b);
  for (const double share : {0.0, 0.05, 0.2, 0.5, 0.95}) {
    SCOPED_TRACE(share);
    machine::Model m;
    m.gravity = 10;
    machine::Node drive = sheave("a", origin, R_a, 1), tail = sheave("b", {c, 0, 0}, R_b, 1);
    for (machine::Node* node : {&drive, &tail}) {
      node->inertia = 20;
      node->law.friction = 0.3;
    }
    drive.kind = machine::NodeKind::drive;
    drive.motor = 0;
    m.motors.resize(1);
    m.motors[0].drive = {machine::DriveKind::speed, smooth_move(0, 2, 0.5, 2)};
    std::vector<machine::Node> nodes{drive, tail};
    if (share > 0) {
      machine::Node load = load_on(m, "cut", share, 1e3, {c * share, 0, R_a + (R_b - R_a) * share});
      load.load.by_motion = true;
      load.load.sense = -1;
      nodes.insert(nodes.begin() + 1, load);
    }
    m.reevings.push_back(reeve("loop", nodes, way / (1 + T / EA), 30, EA));
    m.reevings[0].closed = true;
    TransientOptions options = lasting(0.01, 1e-5);
    options.start = Start::settled;
    const TransientResult r = run_to_end(m, options);
    for (const auto& branch : r.frames.front().branches) EXPECT_NEAR((branch.T_from + branch.T_to) / 2, T, 0.01 * T);
  }
}

TEST(TransientRopeLoad, GoesOnFromItsStateAndAgreesWithTheReference) {
  Saw of;
  of.speed = 4;
  const machine::Model m = saw(of);
  const TransientResult whole = run_to_end(m, lasting(1, 1e-6));
  TransientOptions options = lasting(0.6, 1e-6);
  options.from = run_to_end(m, options).state;
  options.duration = 0.4;
  const auto &a = whole.frames.back(), second = run_to_end(m, options).frames.back();
  options = lasting(1, 1e-6);
  options.method = TimeMethod::reference;
  const auto reference = run_to_end(m, options).frames.back();
  for (const auto& other : {second, reference}) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(other.contacts[i].T_in, a.contacts[i].T_in, 1e-2) << i;
    }
    EXPECT_NEAR(other.contacts[2].slip, a.contacts[2].slip, 1e-4);
    EXPECT_NEAR(other.bodies[0].position.x(), a.bodies[0].position.x(), 1e-8);
  }
}

}  // namespace
}  // namespace taut_test::transient_rope_load_test
