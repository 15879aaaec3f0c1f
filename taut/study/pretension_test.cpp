#include "taut/study/pretension.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/boom_machine.hpp"

/// Ropes pulled tight in turn, with friction and without.
namespace taut_test::pretension_test {

namespace machine = taut::machine;

namespace {

using taut::study::pretension;
using taut::study::PretensionOptions;
using taut::study::PretensionResult;
using taut::study::Pull;

constexpr int extension = 0, retraction = 1;

machine::Observable place_of(int body, int seen_from = machine::ground) {
  machine::Observable o;
  o.name = "x";
  o.quantity = machine::Observed::x;
  o.unit = taut::si::m;
  o.index = body;
  o.seen_from = seen_from;
  return o;
}

Pull until_it_moves(int reeving, const machine::Observable& what, double moves = 1e-5) {
  Pull pull;
  pull.reeving = reeving;
  pull.until = what;
  pull.moves = moves;
  return pull;
}

Pull to_force(int reeving, double force, bool at_end = false) {
  Pull pull;
  pull.reeving = reeving;
  pull.at_end = at_end;
  pull.force = force;
  return pull;
}

/// The boom at 9 m and 0 degrees as the paper reckons with it: rigid but for its ropes, which are slack at first, and
/// f_0 G_3 rounded.
machine::Model boom_with_slack_ropes(double slip) {
  Boom b;
  b.angle = 0;
  b.hook = b.load = 0;
  b.moves = false;
  b.S10 = b.S20 = 0;
  b.C1 = 2.72e6;
  b.eta = 1;
  b.f0 = b.f_inf = slip / b.G3;
  machine::Model m = boom_machine(b);
  for (auto& pad : m.contacts) pad.stiffness = pad.tangential_stiffness = 1e11;
  m.actuators[0].lock_stiffness = 1e11;
  return m;
}

/// Table 1 of Reutov (2021): S10 and S20 as section 3 begins to slide by the pull of one tensioner and of the other.
TEST(Pretension, TensionersPulledInTurn) {
  struct Order {
    std::vector<int> pulled;
    std::vector<std::pair<double, double>> tensions;  // kN, as printed
  };
  const auto out = place_of(boom_bodies::s3, boom_bodies::s2);
  for (const Order& order :
       {Order{.pulled = {extension, retraction}, .tensions = {{0.635, 0}, {0.635, 2.54}, {1.905, 2.54}, {1.905, 5.08}}},
        Order{.pulled = {retraction, extension}, .tensions = {{0, 1.27}, {1.27, 1.27}, {1.27, 3.81}, {2.54, 3.81}}}}) {
    std::vector<Pull> pulls;
    pulls.reserve(4);
    for (std::size_t i = 0; i < 4; ++i) pulls.push_back(until_it_moves(order.pulled[i % 2], out, 2e-8));
    PretensionOptions options;
    const PretensionResult r = pretension(boom_with_slack_ropes(1270), pulls, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    ASSERT_EQ(r.ends.size(), 4U);
    EXPECT_TRUE(r.slowly);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(r.ends[i].T_end[extension], 1e3 * order.tensions[i].first, 0.5) << i;
      EXPECT_NEAR(r.ends[i].T_end[retraction], 1e3 * order.tensions[i].second, 0.5) << i;
    }
  }
}

/// With the pads, the cylinder and the losses of the dynamic model the equation at the limit of sliding stays, whatever
/// the ropes' tensions have become: 2 S1 - S2 = +- f_0 G_3.
TEST(Pretension, TheLimitOfSlidingHoldsInAYieldingBoom) {
  Boom b;
  b.angle = 0;
  b.hook = b.load = 0;
  b.moves = false;
  b.S10 = b.S20 = 1e3;
  const auto out = place_of(boom_bodies::s3, boom_bodies::s2);
  std::vector<Pull> pulls;
  pulls.reserve(6);
  for (int i = 0; i < 6; ++i) pulls.push_back(until_it_moves(i % 2, out, 1e-4));
  const PretensionResult r = pretension(boom_machine(b), pulls);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    const double F = 2 * r.ends[i].T_end[extension] - r.ends[i].T_end[retraction];
    // it has just begun to slide: between the static and the kinetic friction
    EXPECT_GT(std::abs(F), 0.149 * b.G3);
    EXPECT_LT(std::abs(F), 0.156 * b.G3);
    EXPECT_EQ(F > 0, i % 2 == 0);
    EXPECT_GT(r.ends[i].taken, 0);
  }
  EXPECT_NEAR(r.ends[5].taken_in_all, r.ends[1].taken + r.ends[3].taken + r.ends[5].taken, 1e-12);
}

/// A body between two ropes, free along them.
machine::Model between_two_ropes(double tension) {
  machine::Model m;
  m.bodies.push_back(body("ring", origin, 10, "x"));
  const double EA = 2e6, length = 20;
  m.reevings.push_back(
      reeve("left", {anchor("a", {-length, 0, 0}), anchor_on("ring", 0)}, length / (1 + tension / EA), 0, EA));
  m.reevings.push_back(
      reeve("right", {anchor_on("ring", 0), anchor("b", {length, 0, 0})}, length / (1 + tension / EA), 0, EA));
  return m;
}

TEST(Pretension, TwoRopesWithoutFrictionShareTheirTension) {
  const double T0 = 10e3, T1 = 30e3, EA = 2e6;
  const PretensionResult r = pretension(between_two_ropes(T0), {to_force(0, T1), to_force(1, T0, true)});
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_FALSE(r.slowly);
  EXPECT_NEAR(r.before.T_start[0], T0, 1e-3);
  EXPECT_NEAR(r.ends[0].T_start[0], T1, 1e-3);
  EXPECT_NEAR(r.ends[0].T_start[1], T1, 1e-3);
  // the other rope is as long as it was: both together still reach from a to b
  const double L = 20 / (1 + T0 / EA), now = (40 - L * (1 + T1 / EA)) / (1 + T1 / EA);
  EXPECT_NEAR(r.ends[0].taken, L - now, 1e-9);
  EXPECT_NEAR(r.ends[1].T_end[1], T0, 1e-3);
  EXPECT_LT(r.ends[1].taken, 0);  // it was too tight
  EXPECT_NEAR(r.ends[1].taken_in_all, r.ends[1].taken, 0);
}

TEST(Pretension, ATakeUpIsTaken) {
  Pull pull;
  pull.reeving = 1;
  pull.take_up = 5e-3;
  const PretensionResult r = pretension(between_two_ropes(10e3), {pull, pull});
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double L = 20 / (1 + 10e3 / 2e6), T = 2e6 * (40 / (2 * L - 10e-3) - 1);
  EXPECT_NEAR(r.ends[1].taken_in_all, 10e-3, 1e-12);
  EXPECT_NEAR(r.ends[1].T_start[0], T, 1e-6 * T);
  EXPECT_NEAR(r.ends[1].unstretched[1], L - 10e-3, 1e-9);
}

/// The same ring on a floor that holds it by friction.
machine::Model on_a_floor(double tension, double mass, double f0) {
  machine::Model m = between_two_ropes(tension);
  m.gravity = 10;
  m.bodies[0] = body("ring", origin, mass, "xz");
  add_floor(m, 0, 1, 1e10, f0);
  return m;
}

/// Ropes of a block on a floor: it begins to slide when they differ by f W, whichever is pulled; forces and lengths end
/// pulls with friction as without.
TEST(Pretension, ABlockOnAFloorHoldsTheDifference) {
  const double W = 500 * 10.0, f0 = 0.3;
  const machine::Model m = on_a_floor(1e3, 500, f0);
  Pull last;
  last.reeving = 1;
  last.take_up = -1e-3;
  const PretensionResult r =
      pretension(m, {until_it_moves(0, place_of(0)), until_it_moves(1, place_of(0)), to_force(0, 2e3), last});
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.ends[0].T_start[0] - r.ends[0].T_end[1], f0 * W, 5);
  EXPECT_NEAR(r.ends[0].T_start[1], 1e3, 5);  // the block has only just begun
  EXPECT_NEAR(r.ends[1].T_end[1] - r.ends[1].T_start[0], f0 * W, 5);
  EXPECT_NEAR(r.ends[2].T_start[0], 2e3, 1e-3);
  EXPECT_LT(r.ends[2].taken, 0);
  EXPECT_NEAR(r.ends[3].taken, -1e-3, 1e-9);
}

TEST(Pretension, AForceThatIsNotReachedIsToldWithTheLastTension) {
  PretensionOptions options;
  options.longest = 1e-3;
  const PretensionResult r = pretension(on_a_floor(1e3, 500, 0.3), {to_force(0, 5e6)}, options);
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_NE(r.outcome.message.find("pull 1, 'left'"), std::string::npos) << r.outcome.message;
  EXPECT_NE(r.outcome.message.find("not 5e+06 N"), std::string::npos) << r.outcome.message;
  EXPECT_TRUE(r.ends.empty());
}

TEST(Pretension, CanBeInterrupted) {
  PretensionOptions options;
  options.progress = [](std::size_t i) { return i < 1; };
  for (const machine::Model& m : {between_two_ropes(10e3), on_a_floor(1e3, 500, 0.3)}) {
    const PretensionResult r = pretension(m, {to_force(0, 20e3), to_force(1, 25e3)}, options);
    EXPECT_TRUE(r.interrupted);
    EXPECT_EQ(r.ends.size(), 1U);
  }
}

/// A counterweight holds its tension while another rope is let in: the third takes what that one loses. As the second
/// goes slack the third has all of it.
TEST(Pretension, AGivenTensionStaysAsItIs) {
  const double EA = 10e6, P = 30e3;
  machine::Model m;
  m.bodies.push_back(body("trolley", origin, 0, "x"));
  m.reevings.push_back(reeve("weight", {anchor("l", {-10, 0, 0}), anchor_on("trolley", 0)}, 0, 0, EA));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = P;
  m.reevings.push_back(reeve("near", {anchor("r", {10, 0, 0}), anchor_on("trolley", 0)}, 10, 0, EA));
  m.reevings.push_back(reeve("far", {anchor("s", {20, 0, 0}), anchor_on("trolley", 0)}, 20, 0, EA));
  Pull let_in;
  let_in.reeving = 1;
  let_in.take_up = -50e-3;
  const PretensionResult r = pretension(m, {let_in});
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.before.T_start[2], P / 3, 1e-6 * P);
  // EA (10 + u - 10.05)/10.05 + EA u/20 = P
  const double u = (P / EA + 0.05 / 10.05) / (1 / 10.05 + 1 / 20.0);
  EXPECT_NEAR(r.ends[0].T_start[0], P, 1e-9 * P);
  EXPECT_NEAR(r.ends[0].T_start[2], EA * u / 20, 1e-6 * P);
  EXPECT_EQ(r.model.reevings[0].given, machine::Given::tension_at_start);
  // the one that is pulled itself keeps its length from then on
  const PretensionResult other = pretension(m, {to_force(0, 2 * P), let_in});
  ASSERT_TRUE(other.outcome.ok()) << other.outcome.message;
  EXPECT_NEAR(other.ends[0].T_start[0], 2 * P, 1e-9 * P);
  EXPECT_LT(other.ends[1].T_start[0], 1.9 * P);
  EXPECT_EQ(other.ends[1].unstretched[0], other.ends[0].unstretched[0]);
}

/// Over a saddle that holds it by friction the other part of the rope has any tension between F e^-fa and F e^fa.
TEST(Pretension, FrictionLeavesABandAsAPullEnds) {
  const double F = 20e3, f = 0.2;
  machine::Model m;
  m.reevings.push_back(
      reeve("rope", {anchor("a", {-10, 0, 0}), saddle("top", {0, 0, 10}, f), anchor("b", {10, 0, 0})}, 28.25, 0, 10e6));
  const PretensionResult r = pretension(m, {to_force(0, F)});
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.ends[0].T_end[0], F, 1e-6 * F);
  const double most = std::exp(f * M_PI / 2);
  EXPECT_NEAR(r.ends[0].at->branches[1].T_to_max / (F * most), 1, 1e-6);
  EXPECT_NEAR(r.ends[0].at->branches[1].T_to_min / (F / most), 1, 1e-6);
  EXPECT_NEAR(r.ends[0].at->ropes[0].T_max / (F * most), 1, 1e-6);
}

TEST(Pretension, NoPullIsLongerThanTheLongest) {
  PretensionOptions options;
  options.longest = 1e-3;
  const PretensionResult r = pretension(between_two_ropes(10e3), {to_force(0, 30e3)}, options);
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_NE(r.outcome.message.find("'longest'"), std::string::npos) << r.outcome.message;
  EXPECT_TRUE(r.ends.empty());
}

}  // namespace
}  // namespace taut_test::pretension_test
