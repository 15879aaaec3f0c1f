#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/step/step.hpp"
#include "test/support/machines.hpp"

/// What contacts and bearings decide by tensions set by hand: bounds of grip from both sides, moments, and the loss of
/// a sheave by its efficiency. (Their rows: transient_assemble_test.)
namespace taut::solve::dynamics::transient_contact_test {

using namespace taut_test;

constexpr double R = 0.3;

/// Two weights over a sheave, the legs upright unless the left one is drawn aside.
struct Hung {
  machine::Model m;
  Mechanism is;
  Values before, now;

  explicit Hung(double inertia = 0, double eta = 1, double aside = 0, int copies = 1) {
    m.bodies = {body("left", {-R - aside, 0, -6}, 100, "xz"), body("right", {R, 0, -6}, 100, "xz")};
    machine::Node round = sheave("round", origin, R, 1, eta);
    round.inertia = inertia;
    m.reevings.push_back(reeve("rope", {anchor_on("left", 0), round, anchor_on("right", 1)}, 12.5 + aside, 0, 1e6));
    m.reevings[0].copies = copies;
    Built built = build(m, assembled(m), {});
    EXPECT_TRUE(built.outcome.ok()) << built.outcome.message;
    is = std::move(built.mechanism);
    before = now = built.values;
  }
  void pull(double T_in, double T_out) {
    now.lines[0].end_T[1] = now.lines[0].T = T_in;
    now.lines[1].end_T[0] = now.lines[1].T = T_out;
  }
  const Contact& contact() const { return is.contacts[0]; }
};

Grip decided(Hung& of, double ratio, double T_in, double T_out, double slipped = 0, Grip was = Grip::stuck) {
  of.pull(T_in, T_out);
  ContactValues& contact = of.now.contacts[0];
  contact.log_ratio = std::log(ratio);
  contact.ratio = ratio;
  contact.grip = was;
  contact.slipped = slipped;
  Scheme s;
  s.h = s.reach = 0.01;
  s.slip_now = 100;
  decide(of.is, s, of.before, of.now);
  return of.now.contacts[0].grip;
}

TEST(TransientContact, ItSlipsBeyondEitherBoundAndNotBefore) {
  Hung of;
  EXPECT_EQ(decided(of, 2, 1000, 1999), Grip::stuck);
  EXPECT_EQ(decided(of, 2, 1000, 2001), Grip::forward);
  EXPECT_EQ(decided(of, 2, 1999, 1000), Grip::stuck);
  EXPECT_EQ(decided(of, 2, 2001, 1000), Grip::backward);
  EXPECT_EQ(decided(of, 1, 1000, 1001), Grip::equal);  // without loss both are the same
  EXPECT_EQ(decided(of, 2, 0, 1000), Grip::equal);     // nothing presses
  EXPECT_EQ(decided(of, 2, 1000, 0), Grip::equal);
  EXPECT_EQ(decided(of, std::numeric_limits<double>::infinity(), 1, 1e6), Grip::stuck);
  // what the rope's momentum takes presses on nothing: 1500 - 500 against 2600 - 500
  of.now.lines[0].thrust[1] = of.now.lines[1].thrust[0] = 500;
  EXPECT_EQ(decided(of, 2, 1500, 2490), Grip::stuck);
  EXPECT_EQ(decided(of, 2, 1500, 2510), Grip::forward);
}

/// A primal-dual set: what has slipped in the step counts by its stiffness, so that sliding at the bound goes on and
/// sliding back past where it began ends in rest.
TEST(TransientContact, WhatSlidesGoesOnUntilItHasComeBack) {
  Hung of;
  const double k = stiffness_at(of.is, of.contact(), of.now);
  EXPECT_EQ(decided(of, 2, 1000, 2000, 1 / k, Grip::forward), Grip::forward);
  EXPECT_EQ(decided(of, 2, 1000, 1990, 20 / k, Grip::forward), Grip::forward);
  EXPECT_EQ(decided(of, 2, 1000, 2000, -1 / k, Grip::forward), Grip::stuck);
  EXPECT_EQ(decided(of, 2, 2000, 1000, -1 / k, Grip::backward), Grip::backward);
  EXPECT_EQ(decided(of, 2, 2000, 1000, 1 / k, Grip::backward), Grip::stuck);
}

/// R (T_out - T_in) = R (1 - eta)/(1 + eta) (T_in + T_out), where both legs are upright, is T_in = eta T_out.
TEST(TransientContact, ABearingAtItsLimitLosesTheEfficiency) {
  for (const double eta : {0.9, 0.98}) {
    for (const int copies : {1, 3}) {
      Hung of(2, eta, 0, copies);
      of.pull(eta * 5000, 5000);
      const double moment = rope_moment(of.is, of.is.spins[0], of.before, of.now);
      EXPECT_NEAR(moment, copies * R * 5000 * (1 - eta), 1e-9);
      EXPECT_NEAR(bearing_slope(of.is, of.contact(), of.before, of.now).capacity, moment, 1e-9);
      // and so it begins to turn: from both sides, both ways round
      for (const double more : {1 - 1e-6, 1 + 1e-6}) {
        for (const bool back : {false, true}) {
          const double tight = 5000 * more, slack = eta * 5000;
          back ? of.pull(tight, slack) : of.pull(slack, tight);
          of.now.spins[0] = {};
          decide(of.is, {}, of.before, of.now);
          EXPECT_EQ(of.now.spins[0].turns, more > 1 ? (back ? -1 : 1) : 0) << eta << " " << more;
        }
      }
    }
  }
}

/// Its bearing carries the vector sum of both legs: less, the less the rope turns. Slopes by differences.
TEST(TransientContact, ABearingsLimitIsByTheForceOnIt) {
  Hung of(2, 0.92, 5);
  of.pull(3000, 4000);
  const double between = std::acos(of.now.lines[0].t.dot(of.now.lines[1].t));
  const auto capacity = [&](double T_in, double T_out) {
    const double force = std::sqrt(T_in * T_in + T_out * T_out - 2 * T_in * T_out * std::cos(between));
    return R * 0.08 / 1.92 * force;
  };
  const BearingSlope slope = bearing_slope(of.is, of.contact(), of.before, of.now);
  EXPECT_LT(between, 2.6);
  EXPECT_NEAR(slope.capacity, capacity(3000, 4000), 1e-9);
  EXPECT_NEAR(slope.in, (capacity(3001, 4000) - capacity(2999, 4000)) / 2, 1e-7);
  EXPECT_NEAR(slope.out, (capacity(3000, 4001) - capacity(3000, 3999)) / 2, 1e-7);
  of.is.contacts[0].efficiency = 1;
  EXPECT_EQ(bearing_slope(of.is, of.contact(), of.before, of.now).capacity, 0);
}

/// In a step a wheel that turns has the bearing against it, until within the step it would turn back.
TEST(TransientContact, ABearingHoldsWhatItStops) {
  Hung of(2, 0.9);
  of.pull(4000, 4000);
  Scheme s;
  s.h = s.reach = 0.01;
  s.slip_now = 100;
  const double limit = bearing_slope(of.is, of.contact(), of.before, of.now).capacity;
  SpinValues& spin = of.now.spins[0];
  for (const double sense : {1.0, -1.0}) {
    spin = {};
    spin.turns = static_cast<std::int8_t>(sense);
    spin.omega = 0.5 * sense;  // goes on
    decide(of.is, s, of.before, of.now);
    EXPECT_EQ(spin.turns, sense);
    EXPECT_NEAR(spin.bearing, sense * limit, 1e-9);
    spin.omega = -1e-3 * sense;  // would have turned back a little: it has stopped within the step
    decide(of.is, s, of.before, of.now);
    EXPECT_EQ(spin.turns, 0);
  }
}

TEST(TransientContact, LooseRopeStaysWhereItIs) {
  Hung of;
  of.pull(0, 0);
  EXPECT_TRUE(loose(of.contact(), of.now));
  of.pull(0, 1);
  EXPECT_FALSE(loose(of.contact(), of.now));
  of.pull(-1, 0);  // what dampers hold while rates alone are sought is no slack rope
  EXPECT_FALSE(loose(of.contact(), of.now));
  ContactValues was;
  was.flow = 0.7;
  of.before.lines[0].e = of.before.lines[1].e = -0.01;
  EXPECT_EQ(loose_flow(of.contact(), was, of.before), 0);
  of.before.lines[1].e = 1e-6;  // taut on one side: it may go on
  EXPECT_EQ(loose_flow(of.contact(), was, of.before), 0.7);
}

TEST(TransientContact, ARoundWhoseRopeHasRunOffHasNone) {
  Hung of;
  EXPECT_FALSE(has_no_rope(of.contact(), of.now.lines));
  of.now.lines[1].gone = 0;
  EXPECT_FALSE(has_no_rope(of.contact(), of.now.lines)) << "a dead end still lies on it";
  of.now.lines[1].L = run_off_rest * of.now.lines[1].l;
  EXPECT_TRUE(has_no_rope(of.contact(), of.now.lines));
}

}  // namespace taut::solve::dynamics::transient_contact_test
