#include "taut/methods/closed_loop/position.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::position_test {

using namespace taut_test;

Ropes ropes_from(const Input& in) {
  Ropes ropes;
  EXPECT_TRUE(ropes_of(in, ropes).ok());
  return ropes;
}

TEST(ClosedLoopPosition, TheWorstPositionHasTheLargestEndTension) {
  Input in = example();
  in.position = {30, 90, 60, 170};
  const auto rows = sweep(in, ropes_from(in));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(worst_of(rows), 1U);
  for (const Row& row : rows) EXPECT_LE(row.out.T_end_max, rows[1].out.T_end_max);
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_EQ(out.x, 90);
  EXPECT_EQ(out.T_lA, rows[1].out.T_lA);
}

TEST(ClosedLoopPosition, InfeasiblePositionsStayInTheSweep) {
  Input in = example();
  in.slope = -25 * degree;
  in.gathering_angle = 50 * degree;
  in.position = {5, 100};
  const auto rows = sweep(in, ropes_from(in));
  EXPECT_FALSE(rows[0].outcome.ok());
  EXPECT_FALSE(rows[0].outcome.message.empty());
  EXPECT_TRUE(rows[1].outcome.ok()) << rows[1].outcome.message;
  EXPECT_EQ(worst_of(rows), 1U);
}

TEST(ClosedLoopPosition, EqualPullsAreToldApartByTheOtherEnds) {
  Input in = example();
  in.mode = Mode::winch_pull;
  in.sag.reset();
  in.winch_pull = 80e3;
  in.position = {60, 100, 160, 80};
  const auto rows = sweep(in, ropes_from(in));
  EXPECT_EQ(worst_of(rows), 2U);  // the tension at B grows toward B
}

TEST(ClosedLoopPosition, AtAGivenPullTheTailTensionGrowsTowardB) {
  Input in = example();
  Output mid;
  ASSERT_TRUE(solve(in, mid).ok());
  in.mode = Mode::winch_pull;
  in.sag.reset();
  in.winch_pull = mid.T_lA;
  double most = 0;
  for (double x = 100; x < 190; x += 2) {
    in.position = {x};
    Output o;
    ASSERT_TRUE(solve(in, o).ok()) << x;
    most = std::max(most, o.T_uB);
  }
  EXPECT_NEAR(most / mid.T_uB - 1, 0.038, 0.004);
}

TEST(ClosedLoopPosition, NamedRopesGiveTheirWeights) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = "6x36-IWRC 16 mm 1960 MPa";
  in.traction_rope = "6x36-IWRC 18 mm 1960 MPa";
  const Ropes ropes = ropes_from(in);
  EXPECT_NEAR(ropes.q_b, ropes.return_rope->mass_per_length * 9.80665, 1e-12);
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_EQ(out.q_b, ropes.q_b);
  EXPECT_EQ(out.q_T, ropes.q_T);
}

TEST(ClosedLoopPosition, NoVerticalLoadIsRefusedFirst) {
  Input in = example();
  in.slope = -30 * degree;
  in.gathering_angle = 70 * degree;
  Output out;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("no vertical load"), std::string::npos) << o.message;
  EXPECT_TRUE(std::isfinite(out.P));
  EXPECT_TRUE(std::isnan(out.T_b));
}

TEST(ClosedLoopPosition, LiftOffBoundaryAtMidspan) {
  // cot(gamma) + tan(alpha_s) <= 2 f/l; uphill 30 deg, f/l = 0.05: gamma > 56 deg is impossible.
  Input in = example();
  in.slope = -30 * degree;
  in.return_weight = 1e-6;
  in.traction_weight = 1e-6;
  Output out;
  in.gathering_angle = 55.4 * degree;
  EXPECT_TRUE(solve(in, out).ok());
  in.gathering_angle = 56.3 * degree;
  EXPECT_EQ(solve(in, out).status, Status::infeasible);
}

/// Warnings of a position, with an exact sag or values where an engine has them.
std::vector<std::string> warnings_of(const Input& in, const Engine& engine = no_engine) {
  return run(in, engine).warnings;
}

bool warns_of(const std::vector<std::string>& all, const std::string& words) {
  return std::any_of(all.begin(), all.end(), [&](const auto& w) { return w.find(words) != std::string::npos; });
}

// The sag of a carriage that leaves its stop is the one at which T_lB is the gathering force, exactly. That the
// closed-form tier has a little less there says nothing.
TEST(ClosedLoopPosition, ACarriageThatLeavesItsStopIsNotSaidToHaveLeftIt) {
  Input in = example();
  in.mode = Mode::free_running;
  in.sag.reset();
  const double sag = run(in).find_value("f")->value;
  Engine engine;
  engine.sag = [&](const Input&, const Case<double>&, ExactSag& found) {
    found.sag = 1.1 * sag;
    return Outcome{};
  };
  const Result r = run(in, engine);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_LT(r.find_value("T_lB")->value, in.gathering_force);
  EXPECT_FALSE(warns_of(r.warnings, "exceeds T_lB"));
  Input given = example();
  given.sag = 1.1 * sag;
  EXPECT_TRUE(warns_of(warnings_of(given), "exceeds T_lB")) << "at a given sag it has left its stop";
}

// Two sections close to the supports: neither tier has a P_b, so nothing is said of it.
TEST(ClosedLoopPosition, NothingIsSaidOfALoadThatHasNoValue) {
  Input in = example();
  in.carriage = Carriage::two_section;
  in.position = {in.span / 2};
  in.section_distance = in.span / 2 - 0.01;
  Engine engine;
  engine.solve = [](const Input&, const Case<double>&, Output& out) {
    out.T_lA_exact = out.T_lB_exact = out.T_uA_exact = out.T_uB_exact = 90e3;
    return Outcome{};
  };
  const auto all = warnings_of(in, engine);
  ASSERT_TRUE(warns_of(all, "closed-form tier has no answer here"));
  EXPECT_FALSE(warns_of(all, "carries nothing"));
}

}  // namespace taut::closed_loop::position_test
