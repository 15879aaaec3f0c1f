#include "taut/results/motion/straight_ropes.hpp"

#include <gtest/gtest.h>

namespace taut::results::straight_ropes_test {

/// Ropes with these tensions where the motion begins, and with their sag; breaking force 100 kN.
std::vector<SaggingRope> found(const std::vector<double>& begins, const std::vector<double>& sagging,
                               const std::vector<double>& peaks = {}) {
  machine::Model m;
  solve::TransientFrame begin, hangs;
  for (std::size_t i = 0; i < begins.size(); ++i) {
    machine::Reeving rope;
    rope.name = std::string(1, static_cast<char>('a' + i));
    rope.breaking_force = 1e5;
    m.reevings.push_back(rope);
    solve::TransientFrame::Branch moves;
    moves.reeving = static_cast<int>(i);
    moves.T_from = begins[i];
    begin.branches.push_back(moves);
    moves.T_from = 0;
    moves.T_to = sagging[i];
    hangs.branches.push_back(moves);
  }
  return ropes_that_sag(m, begin, hangs, peaks);
}

TEST(StraightRopes, AreNamedWhereTheirSagPullsHarder) {
  const auto some = found({5e3, 20e3, 30e3}, {36e3, 20.9e3, 10e3});
  ASSERT_EQ(some.size(), 1U);
  EXPECT_EQ(some[0].name, "a");
  EXPECT_EQ(sag_words("modes", some[0]),
            "modes: 'a' begins straight with 5 kN; with its sag it has 36 kN: use 'branches: catenary'");
}

TEST(StraightRopes, DoNotCountWhereTheMotionPullsHarderByFarOrTheyHangSlack) {
  EXPECT_TRUE(found({5e3}, {7e3}, {50e3}).empty());
  EXPECT_EQ(found({5e3}, {7e3}, {30e3}).size(), 1U);
  EXPECT_TRUE(found({0}, {900}).empty()) << "a hundredth of its breaking force";
  EXPECT_TRUE(found({0, 300e3}, {2e3, 300e3}).empty()) << "a hundredth of the largest tension of the machine";
}

}  // namespace taut::results::straight_ropes_test
