// Witnesses that share nothing with the solver: a lumped chain, potential energy, symmetry.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "taut/rope/catenary_shape.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace witness_test {

using namespace taut_test;
using namespace taut::solve;

/// A plane chain of springs and lumped weights from (0, 0), hung up by its first tension (H, V), with one load.
struct Chain {
  int elements = 2000, loaded_after = 0;
  double length = 0, weight = 0, stiffness = 0, load_x = 0, load_z = 0;  // the load acts on the chain

  struct End {
    Eigen::Vector2d at, load_at, last;
  };
  End end(const Eigen::Vector2d& first) const {
    const double piece = length / elements;
    End e{.at = {0, 0}, .load_at = {0, 0}, .last = {0, 0}};
    // half an element's weight hangs at the support itself
    Eigen::Vector2d pull = first + Eigen::Vector2d(0, weight * piece / 2);
    for (int i = 1; i <= elements; ++i) {
      e.at += pull.normalized() * piece * (1 + pull.norm() / stiffness);
      e.last = pull;
      pull.y() += weight * piece;
      if (i == loaded_after) {
        e.load_at = e.at;
        pull -= Eigen::Vector2d(load_x, load_z);
      }
    }
    return e;
  }
  /// The first tension that brings the end to `to`.
  Eigen::Vector2d solve(const Eigen::Vector2d& to, Eigen::Vector2d first) const {
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector2d open = end(first).at - to;
      Eigen::Matrix2d slope;
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector2d step = Eigen::Vector2d::Unit(k) * 1e-5 * first.norm();
        slope.col(k) = (end(first + step).at - end(first - step).at) / (2e-5 * first.norm());
      }
      first -= slope.inverse() * open;
    }
    return first;
  }
};

TEST(Witness, ClampedCarriageOnALumpedChain) {
  for (const double part : {0.2, 0.5, 0.8}) {
    const double length = 262, weight = 21, stiffness = 26.6e6;
    machine::Model m;
    m.bodies.push_back(body("car", {250 * part, 0, 102 * part - 8}, 2000, "xz"));
    machine::Node car = over("car", origin, 0);
    car.kind = machine::NodeKind::clamp;
    car.length_before = part * length;
    m.reevings.push_back(
        reeve("skyline", {anchor("head", {0, 0, 0}), car, anchor("tail", {240, 0, 102})}, length, weight, stiffness));
    const EquilibriumResult r = equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    Chain chain;
    chain.length = length;
    chain.weight = weight;
    chain.stiffness = stiffness;
    chain.loaded_after = static_cast<int>(std::lround(part * chain.elements));
    chain.load_z = -2000 * m.gravity;
    const Eigen::Vector2d first = chain.solve({240, 102}, {r.branches[0].H * 1.02, r.branches[0].V_from * 0.97});
    const Chain::End end = chain.end(first);
    EXPECT_LT((end.at - Eigen::Vector2d(240, 102)).norm(), 1e-8);
    EXPECT_NEAR(r.branches[0].T_from / first.norm(), 1, 1e-4);
    EXPECT_NEAR(r.branches[1].T_to / end.last.norm(), 1, 1e-4);
    // the load's place, which other programs got wrong while the tensions were right
    const Vector3& at = r.state.bodies[0].position;
    EXPECT_NEAR(at.x(), end.load_at.x(), 1e-4 * length);
    EXPECT_NEAR(at.z(), end.load_at.y(), 1e-4 * length);
  }
}

TEST(Witness, RollingCarriageHeldOnItsTrackOnALumpedChain) {
  machine::Model m;
  m.bodies.push_back(body("car", {100, 0, 30}, 1500, "xz"));
  m.reevings.push_back(reeve(
      "skyline", {anchor("head", {0, 0, 0}), over("car", origin, 0), anchor("tail", {240, 0, 102})}, 262, 21, 26.6e6));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 90};
  const EquilibriumResult r = equilibrium(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches[0].T_to / r.branches[1].T_from, 1, 1e-10);
  // the resultant of two equal tensions lies on the bisector, across the hold
  EXPECT_NEAR(r.contacts[0].force.dot(r.hold) / (r.contacts[0].force.norm() * r.hold.norm()), 0, 1e-9);
  Chain chain;
  chain.length = 262;
  chain.weight = 21;
  chain.stiffness = 26.6e6;
  chain.elements = 20000;  // the wheel stands between two nodes: half an element of doubt
  chain.loaded_after = static_cast<int>(std::lround(r.branches[0].unstretched / 262 * chain.elements));
  chain.load_x = r.hold.x();
  chain.load_z = r.hold.z() - 1500 * m.gravity;
  const Eigen::Vector2d first = chain.solve({240, 102}, {r.branches[0].H * 1.02, r.branches[0].V_from * 0.97});
  EXPECT_NEAR(r.branches[0].T_from / first.norm(), 1, 1e-4);
  EXPECT_NEAR(r.branches[1].T_to / chain.end(first).last.norm(), 1, 1e-4);
  EXPECT_NEAR(chain.end(first).load_at.x(), 90, 0.01);
}

/// Elastic and gravitational energy of a machine of points, by quadrature along every rope.
double energy(const machine::Model& m, const std::vector<BranchResult>& spans, const std::vector<double>& lengths,
              const machine::State& state) {
  double sum = 0;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) sum += m.bodies[b].mass * m.gravity * state.bodies[b].position.z();
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const machine::Reeving& r = m.reevings[static_cast<std::size_t>(spans[k].reeving)];
    const Vector3 from = machine::in_ground(state, r.nodes[static_cast<std::size_t>(spans[k].from)].at);
    const Vector3 to = machine::in_ground(state, r.nodes[static_cast<std::size_t>(spans[k].to)].at);
    const taut::rope::CatenaryRope rope{.length = lengths[k], .weight = r.weight, .stiffness = r.stiffness};
    const auto span = taut::rope::solve_span(rope, to - from);
    EXPECT_TRUE(span.has_value());
    sum += taut::rope::elastic_energy(span->rope, span->force);
    const int pieces = 400;  // Simpson
    const double h = lengths[k] / pieces;
    for (int i = 0; i <= pieces; ++i) {
      const double share = i == 0 || i == pieces ? 1 : i % 2 == 1 ? 4 : 2;
      sum += r.weight * h / 3 * share * (from + taut::rope::point_at(*span, std::min(i * h, lengths[k]))).z();
    }
  }
  return sum;
}

TEST(Witness, EnergyIsStationaryWithoutFriction) {
  const machine::Model m = with_carriage(true, 0);
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  std::vector<double> lengths;
  lengths.reserve(r.branches.size());
  for (const BranchResult& s : r.branches) lengths.push_back(s.unstretched);
  const double h = 1e-4, force = r.ropes[0].T_max;
  // rope passed over each contact of the skyline
  for (std::size_t k = 0; k < 3; ++k) {
    auto ahead = lengths, back = lengths;
    ahead[k] += h;
    ahead[k + 1] -= h;
    back[k] -= h;
    back[k + 1] += h;
    const double slope = (energy(m, r.branches, ahead, r.state) - energy(m, r.branches, back, r.state)) / (2 * h);
    EXPECT_NEAR(slope / force, 0, 1e-6) << k;
  }
  // the carriage moved
  for (int axis = 0; axis < 3; ++axis) {
    machine::State ahead = r.state, back = r.state;
    ahead.bodies[0].position[axis] += h;
    back.bodies[0].position[axis] -= h;
    const double slope = (energy(m, r.branches, lengths, ahead) - energy(m, r.branches, lengths, back)) / (2 * h);
    EXPECT_NEAR(slope / force, 0, 1e-5) << axis;
  }
}

/// Tensions at all span ends, in order.
std::vector<double> tensions(const EquilibriumResult& r) {
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  std::vector<double> all;
  for (const BranchResult& s : r.branches) all.insert(all.end(), {s.T_from, s.T_to});
  return all;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double factor = 1) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(b[i] / (factor * a[i]), 1, 1e-8) << i;
}

TEST(Witness, SameAnswerMirroredTurnedAndInOtherUnits) {
  const taut::Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
  const taut::Matrix3 turned = Eigen::AngleAxisd(0.7, Vector3::UnitZ()).toRotationMatrix();
  for (const machine::Model& m : {with_carriage(true), tackle(6, 0.97, 3000, 8), tackle(3, 0.96, 2000)}) {
    for (const Motion motion : {Motion::at_rest, Motion::hoist, Motion::lower}) {
      EquilibriumOptions options;
      options.motion = motion;
      const auto T = tensions(equilibrium(m, options));
      expect_same(T, tensions(equilibrium(transformed(m, mirror), options)));
      expect_same(T, tensions(equilibrium(transformed(m, turned), options)));
      expect_same(T, tensions(equilibrium(transformed(m, 1000 * taut::Matrix3::Identity()), options)));
    }
  }
}

TEST(Witness, SameAnswerWithTheRopeRunTheOtherWay) {
  for (const machine::Model& m : {with_carriage(true), tackle(4, 0.97, 3000, 8)}) {
    machine::Model back = m;
    machine::Reeving& r = back.reevings[0];
    std::reverse(r.nodes.begin(), r.nodes.end());
    for (machine::Node& n : r.nodes) n.side = -n.side;
    r.haul = -r.haul;
    EquilibriumOptions options;
    options.motion = Motion::hoist;
    auto T = tensions(equilibrium(m, options));
    const auto B = tensions(equilibrium(back, options));
    std::reverse(T.begin(), T.begin() + std::ptrdiff_t{2} * machine::branch_count(r));
    expect_same(T, B);
  }
}

TEST(Witness, EndsNeedNotBeOrderedLowToHigh) {
  machine::Model m;
  m.reevings.push_back(reeve(
      "rope", {anchor("high", {0, 0, 60}), saddle("mid", {80, 0, 10}, 0), anchor("end", {150, 0, 35})}, 180, 12, 1e7));
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok());
  // along one rope the tension grows with height by its weight (less its stretch)
  for (const BranchResult& s : r.branches) {
    const double strain = std::max(s.T_from, s.T_to) / 1e7;
    EXPECT_NEAR(s.T_to - s.T_from, 12 * (s.end.z() - s.start.z()), 12 * 60 * strain);
  }
  EXPECT_GT(r.branches[0].stretched, r.branches[0].unstretched);
}

}  // namespace witness_test
