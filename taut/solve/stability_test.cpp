#include "taut/solve/stability.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace {

namespace mechanics = taut::mechanics;

using namespace taut_test;
using namespace taut::solve;
using taut::Status;

EnergyCurvature curvature_at_rest(const machine::Model& m) {
  const EquilibriumResult r = equilibrium(m);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  const mechanics::Layout l = mechanics::layout(m, r.state, {}, {});
  const mechanics::System system{.model = m, .layout = l, .coordinate = 0};
  mechanics::Configuration c;
  c.bodies = r.state.bodies;
  for (const mechanics::Layout::Branch& k : l.branches) {
    c.branches.push_back(r.state.branches[static_cast<std::size_t>(k.reeving)][static_cast<std::size_t>(k.from)]);
  }
  mechanics::Evaluation e;
  EXPECT_FALSE(mechanics::evaluate(system, c, e));
  return *energy_curvature(system, c, e);
}

Eigen::MatrixXd full(const taut::SparseRows& rows) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows.rows(), rows.rows());
  for (int i = 0; i < rows.rows(); ++i) {
    for (const auto& [column, value] : rows.row(i)) all(i, column) += value;
  }
  return all;
}

taut::SparseRows sparse(const Eigen::MatrixXd& all) {
  taut::Entries entries;
  entries.reset(static_cast<int>(all.rows()));
  for (int i = 0; i < entries.size(); ++i) {
    for (int j = 0; j < entries.size(); ++j) entries.add(i, j, all(i, j));
  }
  return {entries.size(), entries.all()};
}

double asymmetry(const machine::Model& m) {
  const Eigen::MatrixXd H = full(curvature_at_rest(m).matrix);
  return (H - H.transpose()).norm() / H.norm();
}

TEST(Stability, TheCurvatureOfAnEnergyIsSymmetric) {
  EXPECT_LT(asymmetry(three_spans(316, 0)), 1e-9);
  EXPECT_LT(asymmetry(three_spans(313, 0)), 1e-9);
  EXPECT_LT(asymmetry(with_carriage(true, 0)), 1e-9);
  machine::Model copies = with_carriage(true, 0);
  copies.reevings[0].copies = 2;
  EXPECT_LT(asymmetry(copies), 1e-9);
  // on rounds, with the strain of their arcs; there the machine leaves out the weight of the rope
  EXPECT_LT(asymmetry(tackle(6, 1, 3000)), 1e-9);
  EXPECT_LT(asymmetry(tackle(5, 1, 3000)), 1e-9);
  machine::Model turning = boom();
  for (machine::Reeving& rope : turning.reevings) rope.weight = 0;
  turning.reevings[1].nodes[0].radius = 0;  // of a drum's rope only the free part is counted
  turning.reevings[1].nodes[1].axis = Vector3::UnitY();
  turning.reevings[1].nodes[1].at.at.y() = 0;
  EXPECT_LT(asymmetry(turning), 1e-9);
}

TEST(Stability, NegativeDirections) {
  Eigen::Matrix3d A = Eigen::Vector3d(4, 1e6, 1e-3).asDiagonal();
  EXPECT_FALSE(negative_direction(sparse(A)));
  A(2, 2) = 0;  // neutral
  EXPECT_FALSE(negative_direction(sparse(A)));
  A << 2, 3, 0, 3, 2, 0, 0, 0, 1;  // eigenvalues 5, -1, 1
  const auto v = negative_direction(sparse(A));
  ASSERT_TRUE(v);
  EXPECT_LT(v->dot(A * *v), 0);
}

TEST(Stability, ANegativeDirectionOfALargeMatrix) {
  // springs in a row with a negative one among them: the two parts are pushed apart
  const int n = 500, weak = 300;
  taut::Entries A;
  A.reset(n);
  for (int i = 0; i <= n; ++i) {
    const double k = i == weak ? -0.01 : 1;
    if (i > 0) A.add(i - 1, i - 1, k);
    if (i < n) A.add(i, i, k);
    if (i == 0 || i == n) continue;
    A.add(i - 1, i, -k);
    A.add(i, i - 1, -k);
  }
  const auto v = negative_direction({n, A.all()});
  ASSERT_TRUE(v);
  EXPECT_LT(v->dot(taut::SparseRows(n, A.all()).times(*v)), 0);
  A.add(weak - 1, weak - 1, 1);  // both parts held
  A.add(weak, weak, 1);
  EXPECT_FALSE(negative_direction({n, A.all()}));
}

/// A pole on a hinge between two weightless guys in its plane, with a weight on top.
machine::Model pole(double weight) {
  machine::Model m;
  m.bodies.push_back(body("pole", {0, 0, 0}, 0, "Y"));
  m.loads.push_back({{.body = 0, .at = {0, 0, 10}}, {0, 0, -weight}});
  for (const double side : {-1.0, 1.0}) {
    m.reevings.push_back(reeve("guy", {anchor_on("top", 0, {0, 0, 10}), anchor("a", {8 * side, 0, 0})}, 12.8, 0, 2e6));
  }
  return m;
}

TEST(Stability, AGuyedPoleHoldsUpToItsStiffness) {
  // U = sum of guys - W h cos(theta), guy l(theta): l' = -+ R h/l, l'' = -(R h/l)^2/l
  const double h = 10, R = 8, l = std::hypot(h, R), T = 2e6 * (l / 12.8 - 1), arm = R * h / l;
  const double stiffness = 2 * (2e6 / 12.8 * arm * arm - T * arm * arm / l);
  EXPECT_TRUE(equilibrium(pole(0.999 * stiffness / h)).outcome.ok());
  const EquilibriumResult r = equilibrium(pole(1.001 * stiffness / h));
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("body 'pole' turns over about y"), std::string::npos) << r.outcome.message;
  EXPECT_NE(r.outcome.message.find("describe it a little off this place"), std::string::npos) << r.outcome.message;
}

TEST(Stability, APendulumHangsAndAPoleFalls) {
  machine::Model m;
  m.bodies.push_back(body("rod", {0, 0, 0}, 100, "XY"));
  m.bodies[0].centre = {0, 0, -2};
  EXPECT_TRUE(equilibrium(m).outcome.ok());
  m.bodies[0].centre = {0, 0, 2};
  const EquilibriumResult r = equilibrium(m);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("body 'rod' turns over"), std::string::npos) << r.outcome.message;
}

TEST(Stability, ASlackRopeRunsOverItsSupportIntoOneSpan) {
  // two equal spans, each twice as long as its chord: shared equally, the rope has tension enough to stay only while
  // more length in a span means less tension; here it means more
  machine::Model m;
  m.reevings.push_back(
      reeve("rope", {anchor("a", {0, 0, 0}), saddle("mid", {50, 0, 0}, 0), anchor("b", {100, 0, 0})}, 200, 10, 1e8));
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_GT(std::abs(r.branches[0].unstretched - r.branches[1].unstretched), 80);
  EXPECT_NEAR(r.branches[0].T_to / r.branches[1].T_from, 1, 1e-9);
  // taut, it is shared
  m.reevings[0].value = 104;
  const EquilibriumResult taut = equilibrium(m);
  ASSERT_TRUE(taut.outcome.ok()) << taut.outcome.message;
  EXPECT_NEAR(taut.branches[0].unstretched, taut.branches[1].unstretched, 1e-6);
}

/// A pole that leans by 3 m at its top of 10 m, held by a weight whose rope runs over `bend`.
machine::Model leaning(machine::Node bend, double weight) {
  machine::Model m;
  m.bodies.push_back(body("pole", origin, 0, "Y"));
  m.bodies.push_back(body("weight", {-10, 0, -7}, weight / m.gravity, "z"));
  m.loads.push_back({{.body = 0, .at = {3, 0, 10}}, {0, 0, -10e3}});
  bend.at.at = {-10, 0, 10};
  m.reevings.push_back(
      reeve("line", {anchor_on("top", 0, {3, 0, 10}), std::move(bend), anchor_on("weight", 1)}, 30, 0, 1e7));
  return m;
}

/// Whether the pole does not stay: refused, or found where it hangs from its hinge.
bool falls(const machine::Model& m, Motion motion = Motion::at_rest) {
  EquilibriumOptions options;
  options.motion = motion;
  const EquilibriumResult r = equilibrium(m, options);
  if (r.outcome.ok()) return (r.state.bodies[0].orientation * Vector3(3, 0, 10)).z() < -9;
  return r.outcome.message.find("body 'pole' turns over about y") != std::string::npos;
}

TEST(Stability, ALossDoesNotKeepALeaningPoleUp) {
  for (const double efficiency : {1.0, 0.95}) {
    machine::Node bend = over("bend", origin);
    bend.law.efficiency = efficiency;
    EXPECT_TRUE(falls(leaning(bend, 3000 * efficiency), Motion::in)) << efficiency;
    EXPECT_TRUE(falls(leaning(bend, 3000 / efficiency), Motion::out)) << efficiency;
  }
}

TEST(Stability, ATorqueDoesNotKeepALeaningPoleUp) {
  machine::Node drive = over("drive", origin);
  drive.kind = machine::NodeKind::drive;
  drive.radius = 0.2;
  drive.side = -1;
  drive.tension_drop = 1000;
  EXPECT_TRUE(falls(leaning(drive, 2000)));
}

/// A hook on a rope over a sheave at (0, 0, 10), the rope held by a tension at its other end.
machine::Model balanced_hook(const Vector3& at, double mass, double tension) {
  machine::Model m;
  m.bodies.push_back(body("hook", at, mass, "xz"));
  machine::Reeving rope =
      reeve("rope", {anchor("winch", {-6, 0, 1}), over("head", {0, 0, 10}), anchor_on("hook", 0)}, tension, 0, 1e7);
  rope.given = machine::Given::tension_at_start;
  m.reevings.push_back(rope);
  return m;
}

TEST(Stability, ABodyThatBalancesAnywhereIsToldWhereItIsPutFarAway) {
  machine::Model m = balanced_hook({0, 0, 3}, 500, 500 * 9.80665);
  const EquilibriumResult stays = equilibrium(m);
  ASSERT_TRUE(stays.outcome.ok()) << stays.outcome.message;
  EXPECT_NEAR(stays.state.bodies[0].position.z(), 3, 0.05) << "where it is described";
  EXPECT_EQ(stays.indifferent, "");
  m.bodies[0].position = {5, 0, 3};  // it swings in, and nothing says how far it goes down
  const EquilibriumResult goes = equilibrium(m);
  ASSERT_TRUE(goes.outcome.ok()) << goes.outcome.message;
  EXPECT_NEAR(goes.state.bodies[0].position.x(), 0, 1e-6);
  const double far = std::abs(goes.state.bodies[0].position.z() - 3);
  EXPECT_GT(far, 0.1);
  EXPECT_EQ(goes.indifferent, fmt::format("'hook' by {:.3g} m", far));
  // a rope of a given length has one place for it, however little it stretches
  m.reevings[0].given = machine::Given::length;
  m.reevings[0].value = 19;
  for (const double weight : {0.0, 10.0}) {
    for (const double EA : {1e7, 1e10, 1e12, HUGE_VAL}) {
      m.reevings[0].weight = weight;
      m.reevings[0].stiffness = EA;
      const EquilibriumResult one = equilibrium(m);
      ASSERT_TRUE(one.outcome.ok()) << one.outcome.message;
      EXPECT_EQ(one.indifferent, "") << EA;
    }
  }
}

TEST(Stability, TwoEqualWeightsAreFoundBesideTheirPlaces) {
  machine::Model m;
  m.bodies.push_back(body("left", {-3, 0, 3}, 500, "xz"));
  m.bodies.push_back(body("right", {3, 0, 5}, 500, "xz"));
  m.reevings.push_back(
      reeve("rope", {anchor_on("left", 0), over("a", {-3, 0, 10}), over("b", {3, 0, 10}), anchor_on("right", 1)}, 22, 0,
            1e7));
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.state.bodies[0].position.z() - r.state.bodies[1].position.z(), -2, 1e-3) << "both go down alike";
  EXPECT_EQ(r.indifferent, "");
  m.bodies[0].position = {-20, 0, 3};  // it swings in and rises
  EXPECT_NE(equilibrium(m).indifferent, "");
}

TEST(Stability, AForceAlongTheRopeDoesNotKeepALeaningPoleUp) {
  machine::Model m = leaning(over("bend", origin), 2000);
  m.bodies.push_back(body("cut", {-3.5, 0, 10}, 0, "xyz"));
  machine::Node cut = anchor_on("cut", 2);
  cut.kind = machine::NodeKind::load;
  cut.load.share = 0.5;
  cut.load.force = 1000;
  cut.load.sense = 1;
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 1, cut);
  EXPECT_TRUE(falls(m));
}

}  // namespace
