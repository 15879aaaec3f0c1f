#include "taut/mechanics/system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "taut/rope/catenary_shape.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// The equations out of equilibrium: balances against the slope of the machine's energy, laws against their formulas.
namespace taut::mechanics::system_test {

using namespace taut_test;

struct Laid {
  machine::Model m;
  Layout layout;
  Configuration c;
  Evaluation e;

  explicit Laid(machine::Model of, int flow = 0, const std::optional<machine::Prescribed>& prescribed = {})
      : m(std::move(of)) {
    const machine::State state = machine::initial_state(m);
    taut::Array<taut::Array<int>> flows = no_flow(m);
    for (auto& rope : flows) rope.assign(rope.size(), flow);
    layout = mechanics::layout(m, state, prescribed, flows);
    c = configuration_of(layout, state);
    c.open_loads.assign(layout.ropes.size(), 0);
  }
  System system(double coordinate = 0, double losses = 1) const {
    return {.model = m, .layout = layout, .coordinate = coordinate, .losses = losses};
  }
  /// Spans close by one step at a time.
  const Eigen::VectorXd& residual(double coordinate = 0, double losses = 1) {
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(evaluate(system(coordinate, losses), c, e));
    return e.residual;
  }
};

/// Elastic energy of a rope and what lifting its weight takes, J.
double energy_of(const rope::CatenaryRope& rope, const Vector3& from, const Vector3& to) {
  const Vector3 way = to - from;
  const auto s = rope::solve_catenary(rope, std::hypot(way.x(), way.y()), way.z());
  EXPECT_TRUE(s.has_value());
  constexpr int n = 200;
  double z = 0;
  for (int i = 0; i <= n; ++i) {
    const double part = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    z += part / (3 * n) * (from.z() + rope::point_at(rope, s->force, rope.length * i / n).z);
  }
  return rope.weight * rope.length * z + rope::elastic_energy(rope, s->force);
}

/// An inclined body, heavy beside its origin, with a load at its rim, between heavy ropes, one of them doubled.
TEST(System, BalancesAreTheSlopeOfTheEnergy) {
  machine::Model m;
  machine::Body b = body("body", {4, 1, 5}, 300, "xyzXYZ");
  b.orientation = Eigen::AngleAxisd(0.6, Vector3(1, 2, -1).normalized());
  b.centre = {0.2, -0.3, 0.4};
  m.bodies.push_back(b);
  m.loads.push_back({{.body = 0, .at = {0.5, 0.1, -0.6}}, {700, -400, -900}});
  const std::vector<Vector3> stumps = {{-6, 0, 9}, {15, -3, 11}, {3, 14, 2}},
                             lugs = {{-0.4, 0, 0.3}, {0.5, 0.2, 0}, {0, 0.6, -0.2}};
  const double lengths[] = {11.3, 13.1, 13.2};
  for (std::size_t i = 0; i < 3; ++i) {
    m.reevings.push_back(
        reeve("rope", {anchor("stump", stumps[i]), anchor_on("lug", 0, lugs[i])}, lengths[i], 12, 4e5));
  }
  m.reevings[1].copies = 2;
  Laid laid(m);
  laid.c.bodies[0].position += Vector3(0.2, -0.1, 0.3);  // nowhere near an equilibrium
  const Eigen::VectorXd balance = laid.residual();
  const auto energy = [&](const Configuration& c) {
    const machine::Pose& pose = c.bodies[0];
    double sum = 300 * m.gravity * (pose.position + pose.orientation * b.centre).z();
    sum -= m.loads[0].force.dot(pose.position + pose.orientation * m.loads[0].at.at);
    for (std::size_t i = 0; i < 3; ++i) {
      sum += m.reevings[i].copies * energy_of({.length = c.branches[i].length, .weight = 12, .stiffness = 4e5},
                                              stumps[i], pose.position + pose.orientation * lugs[i]);
    }
    return sum;
  };
  for (int i = 0; i < 6; ++i) {
    const double h = 1e-4;
    Configuration ahead, back;
    Change unit{.step = Eigen::VectorXd::Unit(laid.layout.size, i), .force = std::vector<rope::CatenaryForce>(3)};
    move(laid.system(), laid.c, unit, h, ahead);
    move(laid.system(), laid.c, unit, -h, back);
    EXPECT_NEAR(balance[i], -(energy(ahead) - energy(back)) / (2 * h), 1e-6 * laid.e.largest_force) << i;
  }
  EXPECT_GT(balance.head<6>().cwiseAbs().minCoeff(), 10);
}

/// A rope without weight over a sheave that turns and a saddle that does not, at tensions of its branches set by hand.
TEST(System, LawsOfContactsAreEulersAndTheBearings) {
  const double EA = 1e6, mu = 0.3, eta = 0.93;
  machine::Model m;
  m.reevings.push_back(reeve(
      "rope",
      {anchor("a", {-10, 0, 0}), saddle("saddle", {0, 0, 4}, mu), over("sheave", {9, 2, 5}), anchor("b", {14, 0, -3})},
      0, 0, EA));
  m.reevings[0].nodes[2].law.efficiency = eta;
  for (const int flow : {1, 0, -1}) {
    Laid laid(m, flow);
    const double T[] = {20e3, 26e3, 23e3};
    const Vector3 places[] = {{-10, 0, 0}, {0, 0, 4}, {9, 2, 5}, {14, 0, -3}};
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k)
      length += laid.c.branches[k].length = (places[k + 1] - places[k]).norm() / (1 + T[k] / EA);
    laid.m.reevings[0].value = length - 0.25;
    for (const double losses : {1.0, 0.4}) {
      const Eigen::VectorXd& r = laid.residual(0, losses);
      const Vector3 a = (places[1] - places[0]).normalized(), b = (places[2] - places[1]).normalized();
      const double euler = std::exp(losses * flow * mu * std::acos(a.dot(b))), bearing = std::pow(eta, -losses * flow);
      EXPECT_NEAR(r[*laid.layout.turns[0].row], T[1] / std::sqrt(euler) - T[0] * std::sqrt(euler), 1e-6);
      EXPECT_NEAR(r[*laid.layout.turns[1].row], T[2] / std::sqrt(bearing) - T[1] * std::sqrt(bearing), 1e-6);
      EXPECT_NEAR(r[laid.layout.ropes[0].row], 0.25, 1e-9);
      const Misfit all = misfit(laid.system(), laid.e);
      EXPECT_NEAR(all.length, 0.25, 1e-9);
      EXPECT_NEAR(all.force, std::max(std::abs(r[*laid.layout.turns[0].row]), std::abs(r[*laid.layout.turns[1].row])),
                  1e-9);
    }
    laid.m.reevings[0].given = machine::Given::tension_at_start;
    laid.m.reevings[0].value = 19e3;
    EXPECT_NEAR(laid.residual()[laid.layout.ropes[0].row], 1e3, 1e-6);
    laid.m.reevings[0].given = machine::Given::tension_at_end;
    EXPECT_NEAR(laid.residual()[laid.layout.ropes[0].row], 4e3, 1e-6);
  }
}

/// A carriage on a straight skyline is held along the mean direction of its rope, at its roller.
TEST(System, AHeldCarriageIsPulledAlongItsTrack) {
  machine::Model m;
  m.bodies.push_back(body("car", {60, 0, 10}, 0, "xyz"));
  m.reevings.push_back(reeve(
      "skyline", {anchor("head", {0, 0, 20}), over("car", origin, 0), anchor("tail", {150, 30, 50})}, 165, 0, 1e6));
  m.carriages.push_back({.name = "car", .body = 0, .reeving = 0, .node = 1, .mainline = {}});
  Laid laid(m, 0, machine::Prescribed{.carriage = 0, .x = 55});
  ASSERT_TRUE(laid.layout.hold);
  laid.residual(55);
  const Vector3 in = Vector3(60, 0, -10).normalized(), out = Vector3(90, 30, 40).normalized();
  const Vector3 along = (in + out).normalized();
  EXPECT_LT((track(laid.system(), laid.e) - along).norm(), 1e-12);
  EXPECT_LT((hold_place(laid.system(), laid.c) - Vector3(60, 0, 10)).norm(), 1e-12);
  EXPECT_NEAR(laid.e.residual[*laid.layout.coordinate_row], 5, 1e-9);
  const Eigen::VectorXd without = laid.e.residual;
  laid.c.hold = 1200;
  EXPECT_LT((laid.residual(55).head<3>() - without.head<3>() - 1200 * along).norm(), 1e-9);
}

TEST(System, ABranchWithoutAnswerIsNamed) {
  const double rigid = std::numeric_limits<double>::infinity();
  machine::Model m = three_spans(318, 0.1);
  Laid laid(m);
  laid.m.reevings[0].stiffness = rigid;
  laid.c.branches[1].length = 90;  // of 114 m from saddle to saddle
  const auto none = evaluate(laid.system(), laid.c, laid.e);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->branch, 1);
  EXPECT_EQ(none->why, rope::NoCatenary::too_short);
}

}  // namespace taut::mechanics::system_test
