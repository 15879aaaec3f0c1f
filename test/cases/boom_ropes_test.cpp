// Published numbers of Reutov (2021), static part, and of the quasi-static reference model.
#include "taut/methods/boom_ropes/boom_ropes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/methods/boom_ropes/slip.hpp"
#include "test/support/solved.hpp"

namespace boom_ropes_test {

using namespace taut::boom_ropes;

constexpr double degree = std::numbers::pi / 180;
constexpr double tonne = 9.81e3;

TEST(BoomRopesPaper, ForcesOfTheCases) {
  const Output out = taut_test::solved_as<Output>(whole_boom());
  ASSERT_EQ(out.F.size(), 4u);
  EXPECT_NEAR(out.F[0], -274.06e3, 5);
  EXPECT_NEAR(out.F[1], -326.17e3, 5);
  EXPECT_NEAR(out.F[2], -2.587e3, 0.5);
  EXPECT_NEAR(out.F[3], 0.243e3, 0.5);
  // As printed, to the printed digits; the static test is printed -326.1 for -326.17.
  EXPECT_NEAR(out.F[0], -274.1e3, 50);
  EXPECT_NEAR(out.F[1], -326.1e3, 100);
  EXPECT_NEAR(out.F[2], -2.59e3, 5);
  EXPECT_NEAR(out.F[3], 0.24e3, 5);
}

TEST(BoomRopesPaper, ForceAfterTensioning) {
  const Output out = taut_test::solved_as<Output>(whole_boom());
  EXPECT_NEAR(out.F0_extension, -1.266e3, 0.5);
  EXPECT_NEAR(out.F0_retraction, 1.266e3, 0.5);
  EXPECT_NEAR(out.F0_retraction, 1.27e3, 5);
}

TEST(BoomRopesPaper, SharesOfTheRopes) {
  const Output out = taut_test::solved_as<Output>(whole_boom());
  EXPECT_NEAR(out.lambda_1, 0.3858, 0.00005);
  EXPECT_NEAR(out.lambda_2, 0.2284, 0.00005);
  EXPECT_NEAR(2 * out.lambda_1 + out.lambda_2, 1, 1e-15);
}

TEST(BoomRopesPaper, LeastPretensions) {
  const Output out = taut_test::solved_as<Output>(whole_boom());
  EXPECT_NEAR(out.S10_min, 0.582e3, 0.5);
  EXPECT_NEAR(out.S10_min, 0.58e3, 5);
  EXPECT_NEAR(out.S20_min, 74.8e3, 50);
  EXPECT_NEAR((1.27e3 + 326.1e3) * 0.229, 74.97e3, 5);  // the paper's rounded lambda_2 and F0
  EXPECT_EQ(out.highest_case, 3u);
  EXPECT_EQ(out.lowest_case, 1u);
}

TEST(BoomRopesPaper, BalancingPretension) {
  const Output out = taut_test::solved_as<Output>(whole_boom());
  EXPECT_NEAR(out.S10_balance, (out.S20_min + 1.266e3) / 2, 0.5);
  EXPECT_NEAR((75e3 + 1.27e3) / 2, 38.1e3, 50);
  EXPECT_NEAR(out.S10_balance, 38.1e3, 100);  // from 74.8 instead of 75 kN
  EXPECT_NEAR(95.5 / 38.1, 2.51, 0.005);
  EXPECT_NEAR(181.0 / 75, 2.41, 0.005);
}

TEST(BoomRopesPaper, TensioningInTurn) {
  // Table 1: F0 rounded to 1.27 kN; S10/S20 extension first, retraction first.
  const double printed[4][4] = {
      {0.635, 0, 0, 1.27}, {0.635, 2.54, 1.27, 1.27}, {1.905, 2.54, 1.27, 3.81}, {1.905, 5.08, 2.54, 3.81}};
  const auto rows = tensioning(1.27e3, 4);
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(rows[i].S10_extension_first, printed[i][0] * 1e3, 1e-9);
    EXPECT_NEAR(rows[i].S20_extension_first, printed[i][1] * 1e3, 1e-9);
    EXPECT_NEAR(rows[i].S10_retraction_first, printed[i][2] * 1e3, 1e-9);
    EXPECT_NEAR(rows[i].S20_retraction_first, printed[i][3] * 1e3, 1e-9);
  }
}

TEST(BoomRopesPaper, SlipAngleWithoutJamming) {
  EXPECT_NEAR(free_slip_angle(8.44e3, 0.3 * tonne, 0.155, 0.95, 6) / degree, 6.49, 0.005);
  EXPECT_NEAR(free_slip_angle(8.44e3, 3.3 * tonne, 0.155, 0.95, 6) / degree, 1.68, 0.005);
  const Output out = taut_test::solved_as<Output>(whole_boom());  // 2.94 and 32.4 kN
  EXPECT_NEAR(out.beta1_light / degree, 6.49, 0.01);
  EXPECT_NEAR(out.beta1_heavy / degree, 1.68, 0.01);
}

}  // namespace boom_ropes_test
