#include "taut/solve/motion/parts/sag.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/rope/span.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/modes.hpp"
#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Branches that hang as catenaries while the machine moves: against statics, against chains of segments, against
/// straight ropes without weight, and against themselves mirrored, turned and restarted.
namespace taut_test::transient_sag_test {
namespace {

using std::numbers::pi;
using taut::solve::Branches;
using taut::solve::equilibrium;
using taut::solve::EquilibriumOptions;
using taut::solve::EquilibriumResult;
using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

TransientOptions hanging_for(double duration, double tolerance = 1e-6, int outputs = 10) {
  TransientOptions options = lasting(duration, tolerance, outputs);
  options.branches = Branches::catenary;
  options.start = Start::settled;
  return options;
}

/// A mass clamped to two ropes between anchors of different height. `slack`: what is longer than straight.
machine::Model two_legs(double mass, double slack, double weight = 15, double EA = 5e6) {
  machine::Model m;
  m.bodies.push_back(body("car", {60, 3, -5}, mass, "xyz"));
  const double first = std::sqrt(60 * 60 + 9 + 25.0), second = std::sqrt(90 * 90 + 49 + 625.0);
  m.reevings.push_back(reeve("a", {anchor("A", {0, 0, 0}), anchor_on("car", 0)}, first * (1 + slack), weight, EA));
  m.reevings.push_back(reeve("b", {anchor_on("car", 0), anchor("B", {150, 10, 20})}, second * (1 + slack), weight, EA));
  return m;
}

/// A carriage that rolls on a skyline over two saddles without loss; a drum with a core of 0.4 m hauls its mainline.
machine::Model hauled(double speed, double from = 0.0, double over = 1.0) {
  machine::Model m = with_carriage(false, 0, 2000);
  const machine::Node drum = add_drum(m, "winch", {302, 0, 82}, 0.4, -1);
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, speed, from, over)};
  m.reevings.push_back(reeve("mainline", {drum, anchor_on("car", 0)}, 158, 5, 5e6));
  m.carriages[0].mainline = 1;
  return m;
}

/// Every branch as statics has it, and it stays so.
TEST(TransientSag, StartsWhereStaticsIsAndStays) {
  for (const machine::Model& m : {with_carriage(true, 0), two_legs(800, 0.03), tackle(4, 1, 3000, 8)}) {
    EquilibriumOptions at_rest;
    at_rest.band = false;
    const EquilibriumResult rest = equilibrium(m, at_rest);
    ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
    const TransientResult r = run_to_end(m, hanging_for(2));
    for (const auto& frame : r.frames) {
      for (std::size_t b = 0; b < m.bodies.size(); ++b) {
        EXPECT_LT((frame.bodies[b].position - rest.state.bodies[b].position).norm(), 1e-8);
      }
      ASSERT_EQ(frame.branches.size(), rest.branches.size());
      for (std::size_t k = 0; k < rest.branches.size(); ++k) {
        EXPECT_NEAR(frame.branches[k].T_from / rest.branches[k].T_from, 1, 1e-7) << k;
        EXPECT_NEAR(frame.branches[k].T_to / rest.branches[k].T_to, 1, 1e-7) << k;
        EXPECT_NEAR(frame.branches[k].stretched, rest.branches[k].stretched, 1e-6);
      }
    }
  }
}

/// The tensions at a branch's ends differ by what the rope weighs between their heights (its stretch apart).
TEST(TransientSag, TensionsDifferByWeightTimesHeight) {
  const TransientResult r = run_to_end(two_legs(800, 0.002), hanging_for(0.1));
  const auto& b = r.frames.back().branches[1];
  const double T = (b.T_from + b.T_to) / 2;
  EXPECT_NEAR(b.T_to - b.T_from, 15 * (b.end.z() - b.start.z()) / (1 + T / 5e6), 1e-4);
}

/// Assembled, over rounds: the length along the straight lines, tension from the first moment on.
TEST(TransientSag, BeginsAssembledOverRounds) {
  machine::Model m = tackle(4, 0.97, 3000, 30);
  m.reevings[0].value -= 0.75;
  TransientOptions o = hanging_for(0.2);
  o.start = Start::assembled;
  const TransientResult r = run_to_end(m, o);
  const auto& first = r.frames.front();
  double length = 0;
  for (const auto& b : first.branches) {
    EXPECT_GT(b.T_from, 1000);
    const Vector3 way = b.end - b.start;
    const double hangs = 30 * b.unstretched * std::abs(way.z()) / way.norm();
    EXPECT_NEAR(std::abs(b.T_to - b.T_from), hangs, 1e-3 * hangs);
    length += b.unstretched;
  }
  o.branches = Branches::straight;
  double straight = 0;
  const TransientResult without_sag = run_to_end(m, o);
  for (const auto& b : without_sag.frames.front().branches) straight += b.unstretched;
  EXPECT_NEAR(length, straight, 0.05);
}

/// A mass that swings a little on two sagging legs: the frequency of the tangent stiffness, in modes and in motion.
TEST(TransientSag, SmallVibrations) {
  for (const double slack : {-0.001, 0.002, 0.05}) {
    machine::Model m = two_legs(800, slack);
    for (auto& way : m.bodies[0].free) way = {Vector3::UnitZ(), Vector3::Zero()};
    m.bodies[0].free.resize(1);
    EquilibriumOptions at_rest;
    at_rest.band = false;
    const EquilibriumResult rest = equilibrium(m, at_rest);
    ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
    double K = 0, mass = 800;
    for (const auto& span : rest.branches) {
      K += taut::rope::stiffness(span.shape)(2, 2);
      mass += 15 * span.unstretched / m.gravity / 2;
    }
    const double f = std::sqrt(K / mass) / (2 * pi);
    taut::solve::ModesOptions asked;
    asked.branches = Branches::catenary;
    const auto found = taut::solve::modes(m, asked);
    ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
    EXPECT_NEAR(found.sets[0].modes[0].frequency / f, 1, 1e-8) << slack;
    // let go 1 mm above: back there after a period
    TransientOptions o = hanging_for(1 / f, 1e-8, 1);
    o.start = Start::assembled;
    m.bodies[0].position = rest.state.bodies[0].position + Vector3(0, 0, 1e-3);
    const TransientResult there = run_to_end(m, o);
    const auto& end = there.frames.back().bodies[0];
    EXPECT_NEAR(end.position.z(), m.bodies[0].position.z(), 2e-6);
  }
}

/// Hauled very slowly: at every time the static machine with the carriage there.
TEST(TransientSag, SlowHaulIsTheLoadPath) {
  const machine::Model m = hauled(0.5);
  TransientOptions o = hanging_for(20, 1e-6, 5);
  o.quasi_static = true;
  o.step = 1;
  const TransientResult r = run_to_end(m, o);
  ASSERT_EQ(r.frames.size(), 6U);
  EXPECT_GT(r.frames.back().bodies[0].position.x() - r.frames.front().bodies[0].position.x(), 8);
  for (const auto& frame : r.frames) {
    EquilibriumOptions there;
    there.band = false;
    there.prescribed = {0, frame.bodies[0].position.x()};
    const EquilibriumResult rest = equilibrium(m, there);
    ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
    for (std::size_t k = 0; k < rest.branches.size(); ++k) {
      EXPECT_NEAR(frame.branches[k].T_from / rest.branches[k].T_from, 1, 1e-6) << k;
      EXPECT_NEAR(frame.branches[k].T_to / rest.branches[k].T_to, 1, 1e-6) << k;
    }
    EXPECT_NEAR(frame.bodies[0].position.z(), rest.state.bodies[0].position.z(), 1e-5);
  }
}

/// With next to no weight it is the straight branch, damped or not, over rounds and drums.
TEST(TransientSag, WithoutWeightItIsStraight) {
  for (const double damping : {0.0, 0.004}) {
    machine::Model m = hauled(2);
    for (auto& rope : m.reevings) {
      rope.weight *= 1e-7;
      rope.damping_time = damping;
    }
    m.reevings[0].value = 311;
    TransientOptions o = hanging_for(0.5, 1e-7);
    const TransientResult sagging = run_to_end(m, o);
    o.branches = Branches::straight;
    const TransientResult straight = run_to_end(m, o);
    ASSERT_EQ(straight.frames.size(), sagging.frames.size());
    for (std::size_t i = 0; i < straight.frames.size(); ++i) {
      for (std::size_t k = 0; k < straight.frames[i].branches.size(); ++k) {
        const double T = straight.frames[i].branches[k].T_from;
        EXPECT_NEAR(sagging.frames[i].branches[k].T_from, T, 2e-6 * T + 0.01) << i << " " << k;
      }
      EXPECT_LT((sagging.frames[i].bodies[0].position - straight.frames[i].bodies[0].position).norm(), 1e-6);
    }
  }
}

/// Moved slowly, a chain of ever more segments comes to the catenary, by the square of their number.
TEST(TransientSag, ChainsOfSegmentsComeToIt) {
  const auto moved = [](int segments, Branches branches) {
    machine::Model m = two_legs(800, 0.03, 20);
    machine::Body end = body("end", {150, 10, 20}, 1, "");
    end.driven.push_back({Vector3(0.6, 0, 0.8), Vector3::Zero(), smooth_move(0, 3, 0, 20)});
    m.bodies.push_back(end);
    m.reevings[1].nodes.back() = anchor_on("end", 1);
    for (auto& rope : m.reevings) rope.segments = segments;
    TransientOptions o = hanging_for(20, 1e-6, 1);
    o.branches = branches;
    o.quasi_static = true;
    o.step = 4;
    return run_to_end(m, o).frames.back();
  };
  const auto exact = moved(1, Branches::catenary), coarse = moved(24, Branches::straight),
             fine = moved(48, Branches::straight);
  const auto off = [&](const auto& frame) { return (frame.bodies[0].position - exact.bodies[0].position).norm(); };
  EXPECT_LT(off(coarse), 3e-3);
  EXPECT_NEAR(off(coarse) / off(fine), 4, 0.2);
  // the tension of an end segment is that in its middle
  const double middle =
      exact.branches[0].T_from - 20 * exact.branches[0].unstretched / 96 * exact.branches[0].leaves.z();
  EXPECT_NEAR(fine.branches[0].T_from, middle, 1e-3 * middle);
}

/// Smooth motions with ropes over sheaves, a drum, weights going up: nothing is lost but what is told.
TEST(TransientSag, EnergyCloses) {
  machine::Model car = two_legs(800, 0.02);
  car.bodies[0].position += Vector3(2, 1, 1);
  TransientOptions o = hanging_for(2, 1e-7);
  o.start = Start::assembled;
  for (const double damping : {0.0, 0.05}) {
    for (auto& rope : car.reevings) rope.damping_time = damping;
    const TransientResult r = run_to_end(car, o);
    const auto& e = r.frames.back().energy;
    EXPECT_LT(std::abs(e.residual), 1e-6 * e.turnover) << damping;
    EXPECT_EQ(e.damped > 0, damping > 0);
  }
  const TransientResult hauling = run_to_end(hauled(2), hanging_for(2, 1e-6));
  const auto& e = hauling.frames.back().energy;
  EXPECT_GT(e.supplied, 1e4);
  EXPECT_LT(std::abs(e.residual), 1e-6 * e.turnover);
}

/// A heavy carriage thrown on a slack skyline, on which it rolls: straight, the weight of slack rope hung on nothing.
TEST(TransientSag, EnergyOfASlackRope) {
  machine::Model m = with_carriage(true, 0, 2000);
  m.reevings[0].value = 326;
  m.reevings[1].value = 166;
  m.bodies[0].position.z() += 4;
  TransientOptions o = hanging_for(1, 1e-6);
  o.start = Start::assembled;
  const TransientResult r = run_to_end(m, o);
  const auto& e = r.frames.back().energy;
  EXPECT_LT(std::abs(e.residual), 1e-6 * e.turnover);
  EXPECT_GT(e.turnover, 1e4);
  EXPECT_LT(r.frames.back().bodies[0].position.z(), m.bodies[0].position.z() - 1);
  for (const auto& event : r.events) EXPECT_NE(event.what, "slack");
}

double apart(const TransientResult& a, const TransientResult& b, const taut::Matrix3& turn, const Vector3& by) {
  double worst = 0;
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    const Vector3 there = turn * a.frames[i].bodies[0].position + by;
    worst = std::max(worst, (there - b.frames[i].bodies[0].position).norm());
  }
  return worst;
}

TEST(TransientSag, TurnedMirroredAndOtherWayRound) {
  machine::Model m = hauled(2);
  const TransientOptions o = hanging_for(1, 1e-7, 4);
  const TransientResult r = run_to_end(m, o);
  const Vector3 by(30, -20, 5);
  const taut::Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT(apart(r, run_to_end(turned(m, 0.7, by), o), turn, by), 2e-6);

  machine::Model mirrored = m;
  const taut::Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
  for (auto& one : mirrored.bodies) one.position = mirror * one.position;
  for (auto& rope : mirrored.reevings) {
    for (auto& node : rope.nodes) {
      node.at.at = mirror * node.at.at;
      node.side = -node.side;
    }
  }
  EXPECT_LT(apart(r, run_to_end(mirrored, o), mirror, origin), 2e-6);

  machine::Model swapped = m;
  for (auto& rope : swapped.reevings) {
    std::reverse(rope.nodes.begin(), rope.nodes.end());
    for (auto& node : rope.nodes) node.side = -node.side;
  }
  swapped.carriages[0].node = 2;
  EXPECT_LT(apart(r, run_to_end(swapped, o), taut::Matrix3::Identity(), origin), 2e-6);
}

TEST(TransientSag, TheReferenceAgrees) {
  machine::Model m = hauled(2);
  for (auto& rope : m.reevings) rope.damping_time = 0.003;
  TransientOptions o = hanging_for(1.5, 1e-7, 3);
  const TransientResult fast = run_to_end(m, o);
  o.method = TimeMethod::reference;
  o.tolerance = 1e-6;
  const TransientResult exact = run_to_end(m, o);
  ASSERT_EQ(fast.frames.size(), exact.frames.size());
  EXPECT_LT(apart(fast, exact, taut::Matrix3::Identity(), origin), 1e-5);
  for (std::size_t k = 0; k < exact.frames.back().branches.size(); ++k) {
    EXPECT_NEAR(fast.frames.back().branches[k].T_to / exact.frames.back().branches[k].T_to, 1, 1e-5);
  }
}

/// A heavy rope over sheaves is pulled in within 0.2 s. The rope on the sheaves stretches too. The books close, and the
/// reference gives the same motion. With `rigid` the rope is stiffer.
TEST(TransientSag, RopeOnSheavesStretches) {
  machine::Model m = tackle(3, 1, 300, 40);
  m.tensioners.push_back({0, true, smooth_move(0, -0.3, 0.05, 0.2)});
  TransientOptions o = hanging_for(0.5, 1e-7, 3);
  const TransientResult fast = run_to_end(m, o);
  EXPECT_LT(std::abs(fast.frames.back().energy.residual), 1e-6 * fast.frames.back().energy.turnover);
  o.arcs = taut::solve::Arcs::rigid;
  EXPECT_GT(run_to_end(m, o).ropes[0].T.max, 1.002 * fast.ropes[0].T.max);
  o.arcs = taut::solve::Arcs::stretch;
  o.method = TimeMethod::reference;
  o.tolerance = 1e-7;
  const TransientResult exact = run_to_end(m, o);
  EXPECT_LT(apart(fast, exact, taut::Matrix3::Identity(), origin), 1e-5);
  EXPECT_NEAR(fast.ropes[0].T.max / exact.ropes[0].T.max, 1, 1e-4);
}

TEST(TransientSag, GoesOnToTheLastBit) {
  const machine::Model m = hauled(2);
  TransientOptions o = hanging_for(1);
  o.step = 5e-3;
  const TransientResult whole = run_to_end(m, o);
  o.duration = 0.5;
  const TransientResult first = run_to_end(m, o);
  o.from = first.state;
  const TransientResult second = run_to_end(m, o);
  EXPECT_EQ(whole.frames.back().bodies[0].position, second.frames.back().bodies[0].position);
  EXPECT_EQ(whole.frames.back().branches[0].T_from, second.frames.back().branches[0].T_from);
  o.from->memory.clear();
  const TransientResult anew = run_to_end(m, o);
  EXPECT_LT((whole.frames.back().bodies[0].position - anew.frames.back().bodies[0].position).norm(), 1e-4);
}

/// Where the rope weighs little beside its tension it is straight; a saved state says which ones were not.
TEST(TransientSag, ByWeight) {
  machine::Model m = two_legs(800, 0.01);
  m.reevings[1].weight = 0.2;
  TransientOptions o = hanging_for(0.1);
  o.branches = Branches::by_weight;
  const TransientResult r = run_to_end(m, o);
  EXPECT_EQ(r.sagging, (std::vector<int>{1, 0}));
  EXPECT_FALSE(r.frames[0].branches[0].curve.empty());
  EXPECT_TRUE(r.frames[0].branches[1].curve.empty());
  o.from = r.state;
  EXPECT_EQ(run_to_end(m, o).sagging, (std::vector<int>{1, 0}));
  o.from.reset();
  o.rope_mass = false;
  EXPECT_EQ(run_to_end(m, o).sagging, (std::vector<int>{0, 0}));
}

/// A leg that breaks falls away, at once or over a time; its energy is told.
TEST(TransientSag, ABranchBreaks) {
  for (const double over : {0.0, 0.05}) {
    machine::Model m = two_legs(800, 0.002);
    machine::Event event;
    event.at = 0.2;
    event.kind = machine::EventKind::breaks;
    event.index = 1;
    event.over = over;
    m.events.push_back(event);
    const TransientResult r = run_to_end(m, hanging_for(1, 1e-7));
    EXPECT_LT(r.frames.back().bodies[0].position.z(), r.frames[0].bodies[0].position.z() - 1);
    const auto& e = r.frames.back().energy;
    EXPECT_LT(std::abs(e.residual), 1e-5 * e.turnover) << over;
  }
}

}  // namespace
}  // namespace taut_test::transient_sag_test
