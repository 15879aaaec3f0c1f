#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/motion/run/run.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// What the control makes of steps set by hand: errors against the trapezoidal rule's own on polynomials, and how the
/// bound of them grows in runs of very many steps.
namespace taut::solve::dynamics::transient_control_test {

const machine::Model nothing;

/// A run with one slide of mass and one line, three steps of the sizes `h` (the last one first) behind it.
struct ByHand {
  TransientOptions options;
  Run run{.model = nothing, .options = options};
  double h, h1, h2;

  ByHand(double last, double before, double first) : h(last), h1(before), h2(first) {
    options.duration = 10;
    options.tolerance = 1e-6;
    Body slide;
    slide.count = 1;
    slide.along[0] = Vector3::UnitX();
    slide.about[0] = Vector3::Zero();
    run.m.bodies.push_back(slide);
    run.m.lines.resize(1);
    run.m.lines[0].stiffness = 1e6;
    run.m.size = 1;
    for (Values* v : {&run.before, &run.now}) {
      v->q = v->nu = v->rate = {0};
      v->lines.resize(1);
    }
    run.nu_old = {0};
    run.T_old = run.T_older = {0};
    run.T_largest = {1};
    run.scheme.h = h;
    run.h_last = h1;
    run.h_older = h2;
    run.known = 3;
  }
  /// The velocity over time, counted from the start of the last step; the place by the trapezoidal rule.
  template <class Velocity>
  void move(Velocity velocity) {
    run.nu_old[0] = velocity(-h1);
    run.before.nu[0] = velocity(0.0);
    run.now.nu[0] = velocity(h);
    run.now.q[0] = h / 2 * (run.before.nu[0] + run.now.nu[0]);
  }
  template <class Tension>
  void pull(Tension tension) {
    run.T_older[0] = tension(-h1 - h2);
    run.T_old[0] = tension(-h1);
    run.before.lines[0].T = tension(0.0);
    run.now.lines[0].T = tension(h);
  }
  /// The error itself, as a kink's may be as large as the tolerance.
  double error() const { return error_of(run, true) * options.tolerance; }
};

/// Of v = v_0 + b t + c t^2 the rule gives c h^3/6 too much; what is linear it integrates exactly.
TEST(TransientControl, TheErrorOfAPlaceIsTheTrapezoidalRules) {
  for (const double h1 : {0.02, 0.05, 0.004}) {
    ByHand of(0.02, h1, 0.03);
    of.move([](double t) { return 0.7 - 0.3 * t; });
    EXPECT_NEAR(of.error(), 0, 1e-15);
    of.move([](double t) { return 0.7 - 0.3 * t - 2 * t * t; });
    EXPECT_NEAR(of.error(), 2 * std::pow(0.02, 3) / 6, 1e-14) << h1;
  }
}

/// Of the third derivative of a tension, h^3/12 of it, as the rule has it, by the rope's largest; a parabola is none.
TEST(TransientControl, TheErrorOfATensionIsByItsThirdDerivative) {
  for (const double h1 : {0.01, 0.03}) {
    ByHand of(0.02, h1, 0.015);
    of.run.T_largest = {5e3};
    of.pull([](double t) { return 1e3 + 2e4 * t - 5e5 * t * t; });
    EXPECT_NEAR(of.error(), 0, 1e-13);
    of.pull([](double t) { return 1e3 + 2e4 * t + 4e6 * t * t * t; });
    EXPECT_NEAR(of.error(), 4e6 * 6 * std::pow(0.02, 3) / 12 / 5e3, 1e-6 * of.error()) << h1;
  }
}

/// A rope that slid along its path and within the step comes back: by its rates it turned after 3/4 of the step, and
/// the law held it sliding over the last quarter: too far by the way back.
TEST(TransientControl, TheErrorOfARopeThatTurnsBackIsItsWayBack) {
  ByHand of(0.02, 0.02, 0.02);
  Contact contact;
  contact.in = contact.out = 0;
  contact.column = 0;
  of.run.m.contacts.push_back(contact);
  of.run.T_largest = {2e4};
  for (Values* v : {&of.run.before, &of.run.now}) v->contacts.resize(1);
  of.run.now.lines[0].L = 8;
  ContactValues &was = of.run.before.contacts[0], &is = of.run.now.contacts[0];
  for (const double way : {1.0, -1.0}) {
    is.grip = way > 0 ? Grip::forward : Grip::backward;
    was.slip_rate = 0.3 * way;
    is.slip_rate = -0.1 * way;
    const double back = 0.1 / 2 * (0.02 / 4), stiffness = 2 * 1e6 / 8;  // of both lines
    EXPECT_NEAR(of.error(), stiffness * back / 2e4, 1e-12);
    is.slip_rate = 0.1 * way;  // it only slows down
    EXPECT_EQ(of.error(), 0);
    is.slip_rate = -0.1 * way;
    is.grip = Grip::stuck;  // or is held already
    EXPECT_EQ(of.error(), 0);
  }
}

TEST(TransientControl, ARunMayErrByItsToleranceOverAllItsSteps) {
  ByHand of(0.02, 0.02, 0.02);
  of.move([](double t) { return 3 * t * t; });
  const double share = 0.02 / 10;
  EXPECT_NEAR(error_of(of.run, false) * share, error_of(of.run, true), 1e-12 * error_of(of.run, true));
  of.run.known = 1;  // nothing to predict from
  EXPECT_EQ(error_of(of.run, false), 0);
}

/// Up to 150 000 steps, then within 70 000 more up to eight times, and never with steps that are given.
TEST(TransientControl, VeryManyStepsGrowCoarserUpToEightTimes) {
  ByHand of(0.02, 0.02, 0.02);
  long& steps = of.run.result.steps;
  const auto at = [&](long now) {
    steps = now;
    return impatience(of.run);
  };
  EXPECT_EQ(at(0), 1);
  EXPECT_EQ(at(150'000), 1);
  EXPECT_NEAR(at(155'000), 1.5, 1e-12);
  EXPECT_NEAR(at(160'000), 2, 1e-12);
  EXPECT_EQ(at(220'000), 8);
  EXPECT_EQ(at(10'000'000), 8);
  of.run.floor = 1e-4;
  EXPECT_NEAR(floor_of(of.run), 8e-4, 1e-18);
  of.options.step = 1e-3;
  EXPECT_EQ(at(10'000'000), 1);
  of.options.step = 0;
  of.options.method = TimeMethod::verlet;
  EXPECT_EQ(at(10'000'000), 1);
}

TEST(TransientControl, ThatItGrowsCoarserIsToldOnce) {
  ByHand of(0.02, 0.02, 0.02);
  for (of.run.result.steps = 149'998; of.run.result.steps < 150'010; ++of.run.result.steps) note_impatience(of.run);
  ASSERT_EQ(of.run.result.events.size(), 1U);
  EXPECT_EQ(of.run.result.events[0].what, "coarser");
  of.options.step = 1e-3;
  of.run.result.events.clear();
  for (of.run.result.steps = 149'998; of.run.result.steps < 150'010; ++of.run.result.steps) note_impatience(of.run);
  EXPECT_TRUE(of.run.result.events.empty());
}

/// What may err the same is a step eight times longer: of a motion that shakes fast, so that its steps are far shorter
/// than the run.
TEST(TransientControl, AsMuchErrorIsAllowedAsEightTimesLongerStepsHave) {
  const auto of_step = [](double h, long steps) {
    ByHand of(h, h, h);
    of.run.result.steps = steps;
    of.move([](double t) { return 5 * t * t; });
    return error_of(of.run, false);
  };
  const double h = 1e-6;
  const double patient = of_step(h, 100);
  EXPECT_NEAR(of_step(8 * h, 1'000'000), patient, 1e-6 * patient);
  EXPECT_NEAR(of_step(2 * h, 160'000), patient, 1e-6 * patient);
  EXPECT_NEAR(of_step(8 * h, 100), 512 * patient, 1e-3 * patient);
  // slow motions, whose steps are a share of the run, keep their tolerance
  EXPECT_NEAR(of_step(0.2, 1'000'000), of_step(0.2, 100), 1e-9 * of_step(0.2, 100));
}

/// The lowest order of what the scheme loses in a swing: (omega h)^3 is the tolerance's.
TEST(TransientControl, AResolvingStepIsByTheFastestSwing) {
  ByHand of(0.02, 0.02, 0.02);
  of.run.m.lines[0].body = {-1, 0};
  of.run.m.bodies[0].mass = 4;
  of.run.before.lines[0].L = 10;
  const double omega = std::sqrt(1e6 / 10 / 4);
  EXPECT_NEAR(resolving_step(of.run), std::cbrt(1e-6) / (2 * omega), 1e-9);
  of.run.m.lines[0].stiffness = 1e-9;
  EXPECT_NEAR(resolving_step(of.run), 0.05, 1e-12);  // where nothing swings: by the duration
  of.options.tolerance = 1;
  EXPECT_NEAR(resolving_step(of.run), 0.1, 1e-12);
}

/// What is left of a broken rope may be as short as it likes; one that breaks counts by what is left of its stiffness.
TEST(TransientControl, ABrokenRopeIsNotResolved) {
  ByHand of(0.02, 0.02, 0.02);
  of.run.m.lines[0].body = {-1, 0};
  of.run.m.bodies[0].mass = 4;
  of.run.before.lines[0].L = 1e-15;
  of.run.before.lines[0].gone = 0;
  EXPECT_NEAR(resolving_step(of.run), 0.05, 1e-12);
  of.run.before.lines[0].L = 10;
  of.run.before.lines[0].gone = 0.25;
  EXPECT_NEAR(resolving_step(of.run), std::cbrt(1e-6) / (2 * std::sqrt(0.25 * 1e6 / 10 / 4)), 1e-9);
}

/// A mass between two ropes shakes 160 times in a second, undamped: its steps are of one size for 150 000 of them, and
/// then grow to eight times that; every swing is still resolved, so that it shakes as much as at first.
TEST(TransientControl, ALongShakingRunGrowsCoarserAndKeepsItsSwing) {
  machine::Model m;
  m.gravity = 0;
  m.bodies.push_back(taut_test::body("mass", {0.002, 0, 0}, 2, "x"));
  for (const double end : {-1.0, 1.0}) {
    m.reevings.push_back(
        taut_test::reeve("rope", {taut_test::anchor("a", {end, 0, 0}), taut_test::anchor_on("mass", 0)}, 0.99, 0, 1e6));
  }
  m.observed.push_back({"x", machine::Observed::x, si::m, 0, {}, Vector3::Zero()});
  const auto run = [&](double duration) { return taut_test::run_to_end(m, taut_test::lasting(duration, 1e-6, 500)); };
  const TransientResult usual = run(0.14), longer = run(0.6), longest = run(0.75);
  EXPECT_LT(usual.steps, 150'000);
  EXPECT_TRUE(usual.events.empty());
  // the run reports the sum of the errors of its steps
  EXPECT_GT(usual.spent, 0.2);
  EXPECT_LT(usual.spent, 1e-5 * static_cast<double>(usual.steps));  // the least share of a step
  EXPECT_GT(longest.spent, 10);
  ASSERT_EQ(longest.events.size(), 1U);
  EXPECT_EQ(longest.events[0].what, "coarser");
  ASSERT_GT(longer.steps, 220'000);
  const double mean = 0.14 / static_cast<double>(usual.steps);
  EXPECT_NEAR(longest.events[0].t, 150'001 * mean, 1e-2 * longest.events[0].t);
  EXPECT_NEAR(0.15 / static_cast<double>(longest.steps - longer.steps) / mean, 8, 0.5);
  double largest = 0;
  for (const double x : longest.observed[0]) largest = std::max(largest, std::abs(x));
  EXPECT_NEAR(largest, 0.002, 2e-6);
  EXPECT_LT(std::abs(longest.frames.back().energy.residual), 1e-6 * longest.frames.back().energy.turnover);
}

TEST(TransientControl, WhatIsKeptIsTheStepBefore) {
  ByHand of(0.02, 0.03, 0.05);
  of.run.before.nu = {4};
  of.run.before.rate = {5};
  of.run.before.lines[0].T = 600;
  of.run.T_old = {700};
  keep_history(of.run);
  EXPECT_EQ(of.run.nu_old[0], 4);
  EXPECT_EQ(of.run.rate_old[0], 5);
  EXPECT_EQ(of.run.T_old[0], 600);
  EXPECT_EQ(of.run.T_older[0], 700);
  EXPECT_EQ(of.run.h_last, 0.02);
  EXPECT_EQ(of.run.h_older, 0.03);
  EXPECT_EQ(of.run.known, 4);
}

/// 100 kg that a signal moves to and fro: nothing else would limit the steps, and x runs straight between them. The
/// books close: what moves it is known. So does a rope that it pulls taut, 0.5 m of slack in a pulse of 1 m.
TEST(TransientControl, BodiesThatSignalsMoveLimitTheStepsAndCloseTheBooks) {
  machine::Model m;
  m.gravity = 10;
  m.bodies.push_back(taut_test::body("b", Vector3::Zero(), 100, ""));
  m.reevings.push_back(
      taut_test::reeve("r", {taut_test::anchor("p", {-10, 0, 0}), taut_test::anchor_on("b", 0)}, 10.5, 0, 1e6));
  for (const bool pulse : {false, true}) {
    machine::Signal x;
    if (pulse) {
      x.law = machine::Moves{.from = 0,
                             .moves = {{.at = 5, .to = 1, .over = 0.03, .change = machine::Change::smooth},
                                       {.at = 5.03, .to = 0, .over = 0.03, .change = machine::Change::smooth}}};
    } else {
      x.law = machine::Sine{.mean = 0, .amplitude = 0.2, .omega = M_PI, .phase = 0.5};
    }
    m.bodies[0].driven = {{Vector3::UnitX(), Vector3::Zero(), x}};
    m.bodies[0].driven.push_back({Vector3::UnitZ(), Vector3::Zero(), taut_test::smooth_move(0, 0.1, 1, 2)});
    const TransientOptions options = taut_test::lasting(10, 1e-6, 10);
    const TransientResult r = taut_test::run_to_end(m, options);
    EXPECT_LT(r.open, 1e-5) << pulse;
    if (!pulse) {  // at its tops h^2/8 0.2 pi^2 m/s2 is at most 1e-6 of 10 m: 6 ms
      EXPECT_LT(r.largest_step, 0.05);
      continue;
    }
    // the rope is 10.5 m, the pulse takes its end to 11 m: 1 MN * 0.5/10.5, and 0.1 m of height beside it
    EXPECT_NEAR(r.ropes[0].T.max, 1e6 * (std::hypot(11, 0.1) / 10.5 - 1), 1);
  }
}

}  // namespace taut::solve::dynamics::transient_control_test
