#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Ropes that part: what becomes of their energy, of their dead ends, and of those that have parted already.
namespace taut_test::transient_break {
namespace {

using taut::solve::EnergyLedger;
using taut::solve::TransientFrame;
using taut::solve::TransientResult;

machine::Event break_at(double t, double over, std::optional<int> part = {}) {
  machine::Event event;
  event.words = "break";
  event.kind = machine::EventKind::breaks;
  event.at = t;
  event.over = over;
  event.index = 0;
  event.part = part;
  return event;
}

/// A mass of 100 kg on a rope over two points, 3 m beside each other, 5 m above it; its other end is held 2 m below.
machine::Model over_two_points(double weight) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, 0}, 100, "z"));
  machine::Reeving rope =
      reeve("rope", {anchor_on("held", 0), over("left", {0, 0, 5}), over("right", {3, 0, 5}), anchor("end", {3, 0, 3})},
            0, weight, 1e6);
  rope.given = machine::Given::tension_at_start;
  rope.value = 981;
  m.reevings.push_back(rope);
  return m;
}

double time_of(const TransientResult& r, const std::string& what, const std::string& where) {
  for (const auto& event : r.events) {
    if (event.what == what && event.where == where) return event.t;
  }
  return -1;
}

/// The mass falls freely with a rope without weight: its dead end runs over the right point when the mass has fallen by
/// what hung there, and over the left one when the rest has followed.
TEST(TransientBreak, DeadEndRunsOffWhenItsRopeIsUsedUp) {
  machine::Model m = over_two_points(0);
  m.events.push_back(break_at(0, 0, 2));
  const TransientResult r = run_to_end(m, lasting(1.2, 1e-4, 100));
  const double stretch = 1 + 981 / 1e6, g = 9.81;
  EXPECT_NEAR(time_of(r, "run_off", "right"), std::sqrt(2 * (2 / stretch + 8 * (1 / stretch - 1)) / g), 2e-4);
  EXPECT_NEAR(time_of(r, "run_off", "left"), std::sqrt(2 * (5 / stretch + 5 * (1 / stretch - 1)) / g), 2e-4);
  for (const TransientFrame& frame : r.frames) {
    double whole = 0;
    for (const auto& branch : frame.branches) {
      EXPECT_GT(branch.unstretched, 0);
      whole += branch.unstretched;
    }
    EXPECT_NEAR(whole, 10 / stretch, 1e-5) << frame.t;  // no rope comes out of nothing
    EXPECT_NEAR(frame.energy.residual, 0, 1e-4 * frame.energy.turnover + 1e-6) << frame.t;
  }
}

/// With weight: what runs over the points has a height, and the branch of the dead end is longer than its rope.
TEST(TransientBreak, WeightOfDeadEndsClosesTheBooks) {
  machine::Model m = over_two_points(20);
  m.events.push_back(break_at(0.05, 0, 2));
  const TransientResult r = run_to_end(m, lasting(1.3, 1e-4, 100));
  EXPECT_GT(time_of(r, "run_off", "left"), 0);
  for (const TransientFrame& frame : r.frames) {
    EXPECT_NEAR(frame.energy.residual, 0, 1e-3 * frame.energy.turnover + 1e-6) << frame.t;
  }
}

/// A break that takes 10 ms, far less than the mass moves in: all strain energy is lost in it, in however few steps the
/// rest of the motion would go.
TEST(TransientBreak, StrainEnergyGoesWithTheStiffness) {
  machine::Model m = over_two_points(0);
  m.events.push_back(break_at(0.1, 0.01, 2));
  const TransientResult r = run_to_end(m, lasting(0.2, 1e-4, 100));
  const double strain = r.frames.front().energy.elastic;
  EXPECT_NEAR(strain, 981.0 * 981 / 1e6 / 2 * 10 / (1 + 981e-6), 1e-6);
  const EnergyLedger& end = r.frames.back().energy;
  EXPECT_NEAR(end.elastic, 0, 1e-9);
  EXPECT_NEAR(end.broken, strain, 0.01 * strain);
  EXPECT_NEAR(end.residual, 0, 0.01 * strain);
}

/// What is broken breaks no second time, and does not hold again while it does.
TEST(TransientBreak, BrokenRopeDoesNotHoldAgain) {
  machine::Model m = over_two_points(0);
  m.events = {break_at(0.1, 0), break_at(0.3, 0.05), break_at(0.4, 0.05, 1)};
  const TransientResult r = run_to_end(m, lasting(0.5, 1e-4, 100));
  std::vector<double> broke;
  for (const auto& event : r.events) {
    if (event.what == "break") broke.push_back(event.t);
  }
  ASSERT_EQ(broke.size(), 2U);  // the rope hangs loose at 0.3 s; at 0.4 s its whole part is named
  EXPECT_DOUBLE_EQ(broke[1], 0.4);
  for (std::size_t k = 1; k < r.frames.size(); ++k) {
    const TransientFrame& frame = r.frames[k];
    EXPECT_GE(frame.energy.broken, r.frames[k - 1].energy.broken);
    EXPECT_EQ(frame.branches[0].whole, frame.t < 0.1 + 1e-9);
    EXPECT_TRUE(frame.branches[0].whole || frame.branches[0].T_from == 0);
  }
}

/// A wheel that has lost its rope's end spins on, and gives no rope to what is left.
TEST(TransientBreak, AWheelGivesNoRopeAfterItsEndHasRunOff) {
  machine::Model m = over_two_points(20);
  machine::Node& right = m.reevings[0].nodes[2];
  right.radius = 0.2;
  right.inertia = 4;
  m.events.push_back(break_at(0.1, 0, 2));
  const TransientResult r = run_to_end(m, lasting(1.3, 1e-4, 130));
  const double off = time_of(r, "run_off", "right");
  ASSERT_GT(off, 0);
  double left = 0;
  for (const TransientFrame& frame : r.frames) {
    EXPECT_NEAR(frame.energy.residual, 0, 1e-3 * frame.energy.turnover + 1e-6) << frame.t;
    if (frame.t <= off) continue;
    const double now = frame.branches[0].unstretched + frame.branches[1].unstretched;
    if (left > 0) {
      EXPECT_LT(now, left + 1e-9) << frame.t;
    }
    left = now;
  }
  EXPECT_GT(left, 0);
  EXPECT_GT(std::abs(r.frames.back().contacts[1].spin), 1) << "it does spin";
}

/// A drum pays out to a falling mass; the rope with its dampers parts beyond a light sheave. What is left of it comes
/// free and slack, and no force changes the drum's speed at that moment.
TEST(TransientBreak, ADrumIsNotJoltedByRopeThatComesFree) {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("mass", {0, 0, 0}, 800, "z"));
  machine::Node drum = anchor("drum", {-2, 0, -4});
  drum.radius = 0.4;
  drum.drum = 0;
  machine::Node head = over("head", {0, 0, 8});
  head.law = {0.1, 0.96};
  m.drums.push_back({});
  m.drums[0].name = "drum";
  m.drums[0].core_radius = 0.39;
  m.drums[0].inertia = 28;
  m.drums[0].drive.kind = machine::DriveKind::free;
  machine::Reeving rope = reeve("rope", {drum, head, anchor_on("hook", 0)}, 0, 0, 1.8e7);
  rope.given = machine::Given::tension_at_start;
  rope.value = 4000;
  rope.damping_ratio = 0.26;
  m.reevings.push_back(rope);
  m.events.push_back(break_at(0.5, 0, 1));
  const TransientResult r = run_to_end(m, lasting(0.6, 1e-3, 600));
  const double before = r.frames[499].drums[0].speed, after = r.frames[503].drums[0].speed;
  EXPECT_LT(before, -1) << "it pays out";
  EXPECT_NEAR(after / before, 1, 0.01);
  for (const TransientFrame& frame : r.frames) {
    EXPECT_NEAR(frame.energy.residual, 0, 1e-3 * frame.energy.turnover + 1e-6) << frame.t;
  }
}

}  // namespace
}  // namespace taut_test::transient_break
