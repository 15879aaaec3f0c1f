#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/support/boom_machine.hpp"
#include "test/support/transient_runs.hpp"

/// The telescopic boom in motion: published rows beside an independent model with the same data, and what any such
/// model has to show.
namespace taut_test::boom_motion_test {

namespace machine = taut::machine;

namespace {

using taut::solve::Start;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double degree = std::numbers::pi / 180;

TransientResult run(const machine::Model& m, double duration, double tolerance = 1e-4, double output_step = 0.02,
                    Start start = Start::assembled) {
  TransientOptions options = lasting(duration, tolerance);
  options.output_step = output_step;
  options.start = start;
  return run_to_end(m, options);
}

/// Means over times, or over boom lengths.
BoomState mean(const Boom& b, const TransientResult& r, double from, double to, bool by_length = false) {
  BoomState sum;
  int count = 0;
  for (const TransientFrame& f : r.frames) {
    const BoomState s = boom_state(b, f);
    const double x = by_length ? s.Lb : f.t - b.start;
    if (x < from || x > to || f.t < b.start) continue;
    sum.S1 += s.S1, sum.S2 += s.S2, sum.Fh += s.Fh, sum.Lb += s.Lb;
    ++count;
  }
  EXPECT_GT(count, 0);
  sum.S1 /= count, sum.S2 /= count, sum.Fh /= count, sum.Lb /= count;
  return sum;
}

TEST(BoomMotion, ExtendsAtNineMetres) {
  struct Row {
    double angle, S1, S2, Fh;
  };
  for (const Row& row : {Row{52, 105.0e3, 168.1e3, 102e3}, Row{19, 101.1e3, 176.4e3, 65e3}}) {
    Boom b;
    b.angle = row.angle * degree;
    const TransientResult r = run(boom_machine(b), 4);
    const BoomState s = mean(b, r, 1, 3);
    EXPECT_NEAR(s.S1, row.S1, 0.01 * row.S1);
    EXPECT_NEAR(s.S2, row.S2, 0.01 * row.S2);
    EXPECT_NEAR(s.Fh, row.Fh, 0.03 * row.Fh);
    const auto& energy = r.frames.back().energy;
    EXPECT_LT(std::abs(energy.residual), 1e-3 * energy.turnover);
  }
}

/// The load leaves the ground; it overshoots, and the friction of the pads turns round.
TEST(BoomMotion, LiftsTheRatedLoadAndTheTestLoad) {
  struct Row {
    double load, S1, S2;
  };
  for (const Row& row : {Row{25000, 164.3e3, 44.6e3}, Row{29950, 177.5e3, 17.3e3}}) {
    Boom b;
    b.angle = 77 * degree;
    b.load = row.load;
    b.falls = 8;
    b.moves = false;
    b.winding = 0.1;
    const TransientResult r = run(boom_machine(b), 10);
    const BoomState s = mean(b, r, 7, 9);
    EXPECT_NEAR(s.S1, row.S1, 0.015 * row.S1);
    EXPECT_NEAR(s.S2, row.S2, 2.5e3);
    bool lifted = false;
    for (const auto& e : r.events) lifted = lifted || (e.what == "apart" && e.where == "support");
    EXPECT_TRUE(lifted);
  }
}

/// From 9 to 21 m: friction is constant while the lower pads carry, then grows.
TEST(BoomMotion, ExtendsToItsFullLength) {
  Boom b;
  const TransientResult r = run(boom_machine(b), 32.5);
  const BoomState s = mean(b, r, 20.8, 21, true);
  EXPECT_NEAR(s.S1, 110.8e3, 0.015 * 110.8e3);
  EXPECT_NEAR(s.S2, 151.9e3, 0.015 * 151.9e3);
  double most = 0;
  for (const TransientFrame& f : r.frames) {
    const BoomState now = boom_state(b, f);
    if (f.t > 2 && now.Lb < 21) most = std::max(most, now.Fh);
  }
  EXPECT_NEAR(most, 165.7e3, 0.03 * 165.7e3);
  // sliding equilibrium of the static method
  for (const auto& [length, Fh] : {std::pair{12.0, 103.2e3}, {15.0, 111.3e3}, {18.0, 126.4e3}}) {
    EXPECT_NEAR(mean(b, r, length - 0.1, length + 0.1, true).Fh, Fh, 0.02 * Fh) << length;
  }
}

/// Put up at angle 0 without a hook block: what the pads can't hold goes at once.
TEST(BoomMotion, RelaxesAfterItWasPutUp) {
  Boom b;
  b.angle = 0;
  b.hook = b.load = 0;
  b.moves = false;
  const Boom& k = b;
  const TransientResult r = run(boom_machine(b), 2.5);
  const BoomState s = mean(k, r, 0, 1.5);
  EXPECT_NEAR(s.S1, 94.9e3, 0.01 * 94.9e3);
  EXPECT_NEAR(s.S2, 188.4e3, 0.01 * 188.4e3);
  // section 3 at rest: its pads hold its weight, and the ropes' difference
  const auto& faces = r.frames.back().faces;
  double N = 0, F = 0;
  for (const int i : {4, 5}) {
    N -= faces[static_cast<std::size_t>(i)].force.z();
    F -= faces[static_cast<std::size_t>(i)].force.x();
  }
  for (const int i : {6, 7}) {
    N += faces[static_cast<std::size_t>(i)].force.z();
    F += faces[static_cast<std::size_t>(i)].force.x();
  }
  EXPECT_NEAR(N, b.G3, 100);  // section 3 leans a little, and the ropes with it
  EXPECT_NEAR(2 * s.S1 - s.S2 + F, 0, 20);
  EXPECT_LE(std::abs(F), 0.155 * (b.G3 + 20));
}

/// Frictionless: both ropes stretch by the same way, and the cylinder pushes a moving sheave.
TEST(BoomMotion, FrictionlessRopesShareOneWay) {
  Boom b;
  b.hook = b.load = 0;
  b.eta = 1;
  b.f0 = b.f_inf = 0;
  const TransientResult r = run(boom_machine(b), 4);
  const double kappa = b.C2 / b.C1, constant = kappa * b.S10 + b.S20;
  for (const TransientFrame& f : r.frames) {
    const BoomState s = boom_state(b, f);
    EXPECT_NEAR(kappa * s.S1 + s.S2, constant, 1e-4 * constant);
  }
  const BoomState s = mean(b, r, 2, 3);
  const double F = -b.G3 * std::sin(b.angle);
  EXPECT_NEAR(2 * s.S1 - s.S2 + F, 0, 1e-3 * b.G3);
  EXPECT_NEAR(s.Fh, -2 * F + b.G2 * std::sin(b.angle), 2e-3 * s.Fh);
}

/// Section 3 at 21 m alone, without ropes. It jams: tan b = f_0 (2 c3/a - 1), a = 1.35 m, b = 32 deg. Below it stays.
TEST(BoomMotion, SticksWithoutRopes) {
  Boom b;
  b.ropes = false;
  b.moves = false;
  b.hook = b.load = 0;
  b.travel = 6;
  const auto way = [&](double angle, double duration) {
    b.angle = angle * degree;
    const TransientResult r = run(boom_machine(b), 3 + duration, 1e-4, 0.1);
    const auto out = [&](const TransientFrame& f) {
      const auto &s2 = f.bodies[boom_bodies::s2], &s3 = f.bodies[boom_bodies::s3];
      return (s2.orientation.transpose() * (s3.position - s2.position)).x();
    };
    return out(r.frames[30]) - out(r.frames.back());  // it comes to rest first
  };
  EXPECT_LT(std::abs(way(25, 10)), 1e-5);
  EXPECT_GT(way(36, 3), 0.05);
}

/// Loss of the extension rope at 21 m with 3.3 t: section 3 jerks inwards, and every joule is accounted for.
TEST(BoomMotion, TheEnergyOfABreakIsAccountedFor) {
  Boom b;
  b.angle = 0;
  b.travel = 6;
  b.moves = false;
  machine::Model m = boom_machine(b);
  machine::Event gone;
  gone.words = "break";
  gone.kind = taut::machine::EventKind::breaks;
  gone.at = 1;
  gone.index = 0;
  gone.part = 0;
  m.events.push_back(gone);
  const TransientResult r = run(m, 2, 1e-4, 0.02, Start::settled);
  const auto out = [](const TransientFrame& f) {
    const auto &s2 = f.bodies[boom_bodies::s2], &s3 = f.bodies[boom_bodies::s3];
    return (s2.orientation.transpose() * (s3.position - s2.position)).x();
  };
  EXPECT_NEAR(out(r.frames[50]) - out(r.frames.back()), 0.11, 0.2 * 0.11);
  const auto& energy = r.frames.back().energy;
  const auto& branch = r.frames[49].branches[0];  // of both ropes
  const double stored = branch.T_from * (branch.stretched - branch.unstretched);
  EXPECT_NEAR(energy.broken, stored, 0.01 * stored);
  EXPECT_LT(std::abs(energy.residual), 1e-3 * energy.broken);
}

}  // namespace
}  // namespace taut_test::boom_motion_test
