#include "taut/checks/check_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

namespace taut::checks::check_state_test {

using taut_test::anchor;
using taut_test::anchor_on;

/// Two slanting ropes that hold a load between them; the second in segments.
machine::Model hanging(int segments) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("load", {10, 0, -6}, 400, "xz"));
  m.reevings.push_back(taut_test::reeve("left", {anchor("a", {0, 0, 0}), anchor_on("load", 0)}, 11.6, 30, 2e6));
  m.reevings.push_back(taut_test::reeve("right", {anchor_on("load", 0), anchor("b", {25, 0, 3})}, 17.4, 30, 2e6));
  m.reevings[1].segments = segments;
  return m;
}

solve::TransientResult a_moment(const machine::Model& m) {
  solve::TransientOptions o;
  o.duration = 0.01;
  o.output_step = 0.01;
  return solve::transient(m, o);
}

/// What hangs on both ends of each rope is its weight, in a motion as at rest.
void expect_weights(const CheckState& s, const machine::Model& m) {
  ASSERT_EQ(s.branches.size(), 2U);
  for (const CheckBranch& b : s.branches) {
    const double weight = m.reevings[static_cast<std::size_t>(b.reeving)].weight * b.unstretched;
    const Vector3 both = b.on_start + b.on_end;
    EXPECT_NEAR(both.z(), -weight, 0.01 * weight);
    EXPECT_NEAR(both.x(), 0, 0.01 * weight);
    EXPECT_NEAR(b.on_start.norm(), b.T, 1.1 * weight);
  }
}

TEST(CheckState, pulls_at_rest_and_in_motion) {
  const machine::Model m = hanging(1);
  const auto rest = solve::equilibrium(m);
  ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
  const CheckState at_rest = state_of(m, rest, "at rest", "equilibrium");
  expect_weights(at_rest, m);
  EXPECT_FALSE(at_rest.moves);
  const auto motion = a_moment(m);
  ASSERT_FALSE(motion.frames.empty()) << motion.outcome.message;
  const CheckState moving = state_of(m, motion, motion.frames.front(), "t", "drop");
  expect_weights(moving, m);
  EXPECT_TRUE(moving.moves);
  for (std::size_t i = 0; i < 2; ++i) {  // it begins settled
    EXPECT_LT((moving.branches[i].on_start - at_rest.branches[i].on_start).norm(), 0.02 * at_rest.branches[i].T);
    EXPECT_LT((moving.branches[i].on_end - at_rest.branches[i].on_end).norm(), 0.02 * at_rest.branches[i].T);
  }
}

TEST(CheckState, segments_are_one_branch) {
  const machine::Model m = hanging(6);
  const auto motion = a_moment(m);
  ASSERT_FALSE(motion.frames.empty()) << motion.outcome.message;
  const CheckState s = state_of(m, motion, motion.frames.front(), "t", "drop");
  ASSERT_EQ(s.branches.size(), 2U);
  EXPECT_NEAR(s.branches[1].unstretched, 17.4, 1e-9);
  EXPECT_LT((s.branches[1].end - Vector3(25, 0, 3)).norm(), 1e-12);
  EXPECT_GT(s.branches[1].chord, 17);
  // at its upper end it pulls steeper than its chord
  const Vector3 chord = s.branches[1].end - s.branches[1].start;
  const Vector3& pull = s.branches[1].on_end;
  EXPECT_GT(std::abs(pull.z() / pull.x()), std::abs(chord.z() / chord.x()));
}

/// A straight branch with its weight at its ends hangs as a parabola; one in segments goes through its joints.
TEST(CheckState, free_ropes_hang) {
  const machine::Model m = hanging(6);
  const auto motion = a_moment(m);
  ASSERT_FALSE(motion.frames.empty()) << motion.outcome.message;
  const auto& moment = motion.frames.front();
  const auto ropes = free_ropes(m, motion, moment);
  ASSERT_EQ(ropes.size(), 2U);
  EXPECT_EQ(ropes[1].places.size(), 7U);
  EXPECT_EQ(ropes[1].to, 1);
  const auto& places = ropes[0].places;
  ASSERT_EQ(places.size(), 17U);
  const auto& branch = moment.branches[0];
  EXPECT_EQ(places.front(), branch.start);
  EXPECT_EQ(places.back(), branch.end);
  const Vector3 way = branch.end - branch.start;
  const double level = std::hypot(way.x(), way.y()), T = (branch.T_from + branch.T_to) / 2;
  const double sag = m.reevings[0].weight * branch.unstretched * way.norm() / (8 * T);
  EXPECT_NEAR(((branch.start + branch.end) / 2 - places[8]).z(), sag, 1e-9);
  EXPECT_NEAR(places[8].x() - branch.start.x(), level / 2, 1e-9);
  solve::TransientFrame slack = moment;
  slack.branches[0].T_from = slack.branches[0].T_to = 0;
  EXPECT_EQ(free_ropes(m, motion, slack).size(), 1U);
}

TEST(CheckState, names_of_analyses) {
  EXPECT_EQ(analysis_name("", "envelope"), "envelope");
  EXPECT_EQ(analysis_name("_2", "envelope"), "envelope");
  EXPECT_EQ(analysis_name("_work", "envelope"), "work");
  EXPECT_EQ(analysis_words("_2", "load path"), "load path 2");
  EXPECT_EQ(analysis_words("_work", "load path"), "work");
}

}  // namespace taut::checks::check_state_test
