#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/step/step.hpp"
#include "test/support/machines.hpp"

/// Which slack lines pull as springs that may push, by tensions and grips set by hand; and that a step finds the one
/// tension of a rope that is slack in all of its branches but one.
namespace taut::solve::dynamics::transient_runs_test {

using namespace taut_test;

constexpr double EA = 1e6;

/// A rope over `points` in the ground, 2 m apart, from an anchor to an anchor, or from a drum that pulls.
struct Rope {
  machine::Model m;
  Mechanism is;
  Values before, now;

  explicit Rope(int points, double weight = 0, double pull = -1) {
    std::vector<machine::Node> nodes;
    if (pull < 0) {
      nodes.push_back(anchor("start", origin));
    } else {
      nodes.push_back(add_drum(m, "winch", {0, 0, 0.2}, 0.2, 1));
      m.drums[0].drive.kind = machine::DriveKind::pull;
      m.drums[0].drive.signal.law = pull;
    }
    for (int i = 1; i <= points; ++i) nodes.push_back(over("point " + std::to_string(i), {2.0 * i, 0, 0.1 * i}));
    nodes.push_back(anchor("end", {2.0 * (points + 1), 0, 0.1 * (points + 1)}));
    m.reevings.push_back(reeve("rope", nodes, 2.0 * (points + 1), weight, EA));
    m.reevings[0].damping_time = 0.0;
    m.bodies = {body("beside", {0, 5, 0}, 10, "xyz")};
    Built built = build(m, assembled(m), {});
    EXPECT_TRUE(built.outcome.ok()) << built.outcome.message;
    is = std::move(built.mechanism);
    before = now = built.values;
    for (ContactValues& contact : now.contacts) contact.grip = Grip::equal;
  }
  std::size_t lines() const { return is.lines.size(); }
  /// As long as its way takes for the strain `e` in a line.
  void strain(std::size_t line, double e) {
    for (Values* v : {&before, &now}) {
      LineValues& is_now = v->lines[line];
      is_now.L = path_of(is.lines[line], is_now) / (1 + e);
      is_now.e = e;
      is_now.T = std::max(0.0, EA * e);
      is_now.end_T = {is_now.T, is_now.T};
    }
  }
  Array<double> after_runs() {
    decide_runs(is, before, now);
    Array<double> T;
    for (const LineValues& line : now.lines) T.push_back(line.T);
    return T;
  }
};

TEST(TransientRuns, SlackLinesOfATautRunPullAsIfTheyCouldPush) {
  Rope of(3);
  const double strains[] = {-1e-3, 2e-3, -4e-3, -1e-5};
  for (std::size_t k = 0; k < 4; ++k) of.strain(k, strains[k]);
  const Array<double> T = of.after_runs();
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(T[k], EA * strains[k], 1e-6 * EA * std::abs(strains[k])) << k;
  EXPECT_NEAR(of.now.lines[2].T_e, EA, 1e-9);
  EXPECT_EQ(of.now.lines[2].end_T[0], T[2]);
}

TEST(TransientRuns, ARopeThatIsSlackAllAlongStaysAsItIs) {
  Rope of(3);
  for (std::size_t k = 0; k < 4; ++k) of.strain(k, -1e-3);
  for (const double T : of.after_runs()) EXPECT_EQ(T, 0);
}

TEST(TransientRuns, WhereAContactHoldsTheRopeTheRunEnds) {
  Rope of(3);
  of.strain(0, 1e-3);
  for (std::size_t k = 1; k < 4; ++k) of.strain(k, -1e-3);
  of.now.contacts[1].grip = Grip::stuck;
  const Array<double> T = of.after_runs();
  EXPECT_LT(T[1], 0);
  EXPECT_EQ(T[2], 0);
  EXPECT_EQ(T[3], 0);
}

TEST(TransientRuns, ABrokenLineLoosensItsRun) {
  Rope of(3);
  of.strain(0, 1e-3);
  for (std::size_t k = 1; k < 4; ++k) of.strain(k, -1e-3);
  of.now.lines[3].gone = 0;
  EXPECT_EQ(of.after_runs()[1], 0);
}

TEST(TransientRuns, ADrumThatPullsTautensSlackRope) {
  for (const double pull : {0.0, 50.0}) {
    Rope of(2, 0, pull);
    for (std::size_t k = 0; k < of.lines(); ++k) of.strain(k, -1e-3);
    EXPECT_EQ(of.after_runs()[1]<0, pull> 0) << pull;
  }
}

TEST(TransientRuns, WithWeightTheEndsAreAsNearNoTension) {
  Rope of(1, 20);
  of.strain(0, 1e-3);
  of.strain(1, -1e-3);
  const double T = of.after_runs()[1];
  ASSERT_LT(T, 0);
  EXPECT_NEAR(of.now.lines[1].end_T[0] / T, 0.1, 1e-9);  // it rises along the path: its end bears more
  EXPECT_NEAR(of.now.lines[1].end_T[1] / T, 1.9, 1e-9);
}

/// Tensions of 100 N and 60 N beside a contact: within its law by what is asked, or beyond it.
TEST(TransientRuns, LawsHoldToAShareOfTheLargestTension) {
  Rope of(2);
  const auto holds = [&](Grip grip, double ratio, double in, double out, double share = 1e-4, double floor = 0) {
    of.now.contacts[0].grip = grip;
    of.now.contacts[0].ratio = ratio;
    of.now.contacts[1].grip = Grip::stuck;
    for (const auto& [line, T] : {std::pair{0, in}, std::pair{1, out}}) {
      of.now.lines[line].T = T;
      of.now.lines[line].end_T = {T, T};
    }
    of.now.lines[2].T = 0;
    return laws_hold(of.is, of.now, share, floor);
  };
  EXPECT_FALSE(holds(Grip::equal, 1, 100, 60));
  EXPECT_FALSE(holds(Grip::equal, 1, 100, 99.98));
  EXPECT_TRUE(holds(Grip::equal, 1, 100, 99.995));
  EXPECT_TRUE(holds(Grip::equal, 1, 100, 60, 1e-4, 41));
  EXPECT_TRUE(holds(Grip::backward, 100.0 / 60, 100, 60));
  EXPECT_FALSE(holds(Grip::forward, 100.0 / 60, 100, 60));
  EXPECT_TRUE(holds(Grip::forward, 100.0 / 60, 60, 100));
  EXPECT_TRUE(holds(Grip::stuck, 1, 100, 60));  // it holds what it holds
  EXPECT_FALSE(holds(Grip::equal, 1, 100, 0));  // a damper may keep a line without tension
  EXPECT_TRUE(holds(Grip::equal, 1, 0, 0));     // loose rope has no law
}

/// One step in which nothing but rope can move: all of it has one tension, that of its whole length over its whole way,
/// however it was shared out; or none, and what was taut has got the rope that it needs.
TEST(TransientRuns, AStepFindsTheOneTensionOfARope) {
  for (const double taut_by : {4e-3, 1e-3}) {
    Rope of(12);
    double way = 0, rope = 0;
    for (std::size_t k = 0; k < of.lines(); ++k) {
      of.strain(k, k == 3 ? 13 * taut_by : -2e-3);
      way += of.now.lines[k].l;
      rope += of.now.lines[k].L;
    }
    Scheme s = scheme_of_euler();
    s.h = 1e-3;
    s.reach = s.h * s.gamma * s.alpha_f / s.alpha_m;
    s.slip_now = 1 / s.h;
    s.fresh = true;
    Newton newton;
    newton.tolerance = 1e-12;
    newton.rough = true;
    newton.largest = EA * 13 * taut_by;
    Work w = work_for(of.is);
    ASSERT_EQ(solve_step(of.is, s, of.before, s.h, of.now, w, newton), StepEnd::ok) << taut_by;
    EXPECT_LE(newton.used, 6);
    const double T = std::max(0.0, EA * (way / rope - 1));
    EXPECT_EQ(T > 0, taut_by > 2e-3);
    for (const LineValues& line : of.now.lines) EXPECT_NEAR(line.T, T, 1e-6 * EA * taut_by) << taut_by;
  }
}

}  // namespace taut::solve::dynamics::transient_runs_test
