#include "taut/solve/equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/solve/condition.hpp"
#include "test/support/machines.hpp"

namespace equilibrium_test {

using namespace taut_test;
using namespace taut::solve;
using taut::Status;

EquilibriumResult moving(const machine::Model& m, Motion motion) {
  EquilibriumOptions options;
  options.motion = motion;
  return equilibrium(m, options);
}

double total_length(const EquilibriumResult& r, int reeving) {
  double sum = 0;
  for (const BranchResult& s : r.branches) sum += s.reeving == reeving ? s.unstretched : 0;
  return sum;
}

TEST(Equilibrium, LevelCatenaryOfTheSpecification) {
  machine::Model m;
  m.gravity = 9.81;
  m.reevings.push_back(reeve("rope", {anchor("a", {0, 0, 0}), anchor("b", {80, 0, 0})}, 100, 9.81, 1e7));
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok());
  EXPECT_NEAR(r.branches[0].H, 331.73013818, 1e-8 * 331);
  EXPECT_NEAR(r.branches[0].T_to, 592.144521698, 1e-8 * 592);
  EXPECT_NEAR(r.branches[0].sag, 26.547034967, 1e-8 * 26);
  EXPECT_GT(r.branches[0].stretched, r.branches[0].unstretched);
}

TEST(Equilibrium, EverySaddleObeysItsLawInBothDirections) {
  for (const Motion motion : {Motion::at_rest, Motion::in, Motion::out}) {
    for (const double length : {312.5, 316.0, 330.0}) {
      const machine::Model m = three_spans(length, 0.15);
      const EquilibriumResult r = moving(m, motion);
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      const double flow = motion == Motion::at_rest ? 0 : motion == Motion::in ? -1 : 1;  // haul = -1
      for (const ContactResult& c : r.contacts) {
        const double wanted = c.T_in * std::exp(flow * 0.15 * std::max(0.0, c.wrap));
        EXPECT_NEAR(c.T_out / wanted, 1, 1e-9);
        EXPECT_EQ(c.state, c.wrap < 0  ? ContactState::pulled
                           : flow == 0 ? ContactState::stuck
                                       : ContactState::slipping);
      }
      EXPECT_NEAR(total_length(r, 0) / length, 1, 1e-9);
      EXPECT_LT(r.closure.rope, 1e-9);
      EXPECT_LT(r.closure.balance, 1e-9 * r.ropes[0].T_max);
    }
  }
}

/// The middle of a line lies aside: its saddle is pressed by the bend in plan as by that downwards.
TEST(Equilibrium, ASaddleIsPressedByABendInPlanToo) {
  for (const double aside : {0.0, 4.0, -20.0, 35.0}) {
    for (const double up : {8.0, 0.5}) {
      machine::Model m;
      m.gravity = 9.81;
      machine::Node stone = saddle("stone", {100, aside, up}, 0.15);
      stone.radius = 0.5;
      stone.axis = Vector3::UnitY();
      m.reevings.push_back(reeve("rope", {anchor("a", {0, 0, 0}), stone, anchor("b", {200, 0, 0})}, 60e3, 20, 2e7));
      m.reevings[0].given = machine::Given::tension_at_end;
      for (const Motion motion : {Motion::in, Motion::out}) {
        const EquilibriumResult r = moving(m, motion);
        ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
        const double T_in = r.contacts[0].T_in, T_out = r.contacts[0].T_out;
        const double force = r.contacts[0].force.squaredNorm();
        const double theta = std::acos((T_in * T_in + T_out * T_out - force) / (2 * T_in * T_out));
        EXPECT_NEAR(std::abs(std::log(T_out / T_in)), 0.15 * theta, 1e-9) << aside << ' ' << up;
        EXPECT_NEAR(r.contacts[0].turning, theta, 1e-9);
      }
    }
  }
}

TEST(Equilibrium, BandAtRestHoldsBothDirections) {
  const machine::Model m = three_spans(316, 0.15);
  const EquilibriumResult rest = equilibrium(m);
  ASSERT_TRUE(rest.band);
  const EquilibriumResult in = moving(m, Motion::in), out = moving(m, Motion::out);
  for (std::size_t k = 0; k < rest.branches.size(); ++k) {
    const double T[] = {rest.branches[k].T_from, in.branches[k].T_from, out.branches[k].T_from};
    EXPECT_NEAR(rest.branches[k].T_from_min / std::ranges::min(T), 1, 1e-9);
    EXPECT_NEAR(rest.branches[k].T_from_max / std::ranges::max(T), 1, 1e-9);
  }
  EXPECT_LT(rest.branches[2].T_from_min, rest.branches[2].T_from);
  EXPECT_GT(rest.branches[2].T_from_max, rest.branches[2].T_from);
  EXPECT_FALSE(equilibrium(three_spans(316, 0)).band);
}

/// Lead line of a tackle: S = Q K^n (K - 1)/(K^n - 1), lowering with 1/K for K.
double lead_line(double Q, int n, double K) {
  return K == 1 ? Q / n : Q * std::pow(K, n) * (K - 1) / (std::pow(K, n) - 1);
}

TEST(Equilibrium, LeadLineOfTackles) {
  for (const int falls : {2, 3, 4, 6}) {
    for (const double efficiency : {1.0, 0.98, 0.95}) {
      const machine::Model m = tackle(falls, efficiency, 3000);
      const double Q = 3000 * m.gravity, K = 1 / efficiency;
      const EquilibriumResult up = moving(m, Motion::hoist), down = moving(m, Motion::lower), rest = equilibrium(m);
      ASSERT_TRUE(up.outcome.ok() && down.outcome.ok() && rest.outcome.ok());
      EXPECT_NEAR(up.branches[0].T_from / lead_line(Q, falls, K), 1, 1e-9) << falls;
      EXPECT_NEAR(down.branches[0].T_from / lead_line(Q, falls, efficiency), 1, 1e-9) << falls;
      EXPECT_NEAR(rest.branches[0].T_from / (Q / falls), 1, 1e-9) << falls;
      EXPECT_NEAR(rest.branches[0].T_from_max / lead_line(Q, falls, K), 1, 1e-9);
      // every part is vertical, every sheave wrapped half round but the lead
      for (std::size_t k = 1; k < up.branches.size(); ++k) EXPECT_NEAR(up.branches[k].H, 0, 1e-6);
      for (std::size_t k = 1; k < up.contacts.size(); ++k) EXPECT_NEAR(up.contacts[k].wrap, std::numbers::pi, 1e-9);
    }
  }
}

TEST(Equilibrium, ArcsAreCountedWithTheirStrain) {
  const EquilibriumResult r = equilibrium(tackle(4, 1, 3000));
  const double T = 3000 * 9.80665 / 4;
  double length = total_length(r, 0);
  for (const ContactResult& c : r.contacts) length += 0.25 * c.wrap / (1 + T / 1e7);
  EXPECT_NEAR(length, 20.6 + 52 + 0.5, 1e-9);
}

TEST(Equilibrium, ColdAndWarmRopes) {
  machine::Model m = three_spans(313, 0);
  const EquilibriumResult r = equilibrium(m);
  m.reevings[0].thermal_strain = -30 * 12e-6;
  const EquilibriumResult cold = equilibrium(m);
  EXPECT_GT(cold.ropes[0].T_max, r.ropes[0].T_max);
  EXPECT_NEAR(cold.ropes[0].unstretched, 313, 1e-9);
  // the same as a rope made shorter by hand, with its weight
  machine::Model shorter = three_spans(313 * (1 - 30 * 12e-6), 0);
  shorter.reevings[0].weight /= 1 - 30 * 12e-6;
  EXPECT_NEAR(equilibrium(shorter).ropes[0].T_max, cold.ropes[0].T_max, 1e-6);
}

TEST(Equilibrium, GivenTensionThenFrozenLength) {
  machine::Model m = three_spans(0, 0.1);
  m.reevings[0].given = machine::Given::tension_at_end;
  m.reevings[0].value = 50e3;
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches.back().T_to, 50e3, 1e-4);
  const EquilibriumResult again = equilibrium(installed(m, r));
  EXPECT_NEAR(again.branches.back().T_to, 50e3, 1e-4);
}

TEST(Equilibrium, ClosedRopeWithTakeUp) {
  // a belt over a drive and an idler on a slide, pulled by 5 kN
  machine::Model m;
  m.bodies.push_back(body("slide", {3, 0, 0}, 0, "x"));
  m.loads.push_back({{.body = 0, .at = origin}, {5e3, 0, 0}});
  machine::Node drive = sheave("drive", origin, 0.3, 1);
  drive.kind = machine::NodeKind::drive;
  m.reevings.push_back(reeve("belt", {drive, sheave("idler", origin, 0.3, 1, 0.97, 0)}, 8, 0, 1e6));
  m.reevings[0].closed = true;
  const EquilibriumResult rest = equilibrium(m);
  ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
  EXPECT_NEAR(rest.branches[0].T_from, 2500, 1e-6);
  EXPECT_NEAR(rest.branches[1].T_from, 2500, 1e-6);
  const double stretched = 8 * (1 + 2500 / 1e6);
  EXPECT_NEAR(rest.state.bodies[0].position.x(), (stretched - 2 * std::numbers::pi * 0.3) / 2, 1e-9);
  EXPECT_EQ(rest.contacts[0].state, ContactState::held);
  EXPECT_NEAR(rest.contacts[0].wrap, std::numbers::pi, 1e-12);
  EquilibriumOptions turning;
  turning.flow = {{1, 1}};
  const EquilibriumResult run = equilibrium(m, turning);
  ASSERT_TRUE(run.outcome.ok()) << run.outcome.message;
  EXPECT_NEAR(run.contacts[1].T_out * 0.97, run.contacts[1].T_in, 1e-6);
  EXPECT_NEAR(run.branches[0].T_from + run.branches[1].T_from, 5000, 1e-6);
  EXPECT_EQ(run.contacts[1].state, ContactState::turning);
}

TEST(Equilibrium, CopiesShareTheLoad) {
  machine::Model m = tackle(2, 1, 3000, 8);
  m.reevings[0].copies = 2;
  const EquilibriumResult two = equilibrium(m);
  ASSERT_TRUE(two.outcome.ok());
  machine::Model half = tackle(2, 1, 1500, 8);
  EXPECT_NEAR(two.branches[0].T_from / equilibrium(half).branches[0].T_from, 1, 1e-9);
}

TEST(Equilibrium, SlackGuyDropsOut) {
  // a pole on a hinge, leaning on the guy to its left; the right one is too long to carry
  machine::Model m;
  m.bodies.push_back(body("pole", {0, 0, 0}, 0, "Y"));
  m.loads.push_back({{.body = 0, .at = {0, 0, 10}}, {1e3, 0, -5e3}});
  m.reevings.push_back(reeve("left", {anchor_on("top", 0, {0, 0, 10}), anchor("a", {-10, 0, 0})}, 14.1, 0, 1e6));
  m.reevings.push_back(reeve("right", {anchor_on("top", 0, {0, 0, 10}), anchor("b", {10, 0, 0})}, 14.2, 0, 1e6));
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_FALSE(r.branches[0].slack);
  EXPECT_TRUE(r.branches[1].slack);
  EXPECT_EQ(r.branches[1].T_from, 0);
  // moments about the hinge at the place found
  const Vector3 top = r.branches[0].start;
  const Vector3 guy = r.branches[0].T_from * (r.branches[0].end - top).normalized();
  EXPECT_NEAR(top.cross(guy + Vector3(1e3, 0, -5e3)).y(), 0, 1e-5);
}

TEST(Equilibrium, RopesThatDoNotStretchAreTheLimitOfRopesThatHardlyDo) {
  machine::Model m = with_carriage(false);
  EquilibriumOptions options;
  for (const double x : {100.0, 150.0, 190.0}) {
    options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
    m.reevings[0].stiffness = std::numeric_limits<double>::infinity();
    const EquilibriumResult rigid = equilibrium(m, options);
    ASSERT_TRUE(rigid.outcome.ok()) << rigid.outcome.message;
    m.reevings[0].stiffness = 1e13;
    const EquilibriumResult stiff = equilibrium(m, options);
    ASSERT_TRUE(stiff.outcome.ok()) << stiff.outcome.message;
    for (std::size_t k = 0; k < rigid.branches.size(); ++k) {
      EXPECT_NEAR(rigid.branches[k].T_from / stiff.branches[k].T_from, 1, 1e-6);
      EXPECT_NEAR(rigid.branches[k].stretched / rigid.branches[k].unstretched, 1, 1e-14);
    }
  }
}

TEST(Equilibrium, SaysWhatIsMissing) {
  machine::Model m = three_spans(300, 0);
  m.reevings[0].stiffness = std::numeric_limits<double>::infinity();
  EquilibriumResult r = equilibrium(m);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("'skyline'"), std::string::npos) << r.outcome.message;
  EXPECT_NE(r.outcome.message.find("does not reach"), std::string::npos) << r.outcome.message;

  machine::Model free;
  free.bodies.push_back(body("hook", {0, 0, 5}, 100, "xz"));
  free.loads.push_back({{.body = 0, .at = Vector3::Zero()}, {10, 0, 0}});
  r = equilibrium(free);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("'hook' is not held along z"), std::string::npos) << r.outcome.message;
}

TEST(Equilibrium, FreeCarriageRollsAgainstASupport) {
  // a steep tight line without mainline
  machine::Model m;
  m.bodies.push_back(body("car", {50, 0, 40}, 100, "xz"));
  m.reevings.push_back(reeve(
      "skyline", {anchor("a", {0, 0, 0}), over("car", Vector3::Zero(), 0), anchor("b", {100, 0, 90})}, 134.5, 10, 2e7));
  const EquilibriumResult r = equilibrium(m);
  EXPECT_EQ(r.outcome.status, Status::infeasible);
  EXPECT_NE(r.outcome.message.find("runs against its neighbour"), std::string::npos) << r.outcome.message;
}

// What would read memory of other things, or solve another machine, is refused at the door.
TEST(Equilibrium, RefusesArgumentsOfAnotherMachine) {
  const machine::Model m = with_carriage(true, 0.1, 200);
  const EquilibriumResult r = equilibrium(m);
  EXPECT_THROW(equilibrium(m, {}, machine::State{}), taut::ContractViolation);
  machine::State other = r.state;
  other.branches[0].pop_back();
  EXPECT_THROW(equilibrium(m, {}, other), taut::ContractViolation);
  EquilibriumOptions options;
  options.flow = {{1, 1, 1, 1, 1}, {1}, {2}};
  EXPECT_THROW(equilibrium(m, options), taut::ContractViolation);
  options.flow.clear();
  for (const int carriage : {-1, 1}) {
    options.prescribed = machine::Prescribed{.carriage = carriage, .x = 100};
    EXPECT_THROW(equilibrium(m, options), taut::ContractViolation);
  }
  options.prescribed = machine::Prescribed{.carriage = 0, .x = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(equilibrium(m, options), taut::ContractViolation);
}

}  // namespace equilibrium_test
