#include "taut/solve/drives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/solve/running.hpp"
#include "test/support/machines.hpp"

// Driven ropes: energy, the running rope against its differential equation, the same loop described otherwise.
namespace drives_test {

using namespace taut;
using namespace taut_test;
using solve::Motion;

constexpr double EA = 3e6, mass = 0.8, speed = 18;

/// A loop over a drive, two idlers with losses and a tightened slide, cut on its upper strand.
machine::Model saw(double force = 2500, double efficiency = 1) {
  machine::Model m;
  m.bodies.push_back(body("slide", {8, 0, 0.3}, 0, "x"));
  m.bodies.push_back(body("cut", {5.2, 0, 1.05}, 0, "xyz"));
  m.loads.push_back({{.body = 0, .at = origin}, {14e3, 0, 0}});
  machine::Node drive = sheave("drive", {0, 0, 0}, 0.4, 1);
  drive.kind = machine::NodeKind::drive;
  drive.law = {.friction = 0.3, .efficiency = efficiency};
  machine::Node cut = anchor_on("cut", 1);
  cut.kind = machine::NodeKind::load;
  cut.load.force = force;
  cut.load.sense = -1;
  cut.load.by_motion = true;
  m.reevings.push_back(
      reeve("saw", {drive, sheave("top", {2, 0, 1.2}, 0.2, 1, 0.97), cut, sheave("idler", origin, 0.35, 1, 0.96, 0)},
            19.6, 0, EA));
  m.reevings[0].closed = true;
  m.reevings[0].mass = mass;
  m.reevings[0].weight = mass * m.gravity;
  m.reevings[0].speed = speed;
  m.reevings[0].haul = 1;
  return m;
}

struct Ran {
  solve::EquilibriumResult e;
  solve::DriveResult drive;
};

Ran run(const machine::Model& m, Motion motion) {
  solve::EquilibriumOptions options;
  options.motion = motion;
  Ran r;
  r.e = solve::equilibrium(m, options);
  EXPECT_TRUE(r.e.outcome.ok()) << r.e.outcome.message;
  if (r.e.outcome.ok()) r.drive = solve::drives(m, r.e).at(0);
  return r;
}

/// The weight on the arcs is length, not load: what the free spans lift along the path does not add up to nothing, N m
/// per metre of flow.
double lifted(const solve::EquilibriumResult& e) {
  double height = 0;
  for (const auto& s : e.branches) height += (s.end - s.start).z();
  return mass * 9.80665 * height;
}

TEST(Drives, PowerInIsPowerCutAndPowerLost) {
  for (const Motion motion : {Motion::in, Motion::out}) {
    const auto [e, d] = run(saw(), motion);
    EXPECT_GT(d.power, 2500 * speed);
    EXPECT_NEAR(*d.power_loads, 2500 * speed, 1e-3 * d.power) << "the cut takes F v, v of the rope there";
    EXPECT_GT(*d.power_losses, 0);
    const double T_1 = std::max(d.T_in, d.T_out), T_2 = std::min(d.T_in, d.T_out);
    EXPECT_NEAR(*d.power_creep, speed / (1 + T_1 / EA) * (T_1 - T_2) * (T_1 - T_2) / (2 * EA), 1e-6 * d.power);
    const double taken = *d.power_loads + *d.power_losses + *d.power_carriages + *d.power_creep;
    EXPECT_NEAR(d.power - taken, *d.speed / (1 + T_1 / EA) * lifted(e), 1e-9 * d.power);
    EXPECT_NEAR(d.power, d.torque * *d.speed / 0.4, 1e-9 * d.power);
    EXPECT_EQ(d.torque > 0, motion == Motion::in) << "it drives the way the rope runs";
    EXPECT_LT(e.closure.balance, 1e-5);
  }
}

TEST(Drives, TheMotorTurnsItsOwnBearingToo) {
  for (const Motion motion : {Motion::in, Motion::out}) {
    const double eta = 0.9;
    const auto light = run(saw(), motion).drive, d = run(saw(2500, eta), motion).drive;
    // the loss of its own sheave changes no tension of the rope
    EXPECT_NEAR(d.T_in, light.T_in, 1e-7 * light.T_in);
    EXPECT_NEAR(d.T_out, light.T_out, 1e-7 * light.T_out);
    const double lost = (1 - eta) / (1 + eta) * (d.T_in + d.T_out - 2 * d.centrifugal);
    EXPECT_NEAR(d.power - light.power, lost * speed, 1e-7 * d.power);
    EXPECT_NEAR(std::abs(d.torque) - std::abs(light.torque), lost * 0.4, 1e-7 * std::abs(d.torque));
    EXPECT_NEAR(*d.power_losses - *light.power_losses, lost * speed, 1e-7 * d.power);
    EXPECT_NEAR(*d.power_creep, *light.power_creep, 1e-7 * d.power);
  }
  EXPECT_NEAR(run(saw(2500, 0.9), Motion::at_rest).drive.torque, run(saw(), Motion::at_rest).drive.torque, 1e-6);
}

/// A sheave that no motor drives is one whose motor has no torque.
TEST(Drives, AMotorWithoutTorqueIsASheaveWithItsLoss) {
  machine::Model m = saw();
  const auto known = run(m, Motion::in);
  m.reevings[0].nodes[1].tension_drop = 0;
  const auto found = run(m, Motion::in);
  EXPECT_NEAR(found.drive.T_in, known.drive.T_in, 1e-7 * known.drive.T_in);
  EXPECT_NEAR(found.drive.T_out, known.drive.T_out, 1e-7 * known.drive.T_out);
  EXPECT_NEAR(found.drive.power, known.drive.power, 1e-7 * known.drive.power);
}

TEST(Drives, AtRestThereIsATorqueButNoPower) {
  const auto [e, d] = run(saw(), Motion::at_rest);
  EXPECT_NEAR(d.torque, 0.4 * (2500 + lifted(e)), 5e-3) << "but for the stretch on the way";
  EXPECT_FALSE(d.speed);
  EXPECT_EQ(d.centrifugal, 0);
}

TEST(Drives, TheCentrifugalTensionIsFeltByNoSupport) {
  machine::Model slow = saw();
  slow.reevings[0].speed = 0;
  const auto still = run(slow, Motion::in), fast = run(saw(), Motion::in);
  const double c = mass * speed * speed;
  EXPECT_NEAR(fast.drive.centrifugal, c, 1e-12);
  // the slide is pulled by the same weight: the same pressure on its sheave, and c more in the rope
  const auto idler = [](const Ran& r) {
    return *std::find_if(r.e.contacts.begin(), r.e.contacts.end(), [](const auto& one) { return one.node == 3; });
  };
  EXPECT_NEAR(idler(fast).force.x(), -14e3, 1e-4);
  EXPECT_NEAR(idler(fast).force.x(), idler(still).force.x(), 1e-4);
  EXPECT_NEAR(fast.drive.T_out - still.drive.T_out, c, 1e-3 * c);
  EXPECT_NEAR(fast.drive.ratio, still.drive.ratio, 1e-3);
  // the rope is longer by c/EA, so that the slide goes out by half of that share of the loop
  const double longer = fast.e.state.bodies[0].position.x() - still.e.state.bodies[0].position.x();
  EXPECT_NEAR(longer, c / EA * 19.6 / 2, 0.03 * longer);
}

/// The rope on its way: with the momentum of its flow, d((T - c) d)/ds = w z; it stretches by T. Runge-Kutta along it.
Vector3 end_of_running_rope(Vector3 pull, double c, double w, double L) {
  const int steps = 4000;
  const double h = L / steps;
  Vector3 x = Vector3::Zero();
  for (int i = 0; i < steps; ++i) {
    const auto rate = [&](double s) -> Vector3 {
      const Vector3 p = pull + s * w * Vector3::UnitZ();
      return (1 + (p.norm() + c) / EA) * p.normalized();
    };
    x += h / 6 * (rate(0) + 4 * rate(h / 2) + rate(h));
    pull += h * w * Vector3::UnitZ();
  }
  return x;
}

TEST(Drives, ARunningSpanHasTheShapeOfItsTensionLessTheCentrifugalOne) {
  const auto [e, d] = run(saw(), Motion::in);
  const auto& s = e.branches.back();
  Vector3 along = s.end - s.start;
  along.z() = 0;
  const Vector3 pull = s.H * along.normalized() + s.V_from * up();
  EXPECT_NEAR(pull.norm() + d.centrifugal, s.T_from, 1e-6);
  const Vector3 end = end_of_running_rope(pull, d.centrifugal, mass * 9.80665, s.unstretched);
  EXPECT_LT((end - (s.end - s.start)).norm(), 1e-8);
}

TEST(Drives, AnEndlessRopeReadTheOtherWayIsTheSame) {
  const auto there = run(saw(), Motion::in).drive;
  machine::Model back = saw();
  auto& nodes = back.reevings[0].nodes;
  std::reverse(nodes.begin() + 1, nodes.end());
  for (machine::Node& node : nodes) node.side = -node.side;
  for (machine::Node& node : nodes) node.load.share = 1 - node.load.share;
  const auto other = run(back, Motion::out).drive;
  EXPECT_NEAR(there.T_in, other.T_out, 1e-7 * there.T_in);
  EXPECT_NEAR(there.torque, -other.torque, 1e-7 * there.torque);
  EXPECT_NEAR(there.power, other.power, 1e-7 * there.power);
  EXPECT_NEAR(there.slip_arc, other.slip_arc, 1e-7);
}

TEST(Drives, ATorqueSetsTheOpenLoad) {
  for (const double efficiency : {1.0, 0.9}) {
    machine::Model m = saw(2500, efficiency);
    const auto known = run(m, Motion::in);
    m.reevings[0].nodes[0].tension_drop = known.drive.torque / 0.4;
    m.reevings[0].nodes[2].load.open = true;
    const auto found = run(m, Motion::in);
    EXPECT_NEAR(found.e.rope_loads.at(0).along_path, -2500, 1e-5);
    EXPECT_NEAR(found.drive.torque, known.drive.torque, 1e-6 * known.drive.torque);
  }
}

TEST(Drives, ATorqueSetsTheLengthWhereLossesGrowWithTheTension) {
  machine::Model m = saw(0, 0.95);
  m.bodies[0].position = run(m, Motion::in).e.state.bodies[0].position;
  m.bodies[0].free.clear();
  m.loads.clear();
  const auto known = run(m, Motion::in);
  m.reevings[0].given = machine::Given::torque;
  m.reevings[0].nodes[0].tension_drop = known.drive.torque / 0.4;
  const auto found = run(m, Motion::in);
  EXPECT_NEAR(found.e.ropes[0].unstretched, 19.6, 1e-7);
}

TEST(Drives, ATractionSheaveHoldsTheDifferenceOfItsWeights) {
  machine::Model m;
  m.bodies.push_back(body("cabin", {-0.5, 0, -20}, 900, "z"));
  m.bodies.push_back(body("weight", {0.5, 0, -30}, 700, "z"));
  machine::Node drive = sheave("drive", {0, 0, 0}, 0.5, 1);
  drive.kind = machine::NodeKind::drive;
  m.reevings.push_back(reeve("hoist", {anchor_on("cabin", 0), drive, anchor_on("weight", 1)}, 51.6, 0, 5e6));
  m.reevings[0].copies = 4;
  // the lower body stands on a spring rope, so that the torque has something to stretch
  m.reevings.push_back(reeve("brace", {anchor("floor", {0.5, 0, -40}), anchor_on("weight", 1)}, 9.9, 0, 2e5));
  m.reevings[0].nodes[1].tension_drop = 300;
  const auto r = solve::equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches[0].T_from, 900 * 9.80665 / 4, 1e-6);
  EXPECT_NEAR(r.branches[0].T_to - r.branches[1].T_from, 300, 1e-6);
  EXPECT_NEAR(solve::drives(m, r).at(0).torque, 4 * 300 * 0.5, 1e-6);
}

TEST(Drives, ARopeWhoseGivenTensionIsBelowTheCentrifugalOneLiftsOff) {
  machine::Model m = three_spans(316, 0.1);
  m.reevings[0].mass = 2;
  m.reevings[0].speed = 200;
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 70e3;
  solve::EquilibriumOptions options;
  options.motion = Motion::in;
  const auto r = solve::equilibrium(m, options);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("centrifugal tension of 8e+04 N"), std::string::npos) << r.outcome.message;
}

}  // namespace drives_test
