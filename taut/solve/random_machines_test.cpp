// Random tackles, hanging nets and guyed poles, as random_test.cpp has random lines: an answer closes by its own
// tables, and is the same mirrored, turned, in other units and with its ropes run the other way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/math/index.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/dice.hpp"
#include "test/support/guyed_pole.hpp"
#include "test/support/machines.hpp"
#include "test/support/refused.hpp"

namespace random_machines_test {

using namespace taut_test;
using namespace taut::solve;
using taut::Matrix3;

struct Machine {
  machine::Model model;
  double size = 1;
};

/// Two to eight falls, with or without a tag line, by a winch of given length.
Machine random_tackle(Dice& dice) {
  Machine t;
  const int falls = 2 + dice.below(7);
  const double r = dice.in(0.05, 0.5), h = dice.in(8, 40), mass = dice.ten_to(2, 4.5), part = dice.in(0.2, 0.8);
  const double efficiency = dice.below(2) == 0 ? 1 : dice.in(0.9, 1);
  t.model.bodies.push_back(body("block", {dice.in(-1, 1), 0, h * (1 - part)}, mass, "xz"));
  const Vector3 winch{-dice.in(2, 15), 0, dice.in(-5, 5)};
  std::vector<machine::Node> nodes{anchor("winch", winch)};
  for (int i = 0; i < falls; ++i) {
    const bool head = i % 2 == 0;
    nodes.push_back(head ? sheave("head", {0, 0, h}, r, 1, efficiency) : sheave("block", origin, r, 1, efficiency, 0));
  }
  nodes.push_back(falls % 2 == 0 ? anchor("becket", {-r, 0, h}) : anchor_on("becket", 0, {r, 0, 0}));
  const double length = (winch - Vector3(0, 0, h)).norm() + part * h * falls + 3 * falls * r;
  const double weight = dice.below(2) == 0 ? 0 : dice.ten_to(0, 1.5);
  t.model.reevings.push_back(reeve("hoist", nodes, length, weight, dice.ten_to(6, 8)));
  t.model.reevings[0].copies = 1 + dice.below(2);
  t.model.reevings[0].thermal_strain = dice.in(-5e-4, 5e-4);
  t.size = h * falls;
  return t;
}

/// One to three weights on three to seven ropes.
Machine random_net(Dice& dice) {
  Machine t;
  const int knots = 1 + dice.below(3);
  for (int b = 0; b < knots; ++b) {
    t.model.bodies.push_back(
        body("knot", {dice.in(-20, 20), dice.in(-20, 20), dice.in(0, 20)}, dice.ten_to(0, 3.5), "xyz"));
  }
  const int ropes = knots + 2 + dice.below(3);
  for (int r = 0; r < ropes; ++r) {
    const int b = r % knots, other = (b + 1) % knots;
    const bool between = other != b && dice.below(4) == 0;
    const Vector3 at(dice.in(-50, 50), dice.in(-50, 50), dice.in(25, 60));
    const Vector3 end = between ? t.model.bodies[static_cast<std::size_t>(other)].position : at;
    const double chord = (end - t.model.bodies[static_cast<std::size_t>(b)].position).norm();
    t.model.reevings.push_back(
        reeve("rope", {between ? anchor_on("knot", other) : anchor("a", at), anchor_on("knot", b)},
              chord * dice.in(0.8, 1.4), dice.below(3) == 0 ? 0 : dice.ten_to(0, 2), dice.ten_to(5, 8)));
  }
  t.size = 100;
  return t;
}

Machine random_pole(Dice& dice) {
  Machine t;
  t.size = add_guyed_pole(dice, t.model);
  return t;
}

Machine random_machine(unsigned seed) {
  Dice dice{std::mt19937(seed)};
  const int kind = dice.below(3);
  return kind == 0 ? random_tackle(dice) : kind == 1 ? random_net(dice) : random_pole(dice);
}

/// What is left on each freedom by the tables alone: N, moments by the machine's size.
double worst_balance(const Machine& t, const EquilibriumResult& r) {
  const std::size_t n = t.model.bodies.size();
  std::vector<Vector3> force(n, Vector3::Zero()), moment(n, Vector3::Zero());
  const auto act = [&](int b, const Vector3& at, const Vector3& f) {
    if (b == machine::ground) return;
    const auto i = static_cast<std::size_t>(b);
    force[i] += f;
    moment[i] += (at - r.state.bodies[i].position).cross(f);
  };
  for (int b = 0; b < static_cast<int>(n); ++b) {
    const machine::Body& body = t.model.bodies[static_cast<std::size_t>(b)];
    act(b, machine::in_ground(r.state, {.body = b, .at = body.centre}), {0, 0, -body.mass * t.model.gravity});
  }
  for (const machine::Load& load : t.model.loads) act(load.at.body, machine::in_ground(r.state, load.at), load.force);
  for (const BranchResult& s : r.branches) {
    const machine::Reeving& rope = t.model.reevings[static_cast<std::size_t>(s.reeving)];
    Vector3 along = s.end - s.start;
    along.z() = 0;
    if (along.norm() > 0) along.normalize();
    act(rope.nodes[static_cast<std::size_t>(s.from)].at.body, s.start,
        rope.copies * (s.H * along + s.V_from * taut::up()));
    act(rope.nodes[static_cast<std::size_t>(s.to)].at.body, s.end, -rope.copies * (s.H * along + s.V_to * taut::up()));
  }
  double worst = 0;
  for (std::size_t b = 0; b < n; ++b) {
    for (const machine::Freedom& way : t.model.bodies[b].free) {
      worst = std::max({worst, std::abs(way.along.dot(force[b])), std::abs(way.about.dot(moment[b])) / t.size});
    }
  }
  return worst;
}

double largest(const Machine& t, const EquilibriumResult& r) {
  double most = 0;
  for (const machine::Body& b : t.model.bodies) most = std::max(most, b.mass * t.model.gravity);
  for (const BranchResult& s : r.branches) most = std::max({most, s.T_from, s.T_to});
  return most;
}

RC_GTEST_PROP(RandomMachines, TablesBalance, (unsigned seed)) {
  const Machine t = random_machine(seed);
  const EquilibriumResult r = equilibrium(t.model);
  if (!r.outcome.ok()) return refused(r);
  double stiffest = 0;
  for (const machine::Reeving& rope : t.model.reevings) stiffest = std::max(stiffest, rope.stiffness);
  const double force = 1e-9 * largest(t, r) + 2e-14 * stiffest;
  RC_ASSERT(worst_balance(t, r) <= 10 * force);
  RC_ASSERT(r.closure.rope <= 1e-9 * t.size);
  RC_ASSERT(r.closure.force <= 2 * force);
  for (const BranchResult& s : r.branches) {
    RC_ASSERT(std::isfinite(s.T_from + s.T_to + s.sag + s.stretched) && s.T_from >= 0 && s.T_to >= 0);
    const double warmer = 1 + t.model.reevings[static_cast<std::size_t>(s.reeving)].thermal_strain;
    RC_ASSERT(s.unstretched > 0 && s.stretched >= s.unstretched * warmer * (1 - 1e-12));
    RC_ASSERT(s.sag >= -1e-9 * t.size);
  }
  for (std::size_t k = 0; k < r.ropes.size(); ++k) {
    RC_ASSERT(std::abs(r.ropes[k].unstretched - t.model.reevings[k].value) <= 1e-9 * t.size);
  }
}

/// Every rope's largest tension and the bodies' heights by `scale`.
std::vector<double> answer(const EquilibriumResult& r, double scale) {
  std::vector<double> all;
  all.reserve(r.ropes.size() + r.state.bodies.size());
  for (const RopeResult& rope : r.ropes) all.push_back(rope.T_max);
  for (const machine::Pose& p : r.state.bodies) all.push_back(p.position.z() / scale);
  return all;
}

/// Poles and nets have one stable place near where they start; what is found does not depend on the frame.
RC_GTEST_PROP(RandomMachines, SameInEveryFrame, (unsigned seed)) {
  const Machine t = random_machine(seed);
  const EquilibriumResult r = equilibrium(t.model);
  if (!r.outcome.ok()) return;
  const std::vector<double> here = answer(r, 1);
  const double force = 1e-8 * largest(t, r);
  const Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
  const Matrix3 turned = Eigen::AngleAxisd(0.7 + static_cast<double>(seed % 100), Vector3::UnitZ()).toRotationMatrix();
  for (const Matrix3& M : {mirror, turned, Matrix3(1000 * Matrix3::Identity())}) {
    const EquilibriumResult there = equilibrium(transformed(t.model, M));
    RC_ASSERT(there.outcome.ok());
    const std::vector<double> same = answer(there, std::cbrt(std::abs(M.determinant())));
    for (std::size_t i = 0; i < here.size(); ++i) {
      RC_ASSERT(std::abs(same[i] - here[i]) <= (i < r.ropes.size() ? force : 1e-7 * t.size));
    }
  }
}

}  // namespace random_machines_test
