#include "taut/methods/closed_loop/closed_loop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "taut/methods/closed_loop/engine.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::closed_loop_test {

using namespace taut_test;

std::string complaint_at(const Input& in, const std::string& path) {
  std::string text;
  for (const Complaint& c : complaints(in)) {
    if (c.path == path) text += c.message;
  }
  return text;
}

TEST(ClosedLoopDeck, TheExampleIsFine) {
  EXPECT_TRUE(complaints(example()).empty());
  EXPECT_TRUE(complaints(two_section_example()).empty());
}

TEST(ClosedLoopDeck, ModesAskForTheirOwnKeys) {
  Input in = example();
  in.sag.reset();
  EXPECT_NE(complaint_at(in, "sag"), "");
  in.mode = Mode::winch_pull;
  EXPECT_EQ(complaint_at(in, "sag"), "");
  EXPECT_NE(complaint_at(in, "winch_pull"), "");
  in.mode = Mode::loop_length;
  in.winch_pull.reset();
  EXPECT_NE(complaint_at(in, "loop_length"), "");
  in.loop_length = 402;
  EXPECT_TRUE(complaints(in).empty());
  in = example();
  in.mode = Mode::free_running;
  EXPECT_NE(complaint_at(in, "sag"), "");
  in = example();
  in.winch_pull = 1e4;
  in.loop_length = 400;
  EXPECT_NE(complaint_at(in, "winch_pull"), "");
  EXPECT_NE(complaint_at(in, "loop_length"), "");
}

TEST(ClosedLoopDeck, GeometryMustFit) {
  Input in = example();
  in.position = {100, 200};
  EXPECT_NE(complaint_at(in, "position[1]"), "");
  in.position = {250};
  EXPECT_NE(complaint_at(in, "position"), "");
  in = example();
  in.slope = 0.1;
  in.height_difference = 20;
  EXPECT_NE(complaint_at(in, "height_difference"), "");
  in.slope = 0;
  EXPECT_EQ(complaint_at(in, "height_difference"), "");
  in.height_difference = -400;
  EXPECT_NE(complaint_at(in, "height_difference"), "");
  in = example();
  in.gathering_angle = 90 * degree;
  EXPECT_NE(complaint_at(in, "gathering_angle"), "");
  in.gathering_angle_from = AngleFrom::horizontal;
  EXPECT_EQ(complaint_at(in, "gathering_angle"), "");
}

TEST(ClosedLoopDeck, TheTwoSectionCarriageMustFit) {
  Input in = two_section_example();
  in.position = {198};
  EXPECT_NE(complaint_at(in, "position[0]"), "");
  in.position_of = Section::second;
  EXPECT_EQ(complaint_at(in, "position[0]"), "");
  in.section_distance.reset();
  EXPECT_NE(complaint_at(in, "section_distance"), "");
  in = example();
  in.section_distance = 3;
  in.distance_kind = DistanceKind::rope;
  in.sag_of = in.position_of = Section::second;
  for (const char* key : {"section_distance", "distance_kind", "sag_of", "position_of"}) {
    EXPECT_NE(complaint_at(in, key), "") << key << " does nothing with a single carriage";
  }
}

TEST(ClosedLoopDeck, WhatOnlyAnEngineFindsIsInfeasibleWithoutOne) {
  Input in = two_section_example();
  in.mode = Mode::free_running;
  in.sag.reset();
  EXPECT_TRUE(complaints(in).empty());
  Output out;
  EXPECT_EQ(solve(in, out).status, Status::infeasible);
  in = example();
  in.mode = Mode::loop_length;
  in.sag.reset();
  in.loop_length = 402;
  const Outcome o = solve(in, out);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("exact catenaries"), std::string::npos);
}

TEST(ClosedLoopDeck, AnEngineDecidesTheSagAndTheExactColumn) {
  Input in = example();
  in.mode = Mode::loop_length;
  in.sag.reset();
  in.loop_length = 402;
  Engine engine;
  engine.sag = [](const Input&, const Case<double>&, ExactSag& found) {
    found = {.sag = 12, .second = 50};
    return Outcome{};
  };
  engine.solve = [](const Input&, const Case<double>& c, Output& out) {
    out.T_uA_exact = out.T_uB_exact = out.T_lB_exact = out.T_lLB_exact = out.T_U_exact = 1e3 * c.f;
    out.T_lA_exact = out.T_lLA_exact = 2e3 * c.f;
    return Outcome{};
  };
  const Result r = run(in, engine);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_EQ(r.find_value("f")->value, 12);
  EXPECT_EQ(r.find_value("f_second")->value, 50);
  EXPECT_EQ(r.find_value("T_lA_exact")->value, 24e3);
  engine.solve = [](const Input&, const Case<double>&, Output&) { return infeasible("it lifts off"); };
  EXPECT_EQ(run(in, engine).status, Status::infeasible);
  engine.solve = [](const Input&, const Case<double>&, Output&) { return not_converged("no luck"); };
  const Result without = run(in, engine);
  EXPECT_EQ(without.status, Status::not_converged) << "the closed form is no answer in its place";
  EXPECT_EQ(without.message, "no luck");
}

TEST(ClosedLoopDeck, RopesAndSafetyFactors) {
  Input in = example();
  in.return_weight.reset();
  EXPECT_NE(complaint_at(in, "return_weight"), "");
  in.return_rope = "6x36-IWRC 16 mm 1960 MPa";
  EXPECT_EQ(complaint_at(in, "return_weight"), "");
  EXPECT_EQ(complaint_at(in, "return_rope"), "");
  in.return_rope = "7x99 hemp";
  EXPECT_NE(complaint_at(in, "return_rope"), "");
  in = example();
  in.traction_rope = "6x36-IWRC 16 mm 1960 MPa";
  EXPECT_NE(complaint_at(in, "traction_rope").find("not both"), std::string::npos);
  in = example();
  in.safety_factor = 3;
  EXPECT_NE(complaint_at(in, "safety_factor"), "");
  in.safety_factor.reset();
  in.wire_strength = 1e9;
  EXPECT_NE(complaint_at(in, "wire_strength"), "");
  in = example();
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = {}, .grade = {}};
  EXPECT_NE(complaint_at(in, "choose_ropes"), "");
  in.return_weight.reset();
  in.traction_weight.reset();
  in.safety_factor = 3;
  EXPECT_EQ(complaint_at(in, "choose_ropes"), "");
  in.choose_ropes->construction = "9x99";
  EXPECT_NE(complaint_at(in, "choose_ropes"), "");
}

Input drawn() {
  Input in = example();
  in.slope = *rc::gen::inRange(-250, 251) * 0.1 * degree;
  in.position = {static_cast<double>(*rc::gen::inRange(30, 171))};
  in.sag = *rc::gen::inRange(20, 200) * 0.1;
  in.gathering_angle = *rc::gen::inRange(0, 60) * degree;
  in.tail_efficiency = *rc::gen::inRange(60, 101) / 100.0;
  in.tail_sheaves = *rc::gen::inRange(1, 4);
  in.carriage_weight = *rc::gen::inRange(0, 3) * 700.0;
  in.haul = *rc::gen::element(Haul::in, Haul::out);
  in.roller = *rc::gen::element(Roller::free, Roller::vertical);
  if (*rc::gen::arbitrary<bool>()) {
    in.safety_factor = 3.2;
    in.wire_strength = 1.3e9;
  }
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 1) {
    in.carriage = Carriage::two_section;
    in.section_distance = *rc::gen::inRange(1, 9);
    in.distance_kind = *rc::gen::element(DistanceKind::horizontal, DistanceKind::rope);
    in.sag_of = *rc::gen::element(Section::first, Section::second);
    in.position_of = *rc::gen::element(Section::first, Section::second);
  }
  if (kind == 2) {
    in.mode = Mode::winch_pull;
    in.sag.reset();
    in.winch_pull = *rc::gen::inRange(40, 120) * 1e3;
  }
  if (kind == 3) in.position = {50, 120};
  return in;
}

RC_GTEST_PROP(ClosedLoopTypes, DoubleAndNumAgreeToTheLastBit, ()) {
  const Input in = drawn();
  Output a;
  Output b;
  Sheet<double> silent;
  Sheet<Num> note("Martynikhin 1971", Input::describe(), &in);
  const Outcome first = compute(in, silent, a);
  const Outcome second = compute(in, note, b);
  RC_ASSERT(first.status == second.status);
  RC_ASSERT(first.message == second.message);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit-identical, also where both are NaN
  RC_ASSERT(std::memcmp(&a, &b, sizeof a) == 0);
}

RC_GTEST_PROP(ClosedLoopTypes, LengthsAndForcesScale, ()) {
  // Twice as long with half the weight per metre, three times the forces: the same shape.
  const Input in = drawn();
  RC_PRE(in.mode == Mode::sag);
  Output a;
  RC_PRE(solve(in, a).ok());
  Input big = in;
  big.span *= 2;
  for (double& x : big.position) x *= 2;
  *big.sag *= 2;
  if (big.section_distance) *big.section_distance *= 2;
  big.gathering_force *= 3;
  big.carriage_weight *= 3;
  *big.return_weight *= 1.5;
  *big.traction_weight *= 1.5;
  big.weight_per_area /= 2;
  Output b;
  RC_ASSERT(solve(big, b).ok());
  const double tolerance = 1e-8 * 3 * a.T_end_max;
  RC_ASSERT(std::abs(b.P_b - 3 * a.P_b) < tolerance);
  RC_ASSERT(std::abs(b.T_lA - 3 * a.T_lA) < tolerance);
  RC_ASSERT(std::abs(b.T_uB - 3 * a.T_uB) < tolerance);
  RC_ASSERT(std::abs(b.T_lA_paper - 3 * a.T_lA_paper) < tolerance);
  if (in.wire_strength) RC_ASSERT(std::abs(b.F_return - 3 * a.F_return) < 1e-8 * b.F_return);
}

TEST(ClosedLoopTypes, EveryStepStandsInTheNote) {
  Input in = example();
  in.safety_factor = 3.5;
  in.wire_strength = 140 * kgf_per_mm2;
  Output out;
  Sheet<Num> s("Martynikhin 1971", Input::describe(), &in);
  ASSERT_TRUE(compute(in, s, out).ok());
  for (const char* eq : {"1", "2", "3", "4", "5", "6*", "7", "8", "8*", "9*", "10", "10*"}) {
    EXPECT_TRUE(std::any_of(s.steps().begin(), s.steps().end(), [&](const Step& step) { return step.eq == eq; })) << eq;
  }
}

}  // namespace taut::closed_loop::closed_loop_test
