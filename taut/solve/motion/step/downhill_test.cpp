#include "taut/solve/motion/step/downhill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/step/step.hpp"
#include "test/support/machines.hpp"

/// How far a step is taken, against the energy itself on a grid; a rope without losses against its closed form.
namespace taut::solve::dynamics::downhill_test {

using namespace taut_test;

constexpr double EA = 1e6, h = 1e-3, mass = 10;

/// A rope over a free block and two points of the ground, with a strain for each of its branches.
struct Hung {
  machine::Model m;
  Mechanism is;
  Values before, now;
  Work w;
  Scheme s = scheme_of_euler();

  explicit Hung(const std::array<double, 4>& strains, bool free) {
    m.bodies = {body("block", {2, 0, -1}, mass, free ? "xyz" : "y")};
    m.reevings.push_back(reeve("rope",
                               {anchor("start", {0, 0, 0}), over("sheave", {0, 0, 0}, 0), over("b", {4, 0, 0}),
                                over("c", {6, 0, -1}), anchor("end", {8, 0, 0})},
                               9, 0, EA));
    m.reevings[0].damping_time = 0.0;
    Built built = build(m, assembled(m), {});
    EXPECT_TRUE(built.outcome.ok()) << built.outcome.message;
    is = std::move(built.mechanism);
    before = built.values;
    for (std::size_t k = 0; k < strains.size(); ++k) {
      LineValues& line = before.lines[k];
      line.L = path_of(is.lines[k], line) / (1 + strains[k]);
      line.e = strains[k];
      line.T = std::max(0.0, EA * strains[k]);
      line.end_T = {line.T, line.T};
    }
    now = before;
    w = work_for(is);
    s.h = s.reach = h;
    s.slip_now = 1 / h;
    s.fresh = true;
    s.losses = 0;
  }
  void start() {
    now = before;
    begin_step(is, s, before, w);
    now.rate.assign(now.rate.size(), 0.0);
    follow(is, s, before, w, h, now);
    for (ContactValues& contact : now.contacts) contact.grip = Grip::equal;
  }
  /// Newton's step from there; the forces out of balance stay in `w.residual`.
  Array<double> step() {
    w.tangent = true;
    assemble(is, s, before, now, w);
    EXPECT_TRUE(is.solver.factor());
    const Array<double> force = w.residual;
    is.solver.solve(w.residual);
    Array<double> found = w.residual;
    w.residual = force;
    return found;
  }
  /// Of the ropes and the weight, and of the mass about where it would go by itself.
  double energy() const {
    double all = 0;
    for (const LineValues& line : now.lines) {
      const double longer = std::max(0.0, line.l - line.L);
      all += EA * longer * longer / (2 * line.L);
    }
    for (const Body& one : is.bodies) {
      for (int c = one.first; c < one.first + one.count; ++c) all += mass * h * h * now.rate[c] * now.rate[c] / 2;
    }
    return all + mass * m.gravity * now.bodies[0].x.z();
  }
};

/// Two of its branches are slack: the whole of Newton's step, which takes them for slack, goes too far.
TEST(Downhill, TheStepEndsWhereTheEnergyIsLeast) {
  for (const std::array<double, 4>& strains :
       {std::array{2e-3, -1e-5, 1e-3, -2e-3}, std::array{-1e-5, 3e-3, -1e-5, 1e-3},
        std::array{1e-3, 1e-4, -1e-6, 2e-3}}) {
    Hung of(strains, true);
    of.start();
    const Array<double> step = of.step();
    const double first = of.energy();
    double least = first, at = 0, whole = first;
    constexpr int parts = 1000;
    for (int i = 1; i <= parts; ++i) {
      apply(of.is, step, 1.0 / parts, 1, of.now);
      ASSERT_TRUE(follow(of.is, of.s, of.before, of.w, h, of.now));
      whole = of.energy();
      if (whole < least) {
        least = whole;
        at = static_cast<double>(i) / parts;
      }
    }
    ASSERT_GT(whole - least, 0.01 * (first - least)) << "the whole step would do";
    of.start();
    const Array<double> again = of.step();
    const double share = go_downhill({of.is, of.s, of.before, h, of.now, of.w}, again, 1);
    EXPECT_LT(share, 1);
    EXPECT_NEAR(share, at, 0.06 * at + 2e-3);
    EXPECT_LE(of.energy() - least, 0.01 * (first - least));
  }
}

/// Over points that stand still the strain is that of the whole rope: e = sum l/sum L - 1.
TEST(Downhill, WithoutLossesARopeHasOneStrain) {
  for (const double more : {3e-4, 0.0, -3e-4}) {
    Hung of({2e-3 + more, -1e-3 + more, 1e-3 + more, -1.9e-3 + more}, false);
    double way = 0, rope = 0;
    for (const LineValues& line : of.before.lines) {
      way += line.l;
      rope += line.L;
    }
    for (ContactValues& contact : of.before.contacts) contact.winding = contact.lambda;
    of.s.losses = 1;
    Newton newton;
    newton.tolerance = 1e-12;
    newton.rough = true;
    newton.largest = EA * 2e-3;
    ASSERT_EQ(solve_step(of.is, of.s, of.before, h, of.now, of.w, newton), StepEnd::ok) << more;
    for (const LineValues& line : of.now.lines) EXPECT_NEAR(line.T, EA * std::max(0.0, way / rope - 1), 1e-6) << more;
  }
}

}  // namespace taut::solve::dynamics::downhill_test
