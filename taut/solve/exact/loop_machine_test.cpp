// Running skylines as machines against the exact closed loop, and against the numbers of its published example.
#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/exact/running_loop.hpp"
#include "test/support/machines.hpp"

namespace loop_machine_test {

using namespace taut_test;
using namespace taut::solve;

constexpr double g = 9.80665;

/// A running skyline: traction rope from A to the carriage, return rope from there over B and through the carriage's
/// roller to A. Its lengths are those of an exact loop.
machine::Model loop_machine(const RunningLoop& loop, const LoopState& s) {
  machine::Model m;
  const double c = loop.branch_distance, chord = std::hypot(loop.span, loop.rise);
  const Vector3 up_there =
      loop.offset_is_vertical ? Vector3(0, 0, c) : Vector3(-c * loop.rise / chord, 0, c * loop.span / chord);
  const Vector3 B(loop.span, 0, loop.rise);
  machine::Body car = body("car", {s.first.x, 0, s.first.z}, loop.carriage_weight / g, "xyz");
  if (c > 0) car.free.push_back({Vector3::Zero(), Vector3::UnitY()});
  m.bodies.push_back(car);
  m.reevings.push_back(reeve("traction", {anchor("A", origin), anchor_on("car", 0)}, s.traction_length,
                             loop.traction_rope.weight, loop.traction_rope.stiffness));
  std::vector<machine::Node> nodes{anchor_on("car", 0)};
  const Vector3 pull(loop.pull_x, 0, loop.pull_z);
  int hung = 0;
  double stretch = 0;
  const auto unstretched = [&](double length, double T) { return length / (1 + T / loop.return_rope.stiffness); };
  if (loop.second) {
    hung = 1;
    m.bodies.push_back(body("hung", {s.second.x, 0, s.second.z}, 0, "xyz"));
    nodes.push_back(anchor_on("hung", 1));
    nodes.back().kind = machine::NodeKind::clamp;
    // the loop's piece between the sections does not stretch
    nodes.back().length_before = unstretched(s.between.rope.length, s.between.T_start);
    stretch = s.between.rope.length - nodes.back().length_before;
  }
  m.loads.push_back({{.body = hung, .at = origin}, pull});
  nodes.push_back(over("B", B));
  nodes.back().law.efficiency = loop.efficiency;
  if (c > 0) nodes.push_back(over("B above", B + up_there));
  nodes.push_back(over("car", {0, 0, c}, 0));
  nodes.back().support = -Vector3::UnitZ();
  nodes.push_back(anchor("A above", up_there));
  // between the two sheaves at B the rope counts, in the loop it does not
  const double T_B = (s.lower_B.T_end + s.upper_B.T_end) / 2;
  const double around = unstretched(c, T_B);
  m.reevings.push_back(
      reeve("return", nodes, s.return_length + around - stretch, loop.return_rope.weight, loop.return_rope.stiffness));
  m.carriages.push_back({"car", 0, 1, static_cast<int>(m.reevings[1].nodes.size()) - 2, 0});
  return m;
}

EquilibriumResult in_haul(const machine::Model& m, const std::optional<machine::Prescribed>& prescribed = {}) {
  EquilibriumOptions options;
  options.motion = Motion::in;  // against the return rope's path
  options.prescribed = prescribed;
  EquilibriumResult r = equilibrium(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

/// Compares every end tension and the carriage's place.
void expect_same(const EquilibriumResult& r, const LoopState& s, bool two, double relative) {
  const auto last = r.branches.size() - 1;
  const BranchResult &upper_A = r.branches[last], &upper_B = r.branches[last - 1], &lower_B = r.branches[two ? 2 : 1];
  EXPECT_NEAR(r.branches[0].T_from / s.lower_A.T_start, 1, relative);
  EXPECT_NEAR(r.branches[0].T_to / s.lower_A.T_end, 1, relative);
  EXPECT_NEAR(lower_B.T_from / s.lower_B.T_start, 1, relative);
  EXPECT_NEAR(lower_B.T_to / s.lower_B.T_end, 1, relative);
  EXPECT_NEAR(upper_B.T_from / s.upper_B.T_end, 1, relative);
  EXPECT_NEAR(upper_A.T_to / s.upper_A.T_start, 1, relative);
  EXPECT_NEAR(r.state.bodies[0].position.x(), s.first.x, relative * 200);
  EXPECT_NEAR(r.state.bodies[0].position.z(), s.first.z, relative * 200);
  const ContactResult& roller = r.contacts.back();
  EXPECT_NEAR(roller.force.norm() / s.roller_force(), 1, 20 * relative);
}

RunningLoop base_loop() {
  RunningLoop loop;
  constexpr double kgf = 9.80665;
  loop.span = 200;
  loop.return_rope.weight = 1 * kgf;
  loop.traction_rope.weight = 1.5 * kgf;
  loop.efficiency = 0.9;
  loop.pull_x = 3000 * kgf * std::sin(M_PI / 6);
  loop.pull_z = -3000 * kgf * std::cos(M_PI / 6);
  return loop;
}

TEST(ClosedLoop, TheMachineHasTheTensionsOfTheLoop) {
  for (const double rise : {0.0, 60.0, -45.0}) {
    for (const double x : {60.0, 100.0, 150.0}) {
      for (const double EA : {HUGE_VAL, 1.2e7}) {
        RunningLoop loop = base_loop();
        loop.rise = rise;
        loop.carriage_weight = 3000;
        loop.return_rope.stiffness = loop.traction_rope.stiffness = EA;
        LoopState s;
        ASSERT_TRUE(solve_loop(loop, {x, 10}, s).ok());
        expect_same(in_haul(loop_machine(loop, s)), s, false, std::isinf(EA) ? 1e-7 : 1e-9);
      }
    }
  }
}

TEST(ClosedLoop, ThePublishedExampleByPlaceAlone) {
  // spec, section 6: exact P_b 1166.17, T_uB 6370.0, T_lB 7077.8, T_lA 8587.9 kgf, +-0.05 %
  const RunningLoop loop = base_loop();
  LoopState s;
  ASSERT_TRUE(solve_loop(loop, {100, 10}, s).ok());
  machine::Model m = loop_machine(loop, s);
  m.reevings[0].value = 101;  // neither length is known: x and z are
  m.reevings[1].value = 303;
  machine::Prescribed at{.carriage = 0, .x = 100};
  at.z = -10;
  const EquilibriumResult r = in_haul(m, at);
  EXPECT_NEAR(r.branches[0].T_from / g, 8587.9, 0.0005 * 8587.9);
  EXPECT_NEAR(r.branches[1].T_to / g, 7077.8, 0.0005 * 7077.8);
  EXPECT_NEAR(r.branches[2].T_from / g, 6370.0, 0.0005 * 6370);
  EXPECT_NEAR(r.contacts.back().force.z() / g, 1166.17, 0.0005 * 1166.17);
  EXPECT_NEAR(r.ropes[0].unstretched + r.ropes[1].unstretched, s.loop_length(), 1e-6);
}

TEST(ClosedLoop, ALinkBetweenTheBranches) {
  for (const bool vertical : {false, true}) {
    RunningLoop loop = base_loop();
    loop.rise = 50;
    loop.branch_distance = 1.5;
    loop.offset_is_vertical = vertical;
    loop.return_rope.stiffness = loop.traction_rope.stiffness = 2e7;
    LoopState s;
    ASSERT_TRUE(solve_loop(loop, {80, 10}, s).ok());
    const EquilibriumResult r = in_haul(loop_machine(loop, s));
    // the rope between the two sheaves at B weighs 15 N, which the loop leaves out
    expect_same(r, s, false, 5e-4);
    const Vector3 link = r.state.bodies[0].orientation.col(2);
    EXPECT_NEAR(std::atan2(-link.x(), link.z()), s.lean, 1e-4);
  }
}

TEST(ClosedLoop, TwoSections) {
  // spec, section 6: exact P_b 1134.84 kgf, df 0.980 m at x_1 = 100 m, f_1 = 10 m
  RunningLoop loop = base_loop();
  loop.second = SecondSection{.distance = 3};
  // three metres without any stretch would not tell their tension
  loop.return_rope.stiffness = loop.traction_rope.stiffness = 1e9;
  LoopState s;
  ASSERT_TRUE(solve_loop(loop, {100, 10}, s).ok());
  const EquilibriumResult r = in_haul(loop_machine(loop, s));
  expect_same(r, s, true, 1e-6);
  EXPECT_NEAR(r.contacts.back().force.z() / g, 1134.84, 0.0005 * 1134.84);
  const Vector3 &first = r.state.bodies[0].position, &second = r.state.bodies[1].position;
  const double line = first.z() + (second.x() - first.x()) / (200 - first.x()) * (0 - first.z());
  EXPECT_NEAR(line - second.z(), 0.980, 0.0005);
  EXPECT_NEAR(second.x() - first.x(), 3, 1e-5);
}

/// One endless rope instead of two, fixed to the carriage on its lower branch and carrying it on the upper one.
TEST(ClosedLoop, AnEndlessRopeThatPassesTwice) {
  for (const double rise : {0.0, 40.0, -40.0}) {
    RunningLoop loop = base_loop();
    loop.rise = rise;
    loop.traction_rope = loop.return_rope = {.weight = 12, .stiffness = 1.5e7};
    LoopState s;
    ASSERT_TRUE(solve_loop(loop, {120, 12}, s).ok());
    machine::Model m = loop_machine(loop, s);
    machine::Node drive = over("A", origin), grip = anchor_on("car", 0), roller = m.reevings[1].nodes[2];
    drive.kind = machine::NodeKind::drive;
    grip.kind = machine::NodeKind::clamp;
    grip.length_before = 100;
    m.reevings = {reeve("loop", {drive, grip, m.reevings[1].nodes[1], roller}, s.loop_length(), 12, 1.5e7)};
    m.reevings[0].closed = true;
    m.reevings[0].haul = -1;
    m.carriages = {{.name = "car",
                    .body = 0,
                    .reeving = 0,
                    .node = 3,
                    .mainline = {},
                    .rollers = 1,
                    .grip = machine::Grip{.reeving = 0, .node = 1}}};
    EquilibriumOptions options;
    options.motion = Motion::in;  // against the path: the lower branch runs to A
    options.prescribed = machine::Prescribed{.carriage = 0, .x = 120};
    const EquilibriumResult r = equilibrium(m, options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    ASSERT_EQ(r.branches.size(), 4U);
    EXPECT_NEAR(r.branches[0].T_from / s.lower_A.T_start, 1, 1e-8);
    EXPECT_NEAR(r.branches[1].T_to / s.lower_B.T_end, 1, 1e-8);
    EXPECT_NEAR(r.branches[2].T_from / s.upper_B.T_end, 1, 1e-8);
    EXPECT_NEAR(r.branches[3].T_to / s.upper_A.T_start, 1, 1e-8);
    EXPECT_NEAR(r.state.bodies[0].position.z(), s.first.z, 1e-6);
    EXPECT_NEAR(r.branches[0].unstretched, s.traction_length, 1e-6);
  }
}

TEST(ClosedLoop, TheGridOfSlopesAndSags) {
  // the cases of the spec's table of accuracy, section 10
  int cases = 0;
  for (const double alpha : {-30.0, -10.0, 0.0, 10.0, 30.0}) {
    for (const double f : {0.02, 0.05, 0.10, 0.15}) {
      for (const double gamma : {10.0, 30.0, 50.0}) {
        RunningLoop loop = base_loop();
        loop.rise = 200 * std::tan(alpha * M_PI / 180);
        loop.pull_x = 3000 * g * std::sin(gamma * M_PI / 180);
        loop.pull_z = -3000 * g * std::cos(gamma * M_PI / 180);
        LoopState s;
        if (!solve_loop(loop, {.x = 100, .sag = 200 * f}, s).ok()) continue;
        ++cases;
        expect_same(in_haul(loop_machine(loop, s)), s, false, 1e-6);
      }
    }
  }
  EXPECT_GT(cases, 45);
}

}  // namespace loop_machine_test
