#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/solve/drives.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Moments between output steps, and what lies on drums in them.
namespace taut_test::frame_test {
namespace {

using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

/// A load of 500 kg that falls 0.3 m into its rope, and is thrown up again.
taut::machine::Model falling() {
  taut::machine::Model m;
  m.bodies.push_back(body("load", {0, 0, -8}, 500, "z"));
  m.reevings.push_back(reeve("rope", {anchor("top", {0, 0, 0}), anchor_on("load", 0)}, 8.3, 0, 12e6));
  return m;
}

double tension(const TransientFrame& frame) { return frame.branches[0].T_from; }

TEST(TransientMoments, APeakIsShownHoweverFewOutputsThereAre) {
  TransientOptions options = lasting(2, 1e-5);
  double shown = 0, last = 0;
  options.moment = [&](const TransientResult& so_far, const TransientFrame& moment) {
    EXPECT_GE(moment.t, last);
    EXPECT_GE(moment.t, so_far.frames.back().t);
    last = moment.t;
    shown = std::max(shown, tension(moment));
  };
  options.moment_step = 1;
  const TransientResult r = run_to_end(falling(), options);
  EXPECT_DOUBLE_EQ(shown, r.ropes[0].T.max);
  EXPECT_GT(shown, 10 * 500 * 9.81);
  EXPECT_EQ(r.frames.size(), 2U) << "an output step has nothing to do with it";
}

/// Two loads fall into their ropes one after the other.
TEST(TransientMoments, NoForceChangesMuchUnseenForWhoLooksClosely) {
  taut::machine::Model m = falling();
  m.bodies.push_back(body("late", {0, 0, -7.9}, 500, "z"));
  m.reevings.push_back(reeve("other", {anchor("top", {0, 0, 0}), anchor_on("late", 1)}, 8.3, 0, 12e6));
  const auto largest_sum = [&](bool all, bool closely, long& moments) {
    TransientOptions options = lasting(2, 1e-5);
    double most = 0;
    options.moment = [&](const TransientResult&, const TransientFrame& moment) {
      most = std::max(most, moment.branches[0].T_from + moment.branches[1].T_from);
      ++moments;
    };
    options.moment_step = all ? 0 : 1;
    options.closely = closely;
    const TransientResult r = run_to_end(m, options);
    EXPECT_LE(moments, r.steps);
    return most;
  };
  long all = 0, few = 0, close = 0;
  const double most = largest_sum(true, false, all);
  EXPECT_LT(largest_sum(false, false, few), 0.98 * most) << "it would not need to be looked for";
  EXPECT_NEAR(largest_sum(false, true, close), most, 2e-3 * most);
  EXPECT_LT(few, 20);
  EXPECT_LT(close, all);
}

TEST(TransientMoments, TheyDoNotChangeTheMotion) {
  TransientOptions options = lasting(1, 1e-4, 4);
  const TransientResult alone = run_to_end(falling(), options);
  options.moment = [](const TransientResult&, const TransientFrame&) {};
  const TransientResult watched = run_to_end(falling(), options);
  EXPECT_EQ(watched.steps, alone.steps);
  EXPECT_EQ(watched.frames.back().bodies[0].position, alone.frames.back().bodies[0].position);
}

/// Where no rope has a peak, moments are a given time apart, or a step.
TEST(TransientMoments, WithoutPeaksTheyAreATimeApart) {
  taut::machine::Model m = falling();
  m.reevings[0].value = 7.99;
  TransientOptions options = lasting(1, 1e-4);
  options.start = taut::solve::Start::settled;
  options.step = 0.01;
  options.moment_step = 0.1;
  std::vector<double> times;
  options.moment = [&](const TransientResult&, const TransientFrame& moment) { times.push_back(moment.t); };
  run_to_end(m, options);
  ASSERT_GE(times.size(), 8U);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LE(times[i] - times[i - 1], 0.11 + 1e-9);
}

/// A drum of 0.3 m radius that turns once a second from 5 m of rope.
TEST(TransientMoments, ADrumHasWhatItHasTakenIn) {
  taut::machine::Model m = falling();
  auto drum = add_drum(m, "drum", {0, 0, 0}, 0.3);
  m.drums[0].length_on_drum = 5;
  m.drums[0].width = 0.2;
  m.drums[0].flange_diameter = 0.8;
  m.drums[0].drive.kind = taut::machine::DriveKind::speed;
  m.drums[0].drive.signal = smooth_move(0, 1, 0, 0.5);
  m.reevings[0] = reeve("rope", {drum, anchor_on("load", 0)}, 7.9, 0, 12e6);
  m.reevings[0].diameter = 0.02;
  TransientOptions options = lasting(2, 1e-4, 8);
  options.start = taut::solve::Start::settled;
  const TransientResult r = run_to_end(m, options);
  for (const TransientFrame& frame : r.frames) {
    const auto drums = taut::solve::drums(m, frame);
    ASSERT_EQ(drums.size(), 1U);
    ASSERT_TRUE(drums[0].length);
    EXPECT_FALSE(drums[0].at_end);
    EXPECT_NEAR(*drums[0].length + frame.branches[0].unstretched, 5 + r.frames.front().branches[0].unstretched, 0.02);
    EXPECT_EQ(drums[0].pull, tension(frame));
    EXPECT_EQ(drums[0].layer, frame.on_drums[0].layer);
    EXPECT_GT(drums[0].capacity.value(), 20);
  }
  EXPECT_GT(*taut::solve::drums(m, r.frames.back())[0].length, 6.5);
  m.drums[0].length_on_drum.reset();
  EXPECT_FALSE(taut::solve::drums(m, r.frames.back())[0].length);
}

}  // namespace
}  // namespace taut_test::frame_test
