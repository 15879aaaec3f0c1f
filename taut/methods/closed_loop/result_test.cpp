#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <utility>

#include "taut/calc/verdict.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/closed_loop/engine.hpp"
#include "taut/units/display.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::result_test {

using namespace taut_test;

bool warns(const Result& r, const std::string& words) {
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// How often a run asks the engine for each place with the ropes that it shows in the end.
std::vector<int> times_asked(const Input& in) {
  std::map<std::tuple<double, double, double, double>, int> asked;
  Engine engine;
  engine.solve = [&](const Input&, const Case<double>& c, Output& out) {
    ++asked[{c.x, c.q_b, c.q_T, c.eta}];
    out.T_uA_exact = out.T_uB_exact = out.T_lB_exact = out.T_lLB_exact = out.T_U_exact = 1e3 * c.x;
    out.T_lA_exact = out.T_lLA_exact = 2e3 * c.x;
    return Outcome{};
  };
  const Result r = run(in, engine);
  EXPECT_EQ(r.status, Status::ok) << r.message;
  const double q_b = r.find_value("q_b")->value, q_T = r.find_value("q_T")->value;
  std::vector<int> times;
  for (const auto& [place, n] : asked) {
    if (std::get<1>(place) == q_b && std::get<2>(place) == q_T) times.push_back(n);
  }
  return times;
}

TEST(ClosedLoopResult, EveryPositionIsSolvedOnce) {
  constexpr std::size_t plotted = 61;  // each 3 m from 10 m on
  Input in = example();
  in.position = {32, 77, 113};
  std::vector<int> times = times_asked(in);
  EXPECT_EQ(times.size(), std::size_t{2} * 3 + plotted) << "both hauls";
  EXPECT_EQ(std::ranges::max(times), 1);
  in.position = {32};
  times = times_asked(in);
  EXPECT_EQ(times.size(), std::size_t{2} * 1 + plotted);
  EXPECT_EQ(std::ranges::max(times), 1);
  // chosen ropes are proved hauled in and out, and not once more for the result
  in.position = {32, 77, 113};
  in.return_weight.reset();
  in.traction_weight.reset();
  in.choose_ropes = RopeFilter{};
  in.safety_factor = 3.5;
  times = times_asked(in);
  EXPECT_EQ(times.size(), 6 + plotted);
  EXPECT_EQ(std::ranges::max(times), 1);
}

TEST(ClosedLoopResult, TheExampleIsWhole) {
  Input in = example();
  in.safety_factor = 3.5;
  in.wire_strength = 140 * kgf_per_mm2;
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(r.method, "closed_loop");
  EXPECT_EQ(exit_code(r), 4) << "a factor is asked of ropes whose breaking force is not known";
  EXPECT_EQ(r.figures.size(), 4U);
  EXPECT_EQ(r.comparisons.size(), 8U);
  EXPECT_TRUE(warns(r, "(7) is unsafe"));
  EXPECT_FALSE(warns(r, "outside their range"));
  for (const char* name : {"P", "K", "P_b", "P_b_no_weight", "T_b", "T_n", "T_up", "T_lA_paper", "N", "P_v", "T_uA",
                           "T_uB", "T_lA", "T_lB", "F_return_paper", "F_traction_paper", "F_return", "F_traction"}) {
    EXPECT_NE(r.find_value(name), nullptr) << name;
  }
  EXPECT_EQ(r.find_table("positions"), nullptr);
}

TEST(ClosedLoopResult, TwoSectionsHaveTheirOwnValues) {
  const Result r = run(two_section_example());
  for (const char* name : {"P_b", "delta_f", "P_b_printed", "delta_f_printed"}) {
    EXPECT_NE(r.find_value(name), nullptr) << name;
  }
}

TEST(ClosedLoopResult, AListOfPositionsMakesATable) {
  Input in = example();
  in.slope = -25 * degree;
  in.gathering_angle = 50 * degree;
  in.position = {5, 100, 60};
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok);
  const Table* t = r.find_table("positions");
  ASSERT_NE(t, nullptr);
  ASSERT_EQ(t->rows.size(), 3U);
  EXPECT_TRUE(std::isnan(std::get<double>(t->rows[0][8])));
  EXPECT_NE(std::get<std::string>(t->rows[0].back()), "");
  EXPECT_EQ(std::get<std::string>(t->rows[1].back()), "");
  EXPECT_EQ(r.find_value("x")->value, 100);
  EXPECT_TRUE(warns(r, "1 of 3 positions"));
  EXPECT_TRUE(warns(r, "outside their range"));
  EXPECT_TRUE(warns(r, "Build by the closed-form tier"));
  // near a support that is too small as well
  in.slope = 15 * degree;
  in.position = {180};
  EXPECT_TRUE(warns(run(in), "Build by the values that end in _exact"));
}

// What the paper leaves out of the force of the roller is P_b sin(alpha_s): nothing on a level span.
TEST(ClosedLoopResult, ALevelSpanHasNoForceAlongItsSlope) {
  Input in = example();
  const std::string left_out = "Taking the roller force as vertical alone";
  in.position = {20};
  in.sag = 9;
  for (const double slope : {0.0, 15 * degree}) {
    in.slope = slope;
    const Result r = run(in);
    ASSERT_EQ(r.status, Status::ok) << r.message;
    EXPECT_TRUE(warns(r, "outside their range")) << slope;
    EXPECT_EQ(warns(r, left_out), slope != 0);
    EXPECT_TRUE(warns(r, "Build by ")) << slope;
  }
}

TEST(ClosedLoopResult, NothingFeasibleKeepsTheStepsReached) {
  Input in = example();
  in.slope = -30 * degree;
  in.gathering_angle = 58 * degree;
  in.position = {80, 100};
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("none of the 2 positions"), std::string::npos);
  EXPECT_FALSE(r.steps.empty());
  EXPECT_NE(r.find_value("P_b"), nullptr);
  EXPECT_NE(r.find_table("positions"), nullptr);
  EXPECT_EQ(exit_code(r), 3);
  ASSERT_EQ(r.figures.size(), 1U) << "the loop as described";
  const auto& loop = std::get<Drawing>(r.figures.front());
  EXPECT_NE(loop.title.find("as described"), std::string::npos);
  for (const Shape& one : loop.shapes) {
    const auto* force = std::get_if<ForceArrow>(&one);
    EXPECT_TRUE(force == nullptr || force->label == "S" || force->label == "W_c") << "only what is given";
  }
}

/// Exact values a little above the closed form; none where `lost` says so.
Engine engine_without(std::function<bool(const Case<double>&)> lost) {
  Engine engine;
  engine.solve = [lost = std::move(lost)](const Input&, const Case<double>& c, Output& out) {
    if (lost(c)) return not_converged("no equilibrium is found here");
    out.T_uA_exact = out.T_U_exact = 1.01 * out.T_uA;
    out.T_uB_exact = 1.01 * out.T_uB;
    out.T_lB_exact = out.T_lLB_exact = 1.01 * out.T_lB;
    out.T_lA_exact = out.T_lLA_exact = 1.01 * out.T_lA;
    return Outcome{};
  };
  return engine;
}

// The closed form has an answer everywhere, and ropes far too strong for it.
TEST(ClosedLoopResult, APositionThatTheEngineCanNotSolveIsNotJudged) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = in.traction_rope = "6x36-IWRC 32 mm 1960 MPa";
  in.safety_factor = 3.5;
  in.position = {60, 100, 140};
  const Result whole = run(in, engine_without([](const auto&) { return false; }));
  EXPECT_EQ(verdict_of(whole)->kind, VerdictKind::passes);
  const Result r = run(in, engine_without([](const auto& c) { return c.x == 140; }));
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].missing, 1);
  EXPECT_EQ(r.missing[0].reason, "no equilibrium is found here");
  EXPECT_EQ(std::get<std::string>(r.find_table("positions")->rows[2].back()), "no equilibrium is found here");
  EXPECT_TRUE(warns(r, "1 of 3 positions have no answer"));
  // the other haul alone: over the sheave at B the tension falls the other way
  const double eta = in.tail_efficiency;
  const Result back = run(in, engine_without([&](const auto& c) { return c.x == 140 && c.eta != eta; }));
  EXPECT_TRUE(back.missing.empty());
  EXPECT_EQ(verdict_of(back)->kind, VerdictKind::not_judged);
  ASSERT_EQ(back.unmade.size(), 1U);
  EXPECT_NE(back.unmade[0].find("no equilibrium is found here"), std::string::npos) << back.unmade[0];
  // the only position
  in.position = {140};
  const Result none = run(in, engine_without([](const auto&) { return true; }));
  EXPECT_EQ(none.status, Status::not_converged);
  EXPECT_EQ(exit_code(none), 3);
  // ropes are chosen by what has an answer, and not said to pass
  in.position = {60, 100, 140};
  in.return_rope.reset();
  in.traction_rope.reset();
  in.choose_ropes = RopeFilter{};
  const Result chosen = run(in, engine_without([](const auto& c) { return c.x == 140; }));
  EXPECT_EQ(verdict_of(chosen)->kind, VerdictKind::not_judged);
}

// By hand: of the four ends of the example hauled in T_lA is the largest, and the winch pulls with T_lA /
// head_efficiency.
TEST(ClosedLoopResult, TheLargestTensionIsOfBothRopesBothHaulsAndTheWinch) {
  Input in = example();
  in.head_efficiency = 0.8;
  const Result r = run(in);
  EXPECT_DOUBLE_EQ(r.find_value("T_max")->value, r.find_value("T_lA")->value / 0.8);
  EXPECT_LT(r.find_value("T_end_max")->value, r.find_value("T_max")->value);
  in.haul = Haul::out;
  EXPECT_DOUBLE_EQ(run(in).find_value("T_max")->value, r.find_value("T_max")->value) << "the same two hauls";
  in.position = {60, 100, 140};
  const Result all = run(in);
  const Table* ropes = all.find_table("ropes");
  EXPECT_EQ(all.find_value("T_max")->value,
            std::max(std::get<double>(ropes->rows[0][6]), std::get<double>(ropes->rows[1][6])));
  const Result exact = run(in, engine_without([](const auto&) { return false; }));
  EXPECT_NEAR(exact.find_value("T_max")->value, 1.01 * all.find_value("T_max")->value, 1e-6) << "exact where known";
}

TEST(ClosedLoopResult, ChosenRopesPassTheirChecks) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.safety_factor = 3.5;
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = "IWRC", .grade = 1960e6};
  in.clearance = 12;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  ASSERT_EQ(r.checks.size(), 3U);
  EXPECT_EQ(exit_code(r), 0);
  const Table* t = r.find_table("ropes");
  ASSERT_NE(t, nullptr);
  ASSERT_EQ(t->rows.size(), 2U);
  EXPECT_EQ(std::get<std::string>(t->rows[0][0]), "return");
  EXPECT_GE(std::get<double>(t->rows[0][8]), 3.5);
  EXPECT_NE(r.checks[0].trust.find("derived"), std::string::npos);
}

TEST(ClosedLoopResult, AThinRopeFailsItsCheck) {
  Input in = example();
  in.return_weight.reset();
  in.return_rope = "6x36-IWRC 10 mm 1960 MPa";
  in.safety_factor = 3.5;
  in.clearance = 9;
  const Result r = run(in);
  ASSERT_EQ(r.checks.size(), 2U);
  EXPECT_FALSE(r.checks[0].passes);
  EXPECT_FALSE(r.checks[1].passes);  // 10 m of sag over 9 m of clearance
  EXPECT_EQ(exit_code(r), 4);
}

TEST(ClosedLoopResult, ARopeWithoutALimitIsNotJudged) {
  Input in = example();
  EXPECT_EQ(run(in).unjudged, (std::vector<std::string>{"return rope", "traction rope"}));
  in.return_weight.reset();
  in.return_rope = "6x36-IWRC 24 mm 1960 MPa";
  EXPECT_EQ(run(in).unjudged, (std::vector<std::string>{"return rope", "traction rope"}));
}

/// A limit that the deck gives and nobody can check: by their weight the strength of ropes is not known.
TEST(ClosedLoopResult, AFactorOfARopeByItsWeightIsNotMade) {
  Input in = example();
  in.safety_factor = 3.5;
  Result r = run(in);
  EXPECT_TRUE(r.unjudged.empty());
  ASSERT_EQ(r.unmade.size(), 2U);
  EXPECT_NE(r.unmade[0].find("the safety_factor of the return rope is not checked: its breaking force is not known"),
            std::string::npos)
      << r.unmade[0];
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade");
  EXPECT_EQ(exit_code(r), 4);
  const Table& ropes = *r.find_table("ropes");
  EXPECT_EQ(std::get<std::string>(ropes.rows[0].back()), "user");
  in.return_weight.reset();
  in.return_rope = "6x36-IWRC 24 mm 1960 MPa";
  r = run(in);
  EXPECT_EQ(r.unmade, std::vector<std::string>{unknown_strength("traction")});
  EXPECT_EQ(std::get<std::string>(r.find_table("ropes")->rows[0].back()), "derived");
}

TEST(ClosedLoopResult, RopesAreJudgedInBothDirections) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = in.traction_rope = "6x36-IWRC 24 mm 1960 MPa";
  in.safety_factor = 3.5;
  in.tail_efficiency = 0.8;
  in.slope = -0.3;
  const Result hauled_in = run(in);
  in.haul = Haul::out;
  const Result hauled_out = run(in);
  ASSERT_EQ(hauled_in.checks.size(), 2U);
  ASSERT_EQ(hauled_out.checks.size(), 2U);
  for (const std::size_t i : {0U, 1U}) EXPECT_NEAR(hauled_in.checks[i].value, hauled_out.checks[i].value, 1e-9) << i;
}

TEST(ClosedLoopResult, PositionsWithoutAnAnswerAreMissing) {
  Input in = example();
  in.position = {100, 1};
  in.gathering_angle = 1.2;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].missing, 1);
  EXPECT_EQ(r.missing[0].first, "x = 1 m");
  EXPECT_EQ(r.missing[0].all, "x = 1 m");
  in.position = {1, 2, 100, 3};
  const Result three = run(in);
  ASSERT_EQ(three.missing.size(), 1U);
  EXPECT_EQ(three.missing[0].all, "x = 1 m to x = 2 m (2 states); x = 3 m");
}

TEST(ClosedLoopResult, AFreeCarriageIsWarnedOf) {
  Input in = example();
  in.sag = 26;
  EXPECT_TRUE(warns(run(in), "has left its stop"));
}

TEST(ClosedLoopResult, NoRopeIsInfeasibleWithoutSteps) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.safety_factor = 3.5;
  in.gathering_force *= 100;
  in.choose_ropes = RopeFilter{};
  const Result r = run(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_FALSE(r.given.empty());
}

/// The example with ropes of the catalogue.
Input with_ropes(const char* return_rope, const char* traction_rope, double safety_factor) {
  Input in = example();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = return_rope;
  in.traction_rope = traction_rope;
  in.safety_factor = safety_factor;
  return in;
}

/// Nobody asks for it. The paper's example pulls the traction rope with 8585 kgf, 84.2 kN, at A: a rope of 10 mm, which
/// breaks at 69.8 kN, does not hold, one of 12 mm (100.5 kN) does. Hauled out it has less.
TEST(ClosedLoopResult, ARopeAboveItsBreakingForceFails) {
  Input in = with_ropes("6x36-IWRC 12 mm 1960 MPa", "6x36-IWRC 10 mm 1960 MPa", 0);
  in.safety_factor.reset();
  Result r = run(in);
  ASSERT_EQ(r.checks.size(), 2U);
  EXPECT_EQ(r.checks[1].name, "traction rope does not break");
  // these ropes are lighter, on the lower branch by 0.75 kgf/m: by 0.75 200^2/(8 10) = 375 kgf, 3.7 kN, at most
  EXPECT_LT(r.checks[1].value, 84.2e3);
  EXPECT_GT(r.checks[1].value, 84.2e3 - 3.7e3);
  EXPECT_NEAR(r.checks[1].limit, 69.8e3, 50);
  EXPECT_EQ(r.checks[1].where, "carriage at 100 m");
  EXPECT_TRUE(r.checks[0].passes);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_EQ(exit_code(r), 4);
  in.traction_rope = "6x36-IWRC 12 mm 1960 MPa";
  r = run(in);
  EXPECT_TRUE(r.checks[1].passes);
  EXPECT_EQ(r.unjudged, (std::vector<std::string>{"return rope", "traction rope"}))
      << "breaking is no limit to pass by";
  EXPECT_EQ(verdict_of(r)->verdict_class, "unasked");
}

/// Uphill at 30 deg, 3 m of sag, 20 m from A: tan of the line to A is t = -0.577 - 3/20 = -0.727, the load along it
/// Q = S (cos 54 + t sin 54) = 20 kN (0.5878 - 0.727 0.8090) = -12 N. The roller carries rho (Q + W_l) - W_u with
/// w = q/cos(30 deg), w_b = 10.27/0.866 = 11.86, w_T = 13.0/0.866 = 15.0 N/m, W_u = 11.86 75 = 889 N, W_l = (15.0 20 +
/// 11.86 130)/2 = 921 N, and rho about 0.9 hauled in, 1/0.9 out: 818 - 889 < 0, it lifts off; 1010 - 889 > 0.
Input held_hauled_out_only() {
  Input in = with_ropes("6x36-IWRC 16 mm 1960 MPa", "6x36-IWRC 18 mm 1960 MPa", 3);
  in.span = 150;
  in.slope = -30 * degree;
  in.gathering_force = 20e3;
  in.gathering_angle = 54 * degree;
  in.position = {20};
  in.sag = 3;
  in.haul = Haul::out;
  return in;
}

TEST(ClosedLoopResult, AHaulWithoutAnAnswerIsNotJudged) {
  Input in = held_hauled_out_only();
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  for (const Check& c : r.checks) EXPECT_TRUE(c.passes) << c.name;
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_NE(r.unmade[0].find("hauled in the loop has no answer at all (carriage at 20 m): the roller lifts off"),
            std::string::npos)
      << r.unmade[0];
  EXPECT_TRUE(warns(r, "hauled in the loop has no answer"));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
  EXPECT_EQ(exit_code(r), 4);
  in.haul = Haul::in;
  EXPECT_EQ(run(in).status, Status::infeasible);
  in.gathering_angle = 40 * degree;  // Q = 20 kN (0.766 - 0.727 0.643) = 6 kN: it carries both ways
  EXPECT_TRUE(run(in).unmade.empty());
}

TEST(ClosedLoopResult, PositionsWithoutAnAnswerInTheOtherHaulAreNamed) {
  Input in = held_hauled_out_only();
  in.position = {20, 75};
  const Result r = run(in);
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_TRUE(r.missing.empty()) << "hauled as the deck says it has an answer at both";
  EXPECT_NE(r.unmade[0].find("hauled in the loop has no answer at 1 of 2 positions (carriage at 20 m)"),
            std::string::npos)
      << r.unmade[0];
}

/// One result is in one system of units: 100 m are 328.08 ft.
TEST(ClosedLoopResult, TheMessagesAreInTheUnitsOfTheDeck) {
  Input in = with_ropes("6x36-IWRC 24 mm 1960 MPa", "6x36-IWRC 24 mm 1960 MPa", 3.5);
  in.wire_strength = 140 * kgf_per_mm2;
  in.slope = 15 * degree;  // out of the paper's range
  const Result r = run(in, no_engine, Display({{"force", "kgf"}, {"length", "ft"}}));
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_EQ(r.checks.at(0).where, "carriage at 328.08 ft");
  EXPECT_NE(r.checks[0].rule.find("kgf"), std::string::npos) << r.checks[0].rule;
  const Table& ropes = *r.find_table("ropes");
  EXPECT_TRUE(std::get<std::string>(ropes.rows[0][7]).ends_with("carriage at 328.08 ft"));
  EXPECT_TRUE(warns(r, "kgf"));
  EXPECT_FALSE(warns(r, " kN"));
}

TEST(ClosedLoopResult, AnUnverifiedBreakingForceIsOneInItsChecks) {
  constexpr const char* unverified = "GOST 7668-80|6x36(1+7+7/7+14)-FC|29|1770";
  const Result given = run(with_ropes(unverified, unverified, 3));
  ASSERT_EQ(given.status, Status::ok) << given.message;
  ASSERT_EQ(given.checks.size(), 2U);
  for (const Check& c : given.checks) EXPECT_TRUE(is_unverified(c.trust)) << c.name << ": " << c.trust;
  EXPECT_EQ(verdict_of(given)->kind, VerdictKind::passes_with_warnings) << verdict_of(given)->reason;
  Input in = with_ropes(unverified, unverified, 3);
  in.return_rope.reset();
  in.traction_rope.reset();
  in.choose_ropes = RopeFilter{.construction = {}, .core = "FC", .grade = 1670e6};
  const Result chosen = run(in);
  ASSERT_EQ(chosen.status, Status::ok) << chosen.message;
  for (const Check& c : chosen.checks) EXPECT_TRUE(is_unverified(c.trust)) << c.name << ": " << c.trust;
  EXPECT_EQ(verdict_of(chosen)->kind, VerdictKind::passes_with_warnings) << verdict_of(chosen)->reason;
}

TEST(ClosedLoopResult, TheSagOfTheClearanceSaysWhereItIs) {
  Input in = example();
  in.mode = Mode::free_running;
  in.sag.reset();
  in.position = {30, 100, 60};
  in.clearance = 25;
  const Result r = run(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const auto c = std::find_if(r.checks.begin(), r.checks.end(),
                              [](const Check& one) { return one.name == "sag at the carriage"; });
  ASSERT_NE(c, r.checks.end());
  double deepest = 0, x = 0;
  std::string haul;
  Input other = in;
  other.haul = in.haul == Haul::in ? Haul::out : Haul::in;
  for (const auto& [result, words] :
       {std::pair{r, ""}, {run(other), in.haul == Haul::in ? ", hauled out" : ", hauled in"}}) {
    for (const auto& row : result.find_table("positions")->rows) {
      if (!(std::get<double>(row[1]) > deepest)) continue;
      deepest = std::get<double>(row[1]);
      x = std::get<double>(row[0]);
      haul = words;
    }
  }
  EXPECT_EQ(c->value, deepest);
  EXPECT_EQ(c->where, fmt::format("carriage at {:.4g} m{}", x, haul));
}

// The winch pulls the same both ways: hauled in, the loop hangs deeper than hauled out, and it has to clear the ground.
TEST(ClosedLoopResult, TheClearanceHoldsInBothHauls) {
  Input in = example();
  in.mode = Mode::winch_pull;
  in.sag.reset();
  in.winch_pull = 85e3;
  in.head_efficiency = 0.9;
  in.clearance = 20;
  const auto sag = [&](Haul haul) {
    in.haul = haul;
    const Result r = run(in);
    EXPECT_EQ(r.status, Status::ok) << r.message;
    const auto c = std::find_if(r.checks.begin(), r.checks.end(),
                                [](const Check& one) { return one.name == "sag at the carriage"; });
    return std::pair{r.find_value("f")->value, c == r.checks.end() ? Check{} : *c};
  };
  const auto [f_in, by_in] = sag(Haul::in);
  const auto [f_out, by_out] = sag(Haul::out);
  EXPECT_GT(f_in, 1.1 * f_out);
  EXPECT_EQ(by_in.value, f_in);
  EXPECT_NEAR(by_out.value, f_in, 1e-9 * f_in);
  EXPECT_NE(by_out.where.find("hauled in"), std::string::npos) << by_out.where;
  EXPECT_EQ(by_in.where.find("hauled"), std::string::npos) << by_in.where;
}

}  // namespace taut::closed_loop::result_test
