#include "taut/checks/check_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/base/array.hpp"
#include "taut/rope/span.hpp"
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
  EXPECT_EQ(ropes[1].places().size(), 7U);
  EXPECT_EQ(ropes[1].to, 1);
  const auto& branch = moment.branches[0];
  EXPECT_EQ(ropes[0].places(), (Array<Vector3>{branch.start, branch.end}));
  // by its length it is the catenary of the machine at rest
  ASSERT_TRUE(ropes[0].pieces[0].shape);
  EXPECT_NEAR(ropes[0].pieces[0].shape->rope.length, branch.unstretched, 1e-9);
  // a segment by its tension: W l/(8 T)
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& segment = moment.branches[i + 1];
    const double W = m.reevings[1].weight * segment.unstretched, T = (segment.T_from + segment.T_to) / 2;
    EXPECT_NEAR(ropes[1].pieces[i].sag, W * (segment.end - segment.start).norm() / (8 * T), 1e-9) << i;
  }
  solve::TransientFrame slack = moment;
  slack.branches[0].T_from = slack.branches[0].T_to = 0;
  EXPECT_EQ(free_ropes(m, motion, slack).size(), 1U);
}

/// A straight branch hangs as deep as a rope of its length, also where it has lost nearly all of its tension: the rope
/// of the length l0 with the weight W across it has the sag W l/(8 T) where l0 (1 + T/EA) = l (1 + W^2/(24 T^2)), up to
/// the square of sag over span, here (1/50)^2.
TEST(CheckState, a_free_rope_keeps_its_length) {
  machine::Model m = hanging(6);
  const auto motion = a_moment(m);
  ASSERT_FALSE(motion.frames.empty()) << motion.outcome.message;
  solve::TransientFrame moment = motion.frames.front();
  auto& branch = moment.branches[0];
  const double EA = m.reevings[0].stiffness, W = m.reevings[0].weight * branch.unstretched;
  const double T1 = (branch.T_from + branch.T_to) / 2;
  const Vector3 way = branch.end - branch.start;
  const double across = W * std::hypot(way.x(), way.y()) / way.norm();
  const auto hung = [&](double share) {  // T, by its sag
    branch.T_from = branch.T_to = share * T1;
    const study::RopePiece piece = free_ropes(m, motion, moment)[0].pieces[0];
    return W * way.norm() / (8 * rope::largest_sag(*piece.shape));
  };
  for (const double share : {1.0, 1e-3}) {
    const double T = hung(share);
    EXPECT_NEAR(T - EA * across * across / (24 * T * T), share * T1, 2e-3 * T1);
  }
  // where the tension was given, the length follows from it: that of the straight branch is shorter than the rope
  m.reevings[0].given = machine::Given::tension_at_start;
  EXPECT_NEAR(hung(1), T1, 2e-3 * T1);
  EXPECT_LT(hung(1e-3), T1);
}

/// A wave that takes all tension from a segment does not make a bight of it: a rope through the joints turns in it by
/// no more than at both of them, and by half of that at rest, so that its sag is less than twice that at rest. Straight
/// segments without tension have none.
TEST(CheckState, a_slack_segment_turns_with_the_rope) {
  const machine::Model m = hanging(6);
  const auto motion = a_moment(m);
  ASSERT_FALSE(motion.frames.empty()) << motion.outcome.message;
  solve::TransientFrame moment = motion.frames.front();
  const double at_rest = free_ropes(m, motion, moment)[1].pieces[2].sag;
  moment.branches[3].T_from = moment.branches[3].T_to = 0;
  EXPECT_NEAR(free_ropes(m, motion, moment)[1].pieces[2].sag, 2 * at_rest, 0.05 * at_rest);
  for (std::size_t i = 1; i < moment.branches.size(); ++i) {
    auto& segment = moment.branches[i];
    segment.T_from = segment.T_to = 0;
    segment.start = Vector3(static_cast<double>(i), 0, 0);
    segment.end = Vector3(static_cast<double>(i) + 1, 0, 0);
  }
  const auto slack = free_ropes(m, motion, moment);
  ASSERT_EQ(slack.size(), 2U) << "its joints say how it lies";
  for (const study::RopePiece& piece : slack[1].pieces) EXPECT_EQ(piece.sag, 0);
}

TEST(CheckState, names_of_analyses) {
  EXPECT_EQ(analysis_name("", "envelope"), "envelope");
  EXPECT_EQ(analysis_name("_2", "envelope"), "envelope");
  EXPECT_EQ(analysis_name("_work", "envelope"), "work");
  EXPECT_EQ(analysis_words("_2", "load path"), "load path 2");
  EXPECT_EQ(analysis_words("_work", "load path"), "work");
}

TEST(CheckState, AChainageThatIsNoXIsNotCalledX) {
  machine::Model m;
  EXPECT_EQ(ground_words(m, 12, Display()), "x = 12 m");
  m.terrain_from = {-20, 0, 0};
  EXPECT_EQ(ground_words(m, 340, Display()), "chainage 340 m");
  m.terrain_from = {0, 0, 0};
  m.terrain_along = {0, 1, 0};
  EXPECT_EQ(ground_words(m, 12, Display()), "chainage 12 m");
}

}  // namespace taut::checks::check_state_test
