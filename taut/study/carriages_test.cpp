// Carriages of every kind against statics by hand and against each other in their limits; lines in any direction.
#include "taut/machine/compile/carriages.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "taut/mechanics/arc_length.hpp"
#include "taut/study/load_path.hpp"
#include "test/support/machines.hpp"

namespace carriages_test {

namespace mechanics = taut::mechanics;
namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;

constexpr double g = 9.80665;

solve::EquilibriumResult placed(const machine::Model& m, double x) {
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
  solve::EquilibriumResult r = solve::equilibrium(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

TEST(Rollers, AsTheyComeTogetherTheyAreOne) {
  const solve::EquilibriumResult one = placed(rollers(1, 0, 0, 1500), 60);
  double before = 0;
  for (const double wheelbase : {0.4, 0.2, 0.1, 1e-3}) {
    for (const int count : {2, 3}) {
      const solve::EquilibriumResult r = placed(rollers(count, wheelbase, 0, 1500), 60);
      const double off = std::abs(r.ropes[0].T_max / one.ropes[0].T_max - 1);
      // the span grows shorter by the wheelbase: first order
      EXPECT_LT(off, 0.05 * wheelbase);
      if (count == 2 && before > 0) {
        EXPECT_LT(off, 0.6 * before);
      }
      if (count == 2) before = off;
      EXPECT_NEAR(r.hold.x() / one.hold.x(), 1, 0.05 * wheelbase);
      double wrap = 0;
      for (const solve::ContactResult& c : r.contacts) wrap += c.wrap;
      EXPECT_NEAR(wrap, one.contacts[0].wrap, 0.02 * wheelbase);
    }
  }
}

TEST(Rollers, BalanceOfForcesAndMomentsByHand) {
  // every force that acts on the carriage, from the tables alone
  for (const double height : {0.0, 0.4}) {
    const machine::Model m = rollers(3, 1.2, height, 900);
    const solve::EquilibriumResult r = placed(m, 100);
    const auto& pose = r.state.bodies[0];
    Vector3 force = -900 * g * Vector3::UnitZ() + r.hold, moment = Vector3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 arm = pose.orientation * m.reevings[0].nodes[i + 1].at.at;
      force += r.contacts[i].force;
      moment += arm.cross(r.contacts[i].force);
      EXPECT_NEAR(r.contacts[i].T_in, r.contacts[i].T_out, 1e-5);
    }
    moment += (pose.orientation * Vector3(0, 0, height)).cross(r.hold);
    EXPECT_LT(force.norm(), 1e-4);
    EXPECT_LT(moment.norm(), 1e-4);
    // the hold lies along the track: across the resultant of the rollers
    const Vector3 along =
        (r.branches[0].shape.along * r.branches[0].H + Vector3(0, 0, r.branches[0].V_to)).normalized() +
        (r.branches[3].shape.along * r.branches[3].H + Vector3(0, 0, r.branches[3].V_from)).normalized();
    EXPECT_LT(r.hold.cross(along.normalized()).norm(), 1e-4);
  }
}

TEST(Rollers, AWeightlessRopeBendsAboutTheLoadAsATriangle) {
  // level span, load in the middle, two rollers: by symmetry each leg carries half the weight, the piece between lies
  // level
  machine::Model m;
  machine::Body car = body("car", {50, 0, -5}, 1000, "xyz");
  car.free.push_back({Vector3::Zero(), Vector3::UnitY()});
  m.bodies.push_back(car);
  m.reevings.push_back(reeve(
      "sky",
      {anchor("a", {0, 0, 0}), over("car", {-1, 0, 0.3}, 0), over("car", {1, 0, 0.3}, 0), anchor("b", {100, 0, 0})},
      101, 0, 2e7));
  m.carriages.push_back({"car", 0, 0, 1, {}, 2});
  const solve::EquilibriumResult r = placed(m, 50);
  const double T = r.branches[1].T_from, depth = -r.state.bodies[0].position.z() - 0.3;
  const double leg = std::hypot(49, depth);
  EXPECT_NEAR(2 * T * depth / leg, 1000 * g, 1e-5);
  EXPECT_NEAR((2 * leg + 2) / (1 + T / 2e7), 101, 1e-9);
  EXPECT_NEAR(r.contacts[0].wrap, std::asin(depth / leg), 1e-9);
  EXPECT_NEAR(r.contacts[1].wrap, std::asin(depth / leg), 1e-9);
  EXPECT_NEAR(r.hold.norm(), 0, 1e-6);
}

TEST(Rollers, ALoadOutsideThemLiftsTheOtherOne) {
  machine::Model m = rollers(2, 0.6, 0.2, 0, 0);
  m.loads.push_back({{.body = 0, .at = {0.1, 0, -0.3}}, {0, 0, -8000}});
  solve::EquilibriumResult r = placed(m, 75);
  EXPECT_EQ(r.contacts[0].state, solve::ContactState::turning);
  EXPECT_EQ(r.contacts[1].state, solve::ContactState::turning);
  // pushed forward at its lower end: it would tip up over its rear roller
  m.loads[0] = {.at = {.body = 0, .at = {0, 0, -1.5}}, .force = {-2500, 0, -3000}};
  r = placed(m, 75);
  EXPECT_EQ(r.contacts[0].state == solve::ContactState::pulled || r.contacts[1].state == solve::ContactState::pulled,
            true);
  EXPECT_TRUE(r.contacts[0].wrap < 0 || r.contacts[1].wrap < 0);
}

/// The derivative of the machine's energy by a displacement, at fixed rope lengths, is 0: elastic energy, weights.
TEST(Rollers, TheAnswerIsStationaryInEnergy) {
  const machine::Model m = rollers(2, 1, 0.5, 1200);
  solve::EquilibriumResult r = placed(m, 60);
  const Vector3 hold = r.hold;
  const auto energy = [&](double dx, double dz, double turn) {
    const Vector3 origin_at = r.state.bodies[0].position + Vector3(dx, 0, dz);
    const taut::Matrix3 orientation =
        Eigen::AngleAxisd(turn, Vector3::UnitY()).toRotationMatrix() * r.state.bodies[0].orientation;
    double sum = 1200 * g * origin_at.z();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto end = [&](std::size_t n) -> Vector3 {
        const auto& node = m.reevings[0].nodes[n];
        return node.at.body < 0 ? node.at.at : Vector3(origin_at + orientation * node.at.at);
      };
      const auto span = taut::rope::solve_span({.length = r.branches[k].unstretched, .weight = 18, .stiffness = 26e6},
                                               end(k + 1) - end(k));
      // by quadrature along the rope: weight times height and T^2/(2 EA)
      constexpr int parts = 400;
      for (int i = 0; i < parts; ++i) {
        const double s = span->rope.length * (i + 0.5) / parts, ds = span->rope.length / parts;
        const double T = taut::rope::tension_at(*span, s).norm();
        sum += ds * (18 * (end(k).z() + taut::rope::point_at(*span, s).z()) + T * T / (2 * 26e6));
      }
    }
    return sum;
  };
  const double h = 1e-4, scale = 1200 * g;
  EXPECT_NEAR((energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h) - hold.x(), 0, 1e-3 * scale);
  EXPECT_NEAR((energy(0, h, 0) - energy(0, -h, 0)) / (2 * h) - hold.z(), 0, 1e-3 * scale);
  const Vector3 arm = r.state.bodies[0].orientation * Vector3(0, 0, 0.5);
  EXPECT_NEAR((energy(0, 0, h) - energy(0, 0, -h)) / (2 * h) - arm.cross(hold).y(), 0, 1e-3 * scale);
}

/// A skyline with a carriage that is fixed to an endless haul rope from a drive at the head to a wheel at the tail.
machine::Model hauled(double rise, double friction) {
  machine::Model m;
  m.bodies.push_back(body("car", {80, 0, 10}, 1500, "xyz"));
  machine::Node wheels = over("car", origin, 0);
  wheels.law = friction > 0 ? machine::ContactLaw{.friction = friction, .efficiency = 0} : machine::ContactLaw{};
  m.reevings.push_back(reeve("skyline", {anchor("head", {0, 0, 20}), wheels, anchor("tail", {200, 0, 20 + rise})},
                             203 + rise * rise / 400, 17, 26e6));
  machine::Node drive = sheave("drive", {0, 0, 17}, 0.5, -1);
  drive.kind = machine::NodeKind::drive;
  machine::Node grip = anchor_on("car", 0);
  grip.kind = machine::NodeKind::clamp;
  grip.length_before = 80;
  m.reevings.push_back(reeve("haul", {drive, grip, sheave("wheel", {200, 0, 17 + rise}, 0.5, -1, 0.96)},
                             2 * std::hypot(200, rise) + 8, 7, 8e6));
  m.reevings.back().closed = true;
  m.reevings.back().haul = 1;
  m.carriages.push_back({"car", 0, 0, 1, {}, 1, machine::Grip{.reeving = 1, .node = 1}});
  return m;
}

TEST(FixedTo, TheHaulRopeBearsWhatTheTrackDoesNot) {
  for (const double rise : {0.0, 60.0, -60.0}) {
    const solve::EquilibriumResult r = placed(hauled(rise, 0), 80);
    const solve::ContactResult &wheels = r.contacts[0], &grip = r.contacts[1].node == 0 ? r.contacts[2] : r.contacts[1];
    ASSERT_EQ(grip.state, solve::ContactState::held);
    EXPECT_NEAR(wheels.T_in, wheels.T_out, 1e-4);
    const Vector3 sum = wheels.force + grip.force - 1500 * g * Vector3::UnitZ();
    EXPECT_LT(sum.norm(), 1e-4);
    // the rope holds it from above
    EXPECT_TRUE(rise == 0 || (rise > 0) == (grip.T_out > grip.T_in));
    EXPECT_NEAR(r.ropes[1].unstretched, 2 * std::hypot(200, rise) + 8, 1e-9);
  }
}

TEST(FixedTo, FoundAgainByTheLengthBeforeTheGrip) {
  machine::Model m = hauled(40, 0.02);
  solve::EquilibriumOptions options;
  options.motion = solve::Motion::in;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 130};
  const solve::EquilibriumResult at = solve::equilibrium(m, options);
  ASSERT_TRUE(at.outcome.ok()) << at.outcome.message;
  double before = 0;
  for (const solve::BranchResult& s : at.branches) {
    if (s.reeving == 1 && s.from == 0) before = s.unstretched;
  }
  // it counts from where the rope arrives at its drive
  for (const solve::ContactResult& c : at.contacts) {
    if (c.reeving == 1 && c.node == 0) {
      before += mechanics::arc_length({.radius = 0.5,
                                       .wrap = c.wrap,
                                       .T_in = c.T_in,
                                       .T_out = c.T_out,
                                       .stiffness = 8e6,
                                       .friction = m.reevings[1].nodes[0].law.friction,
                                       .flow = 1})
                    .length;
    }
  }
  m.reevings[1].nodes[1].length_before = before;
  options.prescribed.reset();
  const solve::EquilibriumResult again = solve::equilibrium(m, options);
  ASSERT_TRUE(again.outcome.ok()) << again.outcome.message;
  EXPECT_NEAR(again.state.bodies[0].position.x(), 130, 1e-7);
  EXPECT_NEAR(again.ropes[0].T_max / at.ropes[0].T_max, 1, 1e-9);
}

TEST(Haulback, WhatGivesWayIsTheMainlineOrTheHaulbacksLength) {
  machine::Model m = with_carriage(true, 0);
  m.reevings.push_back(reeve("haulback", {anchor("tail block", {0, 0, 12}), anchor_on("car", 0)}, 0, 4, 4e6));
  m.reevings[2].given = machine::Given::tension_at_start;
  m.reevings[2].value = 15e3;
  m.carriages[0].haulback = 2;
  const solve::EquilibriumResult by_pull = placed(m, 150);
  EXPECT_NEAR(by_pull.branches.back().T_from, 15e3, 1e-5);
  // its length given instead: the same machine
  m.reevings[2].given = machine::Given::length;
  m.reevings[2].value = by_pull.ropes[2].unstretched;
  m.reevings[1].value = by_pull.ropes[1].unstretched;
  const solve::EquilibriumResult by_lengths = solve::equilibrium(m);
  ASSERT_TRUE(by_lengths.outcome.ok()) << by_lengths.outcome.message;
  EXPECT_NEAR(by_lengths.state.bodies[0].position.x(), 150, 1e-6);
  // the mainline's pull given: the haulback's length follows
  m.reevings[1].given = machine::Given::tension_at_start;
  for (const solve::BranchResult& s : by_pull.branches) {
    if (s.reeving == 1) m.reevings[1].value = s.T_from;
  }
  m.reevings[2].value = 100;
  const solve::EquilibriumResult by_mainline = placed(m, 150);
  EXPECT_NEAR(by_mainline.ropes[2].unstretched, by_pull.ropes[2].unstretched, 1e-6);
}

/// A carriage locked on the skyline while its mainline pulls: the place of the lock follows from x, the pull stays.
TEST(Locked, TheClampGivesWayAndTheMainlineKeepsItsPull) {
  machine::Model m = with_carriage(true, 0);
  m.reevings[0].nodes[2].kind = machine::NodeKind::clamp;
  m.reevings[0].nodes[2].length_before = 150;
  m.reevings[1].given = machine::Given::tension_at_start;
  m.reevings[1].value = 9e3;
  const solve::EquilibriumResult r = placed(m, 150);
  for (const solve::BranchResult& s : r.branches) {
    if (s.reeving == 1) {
      EXPECT_NEAR(s.T_from, 9e3, 1e-5);
    }
  }
  EXPECT_NEAR(r.ropes[0].unstretched, 318, 1e-9);
  double before = 0;
  for (const solve::BranchResult& s : r.branches) before += s.reeving == 0 && s.from < 2 ? s.unstretched : 0;
  m.reevings[0].nodes[2].length_before = before;
  const solve::EquilibriumResult again = solve::equilibrium(m);
  ASSERT_TRUE(again.outcome.ok()) << again.outcome.message;
  EXPECT_NEAR(again.state.bodies[0].position.x(), 150, 1e-6);
}

// --- lines in any direction -----------------------------------------------------------------------------------------

TEST(AnyDirection, ALineTurnedInPlanHasTheSameNumbers) {
  for (const auto& machine : {rollers(2, 0.8, 0.3, 1000), with_carriage(true), hauled(40, 0.02)}) {
    LoadPathOptions options;
    options.from = 143;
    options.to = 147;
    options.steps = 6;
    const LoadPath straight = load_path(machine, options);
    ASSERT_TRUE(straight.outcome.ok()) << straight.outcome.message;
    for (const double angle : {0.3, M_PI / 2, 2.5, -1.2}) {
      const Vector3 by(12, -7, 3);
      const Vector3 along(std::cos(angle), std::sin(angle), 0);
      LoadPathOptions other = options;
      other.along = along;
      other.from += by.dot(along);
      other.to += by.dot(along);
      const LoadPath path = load_path(turned(machine, angle, by), other);
      ASSERT_TRUE(path.outcome.ok()) << path.outcome.message;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const auto &a = path.points[i], &b = straight.points[i];
        EXPECT_NEAR(a.z, b.z + 3, 1e-9 * 200);
        for (std::size_t k = 0; k < a.at.ropes.size(); ++k)
          EXPECT_NEAR(a.at.ropes[k].T_max / b.at.ropes[k].T_max, 1, 1e-9);
        for (std::size_t k = 0; k < a.at.contacts.size(); ++k)
          EXPECT_NEAR(a.at.contacts[k].wrap, b.at.contacts[k].wrap, 1e-9);
      }
    }
  }
}

TEST(AnyDirection, EndsSwapped) {
  const machine::Model m = rollers(3, 1, 0.3, 1000);
  machine::Model back = m;
  std::reverse(back.reevings[0].nodes.begin(), back.reevings[0].nodes.end());
  const solve::EquilibriumResult a = placed(m, 45), b = placed(back, 45);
  EXPECT_NEAR(a.ropes[0].T_max / b.ropes[0].T_max, 1, 1e-11);
  EXPECT_NEAR((a.hold - b.hold).norm() / a.hold.norm(), 0, 1e-9);
  EXPECT_NEAR(a.contacts[0].wrap, b.contacts[2].wrap, 1e-10);
}

}  // namespace carriages_test
