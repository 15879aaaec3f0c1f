#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/machine/links/observable.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Ropes in segments that run over rounds and onto drums: their joints are laid out anew before one gets there.
namespace taut_test::joints_test {
namespace {

using taut::solve::Start;
using taut::solve::TimeMethod;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

TransientOptions settled(double duration, double tolerance) {
  TransientOptions options = lasting(duration, tolerance, 100);
  options.start = Start::settled;
  return options;
}

/// A load of 500 kg on a rope from a drum over a wheel 20 m above; the drum takes the rope in at `speed`. The branch
/// from the drum rises at 76 degrees and sags.
machine::Model hoist(int segments, double speed, double length, double weight = 9.81) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies = {body("load", {5.2, 0, 20.0 - (length - 20.3 - 0.4)}, 500, "xz")};
  machine::Node drum = sheave("winch", {0, 0, 0}, 0.15, 1);
  drum.drum = 0;
  m.drums.resize(1);
  m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, speed, 0.2, 0.8)};
  m.reevings.push_back(
      reeve("rope", {drum, sheave("wheel", {5, 0, 20}, 0.2, 1), anchor_on("load", 0)}, length, weight, 5e6));
  m.reevings[0].segments = segments;
  m.reevings[0].damping_time = 2e-3;
  return m;
}

double largest(const TransientResult& r) { return r.ropes[0].T.max; }

/// The rope runs by its joints' distances many times: 0.2 m at the drum and at the wheel.
TEST(Joints, RunOverAWheelAndOntoADrum) {
  const TransientResult straight = run_to_end(hoist(1, 1, 43), settled(12, 1e-5));
  for (const int segments : {2, 5, 12}) {
    const TransientResult chain = run_to_end(hoist(segments, 1, 43), settled(12, 1e-5));
    const TransientFrame &a = chain.frames.back(), &b = straight.frames.back();
    EXPECT_NEAR(a.bodies[0].position.z(), b.bodies[0].position.z(), 2e-3) << segments;
    EXPECT_NEAR(a.drums[0].speed, 1, 1e-9);
    EXPECT_LT(std::abs(a.energy.residual), 1e-6 * a.energy.turnover) << segments;
    // what lies on the drum has taken its motion along, 11.4 kg at 1 m/s; the last share on either side counts no more
    const double kinetic = 11.4 / 2;
    EXPECT_NEAR(a.energy.numerical, (1 - 1.0 / segments) * kinetic, 0.1 * kinetic) << segments;
    EXPECT_NEAR(largest(chain), largest(straight), 0.01 * largest(straight)) << segments;
  }
}

/// Ends swapped: the same motion.
TEST(Joints, RunTheOtherWayAlongThePath) {
  machine::Model m = hoist(5, 1, 43), swapped = m;
  std::reverse(swapped.reevings[0].nodes.begin(), swapped.reevings[0].nodes.end());
  for (machine::Node& node : swapped.reevings[0].nodes) node.side = -node.side;
  const TransientResult a = run_to_end(m, settled(8, 1e-6)), b = run_to_end(swapped, settled(8, 1e-6));
  EXPECT_NEAR(a.frames.back().bodies[0].position.z(), b.frames.back().bodies[0].position.z(), 1e-7);
  EXPECT_NEAR(largest(a), largest(b), 1e-5 * largest(a));
}

/// Let out: the rope comes back from the drum, and the joints go apart.
TEST(Joints, GoApartAsRopeIsLetOut) {
  const TransientResult chain = run_to_end(hoist(6, -1, 26), settled(10, 1e-5));
  const TransientResult straight = run_to_end(hoist(1, -1, 26), settled(10, 1e-5));
  const TransientFrame& last = chain.frames.back();
  EXPECT_NEAR(last.bodies[0].position.z(), straight.frames.back().bodies[0].position.z(), 3e-3);
  double shortest = 1e9, longest = 0;
  for (const TransientFrame::Branch& branch : last.branches) {
    if (branch.from != 1) continue;
    shortest = std::min(shortest, branch.unstretched);
    longest = std::max(longest, branch.unstretched);
  }
  EXPECT_GT(shortest, 1);
  EXPECT_LT(longest, 3 * shortest);
}

/// A heavy rope hangs deep between drum and wheel. A joint on the chord of its neighbours would stretch it: with four
/// segments the tension would jump to twice its size.
TEST(Joints, KeepTheTensionOfARopeThatHangs) {
  const TransientOptions options = settled(6, 1e-5);
  const TransientResult fine = run_to_end(hoist(24, -1, 30, 3 * 9.81), options);
  for (const int segments : {4, 8}) {
    const TransientResult coarse = run_to_end(hoist(segments, -1, 30, 3 * 9.81), options);
    EXPECT_NEAR(largest(coarse), largest(fine), 0.01 * largest(fine)) << segments;
    EXPECT_NEAR(coarse.frames.back().bodies[0].position.z(), fine.frames.back().bodies[0].position.z(), 0.02);
  }
}

/// Against another integrator of the same laws, without dampers: what a joint was given is not forgotten.
TEST(Joints, AreLaidOutInTheReferenceToo) {
  TransientOptions options = settled(4, 2e-7);
  machine::Model m = hoist(4, 1.5, 43);
  m.reevings[0].damping_time = 0;
  const TransientResult implicit = run_to_end(m, options);
  options.method = TimeMethod::reference;
  const TransientResult reference = run_to_end(m, options);
  const TransientFrame &a = implicit.frames.back(), &b = reference.frames.back();
  EXPECT_NEAR(a.bodies[0].position.z(), b.bodies[0].position.z(), 1e-6);
  EXPECT_NEAR(a.drums[0].T, b.drums[0].T, 1e-3 * b.drums[0].T);  // the reference's own scatters by 6e-4
  EXPECT_NEAR(a.energy.numerical, b.energy.numerical, 1e-3 * b.energy.numerical);
}

TEST(Joints, AreLaidOutBetweenVerletsSteps) {
  TransientOptions options = settled(3, 1e-3);
  machine::Model m = hoist(4, 1.5, 43);
  const TransientResult implicit = run_to_end(m, options);
  options.method = TimeMethod::verlet;
  const TransientResult verlet = run_to_end(m, options);
  EXPECT_NEAR(implicit.frames.back().bodies[0].position.z(), verlet.frames.back().bodies[0].position.z(), 1e-4);
  EXPECT_NEAR(largest(implicit), largest(verlet), 2e-3 * largest(verlet));
}

/// A tensioner takes as much rope out of a standing chain as two of its segments have.
TEST(Joints, AreLaidOutWhereATensionerShortensTheRope) {
  machine::Model m;
  m.gravity = 9.81;
  m.reevings.push_back(reeve("stay", {anchor("a", {0, 0, 0}), anchor("b", {30, 0, 4})}, 34, 9.81, 1e6));
  m.reevings[0].segments = 8;
  m.reevings[0].damping_time = 2e-2;
  m.tensioners.push_back({.reeving = 0, .at_start = true, .change = smooth_move(0, -3.5, 0.5, 4)});
  const TransientResult r = run_to_end(m, settled(6, 1e-4));
  double length = 0;
  for (const TransientFrame::Branch& branch : r.frames.back().branches) {
    EXPECT_GT(branch.unstretched, 0.4 * 30.5 / 8);
    length += branch.unstretched;
  }
  EXPECT_NEAR(length, 30.5, 1e-9);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-5 * r.frames.back().energy.turnover);
}

/// They are seen where they are, at equal shares of their branch.
TEST(Joints, AreObserved) {
  machine::Model m = hoist(4, 1, 43);
  for (const char* name : {"rope[2,1].z", "rope[2,3].z", "rope[2,3].vz", "load.z", "load.vz"}) {
    std::vector<taut::Complaint> complaints;
    m.observed.push_back(taut::machine::observable(name, m, "observe", complaints).value());
  }
  const TransientResult r = run_to_end(m, settled(6, 1e-5));
  const auto last = [&](std::size_t k) { return r.observed[k].back(); };
  EXPECT_GT(last(0), last(1));
  EXPECT_GT(last(1), last(3));
  EXPECT_LT(last(1), last(3) + 0.5 * (20 - last(3)));
  EXPECT_NEAR(last(2), last(4), 0.01);
}

/// The joints of a saved state have the masses that they were given last.
TEST(Joints, GoOnFromASavedState) {
  const machine::Model m = hoist(5, 1, 43);
  TransientOptions options = settled(6, 1e-6);
  options.step = 2e-3;
  options.output_step = 0.1;
  const TransientResult whole = run_to_end(m, options);
  options.duration = 3.5;
  const TransientResult first = run_to_end(m, options);
  options.duration = 2.5;
  options.from = first.state;
  const TransientResult second = run_to_end(m, options);
  EXPECT_EQ(whole.frames.back().bodies[0].position.z(), second.frames.back().bodies[0].position.z());
  EXPECT_EQ(whole.frames.back().drums[0].T, second.frames.back().drums[0].T);
}

}  // namespace
}  // namespace taut_test::joints_test
