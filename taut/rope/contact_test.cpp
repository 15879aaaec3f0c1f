#include "taut/rope/contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::rope::contact_test {

constexpr double pi = std::numbers::pi;

Contact saddle(double wrap, double friction) { return {.wrap = wrap, .friction = friction, .turns = false}; }
Contact turning(double wrap, double friction, double efficiency) {
  return {.wrap = wrap, .friction = friction, .efficiency = efficiency};
}

// Independent witness: dT/dtheta = mu (T - c) along the arc, by Runge-Kutta.
double along_arc(const Contact& c, double T_in, double sign) {
  const int n = 1000;
  const double h = c.wrap / n;
  const auto slope = [&](double T) { return sign * c.friction * (T - c.momentum_flow); };
  double T = T_in;
  for (int i = 0; i < n; ++i) {
    const double a = slope(T), b = slope(T + h / 2 * a), d = slope(T + h / 2 * b), e = slope(T + h * d);
    T += h / 6 * (a + 2 * b + 2 * d + e);
  }
  return T;
}

TEST(Contact, CapstanIsTheIntegralAlongTheArc) {
  for (const double c : {0.0, 300.0}) {
    Contact contact = saddle(2.3, 0.17);
    contact.momentum_flow = c;
    EXPECT_NEAR(tension_out(contact, 1000, Flow::in_to_out).T, along_arc(contact, 1000, 1), 1e-9);
    EXPECT_NEAR(tension_out(contact, 1000, Flow::out_to_in).T, along_arc(contact, 1000, -1), 1e-9);
  }
}

TEST(Contact, TacklePullsItsLeadLine) {
  // S = Q K^n (K - 1)/(K^n - 1), K = 1/eta: n parts carry Q, the lead line leaves over one more sheave
  const double K = 1.04, Q = 6e4;
  const Contact sheave = turning(pi, 0.3, 1 / K);
  double part = 1, sum = 0, lead = 0;
  for (int i = 0; i < 6; ++i) {
    sum += part;
    part = lead = tension_out(sheave, part, Flow::in_to_out).T;
  }
  const double expected = Q * std::pow(K, 6) * (K - 1) / (std::pow(K, 6) - 1);
  EXPECT_NEAR(Q / sum * lead, expected, 1e-9);
}

RC_GTEST_PROP(Contact, OtherWayIsTheInverse, ()) {
  Contact c{.wrap = *rc::gen::inRange(0, 700) / 100.0,
            .friction = *rc::gen::inRange(0, 60) / 100.0,
            .efficiency = *rc::gen::inRange(80, 101) / 100.0,
            .turns = *rc::gen::arbitrary<bool>()};
  const double T = *rc::gen::inRange(1, 100000);
  const double there = tension_out(c, T, Flow::in_to_out).T;
  RC_ASSERT(std::abs(tension_out(c, there, Flow::out_to_in).T - T) < 1e-12 * T);
  const Band band = band_at_rest(c, T);
  RC_ASSERT(band.low <= T && T <= band.high && std::abs(band.high - there) <= 1e-12 * there);
  RC_ASSERT(state_of(c, T, T) == ContactState::stuck);
  if (there > T * (1 + 1e-6)) {
    RC_ASSERT(flow_of(c, T, there) == Flow::in_to_out);
    RC_ASSERT(flow_of(c, there, T) == Flow::out_to_in);
    RC_ASSERT(flow_of(c, T, std::sqrt(T * there)) == Flow::at_rest);
    RC_ASSERT(state_of(c, T, there) != ContactState::stuck);
  }
}

TEST(Contact, KnowsItsDerivatives) {
  for (const Contact& base : {saddle(1.2, 0.3), turning(1.2, 0.3, 0.95), turning(0.1, 0.3, 0.9)}) {
    for (const Flow flow : {Flow::in_to_out, Flow::out_to_in}) {
      Contact c = base;
      c.momentum_flow = 40;
      const OutTension at = tension_out(c, 500, flow);
      const double h = 1e-3;
      EXPECT_NEAR(at.dT_dT_in, (tension_out(c, 500 + h, flow).T - tension_out(c, 500 - h, flow).T) / (2 * h), 1e-8);
      Contact more = c, less = c;
      more.wrap += 1e-5;
      less.wrap -= 1e-5;
      EXPECT_NEAR(at.dT_dwrap, (tension_out(more, 500, flow).T - tension_out(less, 500, flow).T) / 2e-5, 1e-5);
    }
  }
}

TEST(Contact, GrooveAndBearingShareInSeries) {
  // little wrap: the groove slips before the bearing turns
  EXPECT_NEAR(largest_ratio(turning(0.1, 0.3, 0.9)), std::exp(0.03), 1e-15);
  EXPECT_EQ(state_of(turning(0.1, 0.3, 0.9), 100, 100 * std::exp(0.03)), ContactState::slipping);
  EXPECT_NEAR(largest_ratio(turning(3, 0.3, 0.9)), 1 / 0.9, 1e-15);
  EXPECT_EQ(state_of(turning(3, 0.3, 0.9), 90, 100), ContactState::turning);
  EXPECT_EQ(state_of(saddle(3, 0.3), 90, 100), ContactState::stuck);
  EXPECT_EQ(state_of(turning(3, 0.3, 1), 90, 100), ContactState::turning);
  EXPECT_NEAR(grip_used(saddle(2, 0.25), 100 * std::exp(0.25), 100), 0.5, 1e-12);
  EXPECT_EQ(grip_used(saddle(2, 0), 100, 100), 0);
  EXPECT_EQ(grip_used(saddle(2, 0), 100, 101), std::numeric_limits<double>::infinity());
}

TEST(Contact, ResultantIsOnTheBisector) {
  const Vector3 down(0, 0, -1), up_(0, 0, 1), aside(1, 0, 0);
  EXPECT_LT((resultant(saddle(pi, 0), 100, up_, 100, down) - Vector3(0, 0, -200)).norm(), 1e-13);
  const Vector3 F = resultant(saddle(pi / 2, 0), 100, up_, 100, aside);
  EXPECT_NEAR(F.norm(), 2 * 100 * std::sin(pi / 4), 1e-12);
  Contact fast = saddle(pi, 0);
  fast.momentum_flow = 100;
  EXPECT_EQ(resultant(fast, 100, up_, 100, down).norm(), 0);  // lifted off
  EXPECT_EQ(line_pressure(fast, 300, 0.5), 400);
  EXPECT_EQ(line_pressure(fast, 50, 0.5), 0);
}

TEST(Contact, GroovesRaiseFriction) {
  EXPECT_NEAR(v_groove_friction(0.1, pi / 2), 0.1, 1e-16);
  EXPECT_NEAR(v_groove_friction(0.1, 20 * pi / 180), 0.1 / std::sin(20 * pi / 180), 1e-15);
  EXPECT_NEAR(undercut_groove_friction(0.1, 0, 0), 0.4 / pi, 1e-15);  // seated round groove: 4 mu/pi
  EXPECT_GT(undercut_groove_friction(0.1, 1.8, 0.5), undercut_groove_friction(0.1, 1.0, 0.5));
  // witness: pressure p0 cos(a) on the flanks from b/2 to pi/2 - g/2 from the bottom, force balance by summation
  const double b = 1.7, g = 0.5;
  double normal = 0, down = 0;
  const int n = 200000;
  const double from = b / 2, to = (pi - g) / 2;
  for (int i = 0; i < n; ++i) {
    const double a = from + (to - from) * (i + 0.5) / n;
    normal += std::cos(a);
    down += std::cos(a) * std::cos(a);
  }
  EXPECT_NEAR(undercut_groove_friction(0.1, b, g), 0.1 * normal / down, 1e-9);
}

TEST(Contact, BeltSlipsNoLongerThanNeeded) {
  Contact drive = saddle(pi, 0.25);
  drive.momentum_flow = 200;
  const auto b = belt_creep(drive, 1800, 1000, 2e5);
  ASSERT_TRUE(b);
  EXPECT_NEAR(800 * std::exp(0.25 * b->slip_arc), 1600, 1e-9);
  EXPECT_NEAR(b->slip_arc + b->rest_arc, pi, 1e-15);
  EXPECT_TRUE(b->holds);
  // witness: mass passes at the same rate everywhere, v (1 + e)^-1 constant
  const double v1 = 1 + 1800 / 2e5, v2 = 1 + 1000 / 2e5;
  EXPECT_NEAR(b->creep, v1 - v2, 1e-15);
  EXPECT_FALSE(belt_creep(drive, 3000, 1000, 2e5)->holds);
  EXPECT_FALSE(belt_creep(drive, 1000, 200, 2e5));
  EXPECT_EQ(belt_creep(drive, 1000, 1000, std::numeric_limits<double>::infinity())->creep, 0);
}

TEST(Contact, RefusesWhatIsNone) {
  EXPECT_THROW(largest_ratio(saddle(-1, 0.1)), ContractViolation);
  EXPECT_THROW(largest_ratio(turning(1, 0.1, 0)), ContractViolation);
  EXPECT_THROW(tension_out(saddle(1, 0.1), 10, Flow::at_rest), ContractViolation);
  EXPECT_THROW(v_groove_friction(0.1, 0), ContractViolation);
}

}  // namespace taut::rope::contact_test
