#include "taut/results/motion/straight_ropes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

namespace taut::results::straight_ropes_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Ropes of one branch of 100 m and 10 N/m, with a breaking force of 100 kN.
machine::Model ropes(std::size_t count) {
  machine::Model m;
  for (std::size_t i = 0; i < count; ++i) {
    machine::Reeving rope;
    rope.name = std::string(1, static_cast<char>('a' + i));
    rope.breaking_force = 1e5;
    rope.weight = 10;
    m.reevings.push_back(rope);
  }
  return m;
}

solve::TransientFrame state_of(const std::vector<double>& tensions) {
  solve::TransientFrame state;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    solve::TransientFrame::Branch branch;
    branch.reeving = static_cast<int>(i);
    branch.T_from = branch.T_to = tensions[i];
    branch.unstretched = 100;
    state.branches.push_back(branch);
  }
  return state;
}

/// Ropes with these tensions where the motion begins, and with their sag.
std::vector<std::string> told(const std::vector<double>& begins, const std::vector<double>& sagging,
                              const std::vector<double>& peaks = {}) {
  return sag_warnings("modes", ropes(begins.size()), state_of(begins), Sagging{.T = sagging}, peaks);
}

TEST(StraightRopes, AreNamedWhereTheirSagPullsHarder) {
  EXPECT_THAT(told({5e3, 20e3, 30e3}, {36e3, 20.9e3, 10e3}),
              ElementsAre("modes: 'a' begins straight with 5 kN; with its sag it has 36 kN: use 'branches: catenary'"));
}

TEST(StraightRopes, DoNotCountWhereTheMotionPullsHarderByFarOrTheyHangSlack) {
  EXPECT_THAT(told({5e3}, {7e3}, {50e3}), IsEmpty());
  EXPECT_EQ(told({5e3}, {7e3}, {30e3}).size(), 1U);
  EXPECT_THAT(told({0}, {900}), IsEmpty()) << "a hundredth of its breaking force";
  EXPECT_THAT(told({0, 300e3}, {2e3, 300e3}), IsEmpty()) << "a hundredth of the largest tension of the machine";
}

// 1000 N of rope at 5 kN and at 50 kN.
TEST(StraightRopes, ThatAreHeavyAreNamedWhereNothingHangs) {
  const auto told = sag_warnings("modes", ropes(2), state_of({5e3, 50e3}), std::nullopt);
  EXPECT_THAT(told, ElementsAre(HasSubstr("'a' is straight, though a free part of it weighs 20 % of its tension")));
  machine::Model m = ropes(1);
  EXPECT_DOUBLE_EQ(heaviest_share(m, state_of({5e3}), 0), 0.2);
  EXPECT_EQ(heaviest_share(m, state_of({0}), 0), 1);
  m.reevings[0].segments = 2;
  EXPECT_EQ(heaviest_share(m, state_of({5e3}), 0), 0);
}

/// 10 kN at a rope of 40 m that hangs, and has parted by half where the motion goes on: it has no more left there
/// either.
TEST(StraightRopes, ThatAreBreakingHangByWhatIsLeftOfThem) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("load", {40, 0, 0}, 1000, "x"));
  m.reevings.push_back(
      taut_test::reeve("rope", {taut_test::anchor("left", {0, 0, 0}), taut_test::anchor_on("load", 0)}, 39.96, 5, 1e7));
  m.loads.push_back({.at = {.body = 0}, .force = {1e4, 0, 0}});
  machine::Event breaks;
  breaks.kind = machine::EventKind::breaks;
  breaks.at = 0;
  breaks.over = 0.02;
  m.events.push_back(breaks);
  solve::TransientOptions options = taut_test::lasting(0.01, 1e-5);
  options.branches = solve::Branches::catenary;
  options.from = taut_test::run_to_end(m, options).state;
  const solve::TransientFrame begins = taut_test::run_to_end(m, options).frames.front();
  ASSERT_NEAR(begins.branches[0].T_from, 5e3, 500);
  const auto hangs = hanging_start(m, options);
  ASSERT_TRUE(hangs);
  EXPECT_NEAR(hangs->branches[0].T_from, begins.branches[0].T_from, 100);
  EXPECT_THAT(sag_warnings("drop", m, begins, with_sag(m, hangs, options.start), {}), IsEmpty());
}

/// 100 m of rope with 10 N/m and 4 kN or 6 kN, before a force along it and behind it: 1000 N of rope at 4 kN.
TEST(StraightRopes, WithForcesAlongThemGoFromRoundToRound) {
  machine::Model m = ropes(1);
  m.reevings[0].nodes = {taut_test::anchor("left", {0, 0, 0}), taut_test::anchor("cut", {50, 0, 0}),
                         taut_test::anchor("right", {100, 0, 0})};
  m.reevings[0].nodes[1].kind = machine::NodeKind::load;
  ASSERT_TRUE(kept_straight(m.reevings[0]));
  solve::TransientFrame begins = state_of({4e3});
  begins.branches.push_back(begins.branches[0]);
  for (auto& branch : begins.branches) branch.unstretched = 50;
  begins.branches[0].to = begins.branches[1].from = 1;
  begins.branches[1].to = 2;
  begins.branches[1].T_from = begins.branches[1].T_to = 6e3;
  EXPECT_DOUBLE_EQ(heaviest_share(m, begins, 0), 0.25);
  EXPECT_THAT(sag_warnings("saw", m, begins, Sagging{.T = {30e3}}),
              ElementsAre("saw: 'a' begins straight with 6 kN; with its sag it has 30 kN: the force along it keeps it "
                          "straight: give it 'segments'"));
  EXPECT_THAT(sag_warnings("saw", m, begins, Sagging{.T = {6e3}, .with_loads = false}),
              ElementsAre("saw: 'a' is straight, though a free part of it weighs 25 % of its tension: the force along "
                          "it keeps it straight: give it 'segments'"));
  m.reevings[0].segments = 4;
  EXPECT_FALSE(any_kept_straight(m));
}

}  // namespace taut::results::straight_ropes_test
