#include "taut/study/put_up.hpp"

#include <gtest/gtest.h>

#include "test/support/machines.hpp"

namespace put_up_test {

namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;

/// A mass that can move in x and z, on two ropes; both are to be put up.
machine::Model two_lines(double left, double right) {
  machine::Model m;
  m.bodies.push_back(body("knot", {50, 0, 15}, 200, "xz"));
  m.reevings.push_back(reeve("left", {anchor("a", {0, 0, 20}), anchor_on("knot", 0)}, 0, 12, 8e6));
  m.reevings.push_back(reeve("right", {anchor_on("knot", 0), anchor("b", {110, 0, 24})}, 0, 9, 6e6));
  m.reevings.push_back(reeve("stay", {anchor("c", {40, 0, 40}), anchor_on("knot", 0)}, 26, 10, 9e6));
  m.reevings[0].put_up = machine::PutUp{.tension = left, .at_end = false, .bodies = {0}, .loads = {}};
  m.reevings[1].put_up = machine::PutUp{.tension = right, .at_end = true, .bodies = {0}, .loads = {}};
  return m;
}

TEST(PutUp, ASpanHasItsTensionAndKeepsItsLength) {
  for (const bool at_end : {false, true}) {
    machine::Model m;
    m.reevings.push_back(reeve("line", {anchor("a", {0, 0, 10}), anchor("b", {120, 0, 25})}, 0, 15, 9e6));
    m.reevings[0].put_up = machine::PutUp{.tension = 30e3, .at_end = at_end, .bodies = {}, .loads = {}};
    const std::vector<PutUpLine> lines = put_up(m);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_TRUE(lines[0].at.outcome.ok()) << lines[0].at.outcome.message;
    EXPECT_EQ(lines[0].at_end, at_end);
    EXPECT_EQ(m.reevings[0].given, machine::Given::length);
    EXPECT_EQ(m.reevings[0].value, lines[0].at.unstretched);
    const solve::EquilibriumResult r = solve::equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR((at_end ? r.branches[0].T_to : r.branches[0].T_from) / 30e3, 1, 1e-9);
  }
}

TEST(PutUp, InTurnEachWithoutThoseToCome) {
  machine::Model m = two_lines(20e3, 25e3);
  const std::vector<PutUpLine> lines = put_up(m);
  ASSERT_EQ(lines.size(), 2U);
  for (const PutUpLine& one : lines) ASSERT_TRUE(one.at.outcome.ok()) << one.at.outcome.message;
  // after the first one: the machine without the second
  machine::Model first = m;
  first.reevings.erase(first.reevings.begin() + 1);
  const solve::EquilibriumResult before = solve::equilibrium(first);
  ASSERT_TRUE(before.outcome.ok()) << before.outcome.message;
  EXPECT_NEAR(before.branches[0].T_from / 20e3, 1, 1e-8);
  // with both: the second has its tension, the first one has changed
  const solve::EquilibriumResult after = solve::equilibrium(m);
  ASSERT_TRUE(after.outcome.ok()) << after.outcome.message;
  EXPECT_NEAR(after.branches[1].T_to / 25e3, 1, 1e-8);
  EXPECT_GT(after.branches[0].T_from, 1.05 * 20e3);
}

TEST(PutUp, EndsWithTheFirstThatFails) {
  machine::Model m = two_lines(20e3, 25e3);
  m.reevings[0].put_up->tension = 1;  // less than the rope weighs
  const std::vector<PutUpLine> lines = put_up(m);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].at.outcome.ok());
  EXPECT_NE(lines[0].at.outcome.message.find("'left' can't be put up with 0.001 kN at its start"), std::string::npos)
      << lines[0].at.outcome.message;
}

/// A mass on ropes side by side, one above the other's mirror image; the first has a length, the others its tension.
machine::Model side_by_side(double mass, const char* ways, const std::vector<double>& EA, double weight) {
  machine::Model m;
  m.bodies.push_back(body("cage", {0, 0, 0}, mass, ways));
  for (std::size_t i = 0; i < EA.size(); ++i) {
    const double x = 0.4 * static_cast<double>(i), high = 20 + static_cast<double>(i);
    m.reevings.push_back(
        reeve("rope", {anchor("head", {x, 0, high}), anchor_on("cage", 0, {x, 0, 0})}, high - 0.01, weight, EA[i]));
    if (i == 0) continue;
    m.reevings[i].given = machine::Given::equal;
    m.reevings[i].equal_to = 0;
  }
  return m;
}

TEST(DrawEqual, RopesWithoutWeightShareTheLoad) {
  machine::Model m = side_by_side(1000, "z", {4e6, 1e6, 9e6}, 0);
  const taut::Outcome drawn = draw_equal(m);
  ASSERT_TRUE(drawn.ok()) << drawn.message;
  const double T = 1000 * m.gravity / 3, z = 20 - 19.99 * (1 + T / 4e6);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(m.reevings[i].given, machine::Given::length);
    const double high = 20 + static_cast<double>(i);
    EXPECT_NEAR(m.reevings[i].value, (high - z) / (1 + T / m.reevings[i].stiffness), 1e-9);
  }
}

TEST(DrawEqual, TheLengthsFoundHaveTheSameTensionAtTheirStarts) {
  for (const char* ways : {"z", "xz"}) {
    machine::Model m = side_by_side(700, ways, {4e6, 1e6, 2e6}, 30);
    m.loads.push_back({{.body = 0, .at = {0.4, 0, 0}}, {50, 0, -2000}});
    const taut::Outcome drawn = draw_equal(m);
    ASSERT_TRUE(drawn.ok()) << drawn.message;
    const solve::EquilibriumResult r = solve::equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.branches[1].T_from / r.branches[0].T_from, 1, 1e-9) << ways;
    EXPECT_NEAR(r.branches[2].T_from / r.branches[0].T_from, 1, 1e-9) << ways;
    EXPECT_GT(r.branches[2].T_from, 2000);
  }
}

/// A vertical rope has its tension as a loop of a kilometre too, whose weight makes it; that is not what is drawn.
TEST(DrawEqual, AVerticalRopeIsDrawnTaut) {
  machine::Model m;
  const double T = 5e3, EA = 10e6, w = 9.81;
  m.bodies.push_back(body("bar", {0, 0, 0}, 1000, "z"));
  m.reevings.push_back(reeve("a", {anchor("A", {-5, 0, 10}), anchor_on("bar", 0)}, 0, w, EA));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = T;
  m.reevings.push_back(reeve("b", {anchor("B", {0, 0, 12}), anchor_on("bar", 0)}, 0, w, EA));
  m.reevings[1].given = machine::Given::equal;
  m.reevings[1].equal_to = 0;
  m.reevings.push_back(reeve("c", {anchor("C", {5, 0, 9}), anchor_on("bar", 0)}, 10.3, w, EA));
  const taut::Outcome drawn = draw_equal(m);
  ASSERT_TRUE(drawn.ok()) << drawn.message;
  const solve::EquilibriumResult r = solve::equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches[1].T_from / T, 1, 1e-8);
  // l = L + (T L - w L^2/2)/EA
  const double l = 12 - r.state.bodies[0].position.z(), L = m.reevings[1].value;
  EXPECT_LT(L, l);
  EXPECT_NEAR(L + (T * L - w * L * L / 2) / EA, l, 1e-8);
}

TEST(DrawEqual, ASlackRopeHasNoTensionToEqual) {
  machine::Model m = side_by_side(1000, "z", {4e6, 1e6, 1e6}, 0);
  m.reevings[0].value = 25;                      // it hangs down
  m.reevings[2].given = machine::Given::length;  // the third carries the cage alone
  const taut::Outcome drawn = draw_equal(m);
  EXPECT_FALSE(drawn.ok());
  EXPECT_NE(drawn.message.find("equal tensions"), std::string::npos) << drawn.message;
  EXPECT_EQ(m.reevings[1].given, machine::Given::equal) << "nothing is taken over";
}

TEST(DrawEqual, ALineIsPutUpWithoutTheRopesThatAreDrawnLater) {
  machine::Model m = two_lines(20e3, 25e3);
  m.reevings.push_back(reeve("second stay", {anchor("d", {60, 0, 40}), anchor_on("knot", 0)}, 0, 10, 9e6));
  m.reevings[3].given = machine::Given::equal;
  m.reevings[3].equal_to = 2;
  machine::Model without = two_lines(20e3, 25e3);
  std::vector<PutUpLine> lines, alone;
  const taut::Outcome drawn = put_up_lines(m, lines);
  ASSERT_TRUE(drawn.ok()) << drawn.message;
  ASSERT_TRUE(put_up_lines(without, alone).ok());
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(lines[i].at.unstretched, alone[i].at.unstretched, 1e-9);
  const solve::EquilibriumResult r = solve::equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches[3].T_from / r.branches[2].T_from, 1, 1e-8);
}

/// A pole of 12 m on a joint at the origin without weight, a guy at its head to each of these x on the ground, put up
/// with tensions, N.
machine::Model pole_on(const std::vector<std::pair<double, double>>& guys) {
  machine::Model m;
  m.bodies.push_back(body("pole", {0, 0, 0}, 0, ""));
  m.bodies[0].free = {{.along = {0, 0, 0}, .about = {0, 1, 0}}};
  for (const auto& [x, T] : guys) {
    machine::Node head = anchor_on("pole", 0);
    head.at.at = {0, 0, 12};
    m.reevings.push_back(reeve("guy", {head, anchor("stump", {x, 0, 0})}, T, 0, 8e6));
    m.reevings.back().given = machine::Given::tension_at_start;
    m.reevings.back().is_to_install = true;
  }
  return m;
}

// Two guys of stiffness k on one side with T1 each, one on the other side with T2, all at 45 deg: the head moves until
// 2 (T1 - k e) = T2 + k e with e by which a guy shortens: e = (2 T1 - T2)/(3 k).
TEST(StandOnGuys, OfABalanceThatIsNotTheOnePutUp) {
  machine::Model m = pole_on({{-12, 14.5e3}, {-12, 14.5e3}, {12, 14.5e3}});
  ASSERT_TRUE(install_guys(m).ok());
  const auto stand = stand_on_guys(m, 0);
  ASSERT_TRUE(stand);
  const auto& at = stand->state.branches;
  EXPECT_NEAR(at[0].T_from, (14.5e3 + 14.5e3) / 3, 20);  // of the second order: the guys turn
  EXPECT_NEAR(at[2].T_from, 2 * 14.5e3 * 2 / 3, 20);
  machine::Model balanced = pole_on({{-12, 10e3}, {-12, 10e3}, {12, 20e3}});
  ASSERT_TRUE(install_guys(balanced).ok());
  const auto still = stand_on_guys(balanced, 0);
  ASSERT_TRUE(still);
  EXPECT_NEAR(still->state.branches[2].T_from, 20e3, 0.1);
}

// The ropes beside the guys, what hangs on them and the loads are not there.
TEST(StandOnGuys, WithoutTheOtherRopes) {
  const machine::Model alone = pole_on({{-12, 10e3}, {12, 10e3}});
  machine::Model m = alone;
  machine::Node head = anchor_on("pole", 0);
  head.at.at = {0, 0, 12};
  m.bodies.push_back(body("hook", {20, 0, 2}, 500, "xz"));
  m.reevings.insert(m.reevings.begin(), reeve("line", {head, anchor_on("hook", 1)}, 25, 10, 8e6));
  m.loads.push_back({.at = {0, {0, 0, 12}}, .force = {8e3, 0, 0}});
  ASSERT_TRUE(install_guys(m).ok());
  const auto stand = stand_on_guys(m, 1);
  ASSERT_TRUE(stand);
  ASSERT_EQ(stand->model.reevings.size(), 2U);
  for (const auto& one : stand->state.branches) EXPECT_NEAR(one.T_from, 10e3, 0.1);
}

// Guys on one side balance the lines, not each other; the clamped pole would only bend to them.
TEST(StandOnGuys, NotWithGuysOnOneSide) {
  machine::Model m = pole_on({{-12, 10e3}, {-11, 10e3}});
  ASSERT_TRUE(install_guys(m).ok());
  EXPECT_FALSE(has_guys_around(m, 0, 0));
  EXPECT_FALSE(stand_on_guys(m, 0));
  machine::Model around = pole_on({{-12, 10e3}, {12, 10e3}});
  EXPECT_TRUE(has_guys_around(around, 0, 1));
  around.bodies[0].free.clear();  // nor do those of what stands fast
  EXPECT_FALSE(has_guys_around(around, 0, 1));
}

// Two weak guys against a heavy pole that leans: they are slack, and it lies down.
TEST(StandOnGuys, NotWhereTheyDoNotHoldIt) {
  machine::Model m = pole_on({{-12, 10}, {12, 10}});
  m.bodies[0].mass = 5e4;
  m.bodies[0].centre = {4, 0, 6};
  for (auto& rope : m.reevings) rope.stiffness = 1e4;
  ASSERT_TRUE(install_guys(m).ok());
  const auto stand = stand_on_guys(m, 0);
  ASSERT_TRUE(stand);
  EXPECT_EQ(stand->state.outcome.message, "its guys do not hold it, it falls over");
}

}  // namespace put_up_test
