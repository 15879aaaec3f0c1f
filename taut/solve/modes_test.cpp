#include "taut/solve/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "test/support/machines.hpp"

/// Small vibrations against closed forms.
namespace taut_test::modes_test {
namespace {

using std::numbers::pi;
using taut::solve::Mode;
using taut::solve::ModeKind;
using taut::solve::modes;
using taut::solve::ModesOptions;
using taut::solve::ModesResult;
using taut::solve::Sheaves;

constexpr double g = 9.81;

/// Masses on a hanging rope each, one below the other; `stretched` lengths at rest.
machine::Model hanging(const std::vector<double>& masses, const std::vector<double>& lengths, double EA,
                       const std::string& free) {
  machine::Model m;
  m.gravity = g;
  double z = 0, below = 0;
  for (const double mass : masses) below += mass;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    z -= lengths[i];
    m.bodies.push_back(body("m" + std::to_string(i), {0, 0, z}, masses[i], free));
    const double unstretched = lengths[i] / (1 + below * g / EA);
    const machine::Node from =
        i == 0 ? anchor("top", origin) : anchor_on("a" + std::to_string(i), static_cast<int>(i) - 1);
    m.reevings.push_back(
        reeve("r" + std::to_string(i), {from, anchor_on("b", static_cast<int>(i))}, unstretched, 0, EA));
    below -= masses[i];
  }
  return m;
}

ModesResult found(const machine::Model& m, const ModesOptions& options = {}) {
  ModesResult r = modes(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

TEST(Modes, MassOnARope) {
  machine::Model m = hanging({100}, {8}, 1e5, "xyz");
  m.reevings[0].damping_ratio = 0.03;
  const ModesResult r = found(m);
  ASSERT_EQ(r.sets.size(), 1U) << "no sheave makes a difference";
  const auto& all = r.sets[0].modes;
  ASSERT_EQ(all.size(), 3U);
  for (const std::size_t swing : {0U, 1U}) {
    EXPECT_NEAR(all[swing].frequency, std::sqrt(g / 8) / (2 * pi), 1e-9);
    EXPECT_NEAR(all[swing].damping, 0, 1e-9);
    EXPECT_EQ(all[swing].kind, ModeKind::swings);
    EXPECT_NEAR(all[swing].bodies[0].shift.z(), 0, 1e-9);
  }
  const double unstretched = 8 / (1 + 100 * g / 1e5);
  EXPECT_NEAR(all[2].frequency, std::sqrt(1e5 / unstretched / 100) / (2 * pi), 1e-9);
  EXPECT_NEAR(all[2].damping, 0.03, 1e-9);
  EXPECT_NEAR(all[2].damped, all[2].frequency * std::sqrt(1 - 0.03 * 0.03), 1e-9);
  EXPECT_NEAR(std::abs(all[2].bodies[0].shift.z()), 1, 1e-9);
  EXPECT_EQ(all[2].largest, 0);
}

TEST(Modes, MoreThanCriticalDampingCreeps) {
  machine::Model m = hanging({100}, {8}, 1e5, "z");
  m.reevings[0].damping_ratio = 2;
  const auto all = found(m).sets[0].modes;
  ASSERT_EQ(all.size(), 2U);
  const double omega = std::sqrt(1e5 * (1 + 100 * g / 1e5) / 8 / 100);
  EXPECT_EQ(all[0].kind, ModeKind::creeps);
  EXPECT_NEAR(all[0].frequency, omega * (2 - std::sqrt(3)) / (2 * pi), 1e-8);
  EXPECT_NEAR(all[1].frequency, omega * (2 + std::sqrt(3)) / (2 * pi), 1e-7);
}

TEST(Modes, DoublePendulum) {
  const double m1 = 3, m2 = 2, l1 = 1.5, l2 = 0.8;
  const auto all = found(hanging({m1, m2}, {l1, l2}, 1e10, "x")).sets[0].modes;
  ASSERT_EQ(all.size(), 2U);
  // m1 l1 l2 w^4 - (m1 + m2) g (l1 + l2) w^2 + (m1 + m2) g^2 = 0
  const double a = m1 * l1 * l2, b = (m1 + m2) * g * (l1 + l2), c = (m1 + m2) * g * g;
  for (const int sign : {-1, 1}) {
    const double omega = std::sqrt((b + sign * std::sqrt(b * b - 4 * a * c)) / (2 * a));
    const Mode& mode = all[sign < 0 ? 0 : 1];
    EXPECT_NEAR(mode.frequency, omega / (2 * pi), 1e-7);
    // x2/x1 = g (m1 + m2)/m2 ... from the lower mass: x2 (g - l2 w^2) = g x1
    EXPECT_NEAR(mode.bodies[1].shift.x() * (g - l2 * omega * omega), g * mode.bodies[0].shift.x(), 1e-5);
  }
}

TEST(Modes, PhysicalPendulumTurnsWhereNothingShifts) {
  machine::Model m = hanging({5}, {2}, 1e6, "z");
  machine::Body rod = body("rod", {10, 0, 0}, 12, "Y");
  rod.centre = {0, 0, -0.7};
  rod.inertia = {1.3, 1.3, 0.1};
  m.bodies.push_back(rod);
  m.reevings.push_back(reeve("slack", {anchor_on("pin", 1), anchor("end", {10.5, 0, 0})}, 1, 0, 1e6));
  const auto all = found(m).sets[0].modes;
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].frequency, std::sqrt(12 * g * 0.7 / (1.3 + 12 * 0.49)) / (2 * pi), 1e-9);
  EXPECT_NEAR(std::abs(all[0].bodies[1].turn.y()), 1, 1e-9);
  EXPECT_EQ(all[0].largest, 1);
}

TEST(Modes, TautString) {
  const double L = 100, EA = 1e6, mass = 0.5;
  const int n = 20;
  machine::Model m;
  m.gravity = 1e-6;
  m.reevings.push_back(reeve("string", {anchor("a", origin), anchor("b", {L, 0, 0})}, L / 1.01, 1e-6 * mass, EA));
  m.reevings[0].segments = n;
  ModesOptions o;
  o.most = 8;
  const auto all = found(m, o).sets[0].modes;
  ASSERT_EQ(all.size(), 8U);
  const double T = 0.01 * EA, node = mass * L / 1.01 / n, a = L / n;
  for (int k = 1; k <= 4; ++k) {
    const double omega = 2 * std::sqrt(T / (a * node)) * std::sin(k * pi / (2 * n));
    for (const int twin : {2 * k - 2, 2 * k - 1}) {  // in both planes
      EXPECT_NEAR(all[static_cast<std::size_t>(twin)].frequency, omega / (2 * pi), 1e-8);
    }
    const double string = k / (2 * L) * std::sqrt(T / (mass / 1.01));
    EXPECT_NEAR(omega / (2 * pi), string, 0.02 * string);
  }
  EXPECT_FALSE(all[0].largest) << "the rope itself";
}

/// Two equal masses on legs of one rope over a sheave.
machine::Model over_sheave(double mass, double leg, double EA, const machine::Node& round) {
  machine::Model m;
  m.gravity = g;
  const double R = round.radius, T = mass * g;
  m.bodies = {body("left", {-R, 0, -leg}, mass, "z"), body("right", {R, 0, -leg}, mass, "z")};
  m.reevings.push_back(
      reeve("rope", {anchor_on("left", 0), round, anchor_on("right", 1)}, (2 * leg + pi * R) / (1 + T / EA), 0, EA));
  return m;
}

TEST(Modes, AStuckSheaveHoldsTheRopeAReleasedOneLetsItRun) {
  const double mass = 200, leg = 6, EA = 1e6, R = 0.3;
  const ModesResult r = found(over_sheave(mass, leg, EA, sheave("head", origin, R, 1, 0.95)));
  ASSERT_EQ(r.sets.size(), 2U);
  EXPECT_EQ(r.sets[0].sheaves, Sheaves::stuck);
  EXPECT_EQ(r.sets[0].held, std::vector<std::string>{"head"});
  const double k = EA * (1 + mass * g / EA) / (leg + R * pi / 2);  // with half of the rope on the sheave
  ASSERT_EQ(r.sets[0].modes.size(), 2U);
  for (const Mode& mode : r.sets[0].modes) EXPECT_NEAR(mode.frequency, std::sqrt(k / mass) / (2 * pi), 1e-7);
  const auto& released = r.sets[1].modes;
  ASSERT_EQ(released.size(), 2U);
  EXPECT_EQ(released[0].kind, ModeKind::free);
  EXPECT_NEAR(released[0].bodies[0].shift.z(), -released[0].bodies[1].shift.z(), 1e-6);
  EXPECT_NEAR(released[1].frequency, std::sqrt(k / mass) / (2 * pi), 1e-7) << "both legs, both masses together";
}

TEST(Modes, ASheaveWithInertiaTurnsWithItsRope) {
  const double mass = 200, leg = 6, EA = 1e6, R = 0.3, J = 3;
  machine::Node head = sheave("head", origin, R, 1);
  head.inertia = J;
  machine::Model m = over_sheave(mass, leg, EA, head);
  const ModesResult r = found(m);
  ASSERT_EQ(r.sets.size(), 1U);
  const auto& all = r.sets[0].modes;
  ASSERT_EQ(all.size(), 3U);
  // springs between the masses and the rim: symmetric with the sheave at rest, antisymmetric against it. Rope that the
  // rim hands over changes each leg's own length too: k by its unstretched length over the stretched one. Half of the
  // rope on the sheave is part of either leg
  const double k = EA * (1 + mass * g / EA) / (leg + R * pi / 2);
  EXPECT_EQ(all[0].kind, ModeKind::free);
  EXPECT_NEAR(all[1].frequency, std::sqrt(k / mass) / (2 * pi), 1e-7);
  EXPECT_NEAR(all[2].frequency, std::sqrt(k / mass + 2 * k * R * R / J) / (2 * pi), 1e-2);
}

TEST(Modes, ATurnedMachineHasTheSameModes) {
  const auto straight = found(boom()).sets;
  machine::Model m = boom();
  const Eigen::Matrix3d turn = (Eigen::Matrix3d() << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1).finished();
  for (machine::Body& b : m.bodies) {
    b.position = turn * b.position;
    b.orientation = turn * b.orientation;
    for (machine::Freedom& way : b.free) {
      way.along = turn * way.along;
      way.about = turn * way.about;
    }
  }
  for (machine::Reeving& rope : m.reevings) {
    for (machine::Node& node : rope.nodes) {
      if (node.at.body != machine::ground) continue;
      node.at.at = turn * node.at.at;
      node.axis = turn * node.axis;
    }
  }
  const auto turned = found(m).sets;
  ASSERT_EQ(straight.size(), turned.size());
  for (std::size_t s = 0; s < straight.size(); ++s) {
    ASSERT_EQ(straight[s].modes.size(), turned[s].modes.size());
    for (std::size_t k = 0; k < straight[s].modes.size(); ++k) {
      EXPECT_NEAR(straight[s].modes[k].frequency, turned[s].modes[k].frequency,
                  1e-6 * (1 + straight[s].modes[k].frequency));
    }
  }
}

TEST(Modes, TooManyFreedomsAreTold) {
  machine::Model m;
  m.reevings.push_back(reeve("rope", {anchor("a", origin), anchor("b", {100, 0, 0})}, 101, 10, 1e7));
  m.reevings[0].segments = 200;
  EXPECT_NE(modes(m).outcome.message.find("fewer 'segments'"), std::string::npos);
}

TEST(Modes, WhereNothingHasInertiaThereAreNone) {
  machine::Model m;
  m.reevings.push_back(reeve("rope", {anchor("a", origin), anchor("b", {100, 0, 0})}, 99.9, 10, 1e7));
  EXPECT_NE(modes(m).outcome.message.find("nothing that can move has inertia"), std::string::npos);
  const machine::Node round = sheave("sheave", {50, 0, 20}, 0.2, 1, 0.98);
  m.reevings[0] = reeve("rope", {anchor("a", origin), round, anchor("b", {100, 0, 0})}, 107, 10, 1e7);
  EXPECT_NE(modes(m).outcome.message.find("nothing that can move has inertia"), std::string::npos);
}

}  // namespace
}  // namespace taut_test::modes_test
