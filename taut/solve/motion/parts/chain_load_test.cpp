#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Forces along ropes in segments: against the straight branch of the same machine, by energy and momentum, and where
/// they go over from one segment to the next.
namespace taut_test::transient_chain_load_test {
namespace {

using taut::solve::Start;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

TransientOptions lasting(double duration, double tolerance, Start start) {
  TransientOptions options;
  options.duration = duration;
  options.output_step = duration / 20;
  options.tolerance = tolerance;
  options.start = start;
  return options;
}

machine::Node load_on(machine::Model& m, const Vector3& at, double share) {
  machine::Body place = body("brake", at, 0, "xyz");
  place.of_rope = true;
  machine::Node node = anchor_on("brake", static_cast<int>(m.bodies.size()));
  node.kind = machine::NodeKind::load;
  node.load.share = share;
  m.bodies.push_back(place);
  return node;
}

/// A mass on a rope with its own mass, a force at the share 0.33 below its top.
machine::Model hanging(int segments, bool friction, bool swapped = false) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, -10}, 200, "xz"));
  machine::Node load = load_on(m, {0, 0, -3.3}, swapped ? 0.67 : 0.33);
  load.load.by_motion = friction;
  load.load.sense = friction || swapped ? -1 : 1;
  if (friction) {
    load.load.force = 150;
  } else {
    load.load.signal = smooth_move(0, 900, 0, 0.3);
  }
  std::vector<machine::Node> nodes{anchor("top", {0, 0, 0}), load, anchor_on("mass", 0)};
  if (swapped) std::reverse(nodes.begin(), nodes.end());
  m.reevings.push_back(reeve("rope", nodes, friction ? 9.92 : 9.95, 0.5 * 9.81, 4e5));
  m.reevings[0].segments = segments;
  m.reevings[0].damping_time = 1e-3;
  return m;
}

/// The first line of a frame at the load: its contact.
const taut::solve::TransientFrame::Contact& load_of(const TransientResult& r) {
  return r.frames.back().contacts.back();
}

/// Where the machine comes to rest under the force, a chain hangs as the straight branch does: half a part's weight
/// is what their tensions differ by.
TEST(TransientChainLoad, TheSteadyStateOfTheStraightBranch) {
  const auto rest = [](int segments, bool swapped) {
    machine::Model m = hanging(segments, false, swapped);
    m.reevings[0].damping_time = 0.02;
    return run_to_end(m, lasting(8, 1e-6, Start::settled));
  };
  const TransientResult straight = rest(1, false);
  for (const int segments : {4, 12}) {
    for (const bool swapped : {false, true}) {
      const TransientResult chain = rest(segments, swapped);
      EXPECT_NEAR(chain.frames.back().bodies[0].position.z(), straight.frames.back().bodies[0].position.z(), 2e-6);
      const auto &a = load_of(chain), &b = load_of(straight);
      const double above = swapped ? a.T_out : a.T_in, below = swapped ? a.T_in : a.T_out;
      EXPECT_NEAR(above - below, 900, 1e-6);
      // the tension at the middle of a segment: half of the upper part's weight is what both may differ by
      EXPECT_NEAR(above, b.T_in, 0.5 * 9.81 * 3.3 / 2 + 1);
      EXPECT_NEAR(chain.frames.back().bodies[1].position.z(), straight.frames.back().bodies[1].position.z(), 1e-6);
      EXPECT_LT(std::abs(chain.frames.back().energy.residual), 1e-6 * chain.frames.back().energy.turnover);
    }
  }
}

TEST(TransientChainLoad, ClosesItsEnergyAndComesToOneMotion) {
  const auto run = [](int segments, bool friction, double tolerance = 1e-6) {
    const Start start = friction ? Start::assembled : Start::settled;
    return run_to_end(hanging(segments, friction), lasting(1, tolerance, start));
  };
  for (const bool friction : {false, true}) {
    const TransientResult coarse = run(10, friction), fine = run(40, friction, 1e-5);
    const double z = fine.frames.back().bodies[0].position.z();
    EXPECT_NEAR(coarse.frames.back().bodies[0].position.z(), z, friction ? 1e-3 : 3e-6);
    const auto& energy = coarse.frames.back().energy;
    EXPECT_LT(std::abs(energy.residual), 1e-6 * energy.turnover);
    EXPECT_GT(friction ? energy.slipped : energy.supplied, 1);
  }
}

/// A chain in free flight between two masses: the force is all that changes its momentum, and as the place follows no
/// end that stands, it keeps its share.
TEST(TransientChainLoad, GivesItsImpulse) {
  machine::Model m;
  m.gravity = 0;
  m.bodies = {body("a", {0, 0, 0}, 30, "xyz"), body("b", {6, 2, 3}, 50, "xyz")};
  machine::Node load = load_on(m, {2.4, 0.8, 1.2}, 0.4);
  load.load.signal = smooth_move(0, 700, 0, 0.2);
  load.load.sense = 1;
  m.reevings.push_back(reeve("rope", {anchor_on("a", 0), load, anchor_on("b", 1)}, 6.9, 0, 1e5));
  m.reevings[0].mass = 0.5;
  m.reevings[0].segments = 6;
  const TransientResult r = run_to_end(m, lasting(0.5, 1e-7, Start::assembled));
  const auto& last = r.frames.back();
  // each segment's mass is at its ends
  const double before = 0.5 * 0.4 * 6.9 / 6, behind = 0.5 * 0.6 * 6.9 / 6;
  Vector3 momentum = (30 + before / 2) * last.bodies[0].velocity + (50 + behind / 2) * last.bodies[1].velocity;
  const auto& joints = r.state.ropes[0].inside_velocity;
  ASSERT_EQ(joints.size(), 11U);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    momentum += (k < 5 ? before : k > 5 ? behind : (before + behind) / 2) * joints[k];
  }
  const double impulse = 700 * (0.5 - 0.1);  // half of the smooth 0.2 s
  EXPECT_LT((momentum - impulse * Vector3(6, 2, 3) / 7).norm(), 1e-6 * impulse);
  EXPECT_LT(std::abs(last.energy.residual), 1e-6 * last.energy.turnover);
}

/// Hauled over a sheave, the rope takes its joints past the place: what the force does has no jump there, nor where it
/// acts in the segment at the sheave itself.
TEST(TransientChainLoad, GoesOverFromSegmentToSegment) {
  const auto machine = [](int segments, double share) {
    machine::Model m;
    m.gravity = 9.81;
    m.bodies = {body("mass", {0.2, 0, -12}, 300, "z")};
    machine::Node wheel = sheave("wheel", {0, 0, 0}, 0.2, 1, 0.97);
    wheel.inertia = 0.3;
    machine::Node drum = sheave("winch", {0, 0, -8}, 0.2, 1);  // below the wheel: nothing sags
    drum.drum = 0;
    m.drums.resize(1);
    m.drums[0].drive = {machine::DriveKind::speed, smooth_move(0, 0.5, 0, 1.2)};
    machine::Node load = load_on(m, {0.2, 0, -12 * share}, share);
    load.load.by_motion = true;
    load.load.sense = -1;
    load.load.force = 400;
    m.reevings.push_back(reeve("rope", {drum, wheel, load, anchor_on("mass", 0)}, 20.56, 0.4 * 9.81, 1e6));
    m.reevings[0].segments = segments;
    m.reevings[0].damping_time = 2e-3;
    return m;
  };
  for (const double share : {0.3, 0.6}) {
    const TransientResult straight = run_to_end(machine(1, share), lasting(2, 1e-4, Start::settled));
    const TransientResult chain = run_to_end(machine(3, share), lasting(2, 1e-4, Start::settled));
    const auto &a = chain.frames.back(), &b = straight.frames.back();
    EXPECT_NEAR(a.bodies[0].position.z(), b.bodies[0].position.z(), 2e-4);
    EXPECT_NEAR(load_of(chain).T_in - load_of(chain).T_out, load_of(straight).T_in - load_of(straight).T_out, 1e-3);
    EXPECT_NEAR(load_of(chain).slip, load_of(straight).slip, 2e-3);
    EXPECT_NEAR(a.energy.slipped, b.energy.slipped, 0.01 * b.energy.slipped);
    EXPECT_LT(std::abs(a.energy.residual), 1e-6 * a.energy.turnover);
    for (std::size_t f = 10; f < chain.frames.size(); ++f) {
      const double T = chain.frames[f].drums[0].T;
      EXPECT_NEAR(T, straight.frames[f].drums[0].T, 0.01 * T) << f;
    }
  }
}

TEST(TransientChainLoad, GoesOnFromItsState) {
  const machine::Model m = hanging(10, true);
  TransientOptions options = lasting(0.6, 1e-6, Start::assembled);
  options.step = 2e-4;
  options.output_step = 0.05;
  const TransientResult whole = run_to_end(m, options);
  options.duration = 0.3;
  options.from = run_to_end(m, options).state;
  const TransientResult second = run_to_end(m, options);
  for (std::size_t f = 0; f < second.frames.size(); ++f) {
    EXPECT_EQ(second.frames[f].bodies[0].position, whole.frames[f + 6].bodies[0].position);
    EXPECT_EQ(second.frames[f].contacts[0].T_in, whole.frames[f + 6].contacts[0].T_in);
  }
}

}  // namespace
}  // namespace taut_test::transient_chain_load_test
