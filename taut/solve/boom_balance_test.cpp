#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/solve/motion/transient.hpp"
#include "test/support/boom_machine.hpp"
#include "test/support/transient_runs.hpp"

/// What any model of the telescopic boom has to show, whatever its data: balances, the ropes' common way, the ratio of
/// the moving sheaves, results that do not hang on the step.
namespace taut_test::boom_balance_test {

namespace machine = taut::machine;

namespace {

using taut::solve::Slid;
using taut::solve::Start;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double degree = std::numbers::pi / 180;

TransientOptions started(Start start, double duration, int outputs) {
  TransientOptions o = lasting(duration, 1e-4, outputs);
  o.start = start;
  return o;
}

/// Sliding from the start on, without inertia.
TransientOptions sliding(double duration, int steps, double by = 0.1) {
  TransientOptions o = slowly(duration, steps, Start::sliding);
  o.slid = {Slid{.drum = false, .index = 0, .by = by}};
  return o;
}

/// All forces on a body: its weight, ropes and pads.
Vector3 forces_on(int body, const machine::Model& m, const TransientFrame& f) {
  Vector3 sum = -m.bodies[static_cast<std::size_t>(body)].mass * m.gravity * Vector3::UnitZ();
  for (const auto& branch : f.branches) {
    const machine::Reeving& rope = m.reevings[static_cast<std::size_t>(branch.reeving)];
    const auto node = [&](int k) { return rope.nodes[static_cast<std::size_t>(k)]; };
    const Vector3 along = (branch.end - branch.start).normalized();
    if (node(branch.from).at.body == body) sum += rope.copies * branch.T_from * along;
    if (node(branch.to).at.body == body) sum -= rope.copies * branch.T_to * along;
  }
  for (std::size_t i = 0; i < f.faces.size(); ++i) {
    if (m.contacts[i].body == body) sum += f.faces[i].force;
    if (m.faces[static_cast<std::size_t>(m.contacts[i].face)].body == body) sum -= f.faces[i].force;
  }
  return sum;
}

/// Pads of section 3 on 2 and of 2 on 3: pressure and friction along the boom on section 3, N.
std::pair<double, double> pads_of_3(const TransientFrame& f) {
  const auto& R = f.bodies[boom_bodies::s2].orientation;
  Vector3 on_3 = Vector3::Zero();
  for (const std::size_t i : {4U, 5U}) on_3 -= f.faces[i].force;
  for (const std::size_t i : {6U, 7U}) on_3 += f.faces[i].force;
  const Vector3 along = R.transpose() * on_3;
  return {along.z(), along.x()};
}

/// At rest and in slow motion, extending and drawn in, with jammed pads and without.
TEST(BoomBalance, EverySectionAndTheHookAreInBalance) {
  for (const double angle : {0.0, 19.0, 52.0, 76.0}) {
    for (const bool retracts : {false, true}) {
      Boom b;
      b.angle = angle * degree;
      b.travel = retracts ? 5.9 : 3.1;
      b.start = 0;
      b.retracts = retracts;
      const machine::Model m = boom_machine(b);
      const TransientResult r = run_to_end(m, sliding(3, 30, retracts ? -0.1 : 0.1));
      for (const TransientFrame& f : r.frames) {
        for (const int body : {boom_bodies::s3, boom_bodies::hook, boom_bodies::load}) {
          EXPECT_LT(forces_on(body, m, f).norm(), 0.05) << angle << " " << f.t;
        }
      }
    }
  }
}

/// Put up with whatever tensions: section 3 holds 2 S1 - S2 + F = 0, F that of its pads and its weight, and no more
/// than they can; they carry its weight across the boom.
TEST(BoomBalance, TheRopesDifferByWhatSection3Asks) {
  for (const double angle : {0.0, 15.0, 40.0}) {
    for (const double S20 : {181e3, 191e3, 205e3}) {
      Boom b;
      b.angle = angle * degree;
      b.S20 = S20;
      b.hook = b.load = 0;
      b.moves = false;
      TransientOptions o = started(Start::assembled, 1, 2);
      o.quasi_static = true;
      o.tolerance = 1e-8;
      const TransientResult r = run_to_end(boom_machine(b), o);
      const BoomState s = boom_state(b, r.frames.back());
      const auto [N, Ff] = pads_of_3(r.frames.back());
      const double F = Ff - b.G3 * std::sin(b.angle);
      EXPECT_NEAR(2 * s.S1 - s.S2 + F, 0, 20);  // section 3 leans a little, and the ropes with it
      EXPECT_NEAR(N, b.G3 * std::cos(b.angle), 100);
      EXPECT_LE(std::abs(Ff), b.f0 * (b.G3 * std::cos(b.angle) + 100));
    }
  }
}

/// Sheaves without loss: both ropes have the same elongation X, so kappa S1 + S2 never changes.
TEST(BoomBalance, RopesWithoutLossShareOneWayInEveryMotion) {
  Boom extending;
  extending.eta = 1;
  Boom lifting = extending;
  lifting.angle = 77 * degree;
  lifting.load = 25000;
  lifting.falls = 8;
  lifting.moves = false;
  lifting.winding = 0.1;
  for (const auto& [b, duration] : {std::pair{extending, 31.5}, {lifting, 10.0}}) {
    const TransientResult r =
        run_to_end(boom_machine(b), started(Start::settled, duration, static_cast<int>(20 * duration)));
    const double kappa = b.C2 / b.C1;
    double low = HUGE_VAL, high = 0;
    for (const TransientFrame& f : r.frames) {
      const BoomState s = boom_state(b, f);
      low = std::min(low, kappa * s.S1 + s.S2);
      high = std::max(high, kappa * s.S1 + s.S2);
    }
    EXPECT_LT(high - low, 1e-4 * high);
  }
}

/// Without any friction the cylinder pushes twice what section 3 asks, and the weight of 2: the moving sheaves' ratio.
TEST(BoomBalance, TheCylinderPushesTwiceWhatSection3Asks) {
  for (const double angle : {5.0, 35.0, 70.0}) {
    for (const double travel : {0.0, 3.0, 5.5}) {
      Boom b;
      b.angle = angle * degree;
      b.travel = travel;
      b.hook = b.load = 0;
      b.eta = 1;
      b.f0 = b.f_inf = 0;
      b.start = 0;
      machine::Model m = boom_machine(b);
      for (auto& pad : m.contacts) {  // rigid, so that no section leans
        pad.stiffness = pad.tangential_stiffness = 1e11;
        pad.clearance = 0;
      }
      const TransientResult r = run_to_end(m, sliding(1, 10));
      const double F = -b.G3 * std::sin(b.angle), Fh = -2 * F + b.G2 * std::sin(b.angle);
      EXPECT_NEAR(boom_state(b, r.frames.back()).Fh, Fh, 1e-5 * Fh) << angle << " " << travel;
    }
  }
}

/// Steady values of the extension at 9 m with half the step.
TEST(BoomBalance, HalfTheStepLeavesTheSteadyValues) {
  std::vector<BoomState> means;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    Boom b;
    TransientOptions o = started(Start::settled, 4, 200);
    o.step = step;
    const TransientResult r = run_to_end(boom_machine(b), o);
    BoomState sum;
    int count = 0;
    for (const TransientFrame& f : r.frames) {
      if (f.t < 2 - 1e-9) continue;
      const BoomState s = boom_state(b, f);
      sum.S1 += s.S1, sum.S2 += s.S2, sum.Fh += s.Fh;
      ++count;
    }
    means.push_back({sum.S1 / count, sum.S2 / count, sum.Fh / count, 0});
  }
  EXPECT_NEAR(means[1].S1, means[2].S1, 1e-4 * means[2].S1);
  EXPECT_NEAR(means[1].S2, means[2].S2, 1e-4 * means[2].S2);
  EXPECT_NEAR(means[1].Fh, means[2].Fh, 1e-4 * means[2].Fh);
}

}  // namespace
}  // namespace taut_test::boom_balance_test
